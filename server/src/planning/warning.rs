//! What people should know about a motion that may run.

/// A remark on a planned motion: in words for people, by code and place for programs.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Warning {
    /// The start or goal lies far outside what was taught.
    #[error(
        "The {which} is {off_deg:.0}° from what you taught at joint {joint}. Watch the arm closely."
    )]
    FarFromTaught {
        /// "start" or "goal".
        which: &'static str,
        /// The joint that is furthest off, from 1.
        joint: usize,
        /// By how much, degrees.
        off_deg: f64,
    },
    /// The learned path misses the demonstrations by more than they differ.
    #[error(
        "The learned path runs {mean_mm:.0} mm from what you showed on average, {max_mm:.0} mm at worst: more than your takes differ from each other."
    )]
    MissesTheTakes {
        /// On average, millimetres.
        mean_mm: f64,
        /// At worst, millimetres.
        max_mm: f64,
    },
    /// The limits made it slower than asked for.
    #[error(
        "The motion runs {factor:.1} times slower than you asked for, to stay within the speed limits."
    )]
    Slowed {
        /// How many times.
        factor: f64,
    },
    /// It passes close to the wrist's singularity.
    #[error("The wrist passes through its stretched pose (joint 5 near 0°).")]
    StretchedWrist,
    /// There is no arm to run it.
    #[error("No arm is connected: this can be looked at, not run.")]
    NoArm,
    /// A joint stands whole turns from the taught start.
    #[error(
        "Joint {joint} stands a whole turn from what you taught; the goal is taken at the same turn."
    )]
    WholeTurn {
        /// Joint, from 1.
        joint: usize,
    },
    /// A joint turns more than half a turn further than taught.
    #[error(
        "Joint {joint} turns {further_deg:.0}° further on its way than you taught. Watch the arm and its cables closely."
    )]
    TurnsFurther {
        /// Joint, from 1.
        joint: usize,
        /// How much further, degrees.
        further_deg: f64,
    },
    /// A signal stands otherwise than the demonstrations began with.
    #[error(
        "{label}: when the arm has reached the start, it will {does} first, as you showed it. Make sure that nothing can fall or be caught."
    )]
    SignalStandsOtherwise {
        /// What people call the signal.
        label: String,
        /// What setting it does.
        does: String,
    },
    /// The motion sets a signal that this server may not set.
    #[error(
        "The motion works the signal {name}, which this server may not set: it cannot be started."
    )]
    SignalUnknown {
        /// The controller's name of it.
        name: String,
    },
}

impl Warning {
    /// A stable name for programs.
    pub fn code(&self) -> &'static str {
        match self {
            Warning::FarFromTaught { .. } => "far_from_taught",
            Warning::MissesTheTakes { .. } => "misses_the_takes",
            Warning::Slowed { .. } => "slowed",
            Warning::StretchedWrist => "stretched_wrist",
            Warning::NoArm => "no_arm",
            Warning::WholeTurn { .. } => "whole_turn",
            Warning::TurnsFurther { .. } => "turns_further",
            Warning::SignalStandsOtherwise { .. } => "signal_stands_otherwise",
            Warning::SignalUnknown { .. } => "signal_unknown",
        }
    }
}
