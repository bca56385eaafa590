//! How the robot side is set up.

use crate::signals::SignalConfig;
use motion::limits::RobotLimits;
use serde::{Deserialize, Serialize};
use std::net::SocketAddr;
use std::time::Duration;

/// Which arm there is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum RobotKind {
    /// The virtual GoFa.
    Virtual,
    /// A GoFa with its own controller.
    Gofa,
    /// No arm: everything that needs one is refused.
    None,
}

/// The whole configuration of [`crate::Robot`]. It can not be printed, because it holds a password.
#[derive(Clone)]
pub struct RobotConfig {
    /// Which arm there is.
    pub kind: RobotKind,
    /// Address on which the controller's EGM messages are awaited; port 0 takes a free one.
    pub egm_listen: SocketAddr,
    /// Address of the controller's web services, `https://host:port` or `http://host:port`. Without it the robot stays
    /// disconnected until [`crate::Robot::connect`] is called.
    pub rws_url: Option<String>,
    /// Controller account.
    pub rws_user: String,
    /// Its password.
    pub rws_password: String,
    /// Fingerprint of the web services' certificate; see [`rws::Config::certificate_sha256`].
    pub rws_certificate_sha256: Option<String>,
    /// Longest wait for one answer of the web services.
    pub rws_timeout: Duration,
    /// Longest wait for the controller to apply references after its program was started.
    pub session_timeout: Duration,
    /// Silence on the control link after which a run has failed.
    pub silence: Duration,
    /// Ask the system for real-time priority for the control loop, and not only for the highest
    /// ordinary one.
    pub real_time: bool,
    /// What the arm is allowed to do.
    pub limits: RobotLimits,
    /// The signals that people may work and motions may set.
    pub signals: Vec<SignalConfig>,
}

impl RobotConfig {
    /// A GoFa with the factory account; the web services' address is still missing.
    #[must_use]
    pub fn new(kind: RobotKind, egm_listen: SocketAddr) -> Self {
        let account = rws::Config::new("");
        Self {
            kind,
            egm_listen,
            rws_url: None,
            rws_user: account.user,
            rws_password: account.password,
            rws_certificate_sha256: None,
            rws_timeout: Duration::from_secs(1),
            session_timeout: Duration::from_secs(5),
            silence: match kind {
                // The virtual controller shares the processor with everything else on a busy
                // machine; a real one does not, and 100 ms are 25 of its cycles.
                RobotKind::Virtual => Duration::from_millis(500),
                RobotKind::Gofa | RobotKind::None => Duration::from_millis(100),
            },
            real_time: true,
            limits: RobotLimits::gofa5(),
            signals: match kind {
                RobotKind::Virtual => vec![SignalConfig::virtual_gripper()],
                RobotKind::Gofa | RobotKind::None => Vec::new(),
            },
        }
    }
}
