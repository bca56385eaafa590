//! Walks a plan: which setpoint belongs to which instant. Pure; time comes in as an argument.
//!
//! The phases are: align (from where the reference stands to the plan's first sample, never
//! more than [`ALIGN_LIMIT_DEG`]), play, settle. Stopping scales the speed along the path down to
//! zero within [`STOP_S`], so that the arm never leaves the path that was approved, and never
//! jumps.

use motion::plan::{Plan, Setpoint};
use motion::{JOINTS, JointAngles, JointVelocities, minimum_jerk};
use serde::Serialize;
use std::sync::Arc;

/// Time from full speed to standstill when stopped, s.
pub const STOP_S: f64 = 0.3;
/// How far the arm may stand from the plan's first sample, deg.
pub const ALIGN_LIMIT_DEG: f64 = 1.0;
/// Peak speed of a joint while it is being aligned, deg/s.
const ALIGN_SPEED_DEG_S: f64 = 2.0;
/// A smaller distance than this needs no alignment, deg.
const ALIGNED_DEG: f64 = 1e-9;
/// The arm has arrived when it is this near to the last reference, deg ...
const SETTLED_DEG: f64 = 0.02;
/// ... and moved no more than this, deg ...
const STILL_DEG: f64 = 0.01;
/// ... for this long, s.
const STILL_S: f64 = 0.05;
/// Longest wait for that, s.
const SETTLE_S: f64 = 5.0;
/// Farther away than this after [`SETTLE_S`], the arm did not follow, deg.
const NOT_SETTLED_DEG: f64 = 0.5;
/// Farthest that the arm may be from its reference on the way, deg.
pub const TRACKING_LIMIT_DEG: f64 = 5.0;

/// What the arm does at the moment, in the words of the screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RunPhase {
    /// On the way to the start of the motion.
    Approach,
    /// In the motion.
    Motion,
    /// At the end of the plan, waiting for the arm to arrive.
    Settling,
    /// Coming to a standstill.
    Stopping,
}

/// How a walk through a plan ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlayerEnd {
    /// The arm stands at the end of the plan.
    Completed,
    /// It was stopped and the reference stands.
    Stopped,
    /// The arm is too far from where it should be.
    NotFollowing {
        /// Joint, from 0.
        joint: usize,
        /// How far, deg.
        error_deg: f64,
    },
    /// The plan is over and the arm did not arrive.
    NotSettled {
        /// Joint, from 0.
        joint: usize,
        /// How far it is off, deg.
        error_deg: f64,
    },
}

/// One step along the plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlayerStep {
    /// Reference for this instant.
    pub setpoint: Setpoint,
    /// Time within the plan, s.
    pub plan_t_s: f64,
    /// Phase after the step.
    pub phase: RunPhase,
    /// Set on the last step.
    pub end: Option<PlayerEnd>,
}

/// A walk through one plan.
#[derive(Debug)]
pub struct Player {
    plan: Arc<Plan>,
    /// Reference at the beginning, and how long it takes to bring it to the plan's first sample.
    align_from: JointAngles,
    align_s: f64,
    aligned_for_s: f64,
    plan_t_s: f64,
    stopping_for_s: Option<f64>,
    settling_for_s: f64,
    still: Still,
    commanded: JointAngles,
}

/// Since when the arm has been standing.
#[derive(Debug, Clone, Copy)]
struct Still {
    joints: JointAngles,
    for_s: f64,
}

impl Player {
    /// Begins with the reference at `reference`, or says by how much the arm is away from the
    /// plan's first sample when that is too far.
    ///
    /// # Errors
    /// The distance in degrees, when above [`ALIGN_LIMIT_DEG`] or no number.
    pub fn new(plan: Arc<Plan>, reference: JointAngles) -> Result<Self, f64> {
        let distance_deg = reference.max_abs_difference(&plan.first());
        if !reference.is_finite() || distance_deg > ALIGN_LIMIT_DEG {
            return Err(distance_deg);
        }
        let align_s = if distance_deg > ALIGNED_DEG {
            (minimum_jerk::PEAK * distance_deg / ALIGN_SPEED_DEG_S).max(STOP_S)
        } else {
            0.0
        };
        Ok(Self {
            plan,
            align_from: reference,
            align_s,
            aligned_for_s: 0.0,
            plan_t_s: 0.0,
            stopping_for_s: None,
            settling_for_s: 0.0,
            still: Still {
                joints: reference,
                for_s: 0.0,
            },
            commanded: reference,
        })
    }

    /// Gives the plan back.
    #[must_use]
    pub fn into_plan(self) -> Arc<Plan> {
        self.plan
    }

    /// Goes `elapsed_s` further. `measured` is the newest feedback; `stop` may come and stays in
    /// force.
    pub fn advance(&mut self, elapsed_s: f64, measured: &JointAngles, stop: bool) -> PlayerStep {
        let elapsed_s = if elapsed_s > 0.0 { elapsed_s } else { 0.0 };
        let (joint, error_deg) = largest_error(&self.commanded, measured);
        if error_deg.is_nan() || error_deg > TRACKING_LIMIT_DEG {
            return self.step(
                at_rest(self.commanded),
                Some(PlayerEnd::NotFollowing { joint, error_deg }),
            );
        }
        if stop && self.stopping_for_s.is_none() {
            self.stopping_for_s = Some(0.0);
        }
        let (progress_s, factor, stopped) = self.path_time(elapsed_s);
        let setpoint = self.setpoint_after(progress_s, factor);
        self.commanded = setpoint.joints;
        let end = if stopped {
            Some(PlayerEnd::Stopped)
        } else if self.plan_t_s >= self.plan.duration_s() && self.stopping_for_s.is_none() {
            self.settle(elapsed_s, measured)
        } else {
            None
        };
        self.step(setpoint, end)
    }

    fn step(&self, setpoint: Setpoint, end: Option<PlayerEnd>) -> PlayerStep {
        PlayerStep {
            setpoint,
            plan_t_s: self.plan_t_s,
            phase: self.phase(),
            end,
        }
    }

    fn phase(&self) -> RunPhase {
        if self.stopping_for_s.is_some() {
            RunPhase::Stopping
        } else if self.plan_t_s >= self.plan.duration_s() {
            RunPhase::Settling
        } else if self.plan_t_s < self.plan.approach_s() || self.aligned_for_s < self.align_s {
            RunPhase::Approach
        } else {
            RunPhase::Motion
        }
    }

    /// By how much the path goes on in `elapsed_s`, the path-speed factor at its end, and
    /// whether the path has come to a standstill.
    ///
    /// The factor falls from 1 to 0 as 1 - 3u² + 2u³ with u = time / [`STOP_S`]; the progress is
    /// its exact integral, so that positions and speeds agree.
    fn path_time(&mut self, elapsed_s: f64) -> (f64, f64, bool) {
        let Some(before_s) = self.stopping_for_s else {
            return (elapsed_s, 1.0, false);
        };
        let after_s = before_s + elapsed_s;
        self.stopping_for_s = Some(after_s);
        let travelled = |t_s: f64| {
            let u = (t_s / STOP_S).min(1.0);
            STOP_S * (u - u * u * u + 0.5 * u * u * u * u)
        };
        let u = (after_s / STOP_S).min(1.0);
        let factor = 1.0 - u * u * (3.0 - 2.0 * u);
        let progress_s = travelled(after_s) - travelled(before_s);
        (progress_s, factor, after_s >= STOP_S)
    }

    fn setpoint_after(&mut self, progress_s: f64, factor: f64) -> Setpoint {
        let left_to_align_s = self.align_s - self.aligned_for_s;
        if left_to_align_s > 0.0 {
            self.aligned_for_s += progress_s;
            if self.aligned_for_s < self.align_s {
                return self.align(factor);
            }
        }
        self.plan_t_s += progress_s - left_to_align_s.max(0.0);
        self.plan_t_s = self.plan_t_s.min(self.plan.duration_s());
        let mut setpoint = self.plan.at(self.plan_t_s);
        for speed in &mut setpoint.velocities.0 {
            *speed *= factor;
        }
        setpoint
    }

    /// Minimum jerk from where the reference stood to the plan's first sample.
    fn align(&self, factor: f64) -> Setpoint {
        let u = self.aligned_for_s / self.align_s;
        let share = minimum_jerk::share(u);
        let slope = minimum_jerk::slope(u) / self.align_s;
        let first = self.plan.first();
        let mut setpoint = at_rest(self.align_from);
        for joint in 0..JOINTS {
            let distance = first.0[joint] - self.align_from.0[joint];
            setpoint.joints.0[joint] += share * distance;
            setpoint.velocities.0[joint] = slope * distance * factor;
        }
        setpoint
    }

    fn settle(&mut self, elapsed_s: f64, measured: &JointAngles) -> Option<PlayerEnd> {
        let (joint, error_deg) = largest_error(&self.commanded, measured);
        let near = error_deg <= SETTLED_DEG;
        if near && measured.max_abs_difference(&self.still.joints) <= STILL_DEG {
            self.still.for_s += elapsed_s;
        } else {
            self.still = Still {
                joints: *measured,
                for_s: 0.0,
            };
        }
        self.settling_for_s += elapsed_s;
        if self.still.for_s >= STILL_S {
            return Some(PlayerEnd::Completed);
        }
        if self.settling_for_s < SETTLE_S {
            return None;
        }
        if error_deg <= NOT_SETTLED_DEG {
            Some(PlayerEnd::Completed)
        } else {
            Some(PlayerEnd::NotSettled { joint, error_deg })
        }
    }
}

/// The joint with the largest difference, and that difference; NaN wins.
fn largest_error(commanded: &JointAngles, measured: &JointAngles) -> (usize, f64) {
    let mut worst = (0, 0.0);
    for (joint, (a, b)) in commanded.0.iter().zip(&measured.0).enumerate() {
        let error = (a - b).abs();
        if error.is_nan() || error > worst.1 {
            worst = (joint, error);
        }
        if error.is_nan() {
            break;
        }
    }
    worst
}

fn at_rest(joints: JointAngles) -> Setpoint {
    Setpoint {
        joints,
        velocities: JointVelocities::ZERO,
    }
}

#[cfg(test)]
mod tests;
