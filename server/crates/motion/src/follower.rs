//! A smooth way of joint angles to a goal that may move at any moment, within the joints' speeds
//! and accelerations and the tool's speed. No time of its own: the caller says how much has passed.
//!
//! Each joint wants the speed of a critically damped second-order system, but none from which it
//! could not brake before its goal. What all joints want is scaled down together until it keeps
//! the limits, and the present speeds are blended towards it by one share for all joints. The
//! speeds that keep the limits are a convex set, so that no blend of two of them leaves it, and
//! the share is chosen so that no joint exceeds its acceleration.

use crate::kinematics::Jacobian;
use crate::limits::RobotLimits;
use crate::{JOINTS, JointAngles, JointVelocities};

/// Longest step of the calculation, s.
pub(crate) const STEP_S: f64 = 0.004;
/// Longer times do not count: whoever was away for so long does not catch up in a rush, s.
const LONGEST_S: f64 = 0.1;
/// Share of the acceleration with which a joint plans to brake; the rest is for its lag.
const BRAKING_SHARE: f64 = 0.5;
/// Share of the tool's speed that is wanted; the rest is for the way the arm changes meanwhile.
const TOOL_SHARE: f64 = 0.96;

/// An arm on its way to a goal.
#[derive(Clone, Debug)]
pub struct Follower {
    limits: RobotLimits,
    /// Natural frequency, 1/s: small goals are followed within about twice its inverse.
    quickness: f64,
    joints: JointAngles,
    speeds: JointVelocities,
}

impl Follower {
    /// An arm at rest. It lags behind a goal that moves steadily by `2 / quickness` seconds.
    #[must_use]
    pub fn new(at: JointAngles, limits: RobotLimits, quickness: f64) -> Self {
        Self {
            limits,
            quickness,
            joints: at,
            speeds: JointVelocities::ZERO,
        }
    }

    /// Where the arm is.
    #[must_use]
    pub fn joints(&self) -> JointAngles {
        self.joints
    }

    /// Whether the arm stands still.
    #[must_use]
    pub fn is_at_rest(&self) -> bool {
        self.speeds == JointVelocities::ZERO
    }

    /// Moves on towards `goal`, or comes to rest without one, and returns where the arm is then.
    pub fn advance(&mut self, goal: Option<&JointAngles>, elapsed_s: f64) -> JointAngles {
        for step_s in steps(elapsed_s) {
            self.step(goal, step_s);
        }
        self.joints
    }

    /// The same by one short step.
    pub(crate) fn step(&mut self, goal: Option<&JointAngles>, step_s: f64) {
        let soft = match goal {
            Some(_) => (2.0 * self.quickness * step_s).min(1.0),
            None => 1.0,
        };
        let mut speeds = self.blended(&self.wanted(goal), soft, step_s);
        // Speeds that kept the tool's limit where the arm was may exceed it where it is.
        if self.tool_share(&speeds) < 1.0 {
            speeds = self.blended(&[0.0; JOINTS], 1.0, step_s);
        }
        self.end_at_ranges(&mut speeds, step_s);
        let share = self.tool_share(&speeds).min(1.0);
        for joint in 0..JOINTS {
            speeds.0[joint] *= share;
            let from = self.joints.0[joint];
            let lowest = self.limits.joint_min_deg[joint].min(from);
            let highest = self.limits.joint_max_deg[joint].max(from);
            let to = from + speeds.0[joint] * step_s;
            // Rounding may lead a hair beyond.
            self.joints.0[joint] = to.clamp(lowest, highest);
        }
        self.speeds = speeds;
    }

    /// Slows down each joint that could not brake any more before the end of its range.
    fn end_at_ranges(&self, speeds: &mut JointVelocities, step_s: f64) {
        let limits = &self.limits;
        for (joint, speed) in speeds.0.iter_mut().enumerate() {
            let at = self.joints.0[joint];
            let fastest = |left_deg: f64| {
                let left_deg = left_deg.max(0.0);
                let braking =
                    2.0 * BRAKING_SHARE * limits.joint_acceleration_deg_s2[joint] * left_deg;
                braking.sqrt().min(left_deg / step_s)
            };
            let down = fastest(at - limits.joint_min_deg[joint]);
            let up = fastest(limits.joint_max_deg[joint] - at);
            *speed = speed.clamp(-down, up);
        }
    }

    /// The present speeds with a share of the wanted ones: `most`, or what the accelerations admit.
    fn blended(&self, wanted: &[f64; JOINTS], most: f64, step_s: f64) -> JointVelocities {
        let share = (0..JOINTS).fold(most, |share, joint| {
            let change = (wanted[joint] - self.speeds.0[joint]).abs();
            let allowed = self.limits.joint_acceleration_deg_s2[joint] * step_s;
            share.min(allowed / change.max(f64::MIN_POSITIVE))
        });
        // Rest is rest, not a speed that is nearly nothing.
        if share >= 1.0 {
            return JointVelocities(*wanted);
        }
        JointVelocities(std::array::from_fn(|joint| {
            let speed = self.speeds.0[joint];
            speed + share * (wanted[joint] - speed)
        }))
    }

    /// The speeds that lead to the goal, within the limits.
    fn wanted(&self, goal: Option<&JointAngles>) -> [f64; JOINTS] {
        let Some(goal) = goal.filter(|goal| goal.is_finite()) else {
            return [0.0; JOINTS];
        };
        let limits = &self.limits;
        let mut wanted = JointVelocities(std::array::from_fn(|joint| {
            let end = goal.0[joint].clamp(limits.joint_min_deg[joint], limits.joint_max_deg[joint]);
            let left = end - self.joints.0[joint];
            let braking = BRAKING_SHARE * limits.joint_acceleration_deg_s2[joint];
            let fastest = (2.0 * braking * left.abs()).sqrt();
            (self.quickness / 2.0 * left).clamp(-fastest, fastest)
        }));
        let share = (0..JOINTS).fold(
            (TOOL_SHARE * self.tool_share(&wanted)).min(1.0),
            |share, joint| {
                let speed = wanted.0[joint].abs().max(f64::MIN_POSITIVE);
                share.min(limits.joint_speed_deg_s[joint] / speed)
            },
        );
        wanted.0.iter_mut().for_each(|speed| *speed *= share);
        wanted.0
    }

    /// Which share of these speeds the tool's speed admits.
    fn tool_share(&self, speeds: &JointVelocities) -> f64 {
        let limits = &self.limits;
        let tool_mm_s = Jacobian::of(&self.joints, limits.tool_mm).point_speed_mm_s(speeds);
        limits.tcp_speed_mm_s / tool_mm_s.max(f64::MIN_POSITIVE)
    }
}

/// A time in short steps of equal length; a time that is none is no step.
pub(crate) fn steps(elapsed_s: f64) -> impl Iterator<Item = f64> {
    let elapsed_s = if elapsed_s > 0.0 {
        elapsed_s.min(LONGEST_S)
    } else {
        0.0
    };
    let count = (elapsed_s / STEP_S - 1e-9).ceil().max(0.0) as usize;
    std::iter::repeat_n(elapsed_s / count.max(1) as f64, count)
}
