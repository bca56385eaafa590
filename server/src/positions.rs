//! Saved positions as starts and goals: which pose a name stands for, for which robot, and what is
//! said when it stands for none any more.

use motion::JointAngles;

use crate::arms::Arm;
use crate::ids::PositionId;
use crate::store::{self, Store};

/// A pose that is older than this is not where the arm stands now.
const FRESH_MS: u64 = 1_000;

/// Why a position can't be saved or used.
#[derive(Debug, thiserror::Error)]
pub enum PositionError {
    /// The store refused.
    #[error(transparent)]
    Store(#[from] store::Error),
    /// Somebody deleted it.
    #[error("the saved position \"{name}\" was deleted")]
    Deleted {
        /// What it was called.
        name: String,
    },
    /// It belongs to another robot.
    #[error("the saved position \"{name}\" belongs to the robot \"{robot}\"")]
    OtherRobot {
        /// What it is called.
        name: String,
        /// Whose it is.
        robot: String,
    },
    /// An angle that the arm can't have.
    #[error("joint {joint} is {value_deg:.1}°, its range is {min_deg:.0}° to {max_deg:.0}°")]
    OutsideRange {
        /// Joint, from 1.
        joint: usize,
        /// What was asked for, degrees.
        value_deg: f64,
        /// Lower end of the range, degrees.
        min_deg: f64,
        /// Upper end of the range, degrees.
        max_deg: f64,
    },
    /// The present pose was asked for, but nobody knows where the arm stands.
    #[error("it is not known where the arm stands")]
    PresentUnknown,
}

/// Where the arm stands, if that was heard of lately.
pub fn present_pose(arm: &Arm) -> Option<JointAngles> {
    let view = arm.robot.view();
    let view = view.borrow();
    let fresh = view.age_ms <= FRESH_MS;
    view.joints_deg.filter(|_| fresh).map(JointAngles)
}

/// The angles to be saved for this arm: those that are given, else those at which it stands.
///
/// # Errors
/// When it can't stand like that, or nobody knows how it stands.
pub fn angles_for(arm: &Arm, given: Option<[f64; 6]>) -> Result<[f64; 6], PositionError> {
    let joints = match given {
        Some(joints_deg) => JointAngles(joints_deg),
        None => present_pose(arm).ok_or(PositionError::PresentUnknown)?,
    };
    match arm.limits.joint_out_of_range(&joints) {
        Some(j) => Err(PositionError::OutsideRange {
            joint: j + 1,
            value_deg: joints.0[j],
            min_deg: arm.limits.joint_min_deg[j],
            max_deg: arm.limits.joint_max_deg[j],
        }),
        None => Ok(joints.0),
    }
}

/// The pose that a saved position stands for, for a motion of this arm.
///
/// # Errors
/// When it is unknown, deleted or another robot's.
pub async fn pose_of(
    store: &Store,
    id: PositionId,
    arm: &Arm,
) -> Result<JointAngles, PositionError> {
    let position = store.position(id).await?;
    if position.deleted {
        return Err(PositionError::Deleted {
            name: position.name,
        });
    }
    if position.robot != arm.id {
        return Err(PositionError::OtherRobot {
            name: position.name,
            robot: position.robot,
        });
    }
    Ok(JointAngles(position.joints_deg))
}
