//! The queue: asking for work, calling it off, and writing down how it ended.

use std::collections::HashMap;
use std::sync::{Arc, Mutex};

use sha2::{Digest, Sha256};
use tokio::sync::Notify;

use super::JobContext;
use crate::clock::SharedClock;
use crate::events::Events;
use crate::ids::{JobId, TaskId};
use crate::store::jobs::{Job, JobProgress, NewTraining};
use crate::store::leases::Lease;
use crate::store::models::{Model, Source, TrainedModel};
use crate::store::text::Failure;
use crate::store::{Result, Store};

/// How long a worker holds a job without renewing its lease.
pub(super) const LEASE_MS: i64 = 30_000;
/// How often a job may be begun before it counts as one that breaks the server.
const MAX_ATTEMPTS: u32 = 5;

/// A training that somebody asks for.
#[derive(Clone, Debug)]
pub struct TrainingRequest {
    /// The task.
    pub task_id: TaskId,
    /// What to train from, by take.
    pub sources: Vec<Source>,
    /// How to train.
    pub method: String,
    /// The seed of everything random.
    pub seed: u64,
}

impl TrainingRequest {
    /// The same for the same inputs, parameters and program.
    fn unique_key(&self) -> String {
        let mut hash = Sha256::new();
        hash.update(format!(
            "train_model {} {} {} {}",
            env!("CARGO_PKG_VERSION"),
            self.task_id,
            self.method,
            self.seed
        ));
        for Source { id, trim } in &self.sources {
            hash.update(format!(" {id}"));
            if let Some(trim) = trim {
                hash.update(format!(" {}-{}", trim.begin_us(), trim.end_us()));
            }
        }
        hex(&hash.finalize())
    }
}

/// Bytes in hexadecimal.
pub(super) fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The queue of background work. Cheap to clone.
#[derive(Clone)]
pub struct Queue(Arc<Inner>);

struct Inner {
    store: Store,
    events: Events,
    clock: SharedClock,
    wake: Notify,
    running: Mutex<HashMap<JobId, Arc<JobContext>>>,
}

impl Queue {
    /// A queue over the store's job table.
    pub fn new(store: Store, events: Events, clock: SharedClock) -> Self {
        Self(Arc::new(Inner {
            store,
            events,
            clock,
            wake: Notify::new(),
            running: Mutex::new(HashMap::new()),
        }))
    }

    /// At start-up: work that the last run left unfinished waits again.
    pub async fn recover(&self) -> Result<u64> {
        self.0.store.requeue_running_jobs().await
    }

    /// Asks for a training. The same again is the same job.
    pub async fn train(&self, request: &TrainingRequest) -> Result<(Job, Model)> {
        let new = NewTraining {
            task_id: request.task_id,
            sources: &request.sources,
            method: &request.method,
            seed: request.seed,
            unique_key: &request.unique_key(),
            max_attempts: MAX_ATTEMPTS,
        };
        let (job, model, is_new) = self
            .0
            .store
            .create_training(new, self.0.clock.now())
            .await?;
        if is_new {
            self.0.events.tell(&model);
            self.0.events.tell(&job);
            self.0.wake.notify_one();
        }
        Ok((job, model))
    }

    /// Calls a job off. One that has ended stays as it is.
    pub async fn cancel(&self, id: JobId) -> Result<Job> {
        let job = self.0.store.cancel_job(id, self.0.clock.now()).await?;
        if let Some(context) = self.running().get(&id) {
            context.cancel();
        }
        self.tell(&job).await;
        Ok(job)
    }

    /// Waits until there may be something to do.
    pub(super) async fn woken(&self) {
        self.0.wake.notified().await;
    }

    /// Takes the next job.
    pub(super) async fn claim(&self, token: &str) -> Result<Option<(Job, Lease, Arc<JobContext>)>> {
        let now = self.0.clock.now();
        let failure = Failure {
            code: "given_up".into(),
            message: "The server stopped again and again while it worked on this.".into(),
            advice: "Try once more; if it happens again, tell whoever looks after the server."
                .into(),
        };
        for job in self.0.store.fail_exhausted_jobs(&failure, now).await? {
            self.tell(&job).await;
        }
        let until = now.plus_ms(LEASE_MS);
        let Some((job, lease)) = self.0.store.claim_job(token, now, until).await? else {
            return Ok(None);
        };
        let context = Arc::new(JobContext::default());
        self.running().insert(job.id, Arc::clone(&context));
        self.0.events.tell(&job);
        Ok(Some((job, lease, context)))
    }

    /// The job is not worked on any more.
    pub(super) fn release(&self, id: JobId) {
        self.running().remove(&id);
    }

    /// Prolongs the lease. False: it is lost.
    pub(super) async fn renew(&self, lease: &Lease) -> Result<bool> {
        let until = self.0.clock.now().plus_ms(LEASE_MS);
        self.0.store.renew_lease(lease, until).await
    }

    /// Tells how far a job is, and writes it down when `durable`. False: the lease is lost.
    pub(super) async fn progress(
        &self,
        job: &mut Job,
        lease: &Lease,
        progress: JobProgress,
        durable: bool,
    ) -> Result<bool> {
        job.progress = progress;
        self.0.events.tell(&*job);
        if !durable {
            return Ok(true);
        }
        self.0.store.save_progress(lease, &job.progress).await
    }

    /// Ends a training with its model.
    pub(super) async fn finish(&self, lease: &Lease, trained: &TrainedModel) -> Result<bool> {
        let now = self.0.clock.now();
        let written = self.0.store.finish_training(lease, trained, now).await?;
        self.tell_again(lease).await?;
        Ok(written)
    }

    /// Ends a job that came to nothing.
    pub(super) async fn fail(&self, lease: &Lease, failure: &Failure) -> Result<bool> {
        let now = self.0.clock.now();
        let written = self.0.store.fail_job(lease, failure, now).await?;
        self.tell_again(lease).await?;
        Ok(written)
    }

    /// Puts a job back for `wait_ms`; an attempt cut short by a shutdown does not count.
    pub(super) async fn put_back(
        &self,
        lease: &Lease,
        wait_ms: i64,
        attempt_counts: bool,
    ) -> Result<bool> {
        let not_before = self.0.clock.now().plus_ms(wait_ms);
        let written = self
            .0
            .store
            .return_job(lease, not_before, attempt_counts)
            .await?;
        self.tell_again(lease).await?;
        Ok(written)
    }

    /// The store that the jobs read from.
    pub(super) fn store(&self) -> &Store {
        &self.0.store
    }

    async fn tell_again(&self, lease: &Lease) -> Result<()> {
        let job = self.0.store.job(lease.job_id).await?;
        self.tell(&job).await;
        Ok(())
    }

    async fn tell(&self, job: &Job) {
        self.0.events.tell(job);
        match self.0.store.model(job.model_id).await {
            Ok(model) => self.0.events.tell(&model),
            Err(error) => tracing::warn!(job.id = %job.id, %error, "the job's model is not there"),
        }
    }

    fn running(&self) -> std::sync::MutexGuard<'_, HashMap<JobId, Arc<JobContext>>> {
        // The map is valid after every single operation, so a panic elsewhere can't spoil it.
        self.0
            .running
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}
