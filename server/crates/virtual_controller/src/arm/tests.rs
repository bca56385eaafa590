//! Tests of the control law against what follows from its equation.

use super::*;

const CYCLE_S: f64 = 0.004_032;

fn arm(settings: EgmSettings) -> Arm {
    Arm::new(settings, JointAngles([0.0; JOINTS]))
}

/// Follows joint 1 at an even speed for `duration_s` and returns how far the arm is behind the
/// reference at the end, deg.
fn distance_behind(speed_deg_s: f64, with_speed: bool, duration_s: f64) -> f64 {
    let mut arm = arm(EgmSettings::default());
    let mut joints = [0.0; JOINTS];
    let mut speeds = [0.0; JOINTS];
    let mut t_s = 0.0;
    while t_s < duration_s {
        t_s += CYCLE_S;
        joints[0] = speed_deg_s * t_s;
        speeds[0] = if with_speed { speed_deg_s } else { 0.0 };
        let reference = Reference {
            joints: Some(JointAngles(joints)),
            velocities: JointVelocities(speeds),
        };
        arm.follow(&reference).unwrap();
    }
    // The last cycle has passed as well: the arm is read at its end.
    speed_deg_s * (t_s + CYCLE_S) - arm.measured().0[0]
}

#[test]
fn positions_alone_lag_by_one_over_the_gain() {
    // A first-order lag follows a ramp at a distance of speed / k, and the servos add theirs.
    let lag_s = distance_behind(10.0, false, 5.0) / 10.0;
    let expected_s = 1.0 / 5.0 + 2.0 * CYCLE_S;
    assert!((lag_s - expected_s).abs() < 0.002, "lag {lag_s} s");
}

#[test]
fn with_the_speed_the_lag_is_below_20_ms() {
    let lag_s = distance_behind(10.0, true, 5.0) / 10.0;
    assert!((0.0..0.020).contains(&lag_s), "lag {lag_s} s");
}

#[test]
fn a_step_is_approached_with_the_time_constant_of_the_gain() {
    let mut arm = arm(EgmSettings::default());
    let reference = Reference {
        joints: Some(JointAngles([10.0; JOINTS])),
        velocities: JointVelocities::ZERO,
    };
    let cycles = (0.2 / CYCLE_S).round() as usize;
    for _ in 0..cycles {
        arm.follow(&reference).unwrap();
    }
    // The answer of position gain and filter together, a system of second order.
    let (gain, filter) = (5.0, TAU * 20.0);
    let root = f64::sqrt(filter * filter - 4.0 * filter * gain);
    let (slow, fast) = ((root - filter) / 2.0, -(root + filter) / 2.0);
    let left = (fast * (slow * 0.2f64).exp() - slow * (fast * 0.2f64).exp()) / (fast - slow);
    let expected = 10.0 * (1.0 - left);
    let angle = arm.planned().0[0];
    assert!(
        (angle - expected).abs() < 0.1,
        "{angle} instead of {expected}"
    );
}

#[test]
fn the_largest_speed_holds_for_all_joints_in_the_same_ratio() {
    let settings = EgmSettings {
        max_speed_deviation_deg_s: 1.0,
        ..EgmSettings::default()
    };
    let mut arm = arm(settings);
    let reference = Reference {
        joints: Some(JointAngles([40.0, 20.0, 10.0, 0.0, 0.0, -40.0])),
        velocities: JointVelocities::ZERO,
    };
    let seconds = 2.0;
    for _ in 0..(seconds / CYCLE_S) as usize {
        arm.follow(&reference).unwrap();
    }
    let angles = arm.planned().0;
    assert!(angles[0] <= seconds * 1.0, "it creeps: {angles:?}");
    assert!(angles[0] > 0.9 * seconds);
    assert!((angles[1] / angles[0] - 0.5).abs() < 0.02);
    assert!((angles[2] / angles[0] - 0.25).abs() < 0.02);
    assert!((angles[5] / angles[0] + 1.0).abs() < 0.02);
}

#[test]
fn the_arm_is_never_faster_than_its_joints_allow() {
    let mut arm = arm(EgmSettings::default());
    let reference = Reference {
        joints: None,
        velocities: JointVelocities([250.0, 0.0, 0.0, 0.0, 0.0, 100.0]),
    };
    let mut before = arm.planned();
    let mut load = 0.0;
    for _ in 0..50 {
        load = arm.follow(&reference).unwrap();
        let now = arm.planned();
        assert!((now.0[0] - before.0[0]) / CYCLE_S <= 125.0 + 1e-6);
        before = now;
    }
    // 250 deg/s asked of a joint that does 125.
    assert!((load - 200.0).abs() < 1e-9);
    assert!((before.0[5] / before.0[0] - 0.4).abs() < 1e-9);
}

#[test]
fn a_reference_outside_the_range_moves_nothing() {
    let mut arm = arm(EgmSettings::default());
    for bad in [90.0, f64::NAN, f64::INFINITY] {
        let mut joints = [0.0; JOINTS];
        joints[2] = bad;
        let reference = Reference {
            joints: Some(JointAngles(joints)),
            velocities: JointVelocities::ZERO,
        };
        let refusal = arm.follow(&reference).unwrap_err();
        assert_eq!(refusal.joint, 3);
        assert!(arm.is_at_rest());
    }
}

#[test]
fn a_speed_cannot_drive_a_joint_out_of_its_range() {
    let mut arm = arm(EgmSettings::default());
    let reference = Reference {
        joints: None,
        velocities: JointVelocities([0.0, 0.0, 140.0, 0.0, 0.0, 0.0]),
    };
    let cycles = (0..500)
        .take_while(|_| arm.follow(&reference).is_ok())
        .count();
    assert!(cycles < 500);
    for _ in 0..500 {
        arm.come_to_rest(0.5);
        assert!(arm.planned().0[2] <= 85.0);
    }
    assert!(arm.is_at_rest());
}

#[test]
fn a_stop_brings_the_arm_to_rest_within_the_ramp() {
    let mut arm = arm(EgmSettings::default());
    let reference = Reference {
        joints: None,
        velocities: JointVelocities([20.0; JOINTS]),
    };
    for _ in 0..200 {
        arm.follow(&reference).unwrap();
    }
    let before = arm.planned().0[0];
    let cycles = (0.5 / CYCLE_S).ceil() as usize + 3;
    for _ in 0..cycles {
        arm.come_to_rest(0.5);
    }
    assert!(arm.is_at_rest());
    // From 20 deg/s evenly to zero in 0.5 s is 5 deg.
    assert!((arm.planned().0[0] - before - 5.0).abs() < 0.1);
}
