//! Changing the speed keeps to the path and to the limits, and comes to an end.

use super::*;
use crate::JointAngles;
use proptest::prelude::*;

const CYCLE_S: f64 = 0.004_032;

/// A sine of each joint between two rests: its speed and acceleration are known in closed form.
#[derive(Debug)]
struct Swing {
    amplitude_deg: [f64; JOINTS],
    duration_s: f64,
}

impl Course for Swing {
    fn at(&self, t_s: f64) -> Setpoint {
        let w = std::f64::consts::TAU / self.duration_s;
        let t_s = t_s.clamp(0.0, self.duration_s);
        Setpoint {
            joints: JointAngles(self.amplitude_deg.map(|a| a * (1.0 - (w * t_s).cos()))),
            velocities: JointVelocities(self.amplitude_deg.map(|a| a * w * (w * t_s).sin())),
        }
    }

    fn duration_s(&self) -> f64 {
        self.duration_s
    }
}

/// A swing whose acceleration reaches `share` of the limit of its quickest joint.
fn swing(share: f64, duration_s: f64, weights: [f64; JOINTS]) -> Swing {
    let limits = RobotLimits::gofa5();
    let w = std::f64::consts::TAU / duration_s;
    let mut amplitude_deg = weights;
    for (joint, amplitude) in amplitude_deg.iter_mut().enumerate() {
        let by_acceleration = limits.joint_acceleration_deg_s2[joint] / (w * w);
        let by_speed = limits.joint_speed_deg_s[joint] / w;
        *amplitude *= share * by_acceleration.min(by_speed);
    }
    Swing {
        amplitude_deg,
        duration_s,
    }
}

#[test]
fn a_stop_takes_a_third_of_a_second_at_hand_guided_speeds() {
    let swing = swing(0.2, 4.0, [1.0; JOINTS]);
    let mut speed = PathSpeed::steady(1.0);
    let (mut t_s, mut took_s) = (1.0, 0.0);
    while !speed.is_at_rest() {
        t_s = speed.advance(&swing, t_s, 0.0, CYCLE_S, &RobotLimits::gofa5());
        took_s += CYCLE_S;
        assert!(took_s < 0.45, "{took_s}");
    }
    assert!(t_s > 1.0);
    assert_eq!(
        speed.advance(&swing, t_s, 0.0, 1.0, &RobotLimits::gofa5()),
        t_s
    );
}

#[test]
fn no_time_changes_nothing() {
    let swing = swing(0.5, 3.0, [1.0; JOINTS]);
    let mut speed = PathSpeed::steady(1.0);
    speed.advance(&swing, 0.7, 0.0, CYCLE_S, &RobotLimits::gofa5());
    for nothing in [0.0, -1.0, f64::NAN] {
        let before = speed;
        let t_s = speed.advance(&swing, 0.7, 0.0, nothing, &RobotLimits::gofa5());
        assert_eq!((t_s, speed), (0.7, before));
    }
}

#[test]
fn the_change_begins_with_the_first_cycle() {
    let swing = swing(0.5, 3.0, [1.0; JOINTS]);
    let mut speed = PathSpeed::steady(1.0);
    speed.advance(&swing, 0.7, 0.0, CYCLE_S, &RobotLimits::gofa5());
    assert!(speed.share() < 1.0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    #[test]
    fn whatever_is_asked_for_when_the_limits_hold_and_the_target_is_reached(
        share in 0.05..0.95_f64,
        duration_s in 1.0..8.0_f64,
        weights in proptest::array::uniform6(-1.0..1.0_f64),
        targets in proptest::collection::vec((0.0..1.0_f64, 1_usize..200), 1..12),
    ) {
        let limits = RobotLimits::gofa5();
        let swing = swing(share, duration_s, weights);
        let mut speed = PathSpeed::steady(1.0);
        let mut t_s = 0.0;
        let mut last = [swing.at(0.0).joints; 2];
        let mut check = |t_s: f64| {
            let now = swing.at(t_s).joints;
            for joint in 0..JOINTS {
                let difference =
                    now.0[joint] - 2.0 * last[1].0[joint] + last[0].0[joint];
                let acceleration = (difference / (CYCLE_S * CYCLE_S)).abs();
                let limit = limits.joint_acceleration_deg_s2[joint] * 1.05;
                assert!(acceleration <= limit, "joint {joint}: {acceleration}");
            }
            last = [last[1], now];
        };
        for (target, cycles) in targets {
            for _ in 0..cycles {
                let before = t_s;
                t_s = speed.advance(&swing, t_s, target, CYCLE_S, &limits);
                prop_assert!(t_s >= before && (0.0..=1.0).contains(&speed.share()));
                check(t_s);
            }
        }
        let mut waited_s = 0.0;
        while !speed.is_at_rest() {
            t_s = speed.advance(&swing, t_s, 0.0, CYCLE_S, &limits);
            check(t_s);
            waited_s += CYCLE_S;
            prop_assert!(waited_s < 1.5, "{speed:?}");
        }
    }

    #[test]
    fn a_long_step_is_the_same_as_many_short_ones(
        target in 0.0..1.0_f64,
        cycles in 1_usize..25,
    ) {
        let limits = RobotLimits::gofa5();
        let swing = swing(0.6, 3.0, [0.7, -0.4, 1.0, 0.2, -0.8, 0.5]);
        let (mut once, mut often) = (PathSpeed::steady(1.0), PathSpeed::steady(1.0));
        let at_once = once.advance(&swing, 0.9, target, STEP_S * cycles as f64, &limits);
        let mut t_s = 0.9;
        for _ in 0..cycles {
            t_s = often.advance(&swing, t_s, target, STEP_S, &limits);
        }
        prop_assert!((at_once - t_s).abs() < 1e-3, "{at_once} {t_s}");
    }
}
