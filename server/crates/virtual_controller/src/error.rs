//! The errors of starting a virtual controller and of reading its fault scripts.

use std::net::SocketAddr;

/// Why a virtual controller cannot start, or a script cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// Robot Web Services cannot listen.
    #[error("Robot Web Services cannot listen on {address}: {source}")]
    Listen {
        /// The address asked for.
        address: SocketAddr,
        /// What the system said.
        source: std::io::Error,
    },
    /// The certificate cannot be made.
    #[error("the certificate cannot be made: {0}")]
    Certificate(String),
    /// The control thread cannot be started.
    #[error("the control thread cannot be started: {0}")]
    Thread(std::io::Error),
    /// The configuration makes no sense.
    #[error("{key} is {value}: {rule}")]
    Config {
        /// Name of the entry.
        key: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        rule: &'static str,
    },
    /// The text is no fault script.
    #[error("this is no fault script: {0}")]
    Script(serde_json::Error),
    /// A fault of a script makes no sense.
    #[error("fault {number} of the script: {rule}")]
    ScriptedFault {
        /// Which one, from 1.
        number: usize,
        /// What is allowed.
        rule: &'static str,
    },
}
