//! What goes into the session rules and what comes out of them.

use crate::wire::Correction;
use motion::JointAngles;

/// Numbers that the rules need.
#[derive(Debug, Clone, PartialEq)]
pub struct SessionConfig {
    /// Silence after which the next message begins a new session, µs.
    pub timeout_us: u64,
    /// Time between two messages from which on the later one counts as late, µs.
    pub late_after_us: u64,
    /// Messages that may be missing in a row without an armed session being braked.
    pub max_lost: i32,
    /// By how much the reference's time may advance from one answer to the next, µs. The arm
    /// went on while messages were lost, and the reference with it.
    pub max_advance_us: u64,
    /// How long setpoints are let through after something odd, so that the arm comes to rest on
    /// its path instead of being held at once, µs.
    pub brake_us: u64,
    /// Largest speed of a reference, joints 1 to 6, deg/s.
    pub max_speed_deg_s: [f64; 6],
}

impl SessionConfig {
    /// Rounding must not make the guard against jumps refuse a motion at its speed limit.
    pub(crate) const MARGIN: f64 = 0.05;
    const ROUNDING_DEG: f64 = 1e-6;

    /// Farthest that one joint's reference may go in `elapsed_s`, degrees.
    #[must_use]
    pub fn largest_step_deg(&self, max_speed_deg_s: f64, elapsed_s: f64) -> f64 {
        max_speed_deg_s * elapsed_s * (1.0 + Self::MARGIN) + Self::ROUNDING_DEG
    }
}

/// Why a session began.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Beginning {
    /// The first message ever.
    First,
    /// The controller began to count from 0 again.
    Restarted,
    /// The counter went back.
    WentBack,
    /// The counter went ahead by more than messages can have been lost.
    SequenceJumped,
    /// The messages come from another address.
    SourceChanged,
    /// No message for longer than the time-out.
    Silence,
}

/// Why an answer does not carry the setpoint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hold {
    /// Nobody has armed the session.
    NotArmed,
    /// Nobody gave a setpoint.
    NoSetpoint,
    /// The controller does not apply references at present.
    NotApplied,
    /// The message lacks the measured pose, its number or the states, or does not come from a
    /// robot.
    Incomplete,
    /// More messages were lost than may be.
    Gap,
    /// The number of the message is not higher than that of the one before, and it is no copy
    /// that came right behind it.
    OutOfOrder,
    /// The messages go on from another address.
    Moved,
    /// The measured pose is farther from the last one than the arm can have gone.
    Implausible,
    /// Another address sends messages of a robot.
    Stranger,
    /// The setpoint is NaN or infinite.
    NotFinite,
    /// The setpoint is farther from the last one than the arm can go meanwhile.
    Jump,
}

/// What one message said.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Received {
    /// Set when the message began a session; everything that was armed is void then.
    pub began: Option<Beginning>,
    /// Measured joint angles; those of the last complete message when this one is not.
    pub measured: JointAngles,
    /// Motors on, program running or undefined, references applied.
    pub may_be_commanded: bool,
    /// The controller reports an error of its external motion interface.
    pub mci_error: bool,
    /// The controller reports motors on.
    pub motors_on: bool,
    /// What is odd about this message.
    pub hold: Option<Hold>,
    /// Setpoints still go through, for the arm to be brought to rest.
    pub brakes: bool,
    /// Messages missing right before this one.
    pub lost: u32,
    /// It came late.
    pub late: bool,
    /// The controller reports that its program runs.
    pub rapid_running: bool,
    /// How much of what the arm can do the latest reference needs, percent.
    pub utilization_percent: Option<f64>,
    /// Time since the session began, µs.
    pub session_age_us: u64,
}

/// The answer to one message.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Answer {
    /// To be encoded and sent to the message's source.
    pub correction: Correction,
    /// Why it is not the setpoint, if it is not.
    pub held: Option<Hold>,
}

/// Counted since the start of the program.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Counters {
    /// Messages received.
    pub cycles: u64,
    /// Messages that never came, by their numbers.
    pub lost: u64,
    /// Messages that came with the number of their predecessor.
    pub repeated: u64,
    /// Messages that came late.
    pub late: u64,
    /// Sessions begun.
    pub sessions: u64,
    /// Setpoints refused because they were no numbers or jumped.
    pub refused: u64,
}
