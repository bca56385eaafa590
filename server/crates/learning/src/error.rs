//! The one error type of this crate. Every refusal says what was wrong, where,
//! and what a worker can do about it.

use serde::Serialize;

/// Why demonstrations could not be read or learned from.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// The text is no demonstration in any known format.
    #[error("{name}: not a readable recording: {reason}")]
    Unreadable {
        /// Name of the demonstration.
        name: String,
        /// What the parser stumbled over.
        reason: String,
    },
    /// Columns of different lengths, or rows of different widths.
    #[error("{name}: {what} has {found} values where {expected} were expected")]
    Ragged {
        /// Name of the demonstration.
        name: String,
        /// The column or row.
        what: String,
        /// Values expected.
        expected: usize,
        /// Values found.
        found: usize,
    },
    /// A value is NaN or infinite.
    #[error("{name}: {what} in row {row} is not a finite number")]
    NotFinite {
        /// Name of the demonstration.
        name: String,
        /// The column.
        what: String,
        /// Row, from 1.
        row: usize,
    },
    /// Time stands still or goes back.
    #[error("{name}: time does not advance in row {row} ({before_s} s, then {after_s} s)")]
    TimeNotIncreasing {
        /// Name of the demonstration.
        name: String,
        /// Row, from 1.
        row: usize,
        /// Time of the row before, seconds.
        before_s: f64,
        /// Time of this row, seconds.
        after_s: f64,
    },
    /// A joint angle outside the arm's range.
    #[error(
        "{name}: joint {joint} stands at {value_deg:.1}° in row {row}, its range is {min_deg:.0}° to {max_deg:.0}°"
    )]
    JointOutOfRange {
        /// Name of the demonstration.
        name: String,
        /// Joint, from 1.
        joint: usize,
        /// Row, from 1.
        row: usize,
        /// Recorded angle, degrees.
        value_deg: f64,
        /// Lower end of the range, degrees.
        min_deg: f64,
        /// Upper end of the range, degrees.
        max_deg: f64,
    },
    /// A second or less of recording.
    #[error("{name}: the recording lasts {duration_s:.2} s; more than 1 s is needed")]
    TooShort {
        /// Name of the demonstration.
        name: String,
        /// Length of the recording, seconds.
        duration_s: f64,
    },
    /// Longer than any motion this is made for.
    #[error("{name}: the recording has {samples} samples; at most {limit} can be learned")]
    TooLong {
        /// Name of the demonstration.
        name: String,
        /// Samples recorded.
        samples: usize,
        /// Most samples allowed.
        limit: usize,
    },
    /// No joint moves in the whole recording.
    #[error("{name}: the arm does not move in this recording")]
    NoMotion {
        /// Name of the demonstration.
        name: String,
    },
    /// The number of joints is not 1 to 7.
    #[error("{name}: {found} joints; 1 to 7 can be learned")]
    JointCount {
        /// Name of the demonstration.
        name: String,
        /// Joints found.
        found: usize,
    },
    /// Demonstrations of one task with different numbers of joints.
    #[error("{name} has {found} joints, {other} has {expected}")]
    DifferentJointCounts {
        /// Name of the demonstration that differs.
        name: String,
        /// A demonstration to compare with.
        other: String,
        /// Joints of the other one.
        expected: usize,
        /// Joints found.
        found: usize,
    },
    /// Nothing to learn from.
    #[error("there is no demonstration to learn from")]
    NoDemonstrations,
    /// More demonstrations than make sense.
    #[error("{found} demonstrations; at most {limit} can be learned together")]
    TooManyDemonstrations {
        /// Demonstrations given.
        found: usize,
        /// Most allowed.
        limit: usize,
    },
    /// The demonstrations do not show the same motion.
    #[error("the demonstrations show different motions: {} against {}", .groups[0].join(", "), .groups[1].join(", "))]
    DifferentMotions {
        /// Names, grouped by the motion they show.
        groups: [Vec<String>; 2],
    },
    /// An event of a signal that cannot be one.
    #[error("{name}: event {row} of the signals cannot be used: {reason}")]
    BadSignal {
        /// Name of the demonstration.
        name: String,
        /// Which event, from 1.
        row: usize,
        /// What is wrong with it.
        reason: String,
    },
    /// The demonstrations work the signals differently.
    #[error("{name} works the signals differently ({does}) from {other} ({other_does})")]
    SignalsDiffer {
        /// Name of the demonstration that differs.
        name: String,
        /// What it does, in words.
        does: String,
        /// A demonstration to compare with.
        other: String,
        /// What that one does, in words.
        other_does: String,
    },
    /// The mixture cannot be fitted.
    #[error("no mixture could be fitted: {reason}")]
    MixtureFailed {
        /// What went wrong.
        reason: String,
    },
    /// A start or goal with the wrong number of joints or a value that is no number.
    #[error("the {which} cannot be used: {reason}")]
    BadTarget {
        /// "start" or "goal".
        which: &'static str,
        /// What is wrong with it.
        reason: String,
    },
    /// A model file that cannot be used.
    #[error("not a usable model: {reason}")]
    BadModel {
        /// What is wrong with it.
        reason: String,
    },
    /// The caller asked to stop.
    #[error("the training was cancelled")]
    Cancelled,
}

/// Where in the input an error lies; every part is optional.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Location {
    /// Name of the demonstration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub demonstration: Option<String>,
    /// Row, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub row: Option<usize>,
    /// Joint, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint: Option<usize>,
    /// Column or field.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field: Option<String>,
}

impl Error {
    /// A stable name for programs.
    pub fn code(&self) -> &'static str {
        match self {
            Error::Unreadable { .. } => "demonstration_unreadable",
            Error::Ragged { .. } => "demonstration_ragged",
            Error::NotFinite { .. } => "demonstration_not_finite",
            Error::TimeNotIncreasing { .. } => "demonstration_time_not_increasing",
            Error::JointOutOfRange { .. } => "demonstration_joint_out_of_range",
            Error::TooShort { .. } => "demonstration_too_short",
            Error::TooLong { .. } => "demonstration_too_long",
            Error::NoMotion { .. } => "demonstration_no_motion",
            Error::JointCount { .. } => "demonstration_joint_count",
            Error::DifferentJointCounts { .. } => "demonstrations_different_joint_counts",
            Error::NoDemonstrations => "no_demonstrations",
            Error::TooManyDemonstrations { .. } => "too_many_demonstrations",
            Error::DifferentMotions { .. } => "demonstrations_different_motions",
            Error::BadSignal { .. } => "demonstration_signal_bad",
            Error::SignalsDiffer { .. } => "signals_differ",
            Error::MixtureFailed { .. } => "mixture_failed",
            Error::BadTarget { .. } => "bad_target",
            Error::BadModel { .. } => "bad_model",
            Error::Cancelled => "cancelled",
        }
    }

    /// Where the trouble lies.
    pub fn where_(&self) -> Location {
        match self {
            Error::Unreadable { name, .. }
            | Error::TooShort { name, .. }
            | Error::TooLong { name, .. }
            | Error::NoMotion { name }
            | Error::JointCount { name, .. }
            | Error::DifferentJointCounts { name, .. } => Location {
                demonstration: Some(name.clone()),
                ..Location::default()
            },
            Error::Ragged { name, what, .. } => Location {
                demonstration: Some(name.clone()),
                field: Some(what.clone()),
                ..Location::default()
            },
            Error::NotFinite { name, what, row } => Location {
                demonstration: Some(name.clone()),
                field: Some(what.clone()),
                row: Some(*row),
                ..Location::default()
            },
            Error::BadSignal { name, row, .. } => Location {
                demonstration: Some(name.clone()),
                field: Some("signals".into()),
                row: Some(*row),
                ..Location::default()
            },
            Error::SignalsDiffer { name, .. } => Location {
                demonstration: Some(name.clone()),
                field: Some("signals".into()),
                ..Location::default()
            },
            Error::TimeNotIncreasing { name, row, .. } => Location {
                demonstration: Some(name.clone()),
                field: Some("time".into()),
                row: Some(*row),
                ..Location::default()
            },
            Error::JointOutOfRange {
                name, row, joint, ..
            } => Location {
                demonstration: Some(name.clone()),
                row: Some(*row),
                joint: Some(*joint),
                ..Location::default()
            },
            Error::BadTarget { which, .. } => Location {
                field: Some((*which).into()),
                ..Location::default()
            },
            _ => Location::default(),
        }
    }

    /// What to do about it, in a worker's words.
    pub fn advice(&self) -> &'static str {
        match self {
            Error::Unreadable { .. } => {
                "Use a recording made by this program, or a JSON or CSV file with time and joint angles."
            }
            Error::Ragged { .. } | Error::NotFinite { .. } | Error::TimeNotIncreasing { .. } => {
                "The file is damaged. Record this take again, or remove it."
            }
            Error::JointOutOfRange { .. } => {
                "This recording is not from this kind of arm. Remove it."
            }
            Error::TooShort { .. } => "Record the motion again, from beginning to end.",
            Error::TooLong { .. } => "Teach the motion in shorter parts.",
            Error::NoMotion { .. } => {
                "Take the arm by the hand and move it while recording, then keep that take."
            }
            Error::JointCount { .. } | Error::DifferentJointCounts { .. } => {
                "Use only recordings of the same arm."
            }
            Error::NoDemonstrations => "Record the motion at least once; three times is better.",
            Error::TooManyDemonstrations { .. } => "Keep the best ones and discard the others.",
            Error::DifferentMotions { .. } => {
                "Keep only takes of one motion in a task; make a second task for the other motion."
            }
            Error::BadSignal { .. } => "The file is damaged. Record this take again, or remove it.",
            Error::SignalsDiffer { .. } => {
                "Discard this take, or record it again and work the gripper as in the others."
            }
            Error::MixtureFailed { .. } => "Record one more take and train again.",
            Error::BadTarget { .. } => "Give one angle in degrees for each joint.",
            Error::BadModel { .. } => "Train the task again.",
            Error::Cancelled => "Start the training again when you want it.",
        }
    }
}
