//! Starts and goals: what was asked for as joint angles, and at which turn of the
//! wrist. What happens between them is the parent's.

use learning::Model;
use motion::{JOINTS, JointAngles, limits::RobotLimits};

use super::PlanError;

/// A start or goal that is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// As in the demonstrations.
    AsTaught,
    /// Where the arm stands now.
    Present,
    /// These joint angles.
    Joints(JointAngles),
}

/// The joint angles of a start or goal, within the arm's range.
pub(super) fn resolve(
    which: &'static str,
    target: Target,
    taught_deg: &[f64],
    present: Option<JointAngles>,
    limits: &RobotLimits,
) -> Result<JointAngles, PlanError> {
    let taught: [f64; JOINTS] = taught_deg
        .try_into()
        .map_err(|_| PlanError::JointCount(taught_deg.len()))?;
    let joints = match target {
        Target::AsTaught => JointAngles(taught),
        Target::Present => present.ok_or(PlanError::PresentUnknown)?,
        Target::Joints(joints) => joints,
    };
    match limits.joint_out_of_range(&joints) {
        Some(j) => Err(PlanError::TargetOutsideRange {
            which,
            joint: j + 1,
            value_deg: joints.0[j],
            min_deg: limits.joint_min_deg[j],
            max_deg: limits.joint_max_deg[j],
        }),
        None => Ok(joints),
    }
}

/// A joint that stands whole turns away from the taught start (only the wrist can)
/// keeps them: the goal is taken at the same turn, where the tool points the same
/// way, instead of unwinding on the way. A goal that is itself asked for at another
/// turn than the taught one stays. Gives the joint that was turned, from 0.
pub(super) fn turn_with_start(
    start: &JointAngles,
    goal: &mut JointAngles,
    model: &Model,
    limits: &RobotLimits,
) -> Result<Option<usize>, PlanError> {
    let mut turned = None;
    for j in 0..JOINTS {
        let offset_deg = start.0[j] - model.start_deg()[j];
        let turns = whole_turns(offset_deg);
        if turns == 0.0 || whole_turns(goal.0[j] - model.goal_deg()[j]) != 0.0 {
            continue;
        }
        goal.0[j] += 360.0 * turns;
        if limits.joint_out_of_range(goal) == Some(j) {
            return Err(PlanError::TurnedAway {
                joint: j + 1,
                offset_deg,
            });
        }
        turned = Some(j);
    }
    Ok(turned)
}

/// The nearest number of whole turns; between two that are equally near, the one
/// nearer to none, so that a joint half a turn away stays at its turn.
pub(super) fn whole_turns(offset_deg: f64) -> f64 {
    let turns = offset_deg / 360.0;
    (turns.abs() - 0.5 - 1e-9).ceil().copysign(turns)
}
