//! Why there is no plan for a wish.

use motion::{JOINTS, gate::Refusal};
use serde_json::{Value, json};

use super::SLOWEST;

/// Why there is no plan.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlanError {
    /// The speed is no share of the taught one.
    #[error("the speed is {0}, it must be between {SLOWEST} and 1")]
    BadSpeed(f64),
    /// "present" was asked for, but nobody knows where the arm stands.
    #[error("it is not known where the arm stands")]
    PresentUnknown,
    /// The model moves another kind of arm.
    #[error("this motion has {0} joints, the arm has {JOINTS}")]
    JointCount(usize),
    /// A start or goal outside the arm's range.
    #[error(
        "the {which} of joint {joint} is {value_deg:.1}°, its range is {min_deg:.0}° to {max_deg:.0}°"
    )]
    TargetOutsideRange {
        /// "start" or "goal".
        which: &'static str,
        /// Joint, from 1.
        joint: usize,
        /// What was asked for, degrees.
        value_deg: f64,
        /// Lower end of the range, degrees.
        min_deg: f64,
        /// Upper end of the range, degrees.
        max_deg: f64,
    },
    /// A joint stands a turn away, and its goal a turn away is out of its range.
    #[error(
        "joint {joint} stands {offset_deg:.0}° from the taught start, and the goal cannot be reached from this turn"
    )]
    TurnedAway {
        /// Joint, from 1.
        joint: usize,
        /// Distance from the taught start, degrees.
        offset_deg: f64,
    },
    /// The arm stands where its motion began.
    #[error("the arm has hardly moved, so there is no way back")]
    NoWayBack,
    /// The reproduction does not come to rest at the goal.
    #[error("the motion does not come to rest at the goal")]
    DoesNotSettle,
    /// The model refused the start or the goal.
    #[error(transparent)]
    Learning(#[from] learning::Error),
    /// The gate refused the motion.
    #[error("the motion may not run: {0}")]
    Refused(#[from] Refusal),
}

impl PlanError {
    /// A stable name for programs.
    pub fn code(&self) -> &'static str {
        match self {
            PlanError::BadSpeed(_) => "bad_speed",
            PlanError::PresentUnknown => "present_pose_unknown",
            PlanError::JointCount(_) => "wrong_joint_count",
            PlanError::TargetOutsideRange { .. } => "outside_joint_range",
            PlanError::TurnedAway { .. } => "joint_turned_away",
            PlanError::NoWayBack => "no_way_back",
            PlanError::DoesNotSettle => "motion_does_not_settle",
            PlanError::Learning(error) => error.code(),
            PlanError::Refused(refusal) => refusal.code(),
        }
    }

    /// Where it goes wrong, for programs. Joints count from 1, as on the arm.
    pub fn place(&self) -> Option<Value> {
        match self {
            PlanError::BadSpeed(_) => Some(json!({ "field": "speed" })),
            PlanError::TargetOutsideRange {
                which,
                joint,
                value_deg,
                min_deg,
                max_deg,
            } => Some(json!({
                "field": which, "joint": joint, "value_deg": value_deg,
                "min_deg": min_deg, "max_deg": max_deg,
            })),
            PlanError::TurnedAway { joint, offset_deg } => Some(json!({
                "field": "start", "joint": joint, "offset_deg": offset_deg,
            })),
            PlanError::Learning(error) => serde_json::to_value(error.where_()).ok(),
            PlanError::Refused(refusal) => Some(match refusal {
                Refusal::Malformed => json!({}),
                Refusal::SignalMisplaced { name, at_s } => json!({ "field": name, "t_s": at_s }),
                Refusal::NotFinite { joint, t_s } => json!({ "joint": joint + 1, "t_s": t_s }),
                Refusal::OutsideRange {
                    joint,
                    t_s,
                    value_deg,
                    limit_deg,
                } => json!({
                    "joint": joint + 1, "t_s": t_s, "value": value_deg, "limit": limit_deg,
                }),
                Refusal::KeepOut { name, t_s, tool_mm } => {
                    json!({ "keep_out": name, "t_s": t_s, "tool_mm": tool_mm })
                }
                Refusal::WristStretched {
                    t_s,
                    value_deg,
                    limit_deg,
                } => json!({ "joint": 5, "t_s": t_s, "value": value_deg, "limit": limit_deg }),
                Refusal::TooQuick(breach) => json!({
                    "joint": breach.quantity.joint().map(|joint| joint + 1),
                    "t_s": breach.t_s, "value": breach.value, "limit": breach.limit,
                }),
            }),
            PlanError::PresentUnknown
            | PlanError::JointCount(_)
            | PlanError::NoWayBack
            | PlanError::DoesNotSettle => None,
        }
    }

    /// What a worker can do about it.
    pub fn advice(&self) -> &'static str {
        match self {
            PlanError::BadSpeed(_) => "Choose a speed between 5 and 100 percent.",
            PlanError::PresentUnknown => {
                "Wait until the arm is connected, or give the joint angles yourself."
            }
            PlanError::JointCount(_) => "Choose a motion that was taught with this arm.",
            PlanError::TargetOutsideRange { .. } | PlanError::Refused(_) => {
                "Choose a start or goal nearer to what you taught, or teach the motion in another place."
            }
            PlanError::TurnedAway { .. } => {
                "Let the motion begin as taught: the arm then turns the joint back slowly first."
            }
            PlanError::NoWayBack => "Preview the motion again from where the arm stands now.",
            PlanError::DoesNotSettle => "Train the task again, with one more take.",
            PlanError::Learning(error) => error.advice(),
        }
    }
}
