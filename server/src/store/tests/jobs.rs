//! The queue's promises: one holder at a time, and every end written once.

use super::super::jobs::{JobProgress, JobState};
use super::super::models::ModelState;
use super::super::text::Failure;
use super::{NOW, store, task, trained, training};

fn failure() -> Failure {
    Failure {
        code: "different_motions".into(),
        message: "Two of the demonstrations show different motions.".into(),
        advice: "Discard one.".into(),
    }
}

#[tokio::test]
async fn a_double_tap_is_the_same_job_and_a_failed_one_can_be_asked_for_again() {
    let (store, _folder) = store().await;
    let task = task(&store).await;
    let (job, model, new) = training(&store, task, "a").await;
    assert!(new);
    assert_eq!((model.version, model.seed), (1, u64::MAX));
    let (again, same, new) = training(&store, task, "a").await;
    assert!(!new);
    assert_eq!((again.id, same.id), (job.id, model.id));
    let (_, other, _) = training(&store, task, "b").await;
    assert_eq!(other.version, 2);
    store.cancel_job(job.id, NOW).await.unwrap();
    let (fresh, _, new) = training(&store, task, "a").await;
    assert!(new);
    assert_ne!(fresh.id, job.id);
    let versions: Vec<u32> = store
        .models(task)
        .await
        .unwrap()
        .iter()
        .map(|m| m.version)
        .collect();
    assert_eq!(versions, [1, 2, 3]);
}

#[tokio::test]
async fn a_job_is_claimed_once_until_its_lease_runs_out() {
    let (store, _folder) = store().await;
    let (job, ..) = training(&store, task(&store).await, "a").await;
    let until = NOW.plus_ms(30_000);
    let (claimed, first) = store.claim_job("one", NOW, until).await.unwrap().unwrap();
    assert_eq!((claimed.id, claimed.attempt), (job.id, 1));
    assert_eq!(claimed.state, JobState::Running);
    assert!(store.claim_job("two", NOW, until).await.unwrap().is_none());
    assert!(
        store
            .renew_lease(&first, NOW.plus_ms(40_000))
            .await
            .unwrap()
    );
    let at = NOW.plus_ms(35_000);
    assert!(store.claim_job("two", at, at).await.unwrap().is_none());

    let late = NOW.plus_ms(40_000);
    let (taken, second) = store
        .claim_job("two", late, late.plus_ms(30_000))
        .await
        .unwrap()
        .unwrap();
    assert_eq!(taken.attempt, 2);
    assert!(!store.renew_lease(&first, late).await.unwrap());
    assert!(
        !store
            .save_progress(&first, &JobProgress::default())
            .await
            .unwrap()
    );
    assert!(
        !store
            .finish_training(&first, &trained(), late)
            .await
            .unwrap()
    );
    assert!(!store.fail_job(&first, &failure(), late).await.unwrap());
    assert!(!store.return_job(&first, late, true).await.unwrap());
    let progress = JobProgress {
        stage: "mixture".into(),
        words: "Comparing mixtures".into(),
        done: 3,
        total: 8,
        fraction: 0.4,
    };
    assert!(store.save_progress(&second, &progress).await.unwrap());
    assert_eq!(store.job(job.id).await.unwrap().progress, progress);
}

#[tokio::test]
async fn finishing_twice_writes_once() {
    let (store, _folder) = store().await;
    let (job, model, _) = training(&store, task(&store).await, "a").await;
    let (_, lease) = store.claim_job("one", NOW, NOW).await.unwrap().unwrap();
    assert!(
        store
            .finish_training(&lease, &trained(), NOW)
            .await
            .unwrap()
    );
    assert!(
        !store
            .finish_training(&lease, &trained(), NOW)
            .await
            .unwrap()
    );
    let job = store.job(job.id).await.unwrap();
    assert_eq!(
        (job.state, job.progress.fraction),
        (JobState::Succeeded, 1.0)
    );
    let ready = store.model(model.id).await.unwrap();
    assert_eq!(ready.state, ModelState::Ready);
    assert_eq!(ready.goal_deg, Some(trained().goal_deg));
    assert_eq!(ready.report, Some(trained().report));
    assert_eq!(store.model_file(model.id).await.unwrap().0, b"{}");
    let ended = store.cancel_job(job.id, NOW).await.unwrap();
    assert_eq!(ended.state, JobState::Succeeded, "what has ended stays");
}

#[tokio::test]
async fn a_cancelled_job_can_not_finish_any_more() {
    let (store, _folder) = store().await;
    let (job, model, _) = training(&store, task(&store).await, "a").await;
    let (_, lease) = store.claim_job("one", NOW, NOW).await.unwrap().unwrap();
    let cancelled = store.cancel_job(job.id, NOW).await.unwrap();
    assert_eq!(cancelled.state, JobState::Cancelled);
    assert!(
        !store
            .finish_training(&lease, &trained(), NOW)
            .await
            .unwrap()
    );
    assert_eq!(
        store.model(model.id).await.unwrap().state,
        ModelState::Cancelled
    );
    assert!(store.model_file(model.id).await.is_err());
    assert!(store.open_jobs().await.unwrap().is_empty());
}

#[tokio::test]
async fn a_failure_is_written_to_job_and_model() {
    let (store, _folder) = store().await;
    let (job, model, _) = training(&store, task(&store).await, "a").await;
    let (_, lease) = store.claim_job("one", NOW, NOW).await.unwrap().unwrap();
    assert!(store.fail_job(&lease, &failure(), NOW).await.unwrap());
    assert_eq!(store.job(job.id).await.unwrap().failure, Some(failure()));
    let model = store.model(model.id).await.unwrap();
    assert_eq!(
        (model.state, model.failure),
        (ModelState::Failed, Some(failure()))
    );
    let failed = store.jobs(Some(JobState::Failed)).await.unwrap();
    assert_eq!(failed.len(), 1);
    assert!(store.jobs(Some(JobState::Queued)).await.unwrap().is_empty());
    assert_eq!(store.jobs(None).await.unwrap().len(), 1);
}

#[tokio::test]
async fn a_start_up_takes_running_jobs_back_until_they_have_been_tried_enough() {
    let (store, _folder) = store().await;
    let (job, model, _) = training(&store, task(&store).await, "a").await;
    for attempt in 1..=2 {
        let (claimed, _) = store
            .claim_job("one", NOW, NOW.plus_ms(9))
            .await
            .unwrap()
            .unwrap();
        assert_eq!(claimed.attempt, attempt);
        assert_eq!(store.requeue_running_jobs().await.unwrap(), 1);
    }
    assert!(store.claim_job("one", NOW, NOW).await.unwrap().is_none());
    let ended = store.fail_exhausted_jobs(&failure(), NOW).await.unwrap();
    assert_eq!(ended[0].id, job.id);
    assert_eq!(
        store.model(model.id).await.unwrap().state,
        ModelState::Failed
    );
}

#[tokio::test]
async fn a_returned_job_waits_and_a_shutdown_costs_no_attempt() {
    let (store, _folder) = store().await;
    training(&store, task(&store).await, "a").await;
    let (_, lease) = store.claim_job("one", NOW, NOW).await.unwrap().unwrap();
    let later = NOW.plus_ms(1_000);
    assert!(store.return_job(&lease, later, false).await.unwrap());
    assert!(store.claim_job("two", NOW, later).await.unwrap().is_none());
    let (job, _) = store.claim_job("two", later, later).await.unwrap().unwrap();
    assert_eq!(job.attempt, 1);
}
