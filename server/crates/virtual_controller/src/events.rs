//! The controller's event log.

use std::collections::VecDeque;

use crate::arm::OutOfRange;
use crate::clock::WallTime;

/// So many events are kept; the oldest go first.
const CAPACITY: usize = 200;

/// Weight of an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// For information.
    Information,
    /// A warning.
    Warning,
    /// An error.
    Error,
}

/// One event.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Event {
    /// Counts from 1.
    pub number: u64,
    /// The controller's event code; its ten thousands are the domain.
    pub code: u32,
    /// Weight.
    pub severity: Severity,
    /// When.
    pub at: WallTime,
    /// What, in a few words.
    pub title: &'static str,
    /// What exactly.
    pub description: String,
}

impl Event {
    /// The log's domain: 1 operational, 4 program, 5 motion, 9 safety.
    #[must_use]
    pub fn domain(&self) -> u32 {
        self.code / 10_000
    }
}

/// Something that the controller logs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Incident {
    /// The motors were switched off.
    MotorsOff,
    /// The motors were switched on.
    MotorsOn,
    /// A guard stopped the arm.
    GuardStop,
    /// The program was started.
    ProgramStarted,
    /// The program was stopped.
    ProgramStopped,
    /// A start was accepted and then taken back.
    StartReverted,
    /// No reference came within the time given.
    NoData {
        /// That time, s.
        timeout_s: f64,
    },
    /// The EGM server's port is closed.
    SendRefused {
        /// Size of the message that could not be sent, bytes.
        bytes: usize,
    },
    /// EGM wanted a joint outside its range.
    OutOfRange(OutOfRange),
    /// The safety controller ended lead-through.
    ToolSpeedViolation,
}

impl Incident {
    fn code(&self) -> u32 {
        match self {
            Self::MotorsOff => 10_010,
            Self::MotorsOn => 10_011,
            Self::GuardStop => 10_012,
            Self::ProgramStopped => 10_125,
            Self::ProgramStarted => 10_151,
            Self::StartReverted => 10_020,
            Self::NoData { .. } => 41_822,
            Self::SendRefused { .. } => 41_830,
            Self::OutOfRange(_) => 50_453,
            Self::ToolSpeedViolation => 90_515,
        }
    }

    fn severity(&self) -> Severity {
        match self {
            Self::MotorsOff | Self::MotorsOn | Self::ProgramStarted | Self::ProgramStopped => {
                Severity::Information
            }
            Self::GuardStop => Severity::Warning,
            _ => Severity::Error,
        }
    }

    fn title(&self) -> &'static str {
        match self {
            Self::MotorsOff => "Motors OFF state",
            Self::MotorsOn => "Motors ON state",
            Self::GuardStop => "Safety guard stop state",
            Self::ProgramStarted => "Program started",
            Self::ProgramStopped => "Program stopped",
            Self::StartReverted => "Execution error state",
            Self::NoData { .. } => "No data from the UdpUc device",
            Self::SendRefused { .. } => "Error sending EGM UdpUc message",
            Self::OutOfRange(_) => "Move not allowed in External Motion Interface",
            Self::ToolSpeedViolation => "Tool speed violation",
        }
    }

    fn description(&self) -> String {
        match self {
            Self::StartReverted => "The start of the program was taken back.".to_owned(),
            Self::NoData { timeout_s } => {
                format!("No reference came within {timeout_s} s; the program is stopped.")
            }
            Self::SendRefused { bytes } => format!("-1 of {bytes} bytes were sent."),
            Self::OutOfRange(bad) => format!(
                "External Motion Interface input out of bounds: joint {} at {:.3} deg.",
                bad.joint, bad.angle_deg
            ),
            Self::ToolSpeedViolation => {
                "The safety controller ended lead-through: the tool moved too fast.".to_owned()
            }
            _ => self.title().to_owned(),
        }
    }
}

/// The events, oldest first.
#[derive(Clone, Debug, Default)]
pub struct EventLog {
    events: VecDeque<Event>,
    count: u64,
}

impl EventLog {
    /// Logs an incident and returns the event's domain and number.
    pub fn add(&mut self, incident: Incident, at: WallTime) -> (u32, u64) {
        self.count += 1;
        let event = Event {
            number: self.count,
            code: incident.code(),
            severity: incident.severity(),
            at,
            title: incident.title(),
            description: incident.description(),
        };
        let domain = event.domain();
        if self.events.len() == CAPACITY {
            self.events.pop_front();
        }
        self.events.push_back(event);
        (domain, self.count)
    }

    /// The events of a domain, newest first; domain 0 holds all.
    pub fn newest_first(&self, domain: u32) -> impl Iterator<Item = &Event> {
        self.events
            .iter()
            .rev()
            .filter(move |event| domain == 0 || event.domain() == domain)
    }
}
