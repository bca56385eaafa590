//! What this crate refuses or reports, in words for the person at the arm.

use crate::view::RobotState;
use rws::RwsError;
use serde::Serialize;

/// Something that a person has to look at.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Fault {
    /// For machines.
    pub code: &'static str,
    /// What happened.
    pub message: String,
    /// What to do.
    pub advice: String,
}

impl Fault {
    pub(crate) fn new(
        code: &'static str,
        message: impl Into<String>,
        advice: impl Into<String>,
    ) -> Self {
        Self {
            code,
            message: message.into(),
            advice: advice.into(),
        }
    }
}

/// Why a request was refused.
#[derive(Debug, thiserror::Error)]
pub enum RobotError {
    /// The server runs without an arm.
    #[error("this server has no robot")]
    NoRobot,
    /// The controller cannot be reached.
    #[error("the robot is not connected")]
    Disconnected,
    /// The arm does something else.
    #[error("the robot is busy ({})", .state.words())]
    Busy {
        /// What it does.
        state: RobotState,
    },
    /// A fault waits for a person.
    #[error("the robot stopped after a fault: {}", .0.message)]
    Faulted(Fault),
    /// Where the arm stands is not known, or not known recently enough.
    #[error("the robot has not reported where the arm stands")]
    PoseUnknown,
    /// The arm does not stand where the plan begins.
    #[error("joint {} stands {difference_deg:.1}° away from where the motion begins", joint + 1)]
    ArmMoved {
        /// Joint, from 0.
        joint: usize,
        /// How far it is away, deg.
        difference_deg: f64,
    },
    /// The mode switch is not at automatic.
    #[error("the controller is in {mode} mode")]
    NotAutomatic {
        /// The mode.
        mode: String,
    },
    /// A stop is active, or the controller is not ready.
    #[error("the motors cannot be switched on: {reason}")]
    NotReady {
        /// Why.
        reason: &'static str,
    },
    /// The motors stayed off.
    #[error("the motors did not switch on")]
    MotorsStayOff,
    /// Only while the arm is being guided.
    #[error("the arm is not being guided")]
    NotGuiding,
    /// Only while a motion runs.
    #[error("no motion is running")]
    NotRunning,
    /// A speed that is not allowed.
    #[error("{:.0} % is no speed for a motion", share * 100.0)]
    BadSpeed {
        /// As asked for.
        share: f64,
    },
    /// No such signal is configured.
    #[error("there is no signal {name} that may be set")]
    SignalUnknown {
        /// What was asked for.
        name: String,
    },
    /// The controller accepted it, and the signal did not change.
    #[error("\"{label}\" did not {wish}")]
    SignalNotSet {
        /// What people call the signal.
        label: String,
        /// What it was to do.
        wish: String,
    },
    /// Stopped by a person before it began.
    #[error("it was stopped before it began")]
    Stopped,
    /// The controller said no, or nothing.
    #[error(transparent)]
    Controller(#[from] RwsError),
    /// The EGM port is not available.
    #[error("the EGM port {address} is not available: {source}")]
    Bind {
        /// As configured.
        address: std::net::SocketAddr,
        /// The system's words.
        source: std::io::Error,
    },
    /// The server is shutting down.
    #[error("the server is shutting down")]
    ShuttingDown,
}

impl RobotError {
    /// A stable word for machines.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::NoRobot => "no_robot",
            Self::Disconnected => "robot_disconnected",
            Self::Busy { .. } => "robot_busy",
            Self::Faulted(_) => "robot_faulted",
            Self::PoseUnknown => "robot_pose_unknown",
            Self::ArmMoved { .. } => "arm_moved",
            Self::NotAutomatic { .. } => "robot_not_automatic",
            Self::NotReady { .. } => "robot_not_ready",
            Self::MotorsStayOff => "motors_off",
            Self::NotGuiding => "robot_not_guiding",
            Self::NotRunning => "robot_not_running",
            Self::BadSpeed { .. } => "bad_speed",
            Self::SignalUnknown { .. } => "signal_unknown",
            Self::SignalNotSet { .. } => "signal_not_set",
            Self::Stopped => "stopped",
            Self::Controller(error) => error.code(),
            Self::Bind { .. } => "egm_port",
            Self::ShuttingDown => "shutting_down",
        }
    }

    /// What a person can do about it.
    #[must_use]
    pub fn advice(&self) -> String {
        let advice = match self {
            Self::NoRobot => "Start the server with --robot virtual.",
            Self::Disconnected => {
                "Check that the controller is switched on and its network cable is plugged in."
            }
            Self::Busy { .. } => "Wait until it has finished, or press Stop.",
            Self::Faulted(fault) => return format!("{} Then acknowledge the fault.", fault.advice),
            Self::PoseUnknown => "Wait a moment and try again.",
            Self::ArmMoved { .. } => "Preview the motion again from where the arm stands now.",
            Self::NotAutomatic { .. } => "Turn the controller's mode switch to automatic.",
            Self::NotReady { .. } => "Release the stop and acknowledge it on the controller.",
            Self::MotorsStayOff => "Switch the motors on at the controller, then try again.",
            Self::NotGuiding => "Make the arm soft first.",
            Self::NotRunning => "Start a motion first.",
            Self::BadSpeed { .. } => "Choose a speed from 5 % to 100 %.",
            Self::SignalUnknown { .. } => {
                "Add the signal to the server's configuration, or train from takes without it."
            }
            Self::SignalNotSet { .. } => {
                "Check the signal on the FlexPendant: something else may hold it."
            }
            Self::Stopped => "Start it again when the arm may move.",
            Self::Controller(error) => error.advice(),
            Self::Bind { .. } => "Close the other program that uses the port, or choose another.",
            Self::ShuttingDown => "Start the server again.",
        };
        advice.to_owned()
    }

    /// The same as something to be acknowledged.
    pub(crate) fn to_fault(&self) -> Fault {
        Fault::new(self.code(), self.to_string(), self.advice())
    }
}
