//! What the gate lets through and what it refuses.

use super::*;

const DT: f64 = 0.004;

/// Joint 1 moves by `travel_deg` in `duration_s` with minimum jerk, from 10 deg.
fn minimum_jerk(travel_deg: f64, duration_s: f64) -> ProposedMotion {
    let n = (duration_s / DT).round() as usize + 1;
    let joints = (0..n)
        .map(|i| {
            let u = i as f64 / (n - 1) as f64;
            let s = u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
            JointAngles([10.0 + travel_deg * s, 0.0, 0.0, 0.0, -45.0, 0.0])
        })
        .collect();
    ProposedMotion {
        period_s: DT,
        approach_samples: 0,
        joints,
        signals: Vec::new(),
    }
}

#[test]
fn a_gentle_motion_is_approved_with_its_exact_samples() {
    let motion = minimum_jerk(20.0, 4.0);
    let plan = approve(&motion, &RobotLimits::gofa5()).unwrap();
    assert_eq!(plan.samples().len(), motion.joints.len());
    assert_eq!(plan.first(), motion.joints[0]);
    assert_eq!(plan.last(), *motion.joints.last().unwrap());
    for (sample, joints) in plan.samples().iter().zip(&motion.joints) {
        assert_eq!(sample.joints, *joints);
    }
}

#[test]
fn peak_speed_is_that_of_the_closed_form() {
    // Minimum jerk peaks at 15/8 of the mean speed.
    let inspection = inspect(&minimum_jerk(20.0, 4.0), &RobotLimits::gofa5()).unwrap();
    assert!((inspection.peak_joint_speed_deg_s[0] - 15.0 / 8.0 * 5.0).abs() < 1e-3);
    // tool0 stands off from axis 1 by its own radius: v = omega r.
    let p = kinematics::tool0(&JointAngles([0.0, 0.0, 0.0, 0.0, -45.0, 0.0]))
        .position
        .0;
    let radius = p[0].hypot(p[1]);
    let expected = (15.0_f64 / 8.0 * 5.0).to_radians() * radius;
    assert!((inspection.peak_tcp_speed_mm_s - expected).abs() < 0.05);
}

#[test]
fn too_quick_is_refused_and_the_advised_slowing_mends_it() {
    let limits = RobotLimits::gofa5();
    let Err(Refusal::TooQuick(breach)) = approve(&minimum_jerk(60.0, 1.0), &limits) else {
        panic!("a motion of 60 deg in a second must be refused");
    };
    assert!(breach.slow_down_by > 1.0);
    let slower = minimum_jerk(60.0, 1.0 * breach.slow_down_by * 1.01);
    approve(&slower, &limits).unwrap();
}

#[test]
fn a_jump_is_refused() {
    let mut motion = minimum_jerk(5.0, 4.0);
    motion.joints[500].0[3] += 0.5;
    assert!(matches!(
        approve(&motion, &RobotLimits::gofa5()),
        Err(Refusal::TooQuick(Breach {
            quantity: Quantity::JointJerk(3),
            ..
        })) | Err(Refusal::TooQuick(Breach {
            quantity: Quantity::JointAcceleration(3),
            ..
        })) | Err(Refusal::TooQuick(Breach {
            quantity: Quantity::JointSpeed(3),
            ..
        }))
    ));
}

#[test]
fn leaving_the_range_names_joint_time_value_and_limit() {
    let refusal = approve(&minimum_jerk(175.0, 60.0), &RobotLimits::gofa5()).unwrap_err();
    let Refusal::OutsideRange {
        joint,
        t_s,
        value_deg,
        limit_deg,
    } = refusal
    else {
        panic!("{refusal}");
    };
    assert_eq!((joint, limit_deg), (0, 180.0));
    assert!(t_s > 30.0 && value_deg > 180.0);
}

#[test]
fn nan_and_empty_are_refused() {
    let mut motion = minimum_jerk(5.0, 4.0);
    motion.joints[3].0[5] = f64::NAN;
    assert!(matches!(
        approve(&motion, &RobotLimits::gofa5()),
        Err(Refusal::NotFinite { joint: 5, .. })
    ));
    motion.joints.clear();
    assert_eq!(
        approve(&motion, &RobotLimits::gofa5()).unwrap_err(),
        Refusal::Malformed
    );
}

#[test]
fn an_end_in_full_motion_is_refused() {
    let mut motion = minimum_jerk(40.0, 4.0);
    motion.joints.truncate(500);
    assert!(matches!(
        approve(&motion, &RobotLimits::gofa5()),
        Err(Refusal::TooQuick(_))
    ));
}

#[test]
fn the_hash_names_the_samples() {
    let limits = RobotLimits::gofa5();
    let plan = approve(&minimum_jerk(20.0, 4.0), &limits).unwrap();
    let same = approve(&minimum_jerk(20.0, 4.0), &limits).unwrap();
    let other = approve(&minimum_jerk(20.000_001, 4.0), &limits).unwrap();
    assert_eq!(plan.hash(), same.hash());
    assert_ne!(plan.hash(), other.hash());
}

#[test]
fn the_plan_interpolates_smoothly_and_rests_outside() {
    let plan = approve(&minimum_jerk(20.0, 4.0), &RobotLimits::gofa5()).unwrap();
    assert_eq!(plan.at(-1.0).joints, plan.first());
    assert_eq!(plan.at(f64::NAN).joints, plan.first());
    assert_eq!(plan.at(99.0).joints, plan.last());
    assert_eq!(plan.at(99.0).velocities, JointVelocities::ZERO);
    // Between samples it follows the closed form of the motion.
    for i in 0..997 {
        let t = 0.002 + f64::from(i) * DT;
        let u = t / 4.0;
        let exact = 10.0 + 20.0 * u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
        let slope = 20.0 / 4.0 * 30.0 * u * u * (1.0 - u) * (1.0 - u);
        assert!((plan.at(t).joints.0[0] - exact).abs() < 1e-6);
        assert!((plan.at(t).velocities.0[0] - slope).abs() < 1e-3);
    }
}
