//! From a model and a wish (start, goal, speed) to the exact samples that may be
//! streamed: a slow approach to the start, the motion, slowed down where the
//! limits ask for it, and the gate's word on the whole.

mod back;
mod error;
mod signals;
mod targets;
mod warning;

use learning::{Model, dmp::Extent};
use motion::{
    JOINTS, JointAngles,
    gate::{self, Inspection, ProposedMotion},
    limits::RobotLimits,
    minimum_jerk,
    plan::Plan,
    spline::Spline,
};

pub use back::back;
pub use error::PlanError;
pub use signals::remarks as signal_remarks;
pub use targets::Target;
use targets::{resolve, turn_with_start, whole_turns};
pub use warning::Warning;

/// Period of the samples: the nominal cycle of the controller.
const PERIOD_S: f64 = 0.004;
/// The reproduction goes on until it is this near the goal and as slow per second;
/// from there it lands on the goal exactly.
const NEAR_GOAL_DEG: f64 = 0.25;
/// How much longer than taught it may take to come near.
const SETTLING_S: f64 = 60.0;
/// Time of the landing.
const LANDING_S: f64 = 0.8;
/// On the way to the start nobody expects haste.
const APPROACH_JOINT_SPEED_DEG_S: f64 = 20.0;
const APPROACH_TCP_SPEED_MM_S: f64 = 100.0;
const APPROACH_SHORTEST_S: f64 = 1.0;
/// Rest between approach and motion.
const PAUSE_S: f64 = 0.25;
/// A start or goal further than this from the taught one is worth a word.
const FAR_DEG: f64 = 30.0;
/// A curve that begins or ends exactly where a joint's range does ripples across that
/// by less than this; it is held at the end of the range instead of being refused.
const RIPPLE_DEG: f64 = 0.01;
/// Smallest speed that can be asked for.
pub const SLOWEST: f64 = 0.05;

/// What is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanRequest {
    /// Where the motion proper begins.
    pub start: Target,
    /// Where it ends.
    pub goal: Target,
    /// Share of the taught speed, [`SLOWEST`] to 1.
    pub speed: f64,
}

/// A motion that may run, with what people should know about it.
#[derive(Clone, Debug)]
pub struct PlannedMotion {
    /// The approved samples.
    pub plan: Plan,
    /// Where the motion proper begins.
    pub start: JointAngles,
    /// Where it should end.
    pub goal: JointAngles,
    /// How many times slower than taught the motion proper is.
    pub stretch: f64,
    /// How many times slower than asked for the limits made it; 1 when they did not.
    pub slowed_by: f64,
    /// What the gate saw.
    pub inspection: Inspection,
    /// Remarks for people.
    pub warnings: Vec<Warning>,
}

/// Plans the reproduction of `model`. `present` is where the arm stands; without
/// it the plan has no approach and can only be looked at.
pub fn plan(
    model: &Model,
    request: &PlanRequest,
    present: Option<JointAngles>,
    limits: &RobotLimits,
) -> Result<PlannedMotion, PlanError> {
    if !(SLOWEST..=1.0).contains(&request.speed) {
        return Err(PlanError::BadSpeed(request.speed));
    }
    let start = resolve("start", request.start, model.start_deg(), present, limits)?;
    let mut goal = resolve("goal", request.goal, model.goal_deg(), present, limits)?;
    let turned = turn_with_start(&start, &mut goal, model, limits)?;
    let motion = reproduction(model, &start, &goal)?;
    let (motion, stretch) = within_rates(&motion, 1.0 / request.speed, limits)?;

    let mut joints = match present {
        Some(present) => approach(&present, &start, limits)?,
        None => Vec::new(),
    };
    let approach_samples = joints.len();
    joints.extend(motion);
    let course = signals::Course {
        at_start_s: approach_samples.saturating_sub(samples_in(PAUSE_S)) as f64 * PERIOD_S,
        begins_s: approach_samples as f64 * PERIOD_S,
        stretch,
        ends_s: (joints.len() - 1) as f64 * PERIOD_S,
    };
    let proposed = ProposedMotion {
        period_s: PERIOD_S,
        approach_samples,
        joints,
        signals: signals::of(model, course),
    };
    let inspection = gate::inspect(&proposed, limits)?;
    let plan = gate::approve(&proposed, limits)?;
    let slowed_by = stretch * request.speed;
    let mut warnings = warnings(
        model,
        &start,
        &goal,
        slowed_by,
        &inspection,
        present,
        limits,
    );
    if let Some(joint) = turned {
        warnings.push(Warning::WholeTurn { joint: joint + 1 });
    }
    Ok(PlannedMotion {
        plan,
        start,
        goal,
        stretch,
        slowed_by,
        inspection,
        warnings,
    })
}

/// The motion at the taught speed, at rest at the goal.
fn reproduction(
    model: &Model,
    start: &JointAngles,
    goal: &JointAngles,
) -> Result<Spline, PlanError> {
    let extent = Extent::UntilSettled {
        tolerance_deg: NEAR_GOAL_DEG,
        longest_s: model.duration_s() + SETTLING_S,
    };
    let path = model.reproduce(&start.0, &goal.0, extent)?;
    let mut points: Vec<JointAngles> = path
        .rows()
        .map(|row| JointAngles(std::array::from_fn(|j| row[j])))
        .collect();
    let end = points[points.len() - 1];
    if !end.is_finite() || end.max_abs_difference(goal) > NEAR_GOAL_DEG {
        return Err(PlanError::DoesNotSettle);
    }
    let dt_s = model.primitive.dt_s;
    land(&mut points, goal, dt_s);
    Ok(Spline::through(points, dt_s))
}

/// Leads a motion that is near its goal to rest exactly there: for each joint the
/// polynomial of fifth degree that takes over position, speed and acceleration.
fn land(points: &mut Vec<JointAngles>, goal: &JointAngles, dt_s: f64) {
    let n = points.len();
    let back = |i: usize| points[n - 1 - i.min(n - 1)];
    let (now, before, earlier) = (back(0), back(1), back(2));
    let steps = (LANDING_S / dt_s).ceil() as usize;
    let duration = steps as f64 * dt_s;
    let course: [[f64; 6]; JOINTS] = std::array::from_fn(|j| {
        let (p, q, r) = (now.0[j], before.0[j], earlier.0[j]);
        // Backward differences, the speed to second order.
        let speed = (3.0 * p - 4.0 * q + r) / (2.0 * dt_s) * duration;
        let acceleration = (p - 2.0 * q + r) / (dt_s * dt_s) * duration * duration;
        let way = goal.0[j] - p;
        [
            p,
            speed,
            0.5 * acceleration,
            10.0 * way - 6.0 * speed - 1.5 * acceleration,
            -15.0 * way + 8.0 * speed + 1.5 * acceleration,
            6.0 * way - 3.0 * speed - 0.5 * acceleration,
        ]
    });
    for step in 1..steps {
        let u = step as f64 / steps as f64;
        points.push(JointAngles(course.map(|c| {
            c.iter()
                .rev()
                .fold(0.0, |sum, coefficient| sum * u + coefficient)
        })));
    }
    points.push(*goal);
}

/// Samples of the curve, stretched in time by at least `stretch` and so far that
/// the rates keep to the limits; and by how much it was stretched.
fn within_rates(
    curve: &Spline,
    stretch: f64,
    limits: &RobotLimits,
) -> Result<(Vec<JointAngles>, f64), PlanError> {
    let mut stretch = stretch;
    loop {
        let joints = sampled(curve, stretch, limits);
        let proposed = ProposedMotion {
            period_s: PERIOD_S,
            approach_samples: 0,
            joints,
            signals: Vec::new(),
        };
        let inspection = gate::inspect(&proposed, limits)?;
        match inspection.breach {
            // A little more than asked for, so that rounding does not ask again. The
            // loop ends: a curve too long for the gate is refused as malformed.
            Some(breach) => stretch *= breach.slow_down_by * 1.001,
            None => return Ok((proposed.joints, stretch)),
        }
    }
}

fn sampled(curve: &Spline, stretch: f64, limits: &RobotLimits) -> Vec<JointAngles> {
    let duration = curve.duration_s() * stretch;
    let count = (duration / PERIOD_S).ceil() as usize + 1;
    (0..count.min(gate::MAX_SAMPLES + 1))
        .map(|i| {
            let joints = curve.at(i as f64 * PERIOD_S / stretch);
            JointAngles(std::array::from_fn(|j| {
                let (min, max) = (limits.joint_min_deg[j], limits.joint_max_deg[j]);
                let held = joints.0[j].clamp(min, max);
                if (joints.0[j] - held).abs() <= RIPPLE_DEG {
                    held
                } else {
                    joints.0[j]
                }
            }))
        })
        .collect()
}

/// The way from where the arm stands to the start, slow, with minimum jerk, and a
/// rest at its end. An arm that stands at the start waits there.
fn approach(
    from: &JointAngles,
    to: &JointAngles,
    limits: &RobotLimits,
) -> Result<Vec<JointAngles>, PlanError> {
    let mut gentle = limits.clone();
    for speed in &mut gentle.joint_speed_deg_s {
        *speed = speed.min(APPROACH_JOINT_SPEED_DEG_S);
    }
    gentle.tcp_speed_mm_s = gentle.tcp_speed_mm_s.min(APPROACH_TCP_SPEED_MM_S);
    let steps = samples_in(APPROACH_SHORTEST_S);
    let points = (0..=steps)
        .map(|i| {
            let u = i as f64 / steps as f64;
            let s = minimum_jerk::share(u);
            JointAngles(std::array::from_fn(|j| {
                from.0[j] + s * (to.0[j] - from.0[j])
            }))
        })
        .collect();
    let (mut joints, _) = within_rates(&Spline::through(points, PERIOD_S), 1.0, &gentle)?;
    joints.extend(std::iter::repeat_n(*to, samples_in(PAUSE_S)));
    Ok(joints)
}

fn samples_in(seconds: f64) -> usize {
    (seconds / PERIOD_S).round() as usize
}

fn warnings(
    model: &Model,
    start: &JointAngles,
    goal: &JointAngles,
    slowed_by: f64,
    inspection: &Inspection,
    present: Option<JointAngles>,
    limits: &RobotLimits,
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    for (which, target, taught) in [
        ("start", start, model.start_deg()),
        ("goal", goal, model.goal_deg()),
    ] {
        let off = |j: usize| {
            let offset = target.0[j] - taught[j];
            (offset - 360.0 * whole_turns(offset)).abs()
        };
        let furthest = (0..JOINTS).max_by(|&a, &b| off(a).total_cmp(&off(b)));
        if let Some(j) = furthest.filter(|&j| off(j) > FAR_DEG) {
            warnings.push(Warning::FarFromTaught {
                which,
                joint: j + 1,
                off_deg: off(j),
            });
        }
    }
    for j in 0..JOINTS {
        let off = |target: &JointAngles, taught: &[f64]| target.0[j] - taught[j];
        let further = off(goal, model.goal_deg()) - off(start, model.start_deg());
        if whole_turns(further) != 0.0 {
            warnings.push(Warning::TurnsFurther {
                joint: j + 1,
                further_deg: further.abs(),
            });
        }
    }
    if let Some(fidelity) = &model.report.fidelity
        && fidelity.missed_over_mutual.is_some_and(|ratio| ratio > 1.0)
    {
        warnings.push(Warning::MissesTheTakes {
            mean_mm: fidelity.missed_mean_mm,
            max_mm: fidelity.missed_max_mm,
        });
    }
    if slowed_by > 1.01 {
        warnings.push(Warning::Slowed { factor: slowed_by });
    }
    if inspection.min_wrist_angle_deg < limits.min_wrist_angle_deg {
        warnings.push(Warning::StretchedWrist);
    }
    if present.is_none() {
        warnings.push(Warning::NoArm);
    }
    warnings
}

#[cfg(test)]
mod tests;
