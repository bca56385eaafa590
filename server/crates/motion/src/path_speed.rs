//! The speed along a planned path, as a share of the plan's own: slowing down, pausing,
//! stopping and going on without leaving the path and without a jump.
//!
//! With f the share, q the plan and t its time, a joint moves with q'(t) f and accelerates with
//! q''(t) f² + q'(t) df/dt. The plan itself keeps q' and q'' within the limits, so for f ≤ 1 only
//! df/dt has to be chosen with care; that is what lives here. Pure; time comes in as an argument.

use crate::limits::RobotLimits;
use crate::plan::Setpoint;
use crate::{JOINTS, JointVelocities};

/// Share of the acceleration limit that a change of speed may use up: the discrete samples of
/// a motion at the limit are allowed to be a little above it between two checks.
const BUDGET: f64 = 0.9;
/// Steepest fall and rise of the share, 1/s.
const FALL_PER_S: f64 = 5.0;
const RISE_PER_S: f64 = 2.0;
/// Quickest change of that steepness, 1/s², and the share of the jerk limit it may use up.
const BEND_PER_S2: f64 = 60.0;
const JERK_BUDGET: f64 = 0.5;
/// A smaller difference than this is none.
const REACHED: f64 = 1e-4;
/// Longest step that is computed in one piece, seconds.
const STEP_S: f64 = 0.005;

/// A path in time, at rest before its beginning and after its end.
pub trait Course {
    /// Position and speed at `t_s` seconds.
    fn at(&self, t_s: f64) -> Setpoint;
    /// Its length, seconds.
    fn duration_s(&self) -> f64;
}

/// The speed along a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathSpeed {
    share: f64,
    slope_per_s: f64,
}

impl PathSpeed {
    /// At `share` of the plan's speed, 0 to 1, and not changing.
    pub fn steady(share: f64) -> Self {
        Self {
            share,
            slope_per_s: 0.0,
        }
    }

    /// The present share.
    pub fn share(&self) -> f64 {
        self.share
    }

    /// Whether nothing moves.
    pub fn is_at_rest(&self) -> bool {
        self.share == 0.0
    }

    /// Brings the share nearer to `target` (0 to 1) during `elapsed_s` and returns where on the
    /// path, at first at `t_s`, the motion has come.
    pub fn advance(
        &mut self,
        course: &impl Course,
        t_s: f64,
        target: f64,
        elapsed_s: f64,
        limits: &RobotLimits,
    ) -> f64 {
        let passes = elapsed_s > 0.0; // False for NaN, too.
        if !passes {
            return t_s;
        }
        let steps = (elapsed_s / STEP_S).ceil().max(1.0);
        let step_s = elapsed_s / steps;
        let mut t_s = t_s;
        for _ in 0..steps as usize {
            let before = self.share;
            self.step(course, t_s, target, step_s, limits);
            t_s = (t_s + 0.5 * (before + self.share) * step_s).min(course.duration_s());
        }
        t_s
    }

    fn step(
        &mut self,
        course: &impl Course,
        t_s: f64,
        target: f64,
        step_s: f64,
        limits: &RobotLimits,
    ) {
        let missing = target - self.share;
        if missing.abs() <= REACHED {
            *self = Self::steady(target);
            return;
        }
        let (lowest, highest, bend_per_s2) = self.bounds(course, t_s, step_s, limits);
        // As steep as allowed, but so that the slope can be gone when the target is reached.
        let wanted = (1.6 * bend_per_s2 * missing.abs())
            .sqrt()
            .min(missing.abs() / step_s)
            .copysign(missing)
            .clamp(-FALL_PER_S, RISE_PER_S);
        let bend = bend_per_s2 * step_s;
        self.slope_per_s = wanted
            .clamp(self.slope_per_s - bend, self.slope_per_s + bend)
            .clamp(lowest, highest);
        let share = self.share + self.slope_per_s * step_s;
        if (target - share) * missing <= 0.0 {
            *self = Self::steady(target);
        } else {
            self.share = share.clamp(0.0, 1.0);
        }
    }

    /// Between which slopes every joint keeps its acceleration limit, and how quickly the slope
    /// may change for the jerk's sake. Not to change the share is always allowed.
    fn bounds(
        &self,
        course: &impl Course,
        t_s: f64,
        step_s: f64,
        limits: &RobotLimits,
    ) -> (f64, f64, f64) {
        let JointVelocities(before) = course.at(t_s).velocities;
        let JointVelocities(after) = course.at(t_s + step_s).velocities;
        let (mut lowest, mut highest) = (-FALL_PER_S, RISE_PER_S);
        let mut bend = BEND_PER_S2;
        for joint in 0..JOINTS {
            let speed = before[joint].abs().max(after[joint].abs());
            // So slow that no slope can matter.
            if speed < 1e-6 {
                continue;
            }
            let own = (after[joint] - before[joint]) / step_s * self.share * self.share;
            let allowed = BUDGET * limits.joint_acceleration_deg_s2[joint];
            // Seen in the direction of motion.
            let own = own * (before[joint] + after[joint]).signum();
            lowest = lowest.max((-(allowed + own) / speed).min(0.0));
            highest = highest.min(((allowed - own) / speed).max(0.0));
            bend = bend.min(JERK_BUDGET * limits.joint_jerk_deg_s3[joint] / speed);
        }
        (lowest, highest, bend)
    }
}

#[cfg(test)]
mod tests;
