//! The last step before a reference is encoded: it never moves faster, and never changes its
//! speed faster, than a checked motion or its stop can.
//!
//! This is no planner. A plan within its limits passes unchanged, also while it is being stopped;
//! anything that jumps is turned into a movement. Lost messages only make one step longer.

use motion::limits::RobotLimits;
use motion::plan::Setpoint;
use motion::{JOINTS, JointAngles, JointVelocities};

/// Samples, differences and our own rounding must not make the limiter bite on a legal motion.
const HEADROOM: f64 = 1.05;
/// Rounding of an angle of some hundred degrees, with room to spare.
const ROUNDING_DEG: f64 = 1e-9;

/// Keeps the reference from jumping.
#[derive(Debug, Clone)]
pub struct RateLimiter {
    speed_deg_s: [f64; JOINTS],
    acceleration_deg_s2: [f64; JOINTS],
    joints: JointAngles,
    /// Mean speed of the last step.
    speed: [f64; JOINTS],
    step_s: f64,
}

impl RateLimiter {
    /// A limiter at rest at `joints`.
    #[must_use]
    pub fn new(limits: &RobotLimits, joints: JointAngles) -> Self {
        let speed_deg_s = limits.joint_speed_deg_s.map(|limit| limit * HEADROOM);
        Self {
            speed_deg_s,
            acceleration_deg_s2: limits
                .joint_acceleration_deg_s2
                .map(|limit| limit * HEADROOM),
            joints,
            speed: [0.0; JOINTS],
            step_s: 0.0,
        }
    }

    /// Starts anew, at rest at `joints`: after a session began, or when the reference was set by
    /// someone else.
    pub fn reset(&mut self, joints: JointAngles) {
        self.joints = joints;
        self.speed = [0.0; JOINTS];
        self.step_s = 0.0;
    }

    /// The reference `elapsed_s` after the last one, as near to `wish` as the limits allow. A wish
    /// that is not finite counts as "stay".
    pub fn limit(&mut self, wish: &Setpoint, elapsed_s: f64) -> Setpoint {
        let goes_on = elapsed_s > 0.0; // False for NaN, too.
        if !goes_on {
            return Setpoint {
                joints: self.joints,
                velocities: JointVelocities(self.speed),
            };
        }
        let mut limited = Setpoint {
            joints: self.joints,
            velocities: JointVelocities::ZERO,
        };
        for joint in 0..JOINTS {
            let (to, speed) = self.limit_joint(joint, wish, elapsed_s);
            limited.velocities.0[joint] = speed;
            self.speed[joint] = (to - self.joints.0[joint]) / elapsed_s;
            limited.joints.0[joint] = to;
        }
        self.joints = limited.joints;
        self.step_s = elapsed_s;
        limited
    }

    /// Angle and speed of one joint.
    fn limit_joint(&self, joint: usize, wish: &Setpoint, elapsed_s: f64) -> (f64, f64) {
        let from = self.joints.0[joint];
        let max_speed = self.speed_deg_s[joint];
        let acceleration = self.acceleration_deg_s2[joint];
        let (mut to, mut speed) = (wish.joints.0[joint], wish.velocities.0[joint]);
        if !(to.is_finite() && speed.is_finite()) {
            (to, speed) = (from, 0.0);
        }
        // Mean speeds of neighbouring steps lie half of both steps apart.
        let last_step_s = if self.step_s > 0.0 {
            self.step_s
        } else {
            elapsed_s
        };
        let change = acceleration * 0.5 * (elapsed_s + last_step_s);
        let previous = self.speed[joint];
        let lowest = (previous - change).max(-max_speed);
        let highest = (previous + change).min(max_speed);
        let wanted = (to - from) / elapsed_s;
        let rounding = ROUNDING_DEG / elapsed_s;
        if (lowest - rounding..=highest + rounding).contains(&wanted) && speed.abs() <= max_speed {
            return (to, speed);
        }
        // Approach the wish so that it can still be met without running past it.
        let distance = to - from;
        let approach = (acceleration * distance.abs())
            .sqrt()
            .min(distance.abs() / elapsed_s);
        let reachable =
            (speed + approach.copysign(distance)).clamp(lowest.min(highest), highest.max(lowest));
        (from + reachable * elapsed_s, reachable)
    }
}

#[cfg(test)]
mod tests;
