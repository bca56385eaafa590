//! Durable background work: a queue of leased jobs and the threads that do them.
//!
//! Not here: SQL (`store::jobs`) and the method itself (crate `learning`).

mod context;
mod queue;
#[cfg(test)]
mod tests;
mod train_model;
mod worker;

use context::JobContext;
pub use queue::{Queue, TrainingRequest};
pub(crate) use train_model::{demonstration_of, demonstration_with};
pub use worker::Worker;

use crate::store::{self, text::Failure};

/// Why a job did not do its work.
#[derive(Debug, thiserror::Error)]
pub enum JobError {
    /// It may work the next time.
    #[error("{0}")]
    Retry(String),
    /// It will never work with these inputs.
    #[error("{}", .0.message)]
    Fail(Failure),
    /// It was called off.
    #[error("called off")]
    Cancelled,
}

impl From<store::Error> for JobError {
    fn from(error: store::Error) -> Self {
        match error {
            store::Error::Database(_) => Self::Retry(error.to_string()),
            _ => Self::Fail(Failure {
                code: "recording_damaged".into(),
                message: format!("A demonstration could not be read: {error}."),
                advice: "Discard that demonstration and record it again.".into(),
            }),
        }
    }
}

impl From<learning::Error> for JobError {
    fn from(error: learning::Error) -> Self {
        match error {
            learning::Error::Cancelled => Self::Cancelled,
            _ => Self::Fail(Failure {
                code: error.code().into(),
                message: error.to_string(),
                advice: error.advice().into(),
            }),
        }
    }
}
