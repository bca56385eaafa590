//! What goes wrong in a run, and that a person has to look at it before the arm moves again.

use crate::support::{Cell, outcome, progress};
use robot::{Fault, RobotState, RunEnd, RunHandle};

const TRAVEL_DEG: [f64; 6] = [8.0, -4.0, 3.0, 5.0, -6.0, 12.0];

async fn moving(cell: &Cell) -> RunHandle {
    let plan = cell.plan(TRAVEL_DEG, 4.0);
    let mut run = cell.robot.run(plan).await.unwrap();
    progress(&mut run, |progress| progress.t_s > 1.0).await;
    run
}

async fn fault(run: RunHandle) -> Fault {
    match outcome(run).await.end {
        RunEnd::Failed(fault) => fault,
        other => panic!("{other:?}"),
    }
}

/// The fault stands, nothing moves until it is acknowledged, and then things work again.
async fn assert_needs_a_person(cell: &mut Cell, fault: &Fault) {
    let view = cell.wait_for_state(RobotState::Faulted).await;
    assert_eq!(view.fault.as_ref(), Some(fault));
    let refusal = cell.robot.run(cell.plan([1.0; 6], 2.0)).await.unwrap_err();
    assert_eq!(refusal.code(), "robot_faulted");
    let refusal = cell.robot.start_guidance().await.unwrap_err();
    assert_eq!(refusal.code(), "robot_faulted");
    cell.robot.stop();
    cell.robot.reset().await.unwrap();
    let view = cell.wait_for_state(RobotState::Idle).await;
    assert_eq!(view.fault, None);
    let pose = settled_pose(cell).await;
    let plan = crate::support::minimum_jerk(pose, [1.0; 6], 1.0);
    let run = cell.robot.run(plan.into()).await.unwrap();
    assert_eq!(outcome(run).await.end, RunEnd::Completed);
}

/// The pose once two measurements of it, one after the other, agree.
async fn settled_pose(cell: &mut Cell) -> motion::JointAngles {
    let mut last: Option<(motion::JointAngles, u64)> = None;
    let view = cell
        .wait_for("a standing arm", |view| {
            let joints = motion::JointAngles(view.joints_deg.unwrap());
            let Some((before, age_ms)) = last.replace((joints, view.age_ms)) else {
                return false;
            };
            // A younger pose than the last one was measured anew.
            view.age_ms < age_ms && joints.max_abs_difference(&before) < 0.01
        })
        .await;
    motion::JointAngles(view.joints_deg.unwrap())
}

#[tokio::test(flavor = "multi_thread")]
async fn when_the_packets_stop_the_run_fails_and_needs_a_person() {
    let mut cell = Cell::start().await;
    let run = moving(&cell).await;
    cell.controller
        .faults()
        .set(|faults| faults.egm_lost = true);
    let fault = fault(run).await;
    assert_eq!(fault.code, "egm_lost");
    cell.controller
        .faults()
        .set(|faults| faults.egm_lost = false);
    assert_needs_a_person(&mut cell, &fault).await;
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_guard_stop_fails_the_run_and_must_be_released_before_reset() {
    let mut cell = Cell::start().await;
    let run = moving(&cell).await;
    cell.controller.faults().guard_stop(true);
    let fault = fault(run).await;
    assert_eq!(fault.code, "guard_stop");
    let refusal = cell.robot.reset().await.unwrap_err();
    assert_eq!(refusal.code(), "robot_not_ready");
    cell.controller.faults().guard_stop(false);
    cell.wait_for("the guard released", |view| view.motors_on == Some(false))
        .await;
    // The release is seen by the next question; until then reset is refused.
    let mut view = cell.robot.view();
    while cell.robot.reset().await.is_err() {
        view.changed().await.unwrap();
    }
    cell.wait_for_state(RobotState::Idle).await;
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_program_that_never_guides_is_reported() {
    let mut cell = Cell::start().await;
    cell.controller
        .faults()
        .set(|faults| faults.egm_lost = true);
    let run = cell.robot.run(cell.plan(TRAVEL_DEG, 2.0)).await.unwrap();
    let fault = fault(run).await;
    assert_eq!(fault.code, "egm_no_session");
    cell.controller
        .faults()
        .set(|faults| faults.egm_lost = false);
    assert_needs_a_person(&mut cell, &fault).await;
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_program_that_does_not_start_moves_nothing_and_needs_no_reset() {
    let mut cell = Cell::start().await;
    cell.controller
        .faults()
        .set(|faults| faults.start_reverts = true);
    let run = cell.robot.run(cell.plan(TRAVEL_DEG, 2.0)).await.unwrap();
    let fault = fault(run).await;
    assert_eq!(fault.code, "robot_program");
    cell.wait_for_state(RobotState::Idle).await;
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn an_arm_that_creeps_does_not_follow_and_the_run_fails() {
    // The controller's own default of 1 deg/s, with which most new cells are first met.
    let mut cell = Cell::with(|config| config.egm.max_speed_deviation_deg_s = 1.0).await;
    let plan = cell.plan([25.0, 0.0, 0.0, 0.0, 0.0, 0.0], 4.0);
    let run = cell.robot.run(plan).await.unwrap();
    let fault = fault(run).await;
    assert_eq!(fault.code, "tracking_error");
    assert!(fault.message.contains("joint 1"), "{}", fault.message);
    cell.wait_for_state(RobotState::Faulted).await;
    cell.end().await;
}
