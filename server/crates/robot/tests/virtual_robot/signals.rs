//! Signals on the virtual controller: worked by a person, changed by the cell, set by a plan.

use crate::support::{Cell, outcome, progress};
use motion::gate::{ProposedMotion, approve};
use motion::limits::RobotLimits;
use motion::plan::{Plan, PlanSignal};
use robot::{GuidanceEvent, RobotError, RobotState, RunEnd};
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::mpsc;

const GRIPPER: &str = "GripperClose";
const TRAVEL_DEG: [f64; 6] = [10.0, 0.0, 0.0, 0.0, 0.0, -10.0];

fn signal(at_s: f64, on: bool) -> PlanSignal {
    PlanSignal {
        name: GRIPPER.into(),
        at_s,
        on,
    }
}

/// A motion from where the arm stands that sets signals on its way.
fn plan(cell: &Cell, duration_s: f64, signals: Vec<PlanSignal>) -> Arc<Plan> {
    let plain = cell.plan(TRAVEL_DEG, duration_s);
    let motion = ProposedMotion {
        period_s: plain.period_s(),
        approach_samples: 0,
        joints: plain.samples().iter().map(|sample| sample.joints).collect(),
        signals,
    };
    Arc::new(approve(&motion, &RobotLimits::gofa5()).unwrap())
}

async fn gripper_is(cell: &mut Cell, on: bool) {
    cell.wait_for("the gripper", |view| view.signals[0].is_on == Some(on))
        .await;
}

async fn next_signal(events: &mut mpsc::Receiver<GuidanceEvent>) -> (String, bool, u64, u64) {
    let mut newest_us = 0;
    loop {
        let event = tokio::time::timeout(Duration::from_secs(10), events.recv());
        match event.await.expect("the stream must go on").unwrap() {
            GuidanceEvent::Signal { name, on, at_us } => return (name, on, at_us, newest_us),
            GuidanceEvent::Sample(sample) => newest_us = sample.at_us,
            GuidanceEvent::Gap { .. } => {}
            GuidanceEvent::Ended { reason } => panic!("guidance ended: {reason}"),
        }
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_person_works_the_gripper_and_sees_it() {
    let mut cell = Cell::start().await;
    gripper_is(&mut cell, false).await;
    cell.robot.set_signal(GRIPPER, true).await.unwrap();
    let shown = cell.view.borrow().signals[0].clone();
    assert_eq!(
        (shown.is_on, shown.signal.label.as_str()),
        (Some(true), "Gripper")
    );
    assert!(cell.controller.faults().signal(GRIPPER).unwrap());
    let refused = cell
        .robot
        .set_signal("Asi1Button1", true)
        .await
        .unwrap_err();
    assert!(
        matches!(refused, RobotError::SignalUnknown { .. }),
        "{refused}"
    );
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_signal_that_does_not_change_is_an_error_in_words() {
    let cell = Cell::start().await;
    cell.controller
        .faults()
        .set(|faults| faults.signals_stuck = true);
    let error = cell.robot.set_signal(GRIPPER, true).await.unwrap_err();
    assert_eq!(error.to_string(), "\"Gripper\" did not close");
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn while_guiding_what_is_set_and_what_the_cell_changes_is_told_in_time() {
    let mut cell = Cell::start().await;
    gripper_is(&mut cell, false).await;
    let mut events = cell.robot.start_guidance().await.unwrap();
    cell.robot.set_signal(GRIPPER, true).await.unwrap();
    let (name, on, at_us, newest_us) = next_signal(&mut events).await;
    assert_eq!((name.as_str(), on), (GRIPPER, true));
    assert!(
        at_us.abs_diff(newest_us) < 2_000_000,
        "{at_us} beside {newest_us}"
    );

    cell.controller.faults().wire_signal(GRIPPER, false);
    let (name, on, later_us, _) = next_signal(&mut events).await;
    assert_eq!((name.as_str(), on), (GRIPPER, false));
    assert!(later_us > at_us);
    gripper_is(&mut cell, false).await;

    // Presses that are shorter than any poll: until the controller's own word of changes is heard,
    // which takes a moment on a busy machine, they may go unseen.
    let mut seen = Vec::new();
    for _ in 0..10 {
        cell.controller.faults().wire_signal(GRIPPER, true);
        cell.controller.faults().wire_signal(GRIPPER, false);
        let next = tokio::time::timeout(Duration::from_secs(2), next_signal(&mut events));
        if let Ok((_, pressed, ..)) = next.await {
            seen = vec![pressed, next_signal(&mut events).await.1];
            break;
        }
    }
    assert_eq!(seen, [true, false]);
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_plan_sets_its_signals_when_it_comes_to_them() {
    let mut cell = Cell::start().await;
    gripper_is(&mut cell, false).await;
    let plan = plan(
        &cell,
        2.0,
        vec![signal(0.0, false), signal(1.0, true), signal(2.0, false)],
    );
    let mut run = cell.robot.run(plan).await.unwrap();
    let refused = cell.robot.set_signal(GRIPPER, true).await.unwrap_err();
    assert!(matches!(refused, RobotError::Busy { .. }), "{refused}");
    progress(&mut run, |progress| progress.t_s > 0.5).await;
    assert_eq!(
        cell.view.borrow().signals[0].is_on,
        Some(false),
        "not before its time"
    );
    gripper_is(&mut cell, true).await;
    let outcome = outcome(run).await;
    assert_eq!(outcome.end, RunEnd::Completed);
    let noted = outcome
        .events
        .iter()
        .filter(|event| event.code == "signal_set");
    assert_eq!(noted.count(), 3);
    let set: Vec<(f64, bool)> = outcome.signals.iter().map(|s| (s.at_s, s.on)).collect();
    let noted = outcome
        .events
        .iter()
        .filter(|event| event.code == "signal_set");
    assert_eq!(noted.count(), set.len(), "{:?}", outcome.events);
    assert_eq!(
        set,
        [(0.0, false), (1.0, true), (2.0, false)],
        "also what is due at the end"
    );
    assert!(!cell.controller.faults().signal(GRIPPER).unwrap());
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_signal_that_fails_brings_the_arm_to_rest_on_its_path() {
    let mut cell = Cell::start().await;
    let plan = plan(&cell, 4.0, vec![signal(1.0, true)]);
    cell.controller
        .faults()
        .set(|faults| faults.signals_stuck = true);
    let run = cell.robot.run(plan.clone()).await.unwrap();
    let outcome = outcome(run).await;
    let RunEnd::Failed(fault) = &outcome.end else {
        panic!("{:?}", outcome.end);
    };
    assert_eq!(fault.code, "signal_failed");
    assert!(
        fault.message.contains("\"Gripper\" did not close"),
        "{}",
        fault.message
    );
    let last = outcome.record.last().unwrap();
    assert!(
        last.plan_t_s > 1.0 && last.plan_t_s < 3.5,
        "{}",
        last.plan_t_s
    );
    for record in &outcome.record {
        let planned = plan.at(record.plan_t_s).joints;
        assert!(record.commanded.max_abs_difference(&planned) < 0.05);
    }
    cell.wait_for_state(RobotState::Faulted).await;
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_stop_before_the_signal_leaves_it_alone() {
    let mut cell = Cell::start().await;
    gripper_is(&mut cell, false).await;
    let plan = plan(&cell, 3.0, vec![signal(2.0, true)]);
    let mut run = cell.robot.run(plan).await.unwrap();
    progress(&mut run, |progress| progress.t_s > 0.5).await;
    cell.robot.stop();
    let outcome = outcome(run).await;
    assert_eq!(outcome.end, RunEnd::Stopped);
    assert!(outcome.signals.is_empty());
    assert!(!cell.controller.faults().signal(GRIPPER).unwrap());
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_plan_with_an_unknown_signal_is_refused_before_anything_moves() {
    let cell = Cell::start().await;
    let mut unknown = signal(1.0, true);
    unknown.name = "Vacuum".into();
    let error = cell
        .robot
        .run(plan(&cell, 2.0, vec![unknown]))
        .await
        .unwrap_err();
    assert_eq!(error.code(), "signal_unknown");
    assert!(error.to_string().contains("Vacuum"));
    cell.end().await;
}
