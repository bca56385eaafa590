//! The cell: which robots the server works with, read from a configuration file or, without one,
//! from the command line.
//!
//! Here is what is known of a robot before it is started, and the words for a file that can't be
//! used. Not here: starting them (`app`), and what they do then (`arms`).

mod address;
mod check;
mod file;
#[cfg(test)]
mod tests;

use std::fmt;
use std::net::{Ipv4Addr, SocketAddr};
use std::path::{Path, PathBuf};
use std::time::Duration;

use motion::limits::RobotLimits;
use robot::{RobotConfig, RobotKind, SignalConfig};

use crate::config::{Config, RobotChoice};

/// A robot as it is configured.
#[derive(Clone, Debug)]
pub struct RobotSettings {
    /// What requests call it: lower-case letters, digits and hyphens.
    pub id: String,
    /// What people call it.
    pub name: String,
    /// Which arm it is.
    pub kind: RobotKind,
    /// Where its controller's EGM messages are awaited.
    pub egm_listen: SocketAddr,
    /// How its controller is reached; a virtual robot brings its own.
    pub controller: Option<Controller>,
    /// What it may do.
    pub limits: RobotLimits,
    /// Whether it may move without anybody holding a button.
    pub continuous_run: bool,
    /// The signals that people may work on it.
    pub signals: Vec<SignalConfig>,
    /// Silence on the control link after which a motion has failed.
    pub silence: Duration,
}

/// How a controller's web services are reached.
#[derive(Clone, Debug)]
pub struct Controller {
    /// Their address.
    pub rws_url: String,
    /// The account and its password; without them the factory's account is used.
    pub account: Option<Account>,
    /// The fingerprint (SHA-256) of the only certificate that is trusted, as 64 lower-case
    /// hexadecimal digits.
    pub certificate_sha256: Option<String>,
}

/// An account of a controller.
#[derive(Clone, Debug)]
pub struct Account {
    /// Its name.
    pub user: String,
    /// Its password.
    pub password: Secret,
}

/// A text that is never printed.
#[derive(Clone)]
pub struct Secret(String);

impl fmt::Debug for Secret {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("[secret]")
    }
}

/// Why a configuration file can't be used.
#[derive(Debug, thiserror::Error)]
pub enum CellError {
    /// It can't be read.
    #[error("the configuration file {file} can't be read: {source}; check the name after --config")]
    Unreadable {
        /// Which one.
        file: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// Something in it is wrong.
    #[error("{}, line {line}{}: {what}; {advice}", .file.display(), in_field(.field))]
    Wrong {
        /// Which file.
        file: PathBuf,
        /// Where in it, from 1.
        line: usize,
        /// Which field; empty when it is about no single one.
        field: String,
        /// What is wrong.
        what: String,
        /// What to do.
        advice: String,
    },
}

fn in_field(field: &str) -> String {
    if field.is_empty() {
        String::new()
    } else {
        format!(", {field}")
    }
}

/// The robots of this configuration; at least one.
///
/// # Errors
/// When the configuration file can't be read or used.
pub fn robots(config: &Config) -> Result<Vec<RobotSettings>, CellError> {
    match &config.config {
        Some(file) => read(file),
        None => Ok(vec![without_file(config)]),
    }
}

/// The robots that a configuration file names.
///
/// # Errors
/// When the file can't be read or something in it is wrong.
pub fn read(file: &Path) -> Result<Vec<RobotSettings>, CellError> {
    let text = std::fs::read_to_string(file).map_err(|source| CellError::Unreadable {
        file: file.to_owned(),
        source,
    })?;
    let environment = |name: &str| std::env::var(name).ok();
    check::robots(&check::Source::new(file, &text, &environment))
}

/// Everything on this computer, as the command line says.
fn without_file(config: &Config) -> RobotSettings {
    let (id, name, kind) = match config.robot {
        RobotChoice::Virtual => ("virtual", "Virtual robot", RobotKind::Virtual),
        RobotChoice::None => ("none", "No robot", RobotKind::None),
    };
    // The virtual arm is on this computer, and nobody else has any business at its port.
    let egm_listen = SocketAddr::from((Ipv4Addr::LOCALHOST, config.egm_port));
    RobotSettings {
        id: id.to_owned(),
        name: name.to_owned(),
        kind,
        egm_listen,
        controller: None,
        limits: RobotLimits::gofa5(),
        continuous_run: true,
        signals: RobotConfig::new(kind, egm_listen).signals,
        silence: RobotConfig::new(kind, egm_listen).silence,
    }
}

impl RobotSettings {
    /// The same for the robot's own side.
    pub fn robot_config(&self) -> RobotConfig {
        let mut config = RobotConfig::new(self.kind, self.egm_listen);
        config.silence = self.silence;
        config.limits = self.limits.clone();
        config.signals.clone_from(&self.signals);
        if let Some(controller) = &self.controller {
            config.rws_url = Some(controller.rws_url.clone());
            config
                .rws_certificate_sha256
                .clone_from(&controller.certificate_sha256);
            if let Some(account) = &controller.account {
                config.rws_user.clone_from(&account.user);
                config.rws_password.clone_from(&account.password.0);
            }
        }
        config
    }
}
