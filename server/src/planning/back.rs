//! The way back: along the path that the arm came, from where it stopped to where it began.

use motion::{
    JointAngles, JointVelocities,
    gate::{self, Inspection, ProposedMotion},
    limits::RobotLimits,
    path_speed::{Course, PathSpeed},
    plan::{Plan, Setpoint},
};

use super::{PERIOD_S, PlanError};

/// Shares of the plan's speed that are tried, the quickest first: where the path bends sharply
/// right at the stop, starting from rest there may need a slower pace.
const PACES: [f64; 3] = [1.0, 0.5, 0.2];
/// Shorter ways than this are none, seconds of the plan.
const SHORTEST_S: f64 = 0.05;

/// The checked way back of an arm that stopped at `stopped_s` of `plan`: to the start of its
/// motion, or, when it was still on its way there, to where it stood before.
///
/// # Errors
/// [`PlanError::NoWayBack`] when it has hardly moved; as the gate says otherwise.
pub fn back(
    plan: &Plan,
    stopped_s: f64,
    limits: &RobotLimits,
) -> Result<(Plan, Inspection), PlanError> {
    let ends_s = if stopped_s > plan.approach_s() {
        plan.approach_s()
    } else {
        0.0
    };
    let way = Reversed {
        plan,
        from_s: stopped_s.min(plan.duration_s()),
        to_s: ends_s,
    };
    if way.duration_s() < SHORTEST_S {
        return Err(PlanError::NoWayBack);
    }
    let mut refusal = PlanError::NoWayBack;
    for pace in PACES {
        let proposed = ProposedMotion {
            period_s: PERIOD_S,
            approach_samples: 0,
            joints: sampled(&way, pace, limits),
            signals: Vec::new(),
        };
        let approved = gate::inspect(&proposed, limits)
            .and_then(|inspection| Ok((gate::approve(&proposed, limits)?, inspection)));
        match approved {
            Ok(approved) => return Ok(approved),
            Err(refused) => refusal = refused.into(),
        }
    }
    Err(refusal)
}

/// From rest at the stop to the plan's own rest at the other end.
fn sampled(way: &Reversed, pace: f64, limits: &RobotLimits) -> Vec<JointAngles> {
    let mut speed = PathSpeed::steady(0.0);
    let mut t_s = 0.0;
    let mut joints = vec![way.at(0.0).joints];
    while t_s < way.duration_s() && joints.len() <= gate::MAX_SAMPLES {
        t_s = speed.advance(way, t_s, pace, PERIOD_S, limits);
        joints.push(way.at(t_s).joints);
    }
    joints
}

/// A plan from a later to an earlier time.
struct Reversed<'a> {
    plan: &'a Plan,
    from_s: f64,
    to_s: f64,
}

impl Course for Reversed<'_> {
    fn at(&self, t_s: f64) -> Setpoint {
        let t_s = t_s.clamp(0.0, self.duration_s());
        let Setpoint { joints, velocities } = self.plan.at(self.from_s - t_s);
        Setpoint {
            joints,
            velocities: JointVelocities(velocities.0.map(|speed| -speed)),
        }
    }

    fn duration_s(&self) -> f64 {
        self.from_s - self.to_s
    }
}
