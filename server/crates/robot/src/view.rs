//! What everyone may see of the robot.

use crate::config::RobotKind;
use crate::error::Fault;
use crate::guidance::HandActivity;
use crate::run::RunProgress;
use crate::signals::SignalView;
use serde::Serialize;

/// What the robot does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RobotState {
    /// The controller does not answer.
    Disconnected,
    /// Nothing; ready.
    Idle,
    /// The arm is soft and a person moves it.
    Guiding,
    /// A plan is being run.
    Reproducing,
    /// It comes to a standstill.
    Stopping,
    /// A person has to acknowledge a fault.
    Faulted,
}

impl RobotState {
    /// For a sentence.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Self::Disconnected => "not connected",
            Self::Idle => "preparing",
            Self::Guiding => "being guided by hand",
            Self::Reproducing => "running a motion",
            Self::Stopping => "stopping",
            Self::Faulted => "waiting for a fault to be acknowledged",
        }
    }
}

/// The link on which the arm is controlled.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct EgmView {
    /// A message came within the last 100 ms.
    pub connected: bool,
    /// Messages received.
    pub cycles: u64,
    /// Messages that never came.
    pub lost: u64,
    /// Messages that came late.
    pub late: u64,
    /// The control thread was given the priority it asked for.
    pub real_time: bool,
}

/// The robot at one moment.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RobotView {
    /// Which arm there is.
    pub kind: RobotKind,
    /// What it does.
    pub state: RobotState,
    /// Measured joint angles, deg; nothing until the first measurement.
    pub joints_deg: Option<[f64; 6]>,
    /// Position of the tool's centre point in the base frame, mm.
    pub tcp_mm: Option<[f64; 3]>,
    /// Age of the joint angles, ms.
    pub age_ms: u64,
    /// Motors on or off, if known.
    pub motors_on: Option<bool>,
    /// Mode switch in words, if known.
    pub operating_mode: Option<String>,
    /// Whether the arm is soft, if known.
    pub lead_through: Option<bool>,
    /// The control link.
    pub egm: EgmView,
    /// What the virtual hand does, while guiding the virtual arm.
    pub hand: Option<HandActivity>,
    /// What has to be acknowledged.
    pub fault: Option<Fault>,
    /// Where the present run is.
    pub run: Option<RunProgress>,
    /// The signals that may be worked.
    pub signals: Vec<SignalView>,
}

impl RobotView {
    pub(crate) fn new(kind: RobotKind) -> Self {
        Self {
            kind,
            state: RobotState::Disconnected,
            joints_deg: None,
            tcp_mm: None,
            age_ms: 0,
            motors_on: None,
            operating_mode: None,
            lead_through: None,
            egm: EgmView::default(),
            hand: None,
            fault: None,
            run: None,
            signals: Vec::new(),
        }
    }
}
