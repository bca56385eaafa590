//! The panel: motors, operating mode, speed ratio.

use crate::hal::Entries;
use crate::{Client, RwsError};

/// State of the controller's motors and stops.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ControllerState {
    /// Starting up.
    Init,
    /// Motors off, ready to be switched on.
    MotorsOff,
    /// Motors on.
    MotorsOn,
    /// A guard (light curtain, door, safe speed) stopped the arm.
    GuardStop,
    /// An emergency stop is pressed.
    EmergencyStop,
    /// The emergency stop was released and waits to be acknowledged.
    EmergencyStopReset,
    /// The controller failed.
    SystemFailure,
    /// A word this client does not know.
    Other(String),
}

impl ControllerState {
    pub(crate) fn from_wire(word: &str) -> Self {
        match word.to_ascii_lowercase().as_str() {
            "init" => Self::Init,
            "motoroff" => Self::MotorsOff,
            "motoron" => Self::MotorsOn,
            "guardstop" => Self::GuardStop,
            "emergencystop" => Self::EmergencyStop,
            "emergencystopreset" => Self::EmergencyStopReset,
            "sysfail" => Self::SystemFailure,
            _ => Self::Other(word.to_owned()),
        }
    }
}

/// Position of the controller's mode switch.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum OperatingMode {
    /// Automatic.
    Auto,
    /// Manual with reduced speed.
    ManualReduced,
    /// Manual with full speed.
    ManualFull,
    /// A word this client does not know.
    Other(String),
}

impl OperatingMode {
    // Real controllers write this in capitals, others do not.
    pub(crate) fn from_wire(word: &str) -> Self {
        match word.to_ascii_lowercase().as_str() {
            "auto" => Self::Auto,
            "manr" => Self::ManualReduced,
            "manf" => Self::ManualFull,
            _ => Self::Other(word.to_owned()),
        }
    }
}

impl std::fmt::Display for OperatingMode {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::Auto => "automatic",
            Self::ManualReduced => "manual",
            Self::ManualFull => "manual full speed",
            Self::Other(word) => word,
        })
    }
}

impl Client {
    /// Reads the state of motors and stops.
    ///
    /// # Errors
    /// As for every call.
    pub async fn controller_state(&self) -> Result<ControllerState, RwsError> {
        let word = self
            .panel_field("/rw/panel/ctrl-state", "ctrlstate")
            .await?;
        Ok(ControllerState::from_wire(&word))
    }

    /// Switches the motors. Automatic mode is needed, and no stop may be active.
    ///
    /// # Errors
    /// [`RwsError::Refused`] when the controller will not.
    pub async fn set_motors(&self, on: bool) -> Result<(), RwsError> {
        let state = if on { "motoron" } else { "motoroff" };
        self.post("/rw/panel/ctrl-state", &[("ctrl-state", state)])
            .await
            .map(|_| ())
    }

    /// Reads the mode switch.
    ///
    /// # Errors
    /// As for every call.
    pub async fn operating_mode(&self) -> Result<OperatingMode, RwsError> {
        let word = self.panel_field("/rw/panel/opmode", "opmode").await?;
        Ok(OperatingMode::from_wire(&word))
    }

    /// Reads the speed override in percent.
    ///
    /// # Errors
    /// As for every call.
    pub async fn speed_ratio_percent(&self) -> Result<f64, RwsError> {
        let path = "/rw/panel/speedratio";
        let text = self.get(path).await?;
        Entries::parse(path, &text)?
            .with_field("speedratio")?
            .number("speedratio")
    }

    async fn panel_field(&self, path: &str, field: &str) -> Result<String, RwsError> {
        let text = self.get(path).await?;
        Entries::parse(path, &text)?.with_field(field)?.text(field)
    }
}
