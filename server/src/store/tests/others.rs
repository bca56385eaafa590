//! Tasks, reproductions, paired phones and the audit trail.

use super::super::Error;
use super::super::flights::CycleCounts;
use super::super::reproductions::{
    NewReproduction, ReproductionResult, ReproductionState, TrackingError,
};
use super::{NOW, store, task, training};
use crate::ids::{ReproductionId, TaskId};

#[tokio::test]
async fn a_deleted_task_is_out_of_sight_but_not_gone() {
    let (store, _folder) = store().await;
    let id = task(&store).await;
    let (same, made) = store.create_task(id, "Other name", NOW).await.unwrap();
    assert_eq!((same.name.as_str(), made), ("Drill", false));
    assert_eq!(store.rename_task(id, "Mill").await.unwrap().name, "Mill");
    assert_eq!(store.tasks().await.unwrap().len(), 1);
    store.delete_task(id, NOW).await.unwrap();
    assert!(store.tasks().await.unwrap().is_empty());
    assert!(matches!(store.task(id).await, Err(Error::NotFound { .. })));
    assert!(store.delete_task(id, NOW).await.is_err());
    assert!(store.rename_task(id, "X").await.is_err());
    let reused = store.create_task(id, "Drill", NOW).await;
    assert!(matches!(reused, Err(Error::IdTaken { .. })));
    let rows: i64 = sqlx::query_scalar("SELECT count(*) FROM task")
        .fetch_one(&store.readers)
        .await
        .unwrap();
    assert_eq!(rows, 1);
}

fn new<'a>(task_id: TaskId, model_id: crate::ids::ModelId, key: &'a str) -> NewReproduction<'a> {
    NewReproduction {
        id: ReproductionId::new(),
        task_id,
        model_id,
        robot: "left",
        plan: "aa",
        start_deg: &[1.0; 6],
        goal_deg: &[2.0; 6],
        duration_s: 7.5,
        backwards: false,
        idempotency_key: Some(key),
    }
}

#[tokio::test]
async fn a_reproduction_is_closed_with_its_figures() {
    let (store, _folder) = store().await;
    let task = task(&store).await;
    let (_, model, _) = training(&store, task, "a").await;
    let made = store
        .create_reproduction(new(task, model.id, "k"), NOW)
        .await
        .unwrap();
    assert_eq!(made.state, ReproductionState::Running);
    assert_eq!(
        store.running_reproduction("left").await.unwrap(),
        Some(made.clone())
    );
    let by_key = store.reproduction_by_key("k").await.unwrap();
    assert_eq!(by_key, Some(made.clone()));
    let second = store
        .create_reproduction(new(task, model.id, "k"), NOW)
        .await;
    assert!(second.is_err(), "one key starts one motion");
    let result = ReproductionResult {
        state: ReproductionState::Succeeded,
        reason: None,
        e_j_deg: Some(0.01),
        e_j_commanded_deg: Some(0.001),
        gmcc: Some(0.999),
        tracking_error_deg: Some(TrackingError {
            mean: 0.1,
            max: 0.5,
            max_by_joint: Some([0.5, 0.4, 0.3, 0.2, 0.1, 0.0]),
            rms_by_joint: Some([0.1; 6]),
        }),
        cycles: Some(CycleCounts {
            total: 2_500,
            lost: 3,
            late: 2,
            held: 1,
            limited: 4,
        }),
    };
    let done = store
        .finish_reproduction(made.id, &result, NOW.plus_ms(8_000))
        .await
        .unwrap();
    assert_eq!(done.e_j_deg, Some(0.01));
    assert_eq!(done.tracking_error_deg, result.tracking_error_deg);
    assert_eq!(done.cycles, result.cycles);
    assert!(store.running_reproduction("left").await.unwrap().is_none());
    assert_eq!(
        store.reproductions(Some(task), 200).await.unwrap(),
        std::slice::from_ref(&done)
    );
    assert_eq!(store.reproductions(None, 200).await.unwrap(), [done]);
    assert!(
        store
            .reproductions(Some(TaskId::new()), 200)
            .await
            .unwrap()
            .is_empty()
    );
}

#[tokio::test]
async fn a_motion_that_was_refused_never_was() {
    let (store, _folder) = store().await;
    let task = task(&store).await;
    let (_, model, _) = training(&store, task, "a").await;
    let refused = store
        .create_reproduction(new(task, model.id, "r"), NOW)
        .await
        .unwrap();
    store.withdraw_reproduction(refused.id).await.unwrap();
    assert!(store.reproduction(refused.id).await.is_err());
}

#[tokio::test]
async fn a_pairing_ends_when_it_expires() {
    let (store, _folder) = store().await;
    let (phone, stranger) = ([7; 32], [8; 32]);
    let expires = NOW.plus_ms(1_000);
    store
        .add_pairing(&phone, "192.0.2.7", NOW, expires)
        .await
        .unwrap();
    assert!(store.is_paired(&phone, NOW).await.unwrap());
    assert!(!store.is_paired(&stranger, NOW).await.unwrap());
    assert!(!store.is_paired(&phone, expires).await.unwrap());
    store
        .add_pairing(&stranger, "192.0.2.8", expires, expires.plus_ms(1))
        .await
        .unwrap();
    let rows: i64 = sqlx::query_scalar("SELECT count(*) FROM pairing_session")
        .fetch_one(&store.readers)
        .await
        .unwrap();
    assert_eq!(rows, 1, "the expired one is forgotten");
}

#[tokio::test]
async fn the_audit_trail_only_grows() {
    let (store, _folder) = store().await;
    for action in ["start", "stop"] {
        store
            .audit("this computer", action, "robot", NOW)
            .await
            .unwrap();
    }
    let actions: Vec<String> = sqlx::query_scalar("SELECT action FROM audit_event ORDER BY id")
        .fetch_all(&store.readers)
        .await
        .unwrap();
    assert_eq!(actions, ["start", "stop"]);
}
