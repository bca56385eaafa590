//! What the arm is told along a plan, when it is stopped, and when it does not follow.

use super::*;
use crate::testing::{HOME, line_plan, minimum_jerk_plan};
use motion::JointVelocities;

const CYCLE_S: f64 = 0.004_032;
const GO: Orders = Orders {
    stop: false,
    pause: false,
    speed: 1.0,
};
const STOP: Orders = Orders { stop: true, ..GO };
const PAUSE: Orders = Orders { pause: true, ..GO };

fn player() -> Player {
    let plan = Arc::new(line_plan());
    let first = plan.first();
    begin(plan, first).unwrap()
}

fn begin(plan: Arc<Plan>, reference: JointAngles) -> Result<Player, f64> {
    Player::new(plan, reference, &RobotLimits::gofa5())
}

/// Runs to the end with an arm that follows exactly, collecting every step.
fn walk(player: &mut Player, stop_at_step: Option<usize>) -> Vec<PlayerStep> {
    let mut measured = player.commanded;
    let mut steps = Vec::new();
    for index in 0..5_000 {
        let orders = if stop_at_step == Some(index) {
            STOP
        } else {
            GO
        };
        let step = player.advance(CYCLE_S, &measured, orders);
        measured = step.setpoint.joints;
        steps.push(step);
        if step.end.is_some() {
            return steps;
        }
    }
    panic!("the player must come to an end");
}

#[test]
fn it_follows_the_plan_exactly_and_completes() {
    let mut player = player();
    let plan = Arc::clone(&player.way.plan);
    let steps = walk(&mut player, None);
    for (index, step) in steps.iter().enumerate() {
        let t_s = ((index + 1) as f64 * CYCLE_S).min(plan.duration_s());
        let planned = plan.at(t_s);
        assert!(step.setpoint.joints.max_abs_difference(&planned.joints) < 1e-9);
    }
    let last = steps.last().unwrap();
    assert_eq!(last.end, Some(PlayerEnd::Completed));
    assert_eq!(last.phase, RunPhase::Settling);
    assert_eq!(last.setpoint.joints, plan.last());
    assert_eq!(last.setpoint.velocities, JointVelocities::ZERO);
}

#[test]
fn a_stop_comes_to_rest_on_the_path_within_its_time() {
    for stop_at in [0, 20, 150, 248, 400] {
        let mut player = player();
        let plan = Arc::clone(&player.way.plan);
        let steps = walk(&mut player, Some(stop_at));
        assert_eq!(steps.last().unwrap().end, Some(PlayerEnd::Stopped));
        let ramp = &steps[stop_at..];
        assert!((ramp.len() as f64) * CYCLE_S <= 0.4);
        let rest = steps.last().unwrap().setpoint;
        assert!(rest.velocities.0.iter().all(|speed| speed.abs() < 1e-9));
        let mut previous = plan.at(stop_at as f64 * CYCLE_S);
        for step in ramp {
            // On the path: the pose is the plan's at the time the step names.
            let on_path = plan.at(step.plan_t_s).joints;
            assert!(step.setpoint.joints.max_abs_difference(&on_path) < 1e-9);
            // Never faster than the plan's peak: no jump, no surge.
            let moved = step.setpoint.joints.max_abs_difference(&previous.joints);
            assert!(moved <= 9.4 * CYCLE_S, "{moved}");
            assert_eq!(step.phase, RunPhase::Stopping);
            previous = step.setpoint;
        }
    }
}

#[test]
fn the_reported_speed_is_the_slope_of_the_positions_also_while_stopping() {
    let mut player = player();
    let steps = walk(&mut player, Some(150));
    for pair in steps.windows(2) {
        for joint in 0..JOINTS {
            let slope =
                (pair[1].setpoint.joints.0[joint] - pair[0].setpoint.joints.0[joint]) / CYCLE_S;
            let named =
                0.5 * (pair[0].setpoint.velocities.0[joint] + pair[1].setpoint.velocities.0[joint]);
            assert!((slope - named).abs() < 0.02, "{slope} against {named}");
        }
    }
}

#[test]
fn a_small_distance_to_the_start_is_closed_gently_first() {
    let plan = Arc::new(line_plan());
    let mut reference = plan.first();
    reference.0[2] += 0.9;
    let mut player = begin(Arc::clone(&plan), reference).unwrap();
    let mut previous = reference;
    let mut measured = reference;
    loop {
        let step = player.advance(CYCLE_S, &measured, GO);
        if step.plan_t_s > 0.0 {
            break;
        }
        assert_eq!(step.phase, RunPhase::Approach);
        let speed = step.setpoint.joints.max_abs_difference(&previous) / CYCLE_S;
        assert!(speed <= ALIGN_SPEED_DEG_S * 1.001, "{speed}");
        previous = step.setpoint.joints;
        measured = previous;
    }
    assert!(previous.max_abs_difference(&plan.first()) < 1e-3);
}

#[test]
fn an_arm_that_was_moved_away_is_refused() {
    let plan = Arc::new(line_plan());
    let mut reference = plan.first();
    reference.0[4] += 1.5;
    let distance = begin(Arc::clone(&plan), reference).unwrap_err();
    assert!((distance - 1.5).abs() < 1e-9);
    assert!(begin(plan, JointAngles([f64::NAN; 6])).is_err());
}

#[test]
fn an_arm_that_does_not_follow_ends_the_run() {
    let plan = Arc::new(minimum_jerk_plan([20.0, 0.0, 0.0, 0.0, 0.0, 0.0], 3.0));
    let mut player = begin(plan, HOME).unwrap();
    for _ in 0..5_000 {
        let step = player.advance(CYCLE_S, &HOME, GO);
        if let Some(end) = step.end {
            let PlayerEnd::NotFollowing {
                joint: 0,
                error_deg,
            } = end
            else {
                panic!("{end:?}");
            };
            assert!((TRACKING_LIMIT_DEG..TRACKING_LIMIT_DEG + 0.2).contains(&error_deg));
            return;
        }
    }
    panic!("the run must end");
}

#[test]
fn a_measured_pose_that_is_no_number_ends_the_run() {
    let step = player().advance(CYCLE_S, &JointAngles([f64::NAN; 6]), GO);
    assert!(matches!(step.end, Some(PlayerEnd::NotFollowing { .. })));
}

#[test]
fn it_waits_for_a_lagging_arm_but_not_for_ever() {
    let plan = Arc::new(line_plan());
    for (offset_deg, arrives) in [(0.3, true), (0.7, false)] {
        let mut player = begin(Arc::clone(&plan), plan.first()).unwrap();
        let mut cycles = 0_u32;
        let end = loop {
            let mut measured = player.commanded;
            measured.0[1] += offset_deg;
            cycles += 1;
            if let Some(end) = player.advance(CYCLE_S, &measured, GO).end {
                break end;
            }
        };
        let waited_s = f64::from(cycles) * CYCLE_S - plan.duration_s();
        assert!(
            (SETTLE_S - 0.1..SETTLE_S + 0.1).contains(&waited_s),
            "{waited_s}"
        );
        assert_eq!(end == PlayerEnd::Completed, arrives);
    }
}

/// Steps under the same orders.
fn steps(player: &mut Player, orders: Orders, count: usize) -> Vec<PlayerStep> {
    (0..count)
        .map(|_| {
            let measured = player.commanded;
            player.advance(CYCLE_S, &measured, orders)
        })
        .collect()
}

#[test]
fn a_pause_stands_on_the_path_and_goes_on_from_there() {
    let mut player = player();
    steps(&mut player, GO, 150);
    let paused = *steps(&mut player, PAUSE, 300).last().unwrap();
    assert_eq!(paused.phase, RunPhase::Paused);
    assert_eq!(paused.end, None);
    let plan = Arc::clone(&player.way.plan);
    assert_eq!(paused.setpoint.joints, plan.at(paused.plan_t_s).joints);
    assert!(paused.plan_t_s > 0.0 && paused.plan_t_s < plan.duration_s());
    let on = steps(&mut player, GO, 1);
    assert!(on[0].plan_t_s > paused.plan_t_s && on[0].plan_t_s < paused.plan_t_s + CYCLE_S);
    let end = walk(&mut player, None);
    assert_eq!(end.last().unwrap().end, Some(PlayerEnd::Completed));
    assert_eq!(end.last().unwrap().setpoint.joints, plan.last());
}

#[test]
fn a_pause_that_is_forgotten_ends_the_run() {
    let mut player = player();
    steps(&mut player, GO, 150);
    let mut waited_s = 0.0;
    loop {
        let step = steps(&mut player, PAUSE, 1)[0];
        waited_s += CYCLE_S;
        if let Some(end) = step.end {
            assert_eq!(end, PlayerEnd::Stopped);
            break;
        }
        assert!(waited_s < LONGEST_PAUSE_S + 2.0);
    }
    assert!(waited_s > LONGEST_PAUSE_S);
}

#[test]
fn a_stop_cannot_be_taken_back() {
    let mut player = player();
    steps(&mut player, GO, 150);
    steps(&mut player, STOP, 1);
    let rest = steps(&mut player, GO, 200);
    assert!(rest.iter().any(|step| step.end == Some(PlayerEnd::Stopped)));
}

#[test]
fn at_half_speed_the_same_path_takes_twice_as_long() {
    let half = Orders { speed: 0.5, ..GO };
    let mut player = player();
    let plan = Arc::clone(&player.way.plan);
    steps(&mut player, half, 100);
    let before = player.way_s;
    let taken = steps(&mut player, half, 100);
    assert!((player.way_s - before - 50.0 * CYCLE_S).abs() < 1e-9);
    for step in taken {
        let planned = plan.at(step.plan_t_s);
        assert_eq!(step.setpoint.joints, planned.joints);
        for (speed, full) in step.setpoint.velocities.0.iter().zip(planned.velocities.0) {
            assert!((speed - 0.5 * full).abs() < 1e-9);
        }
    }
}
