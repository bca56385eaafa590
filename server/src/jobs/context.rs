//! What a running job is given: a place to say how far it is, and the word to stop.

use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::store::jobs::JobProgress;

/// Shared between the thread that works and the task that watches over it.
#[derive(Default)]
pub struct JobContext {
    cancelled: AtomicBool,
    latest: Mutex<Option<JobProgress>>,
}

impl JobContext {
    /// Says how far the work is, and hears whether it is still wanted.
    pub fn report(&self, progress: JobProgress) -> ControlFlow<()> {
        if let Ok(mut latest) = self.latest.lock() {
            *latest = Some(progress);
        }
        if self.is_cancelled() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// The work is not wanted any more.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Whether the work is not wanted any more.
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// What was reported since the last time this was asked.
    pub fn take_progress(&self) -> Option<JobProgress> {
        self.latest.lock().ok()?.take()
    }
}
