//! The worker on the real method: calling off, shutting down, and failing.

use std::sync::Arc;
use std::time::Duration;

use tokio::sync::broadcast::Receiver;
use tokio::time::timeout;

use super::worker::{back_off_ms, panicked};
use super::{JobContext, JobError, Queue, TrainingRequest, Worker, train_model};
use crate::clock::{SystemClock, WallTime};
use crate::events::{Event, Events};
use crate::ids::{DemonstrationId, TaskId};
use crate::shutdown::Shutdown;
use crate::store::Store;
use crate::store::demonstrations::{DemonstrationSource, DemonstrationState, NewDemonstration};
use crate::store::jobs::{Job, JobState};
use crate::store::models::{ModelState, Source};
use crate::store::samples::Sample;
use crate::test_support::TestFolder;

struct Bench {
    store: Store,
    queue: Queue,
    events: Receiver<Event>,
    task: TaskId,
    _folder: TestFolder,
}

impl Bench {
    async fn new() -> Self {
        let folder = TestFolder::new();
        let store = Store::open(&folder.path().join("team.sqlite"))
            .await
            .unwrap();
        let events = Events::default();
        let task = TaskId::new();
        store.create_task(task, "Swing", WallTime(0)).await.unwrap();
        Self {
            queue: Queue::new(store.clone(), events.clone(), Arc::new(SystemClock)),
            store,
            events: events.listen(),
            task,
            _folder: folder,
        }
    }

    /// Stores a swing along `direction`, slower or faster from take to take.
    async fn take(&self, seconds: f64, direction: [f64; 6]) -> DemonstrationId {
        let new = NewDemonstration {
            id: DemonstrationId::new(),
            task_id: self.task,
            state: DemonstrationState::Kept,
            source: DemonstrationSource::File,
            robot: None,
        };
        let samples: Vec<Sample> = (0..=(seconds * 50.0) as u64)
            .map(|row| {
                let share = row as f64 * 0.02 / seconds;
                let turn = 0.5 - 0.5 * (std::f64::consts::PI * share).cos();
                Sample {
                    at_us: 20_000 * row,
                    joints_deg: std::array::from_fn(|j| 5.0 * j as f64 + direction[j] * turn),
                    tcp_mm: None,
                }
            })
            .collect();
        let stored = self
            .store
            .store_demonstration(new, &samples, &[], "made up", WallTime(0))
            .await;
        stored.unwrap().id
    }

    async fn ask(&self, demonstrations: Vec<DemonstrationId>) -> Job {
        let request = TrainingRequest {
            task_id: self.task,
            sources: demonstrations
                .into_iter()
                .map(|id| Source { id, trim: None })
                .collect(),
            method: "paper".into(),
            seed: 5,
        };
        self.queue.train(&request).await.unwrap().0
    }

    fn worker(&self) -> (Worker, Shutdown) {
        let shutdown = Shutdown::default();
        let worker = Worker::start(self.queue.clone(), shutdown.clone()).unwrap();
        (worker, shutdown)
    }

    /// Waits until the job is heard of in a way that fits.
    async fn heard(&mut self, fits: impl Fn(&Job) -> bool) -> Job {
        let wait = async {
            loop {
                if let Ok(Event::Job { job }) = self.events.recv().await
                    && fits(&job)
                {
                    return job;
                }
            }
        };
        timeout(Duration::from_secs(120), wait).await.unwrap()
    }
}

const UP: [f64; 6] = [10.0, 20.0, -15.0, 12.0, -18.0, 25.0];
const ACROSS: [f64; 6] = [-60.0, -40.0, 30.0, 5.0, 40.0, -70.0];

fn at_work(job: &Job) -> bool {
    job.state == JobState::Running && !job.progress.stage.is_empty()
}

#[tokio::test(flavor = "multi_thread")]
async fn a_training_that_is_called_off_leaves_no_model_and_the_worker_goes_on() {
    let mut bench = Bench::new().await;
    let takes = vec![bench.take(2.0, UP).await, bench.take(2.2, UP).await];
    let job = bench.ask(takes.clone()).await;
    let (worker, shutdown) = bench.worker();
    bench.heard(at_work).await;
    let cancelled = bench.queue.cancel(job.id).await.unwrap();
    assert_eq!(cancelled.state, JobState::Cancelled);
    let next = bench.ask(takes).await;
    bench
        .heard(|job| job.id == next.id && job.state == JobState::Running)
        .await;
    bench.queue.cancel(next.id).await.unwrap();
    shutdown.raise();
    worker.ended().await;
    for job in [job, next] {
        assert_eq!(
            bench.store.job(job.id).await.unwrap().state,
            JobState::Cancelled
        );
        let model = bench.store.model(job.model_id).await.unwrap();
        assert_eq!(model.state, ModelState::Cancelled);
        assert!(bench.store.model_file(model.id).await.is_err());
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_training_cut_by_a_shutdown_starts_again_and_gives_the_same_model() {
    let mut bench = Bench::new().await;
    let takes = vec![bench.take(1.1, UP).await];
    let job = bench.ask(takes).await;
    let (worker, shutdown) = bench.worker();
    bench.heard(at_work).await;
    shutdown.raise();
    worker.ended().await;
    let waiting = bench.store.job(job.id).await.unwrap();
    assert_eq!((waiting.state, waiting.attempt), (JobState::Queued, 0));

    let (worker, shutdown) = bench.worker();
    let ended = bench.heard(|job| job.finished_at.is_some()).await;
    assert_eq!(ended.state, JobState::Succeeded, "{:?}", ended.failure);
    shutdown.raise();
    worker.ended().await;
    let (body, _) = bench.store.model_file(job.model_id).await.unwrap();
    let inputs = train_model::inputs(&bench.store, job.model_id)
        .await
        .unwrap();
    let uncut = inputs.train(&JobContext::default()).unwrap();
    assert_eq!(body, uncut.body);
}

#[tokio::test(flavor = "multi_thread")]
async fn two_motions_in_one_task_fail_with_words_and_advice() {
    let mut bench = Bench::new().await;
    let takes = vec![
        bench.take(2.0, UP).await,
        bench.take(2.1, UP).await,
        bench.take(2.0, ACROSS).await,
        bench.take(2.1, ACROSS).await,
    ];
    let job = bench.ask(takes).await;
    let (worker, shutdown) = bench.worker();
    let ended = bench.heard(|job| job.finished_at.is_some()).await;
    let failure = ended.failure.unwrap();
    assert_eq!(failure.code, "demonstrations_different_motions");
    assert!(failure.message.contains("take 3") && !failure.advice.is_empty());
    shutdown.raise();
    worker.ended().await;
    assert_eq!(
        bench.store.model(job.model_id).await.unwrap().state,
        ModelState::Failed
    );
}

#[tokio::test]
async fn work_left_running_by_a_crash_waits_again() {
    let bench = Bench::new().await;
    let takes = vec![bench.take(2.0, UP).await];
    let job = bench.ask(takes).await;
    bench
        .queue
        .claim("a worker that died")
        .await
        .unwrap()
        .unwrap();
    assert!(bench.queue.claim("another").await.unwrap().is_none());
    assert_eq!(bench.queue.recover().await.unwrap(), 1);
    let (again, ..) = bench.queue.claim("another").await.unwrap().unwrap();
    assert_eq!((again.id, again.attempt), (job.id, 2));
}

#[test]
fn a_program_error_is_tried_once_more_and_then_told() {
    assert!(matches!(panicked(1), JobError::Retry(_)));
    assert!(matches!(panicked(2), JobError::Fail(failure) if failure.code == "internal_error"));
}

#[test]
fn a_job_rests_longer_from_attempt_to_attempt() {
    let rests: Vec<i64> = (1..=4).map(back_off_ms).collect();
    assert_eq!(rests, [1_000, 10_000, 60_000, 60_000]);
}
