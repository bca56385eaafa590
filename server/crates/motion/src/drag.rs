//! Dragging: joint angles for an arm whose tool flange somebody pulls to a place, as a finger does
//! on a screen. No time of its own: the caller says how much has passed.
//!
//! A *goal* runs ahead of the arm towards the target, as fast as the tool may move and turn, by
//! inverse kinematics; where the target is out of reach it comes to rest at the nearest place. The
//! arm follows the goal smoothly ([`crate::follower`]). Nothing here looks at keep-out boxes: a
//! hand is not stopped by them either, and the gate judges every motion that is learned from it.

use crate::follower::{Follower, steps};
use crate::kinematics::{inverse, tool0};
use crate::limits::RobotLimits;
use crate::{JOINTS, JointAngles, Orientation, Pose, Position};

/// A target that nobody repeats for so long is let go, s.
pub const PATIENCE_S: f64 = 0.3;
/// The speed that a controller admits while a person holds the arm, mm/s.
const TOOL_MM_S: f64 = 250.0;
/// The tool turns no faster, deg/s.
const TURN_DEG_S: f64 = 90.0;
/// How quickly the arm follows its goal, 1/s: it lags behind by 67 ms.
const QUICKNESS: f64 = 30.0;
/// No arm of this kind reaches so far; a target farther away is as good as one there, mm.
const FAR_MM: f64 = 10_000.0;
/// Likewise more than a whole turn, deg.
const WHOLE_TURN_DEG: f64 = 360.0;

/// Where somebody wants the tool flange.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// Its centre in the base frame, mm.
    pub tool_mm: [f64; 3],
    /// How it is turned from where the drag began, in the flange's own frame: once, about the axis
    /// with these parts, by its length, deg.
    pub turn_deg: [f64; 3],
}

/// One drag, from when the flange is taken until it is let go.
#[derive(Clone, Debug)]
pub struct Drag {
    limits: RobotLimits,
    /// Orientation of the flange when the drag began.
    held: Orientation,
    target: Option<Pose>,
    age_s: f64,
    goal: JointAngles,
    arm: Follower,
}

impl Drag {
    /// Takes hold of an arm that stands at `joints`.
    #[must_use]
    pub fn begin(joints: JointAngles, limits: &RobotLimits) -> Self {
        let limits = RobotLimits {
            tcp_speed_mm_s: limits.tcp_speed_mm_s.min(TOOL_MM_S),
            ..limits.clone()
        };
        Self {
            held: tool0(&joints).orientation,
            target: None,
            age_s: 0.0,
            goal: joints,
            arm: Follower::new(joints, limits.clone(), QUICKNESS),
            limits,
        }
    }

    /// Goes on from an arm that stands at `joints`, with the orientation from the beginning.
    pub fn resume(&mut self, joints: JointAngles) {
        self.goal = joints;
        self.arm = Follower::new(joints, self.limits.clone(), QUICKNESS);
    }

    /// Pulls towards a target. One that is not a number is as none.
    pub fn aim(&mut self, target: &Target) {
        let is_finite = |parts: [f64; 3]| parts.iter().all(|part| part.is_finite());
        if !is_finite(target.tool_mm) || !is_finite(target.turn_deg) {
            return;
        }
        let turn = target.turn_deg;
        let turn_deg = turn.map(|part| part.clamp(-WHOLE_TURN_DEG, WHOLE_TURN_DEG));
        self.age_s = 0.0;
        self.target = Some(Pose {
            position: Position(target.tool_mm.map(|part| part.clamp(-FAR_MM, FAR_MM))),
            orientation: inverse::turned(&self.held, turn_deg),
        });
    }

    /// Moves on by a time and returns where the arm is then.
    pub fn advance(&mut self, elapsed_s: f64) -> JointAngles {
        for step_s in steps(elapsed_s) {
            self.age_s += step_s;
            if self.age_s > PATIENCE_S {
                self.target = None;
            }
            match self.target {
                Some(target) => {
                    self.goal = self.ahead(&target, step_s);
                    self.arm.step(Some(&self.goal), step_s);
                }
                None => {
                    self.arm.step(None, step_s);
                    self.goal = self.arm.joints();
                }
            }
        }
        self.arm.joints()
    }

    /// Whether nobody pulls and the arm stands still.
    #[must_use]
    pub fn is_at_rest(&self) -> bool {
        self.target.is_none() && self.arm.is_at_rest()
    }

    /// The goal after one step towards the target.
    fn ahead(&self, target: &Pose, step_s: f64) -> JointAngles {
        let at = tool0(&self.goal);
        let way = inverse::error(&at, target);
        let share = |most: f64, length: f64| (most / length.max(f64::MIN_POSITIVE)).min(1.0);
        let moved = share(
            self.limits.tcp_speed_mm_s * step_s,
            inverse::length(way.position_mm),
        );
        let turned = share(TURN_DEG_S * step_s, inverse::length(way.turn_deg));
        let next = inverse::on_the_way(&at, &way, moved, turned);
        let longest: [f64; JOINTS] = self.limits.joint_speed_deg_s.map(|speed| speed * step_s);
        inverse::step(&self.goal, &next, &self.limits, &longest)
    }
}

#[cfg(test)]
mod tests;
