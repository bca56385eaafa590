//! Legal motions pass unchanged, everything else becomes a movement.

use super::*;
use crate::player::{Orders, Player};
use crate::testing::{line_plan, minimum_jerk_plan};
use proptest::prelude::*;
use std::sync::Arc;

const CYCLE_S: f64 = 0.004_032;

fn limits() -> RobotLimits {
    RobotLimits::gofa5()
}

/// Walks a plan with the given step times, limiting every setpoint; stops at `stop_at_s`.
/// Panics when a setpoint was changed.
fn assert_unchanged(plan: motion::plan::Plan, steps_s: &[f64], stop_at_s: f64) {
    let plan = Arc::new(plan);
    let mut limiter = RateLimiter::new(&limits(), plan.first());
    let mut player = Player::new(Arc::clone(&plan), plan.first(), &limits()).unwrap();
    let mut now_s = 0.0;
    let mut measured = plan.first();
    for step_s in steps_s.iter().cycle() {
        now_s += step_s;
        let orders = Orders {
            stop: now_s >= stop_at_s,
            pause: false,
            speed: 1.0,
        };
        let step = player.advance(*step_s, &measured, orders);
        let limited = limiter.limit(&step.setpoint, *step_s);
        assert_eq!(limited, step.setpoint, "at {now_s} s");
        measured = limited.joints;
        if step.end.is_some() || now_s > stop_at_s + 2.0 {
            break;
        }
    }
}

#[test]
fn a_plan_at_its_limits_and_its_stop_pass_unchanged() {
    for stop_at_s in [0.1, 0.4, 0.77, 1.2, 99.0] {
        let fast = minimum_jerk_plan([40.0, 0.0, 0.0, 20.0, 15.0, -50.0], 1.6);
        assert_unchanged(fast, &[CYCLE_S], stop_at_s);
    }
}

#[test]
fn lost_messages_do_not_bend_a_plan() {
    let steps = [CYCLE_S, 2.0 * CYCLE_S, CYCLE_S, 0.016, 0.000_5, CYCLE_S];
    for stop_at_s in [0.5, 99.0] {
        let plan = minimum_jerk_plan([40.0, 0.0, 0.0, 20.0, 15.0, -50.0], 1.6);
        assert_unchanged(plan, &steps, stop_at_s);
    }
}

#[test]
fn a_jump_of_the_wish_becomes_a_movement_that_arrives() {
    let plan = line_plan();
    let start = plan.first();
    let mut limiter = RateLimiter::new(&limits(), start);
    let mut target = start;
    target.0[0] += 20.0;
    target.0[5] -= 3.0;
    let wish = Setpoint {
        joints: target,
        velocities: JointVelocities::ZERO,
    };
    let mut reached_after_s = None;
    for cycle in 1..2_000 {
        let reference = limiter.limit(&wish, CYCLE_S);
        if reference.joints.max_abs_difference(&target) < 1e-6 {
            reached_after_s = Some(f64::from(cycle) * CYCLE_S);
            break;
        }
    }
    let reached_after_s = reached_after_s.expect("the reference must arrive");
    assert!((0.16..2.0).contains(&reached_after_s), "{reached_after_s}");
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![6 => -170.0..170.0_f64, 1 => Just(f64::NAN), 1 => Just(f64::INFINITY)]
}

proptest! {
    #[test]
    fn whatever_is_wished_for_the_reference_never_jumps(
        wishes in proptest::collection::vec(
            (
                proptest::array::uniform6(number()),
                proptest::array::uniform6(number()),
                prop_oneof![8 => Just(CYCLE_S), 1 => 0.0..0.016_f64, 1 => Just(f64::NAN)],
            ),
            1..300,
        ),
    ) {
        let limits = limits();
        let mut limiter = RateLimiter::new(&limits, JointAngles([0.0; 6]));
        let mut previous = JointAngles([0.0; 6]);
        let mut previous_speed = [0.0; 6];
        let mut previous_step_s = CYCLE_S;
        for (joints, velocities, elapsed_s) in wishes {
            let wish = Setpoint {
                joints: JointAngles(joints),
                velocities: JointVelocities(velocities),
            };
            let reference = limiter.limit(&wish, elapsed_s);
            prop_assert!(reference.joints.is_finite());
            prop_assert!(reference.velocities.is_finite());
            if elapsed_s.is_nan() || elapsed_s <= 0.0 {
                prop_assert_eq!(reference.joints, previous);
                continue;
            }
            for joint in 0..6 {
                let speed = (reference.joints.0[joint] - previous.0[joint]) / elapsed_s;
                let rounding = 2.0 * ROUNDING_DEG / elapsed_s;
                let largest = limits.joint_speed_deg_s[joint] * HEADROOM + rounding;
                prop_assert!(speed.abs() <= largest);
                prop_assert!(reference.velocities.0[joint].abs() <= largest);
                let acceleration = limits.joint_acceleration_deg_s2[joint] * HEADROOM;
                let change = (speed - previous_speed[joint]).abs();
                let mean_step_s = 0.5 * (elapsed_s + previous_step_s.max(elapsed_s));
                let previous_rounding = 2.0 * ROUNDING_DEG / previous_step_s;
                prop_assert!(
                    change <= acceleration * mean_step_s * 1.000_001 + rounding + previous_rounding,
                    "joint {joint}: {change} deg/s"
                );
                previous_speed[joint] = speed;
            }
            previous = reference.joints;
            previous_step_s = elapsed_s;
        }
    }
}
