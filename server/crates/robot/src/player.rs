//! Walks a plan: which setpoint belongs to which instant. Pure; time comes in as an argument.
//!
//! The phases are: align (from where the reference stands to the plan's first sample, never
//! more than [`ALIGN_LIMIT_DEG`]), play, settle. Speed, pause and stop change the speed along the
//! path ([`motion::path_speed`]), so that the arm never leaves the path that was approved, never
//! jumps, and keeps the limits while it slows down.

use motion::limits::RobotLimits;
use motion::path_speed::{Course, PathSpeed};
use motion::plan::{Plan, Setpoint};
use motion::{JOINTS, JointAngles, minimum_jerk};
use serde::Serialize;
use std::sync::Arc;

/// How far the arm may stand from the plan's first sample, deg.
pub const ALIGN_LIMIT_DEG: f64 = 1.0;
/// Peak speed of a joint while it is being aligned, deg/s.
const ALIGN_SPEED_DEG_S: f64 = 2.0;
/// Shortest time for that, s.
const ALIGN_SHORTEST_S: f64 = 0.3;
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
/// Longest pause, s. A controller ends its guidance by itself when nothing moves for long, and
/// an arm that was forgotten must not begin to move again.
pub const LONGEST_PAUSE_S: f64 = 300.0;
/// Slowest speed that can be asked for, as a share of the plan's.
pub const SLOWEST: f64 = 0.05;

/// What the arm does at the moment, in the words of the screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RunPhase {
    /// On the way to the start of the motion.
    Approach,
    /// In the motion.
    Motion,
    /// Slowed down to standstill on the path, until it is to go on.
    Paused,
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

/// What a person asks of a run. Stopping cannot be taken back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orders {
    /// Slow down to standstill, and end.
    pub stop: bool,
    /// Slow down to standstill, and wait.
    pub pause: bool,
    /// Speed as a share of the plan's, [`SLOWEST`] to 1.
    pub speed: f64,
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
    way: Way,
    limits: RobotLimits,
    /// Where on the way.
    way_s: f64,
    speed: PathSpeed,
    orders: Orders,
    paused_for_s: f64,
    settling_for_s: f64,
    still: Still,
    commanded: JointAngles,
}

/// The plan with what leads from the reference to its first sample.
#[derive(Debug)]
struct Way {
    plan: Arc<Plan>,
    align_from: JointAngles,
    align_s: f64,
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
    pub fn new(plan: Arc<Plan>, reference: JointAngles, limits: &RobotLimits) -> Result<Self, f64> {
        let distance_deg = reference.max_abs_difference(&plan.first());
        if !reference.is_finite() || distance_deg > ALIGN_LIMIT_DEG {
            return Err(distance_deg);
        }
        let align_s = if distance_deg > ALIGNED_DEG {
            (minimum_jerk::PEAK * distance_deg / ALIGN_SPEED_DEG_S).max(ALIGN_SHORTEST_S)
        } else {
            0.0
        };
        Ok(Self {
            way: Way {
                plan,
                align_from: reference,
                align_s,
            },
            limits: limits.clone(),
            way_s: 0.0,
            speed: PathSpeed::steady(1.0),
            orders: Orders {
                stop: false,
                pause: false,
                speed: 1.0,
            },
            paused_for_s: 0.0,
            settling_for_s: 0.0,
            still: Still {
                joints: reference,
                for_s: 0.0,
            },
            commanded: reference,
        })
    }

    /// The same, standing still until it may move.
    #[must_use]
    pub fn waiting(self) -> Self {
        Self {
            speed: PathSpeed::steady(0.0),
            ..self
        }
    }

    /// Gives the plan back.
    #[must_use]
    pub fn into_plan(self) -> Arc<Plan> {
        self.way.plan
    }

    /// Goes `elapsed_s` further. `measured` is the newest feedback.
    pub fn advance(
        &mut self,
        elapsed_s: f64,
        measured: &JointAngles,
        orders: Orders,
    ) -> PlayerStep {
        let elapsed_s = if elapsed_s > 0.0 { elapsed_s } else { 0.0 };
        let (joint, error_deg) = largest_error(&self.commanded, measured);
        if error_deg.is_nan() || error_deg > TRACKING_LIMIT_DEG {
            return self.step(
                Setpoint::at_rest(self.commanded),
                Some(PlayerEnd::NotFollowing { joint, error_deg }),
            );
        }
        self.orders = Orders {
            stop: self.orders.stop || orders.stop || self.paused_for_s > LONGEST_PAUSE_S,
            ..orders
        };
        let target = self.target();
        self.way_s = self
            .speed
            .advance(&self.way, self.way_s, target, elapsed_s, &self.limits);
        let mut setpoint = self.way.at(self.way_s);
        for speed in &mut setpoint.velocities.0 {
            *speed *= self.speed.share();
        }
        self.commanded = setpoint.joints;
        let end = self.end(elapsed_s, measured);
        self.step(setpoint, end)
    }

    fn target(&self) -> f64 {
        let Orders { stop, pause, speed } = self.orders;
        if stop || pause {
            0.0
        } else if speed.is_nan() {
            SLOWEST
        } else {
            speed.clamp(SLOWEST, 1.0)
        }
    }

    fn end(&mut self, elapsed_s: f64, measured: &JointAngles) -> Option<PlayerEnd> {
        let rests = self.speed.is_at_rest();
        if self.orders.stop {
            return rests.then_some(PlayerEnd::Stopped);
        }
        self.paused_for_s = if rests {
            self.paused_for_s + elapsed_s
        } else {
            0.0
        };
        if self.way_s >= self.way.duration_s() {
            return self.settle(elapsed_s, measured);
        }
        None
    }

    fn step(&self, setpoint: Setpoint, end: Option<PlayerEnd>) -> PlayerStep {
        PlayerStep {
            setpoint,
            plan_t_s: self.way.plan_t_s(self.way_s),
            phase: self.phase(),
            end,
        }
    }

    fn phase(&self) -> RunPhase {
        if self.orders.stop {
            RunPhase::Stopping
        } else if self.way_s >= self.way.duration_s() {
            RunPhase::Settling
        } else if self.speed.is_at_rest() {
            RunPhase::Paused
        } else if self.way_s < self.way.align_s + self.way.plan.approach_s() {
            RunPhase::Approach
        } else {
            RunPhase::Motion
        }
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

impl Way {
    fn plan_t_s(&self, way_s: f64) -> f64 {
        (way_s - self.align_s).max(0.0)
    }
}

impl Course for Way {
    /// Minimum jerk from where the reference stood to the plan's first sample, then the plan.
    fn at(&self, way_s: f64) -> Setpoint {
        if way_s >= self.align_s {
            return self.plan.at(way_s - self.align_s);
        }
        let u = way_s / self.align_s;
        let share = minimum_jerk::share(u);
        let slope = minimum_jerk::slope(u) / self.align_s;
        let first = self.plan.first();
        let mut setpoint = Setpoint::at_rest(self.align_from);
        for joint in 0..JOINTS {
            let distance = first.0[joint] - self.align_from.0[joint];
            setpoint.joints.0[joint] += share * distance;
            setpoint.velocities.0[joint] = slope * distance;
        }
        setpoint
    }

    fn duration_s(&self) -> f64 {
        self.align_s + self.plan.duration_s()
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

#[cfg(test)]
mod tests;
