//! Plans for this crate's tests. They pass the gate as every plan does.

use motion::JointAngles;
use motion::gate::{ProposedMotion, approve};
use motion::limits::RobotLimits;
use motion::plan::Plan;

pub(crate) const HOME: JointAngles = JointAngles([0.0, 10.0, 20.0, 0.0, -45.0, 5.0]);

/// From [`HOME`] by `travel_deg` in `duration_s`, minimum jerk, at 4 ms.
pub(crate) fn minimum_jerk_plan(travel_deg: [f64; 6], duration_s: f64) -> Plan {
    let period_s = 0.004;
    let count = (duration_s / period_s).round() as usize;
    let joints = (0..=count)
        .map(|index| {
            let u = index as f64 / count as f64;
            let share = u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
            let mut joints = HOME;
            for (joint, travel) in joints.0.iter_mut().zip(&travel_deg) {
                *joint += share * travel;
            }
            joints
        })
        .collect();
    let motion = ProposedMotion {
        period_s,
        approach_samples: 0,
        joints,
        signals: Vec::new(),
    };
    // The tool's speed is not what these tests are about.
    let limits = RobotLimits {
        tcp_speed_mm_s: 10_000.0,
        ..RobotLimits::gofa5()
    };
    approve(&motion, &limits).expect("the test's motion must be legal")
}

/// Two seconds, ten degrees on joints 1 and 6.
pub(crate) fn line_plan() -> Plan {
    minimum_jerk_plan([10.0, 0.0, 0.0, 0.0, 0.0, -10.0], 2.0)
}
