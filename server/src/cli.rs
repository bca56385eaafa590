//! The command line beside the server: training, reproduction and
//! evaluation on files, a look at the links to a controller, and the virtual robot by itself.

pub mod doctor;
pub mod evaluate;
mod folder;
pub mod reproduce;
mod terminal;
pub mod train;
pub mod virtual_robot;

/// Why a command failed; printed to people, with what to do about it.
#[derive(Debug, thiserror::Error)]
pub enum CliError {
    /// A file or folder that cannot be read or written.
    #[error("{path}: {source}")]
    File {
        /// The path as given.
        path: String,
        /// What the system says.
        source: std::io::Error,
    },
    /// A folder without recordings.
    #[error(
        "{path}: no recordings (.json or .csv) in this folder\nGive the folder that holds the demonstrations of one task."
    )]
    NoRecordings {
        /// The path as given.
        path: String,
    },
    /// An option that makes no sense.
    #[error("{0}")]
    Usage(String),
    /// A file that is no model.
    #[error("{path}: {error}\n{}", .error.advice())]
    Model {
        /// The path as given.
        path: String,
        /// What is wrong with it.
        error: learning::Error,
    },
    /// The library refused.
    #[error("{error}\n{}", error.advice())]
    Learning {
        /// What it refused.
        #[from]
        error: learning::Error,
    },
    /// Something between this computer and a controller is not as it should be.
    #[error("{failed} of {all} checks failed")]
    Unwell {
        /// So many.
        failed: usize,
        /// Of so many.
        all: usize,
    },
    /// The virtual robot did not start, or its script makes no sense.
    #[error("the virtual robot does not start: {0}")]
    VirtualRobot(#[from] virtual_controller::Error),
    /// Threads could not be started.
    #[error("the worker threads could not be started: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
}

impl CliError {
    fn file(path: &std::path::Path) -> impl FnOnce(std::io::Error) -> CliError {
        let path = path.display().to_string();
        move |source| CliError::File { path, source }
    }
}
