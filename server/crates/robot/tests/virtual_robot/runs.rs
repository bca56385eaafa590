//! Running a plan, stopping it, and what is refused.

use crate::support::{Cell, outcome, progress};
use robot::{RobotError, RobotState, RunEnd, RunPhase};

const TRAVEL_DEG: [f64; 6] = [8.0, -4.0, 3.0, 5.0, -6.0, 12.0];

#[tokio::test(flavor = "multi_thread")]
async fn a_plan_is_run_and_the_arm_arrives() {
    let mut cell = Cell::start().await;
    let plan = cell.plan(TRAVEL_DEG, 2.0);
    let run = cell.robot.run(plan.clone()).await.unwrap();
    let outcome = outcome(run).await;
    assert_eq!(outcome.end, RunEnd::Completed);

    let last = outcome.record.last().unwrap();
    let error_deg = last.measured.max_abs_difference(&plan.last());
    assert!(error_deg <= 0.02, "{error_deg}");
    // A record for every cycle, each on the plan.
    assert!(outcome.record.len() > 100, "{}", outcome.record.len());
    for record in &outcome.record {
        let planned = plan.at(record.plan_t_s).joints;
        assert!(record.commanded.max_abs_difference(&planned) < 0.01);
        assert!(!record.held);
        assert!(record.motors_on && record.rapid_running);
    }
    assert!(outcome.chunks >= 5, "the record comes while the arm moves");
    let codes: Vec<&str> = outcome.events.iter().map(|event| event.code).collect();
    let expected = [
        "controller_state",
        "armed",
        "motion",
        "settling",
        "completed",
    ];
    for code in expected {
        assert!(codes.contains(&code), "{code}: {codes:?}");
    }
    let idle = cell.wait_for_state(RobotState::Idle).await;
    assert_eq!((idle.run, idle.fault), (None, None));
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn two_plans_can_be_run_one_after_the_other() {
    let mut cell = Cell::start().await;
    for travel_deg in [TRAVEL_DEG, TRAVEL_DEG.map(|travel| -travel)] {
        let plan = cell.plan(travel_deg, 1.6);
        let run = cell.robot.run(plan.clone()).await.unwrap();
        assert_eq!(outcome(run).await.end, RunEnd::Completed);
        cell.wait_for_state(RobotState::Idle).await;
        cell.wait_for("the end pose", |view| {
            let joints = view.joints_deg.map(motion::JointAngles);
            joints.is_some_and(|joints| joints.max_abs_difference(&plan.last()) < 0.05)
        })
        .await;
    }
    cell.end().await;
}

/// The controller still brings the arm to rest when the run is already over.
#[tokio::test(flavor = "multi_thread")]
async fn right_after_a_run_the_arm_can_be_taken_by_the_hand() {
    let mut cell = Cell::start().await;
    let run = cell.robot.run(cell.plan(TRAVEL_DEG, 1.6)).await.unwrap();
    assert_eq!(outcome(run).await.end, RunEnd::Completed);
    cell.wait_for_state(RobotState::Idle).await;
    cell.robot.start_guidance().await.unwrap();
    cell.wait_for_state(RobotState::Guiding).await;
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_stop_in_the_middle_keeps_to_the_path_and_does_not_jump() {
    let mut cell = Cell::start().await;
    let plan = cell.plan(TRAVEL_DEG, 4.0);
    let mut run = cell.robot.run(plan.clone()).await.unwrap();
    progress(&mut run, |progress| progress.t_s > 1.5).await;
    cell.robot.stop();
    let outcome = outcome(run).await;
    assert_eq!(outcome.end, RunEnd::Stopped);

    let stopping: Vec<_> = outcome
        .record
        .iter()
        .filter(|record| record.phase == RunPhase::Stopping)
        .collect();
    // The ramp of 0.3 s goes half as far as full speed would.
    let went_on_s = outcome.record.last().unwrap().plan_t_s - stopping[0].plan_t_s;
    assert!((0.05..0.16).contains(&went_on_s), "{went_on_s}");
    for pair in outcome.record.windows(2) {
        let moved = pair[1].commanded.max_abs_difference(&pair[0].commanded);
        // The plan's peak speed is 5.7 deg/s, and a step is at most 16 ms long.
        assert!(moved < 0.1, "{moved}");
        let planned = plan.at(pair[1].plan_t_s).joints;
        assert!(pair[1].commanded.max_abs_difference(&planned) < 0.01);
    }
    cell.wait_for_state(RobotState::Idle).await;
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_stop_before_the_arm_moves_is_not_lost() {
    let mut cell = Cell::start().await;
    let plan = cell.plan(TRAVEL_DEG, 2.0);
    let start = cell.pose();
    let run = cell.robot.run(plan).await.unwrap();
    cell.robot.stop();
    let outcome = outcome(run).await;
    assert_eq!(outcome.end, RunEnd::Stopped);
    let idle = cell.wait_for_state(RobotState::Idle).await;
    let joints = motion::JointAngles(idle.joints_deg.unwrap());
    assert!(joints.max_abs_difference(&start) < 0.05);
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn only_one_run_at_a_time_and_no_guiding_meanwhile() {
    let mut cell = Cell::start().await;
    let plan = cell.plan(TRAVEL_DEG, 2.0);
    let run = cell.robot.run(plan.clone()).await.unwrap();
    let second = cell.robot.run(plan).await.unwrap_err();
    assert_eq!(second.code(), "robot_busy");
    let guidance = cell.robot.start_guidance().await.unwrap_err();
    assert_eq!(guidance.code(), "robot_busy");
    let hand = robot::HandCommand::Show {
        script: robot::HandScript::F1,
        seed: 1,
    };
    let hand = cell.robot.virtual_hand(hand).await.unwrap_err();
    assert_eq!(hand.code(), "robot_not_guiding");
    assert_eq!(outcome(run).await.end, RunEnd::Completed);
    cell.wait_for_state(RobotState::Idle).await;
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_plan_that_begins_elsewhere_is_refused() {
    let cell = Cell::start().await;
    let mut elsewhere = cell.pose();
    elsewhere.0[2] += 4.0;
    let plan = crate::support::minimum_jerk(elsewhere, TRAVEL_DEG, 2.0);
    let refusal = cell.robot.run(plan.into()).await.unwrap_err();
    let RobotError::ArmMoved {
        joint,
        difference_deg,
    } = refusal
    else {
        panic!("{refusal}");
    };
    assert_eq!(joint, 2);
    assert!((difference_deg - 4.0).abs() < 0.05);
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_small_distance_to_the_beginning_is_closed_gently() {
    let cell = Cell::start().await;
    let mut nearby = cell.pose();
    nearby.0[1] -= 0.6;
    let plan = crate::support::minimum_jerk(nearby, TRAVEL_DEG, 2.0);
    let run = cell.robot.run(plan.into()).await.unwrap();
    let outcome = outcome(run).await;
    assert_eq!(outcome.end, RunEnd::Completed);
    for pair in outcome.record.windows(2) {
        let moved = pair[1].commanded.max_abs_difference(&pair[0].commanded);
        assert!(moved < 0.2, "{moved}");
    }
    cell.end().await;
}
