//! The worker: one task that takes jobs, watches over their leases and reports how far they are,
//! and a pool of low-priority threads in which the work itself is done.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::Duration;

use rayon::{ThreadPool, ThreadPoolBuilder};
use tokio::sync::oneshot;
use tokio::task::JoinHandle;
use tokio::time::{Instant, MissedTickBehavior, interval};

use super::{JobContext, JobError, Queue, train_model};
use crate::shutdown::Shutdown;
use crate::store::jobs::Job;
use crate::store::leases::Lease;
use crate::store::models::TrainedModel;
use crate::store::text::Failure;
use crate::store::{self};

/// How often a watcher of the live socket hears of progress, at most.
const TELL_EVERY: Duration = Duration::from_millis(100);
const SAVE_EVERY: Duration = Duration::from_millis(500);
const RENEW_EVERY: Duration = Duration::from_secs(10);
/// How often the queue is looked at when nobody says that there is something new.
const LOOK_EVERY: Duration = Duration::from_secs(1);
/// A job that panics is tried this many times.
const PANIC_ATTEMPTS: u32 = 2;

/// The running worker.
pub struct Worker(JoinHandle<()>);

impl Worker {
    /// Starts the threads and the task that feeds them.
    ///
    /// # Errors
    /// When the operating system gives no threads.
    pub fn start(queue: Queue, shutdown: Shutdown) -> Result<Self, rayon::ThreadPoolBuildError> {
        let pool = Arc::new(pool()?);
        let running = Running {
            queue,
            pool,
            shutdown,
        };
        Ok(Self(tokio::spawn(running.run())))
    }

    /// Waits until the worker has put its job back and ended.
    pub async fn ended(self) {
        if let Err(error) = self.0.await {
            tracing::error!(%error, "the job worker broke off");
        }
    }
}

fn pool() -> Result<ThreadPool, rayon::ThreadPoolBuildError> {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    ThreadPoolBuilder::new()
        .num_threads(cores.saturating_sub(1).max(1))
        .thread_name(|index| format!("trainer-{index}"))
        .start_handler(|_| {
            // The real-time loop and the pages come first; without the permission training only
            // competes harder, so a refusal is no reason not to start.
            if let Err(error) = rustix::process::setpriority_process(None, 19) {
                tracing::warn!(%error, "training runs at normal priority");
            }
        })
        .build()
}

struct Running {
    queue: Queue,
    pool: Arc<ThreadPool>,
    shutdown: Shutdown,
}

type Outcome = Result<TrainedModel, JobError>;

impl Running {
    async fn run(self) {
        while !self.shutdown.is_raised() {
            let token = uuid::Uuid::now_v7().to_string();
            match self.queue.claim(&token).await {
                Ok(Some((job, lease, context))) => {
                    let id = job.id;
                    if let Err(error) = self.work(job, lease, context).await {
                        tracing::error!(job.id = %id, %error, "the end of a job could not be stored");
                    }
                    self.queue.release(id);
                }
                Ok(None) => self.wait().await,
                Err(error) => {
                    tracing::error!(%error, "the job queue could not be read");
                    self.wait().await;
                }
            }
        }
    }

    async fn wait(&self) {
        tokio::select! {
            () = self.queue.woken() => {}
            () = tokio::time::sleep(LOOK_EVERY) => {}
            () = self.shutdown.raised() => {}
        }
    }

    async fn work(
        &self,
        job: Job,
        lease: Lease,
        context: Arc<JobContext>,
    ) -> Result<(), store::Error> {
        tracing::info!(job.id = %job.id, job.attempt = job.attempt, "training begins");
        let attempt = job.attempt;
        let (answer, outcome) = oneshot::channel();
        match train_model::inputs(self.queue.store(), job.model_id).await {
            Ok(inputs) => {
                let context = Arc::clone(&context);
                self.pool.spawn(move || {
                    let outcome = catch_unwind(AssertUnwindSafe(|| inputs.train(&context)));
                    // Nobody listens any more when the lease was lost meanwhile.
                    let _ = answer.send(outcome.unwrap_or_else(|_| Err(panicked(attempt))));
                });
            }
            Err(error) => {
                let _ = answer.send(Err(error));
            }
        }
        let Some(outcome) = self.watch(job, &lease, &context, outcome).await? else {
            return Ok(());
        };
        self.close(attempt, &lease, outcome).await
    }

    /// Reports and renews until the work ends. None: the lease is lost, somebody else has the job.
    async fn watch(
        &self,
        mut job: Job,
        lease: &Lease,
        context: &JobContext,
        mut outcome: oneshot::Receiver<Outcome>,
    ) -> Result<Option<Outcome>, store::Error> {
        let mut tick = interval(TELL_EVERY);
        tick.set_missed_tick_behavior(MissedTickBehavior::Delay);
        let (mut saved, mut renewed) = (Instant::now(), Instant::now());
        let mut held = true;
        loop {
            tokio::select! {
                ended = &mut outcome => {
                    let ended = ended.unwrap_or_else(|_| Err(panicked(job.attempt)));
                    return Ok(held.then_some(ended));
                }
                () = self.shutdown.raised(), if !context.is_cancelled() => context.cancel(),
                _ = tick.tick() => {}
            }
            if context.is_cancelled() {
                continue;
            }
            if let Some(progress) = context.take_progress() {
                let durable = saved.elapsed() >= SAVE_EVERY;
                if durable {
                    saved = Instant::now();
                }
                held &= self
                    .queue
                    .progress(&mut job, lease, progress, durable)
                    .await?;
            }
            if renewed.elapsed() >= RENEW_EVERY {
                renewed = Instant::now();
                held &= self.queue.renew(lease).await?;
            }
            if !held {
                context.cancel();
            }
        }
    }

    async fn close(
        &self,
        attempt: u32,
        lease: &Lease,
        outcome: Outcome,
    ) -> Result<(), store::Error> {
        let job_id = lease.job_id;
        match outcome {
            Ok(trained) => {
                if self.queue.finish(lease, &trained).await? {
                    tracing::info!(job.id = %job_id, summary = %trained.summary, "training ended");
                }
            }
            Err(JobError::Cancelled) if self.shutdown.is_raised() => {
                self.queue.put_back(lease, 0, false).await?;
            }
            Err(JobError::Cancelled) => tracing::info!(job.id = %job_id, "training called off"),
            Err(JobError::Retry(reason)) => {
                tracing::warn!(job.id = %job_id, %reason, "training will be tried again");
                self.queue
                    .put_back(lease, back_off_ms(attempt), true)
                    .await?;
            }
            Err(JobError::Fail(failure)) => {
                tracing::info!(job.id = %job_id, code = %failure.code, "training failed");
                self.queue.fail(lease, &failure).await?;
            }
        }
        Ok(())
    }
}

/// How long a job rests after its n-th attempt.
pub(super) fn back_off_ms(attempt: u32) -> i64 {
    match attempt {
        0 | 1 => 1_000,
        2 => 10_000,
        _ => 60_000,
    }
}

pub(super) fn panicked(attempt: u32) -> JobError {
    if attempt < PANIC_ATTEMPTS {
        return JobError::Retry("the training broke off with a program error".into());
    }
    JobError::Fail(Failure {
        code: "internal_error".into(),
        message: "The training broke off because of an error in the program.".into(),
        advice: "Your demonstrations are safe. Tell whoever looks after the server.".into(),
    })
}
