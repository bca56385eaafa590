//! The arm as EGM moves it: the controller's control law and the servos' delay.
//!
//! `speed = k * (position reference - position) + speed reference`, common scaling to the largest
//! admitted speed, a low-pass filter of first order, and the servos, which follow some cycles
//! later. No time of its own: one call is one cycle.

use std::collections::VecDeque;
use std::f64::consts::TAU;

use motion::limits::RobotLimits;
use motion::{JOINTS, JointAngles, JointVelocities};

use crate::config::EgmSettings;

/// How long the brakes need, s.
pub const BRAKE_S: f64 = 0.11;

/// What the controller was last told to follow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Position; without it the speed alone counts.
    pub joints: Option<JointAngles>,
    /// Speed.
    pub velocities: JointVelocities,
}

/// A joint outside its range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfRange {
    /// Joint, from 1.
    pub joint: usize,
    /// Its angle, deg.
    pub angle_deg: f64,
}

/// Joint angles and speeds, and how they change.
#[derive(Clone, Debug)]
pub struct Arm {
    settings: EgmSettings,
    limits: RobotLimits,
    /// What the servos are following; the arm itself is `delayed`.
    planned: JointAngles,
    speeds: [f64; JOINTS],
    /// Positions on their way through the servos, oldest first; the oldest is where the arm is.
    delayed: VecDeque<JointAngles>,
    /// Loss of speed while coming to rest, deg/s².
    braking: Option<[f64; JOINTS]>,
}

impl Arm {
    /// An arm at rest.
    #[must_use]
    pub fn new(settings: EgmSettings, at: JointAngles) -> Self {
        Self {
            settings,
            limits: RobotLimits::gofa5(),
            planned: at,
            speeds: [0.0; JOINTS],
            delayed: vec![at; settings.servo_delay_cycles + 1].into(),
            braking: None,
        }
    }

    /// Where the arm is.
    #[must_use]
    pub fn measured(&self) -> JointAngles {
        self.delayed.front().copied().unwrap_or(self.planned)
    }

    /// Where the controller wants it now.
    #[must_use]
    pub fn planned(&self) -> JointAngles {
        self.planned
    }

    /// Moves one cycle towards `reference` and returns how much of the arm's performance that
    /// needs, in percent; above 100 the arm goes slower than asked, in the same direction.
    ///
    /// # Errors
    /// The first joint that the reference or the motion brings outside its range. The arm has not
    /// moved then.
    pub fn follow(&mut self, reference: &Reference) -> Result<f64, OutOfRange> {
        let target = reference.joints.unwrap_or(self.planned);
        self.check_range(&target)?;
        let law = &self.settings;
        let mut wanted = reference.velocities.0;
        for (joint, speed) in wanted.iter_mut().enumerate() {
            *speed += law.position_gain * (target.0[joint] - self.planned.0[joint]);
        }
        let fastest = wanted
            .iter()
            .fold(0.0, |most: f64, speed| most.max(speed.abs()));
        let load = wanted
            .iter()
            .zip(self.limits.joint_speed_deg_s)
            .fold(0.0, |most: f64, (speed, limit)| {
                most.max(speed.abs() / limit)
            });
        let scale = (law.max_speed_deviation_deg_s / fastest)
            .min(1.0 / load)
            .min(1.0);
        let filter = 1.0 - (-TAU * law.low_pass_hz * law.cycle_s).exp();
        let mut speeds = self.speeds;
        let mut next = self.planned;
        for joint in 0..JOINTS {
            speeds[joint] += filter * (wanted[joint] * scale - speeds[joint]);
            next.0[joint] += speeds[joint] * law.cycle_s;
        }
        self.check_range(&next)?;
        self.braking = None;
        self.speeds = speeds;
        self.advance(next);
        Ok(100.0 * load)
    }

    /// Moves one cycle while no reference counts: comes to rest within `ramp_s`, then stays.
    pub fn come_to_rest(&mut self, ramp_s: f64) {
        let step = self.settings.cycle_s;
        let speeds = &mut self.speeds;
        let braking = self
            .braking
            .get_or_insert_with(|| speeds.map(|speed| speed.abs() / ramp_s.max(step)));
        let mut next = self.planned;
        for joint in 0..JOINTS {
            let left = (speeds[joint].abs() - braking[joint] * step).max(0.0);
            speeds[joint] = left.copysign(speeds[joint]);
            let angle = next.0[joint] + speeds[joint] * step;
            // The mechanical end of a joint holds it.
            next.0[joint] = angle.clamp(
                self.limits.joint_min_deg[joint],
                self.limits.joint_max_deg[joint],
            );
        }
        self.advance(next);
    }

    /// Forgets the present braking, so that the next one counts from the present speed.
    pub fn brake_anew(&mut self) {
        self.braking = None;
    }

    /// Puts the arm somewhere, as a hand does that moves it while it is soft.
    pub fn place(&mut self, at: JointAngles) {
        self.speeds = [0.0; JOINTS];
        self.braking = None;
        self.planned = at;
        self.delayed.iter_mut().for_each(|place| *place = at);
    }

    /// True when neither the controller nor the servos move the arm.
    #[must_use]
    pub fn is_at_rest(&self) -> bool {
        self.speeds.iter().all(|speed| *speed == 0.0)
            && self.delayed.iter().all(|place| *place == self.planned)
    }

    fn advance(&mut self, next: JointAngles) {
        self.planned = next;
        self.delayed.pop_front();
        self.delayed.push_back(next);
    }

    fn check_range(&self, joints: &JointAngles) -> Result<(), OutOfRange> {
        match self.limits.joint_out_of_range(joints) {
            None => Ok(()),
            Some(index) => Err(OutOfRange {
                joint: index + 1,
                angle_deg: joints.0[index],
            }),
        }
    }
}

#[cfg(test)]
mod tests;
