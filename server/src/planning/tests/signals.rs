//! When a plan sets its signals, and what people are told before.

use learning::ModelSignal;
use motion::plan::PlanSignal;
use robot::{SignalConfig, SignalView};

use super::*;

const GRIPPER: &str = "GripperClose";

/// Closes at 40 % of the taught motion and opens at its end.
fn gripping() -> Model {
    let change = |on, phase| ModelSignal {
        name: GRIPPER.into(),
        on,
        phase,
        spread_s: 0.1,
    };
    let mut model = model().clone();
    model.signals = vec![change(true, 0.4), change(false, 1.0)];
    model
}

fn planned(request: &PlanRequest, present: Option<JointAngles>) -> PlannedMotion {
    plan(&gripping(), request, present, &limits()).unwrap()
}

fn times_s(planned: &PlannedMotion) -> Vec<f64> {
    planned.plan.signals().iter().map(|s| s.at_s).collect()
}

/// The phase of the model at which the plan's pose of `at_s` is the learned one, from how far
/// joint 1 has come: it only rises.
fn phase_of(planned: &PlannedMotion, at_s: f64) -> f64 {
    let learned = model().regression().mean_deg;
    let reached = planned.plan.at(at_s).joints.0[0];
    let row = learned.rows().position(|row| row[0] >= reached).unwrap();
    row as f64 / (learned.len() - 1) as f64
}

#[test]
fn a_signal_is_set_where_the_learned_motion_is_at_its_phase() {
    let present = JointAngles([5.0, 0.0, 10.0, 5.0, -60.0, 20.0]);
    for speed in [1.0, 0.5] {
        let request = PlanRequest {
            speed,
            ..as_taught()
        };
        let planned = planned(&request, Some(present));
        let times = times_s(&planned);
        assert!(
            (phase_of(&planned, times[1]) - 0.4).abs() < 0.005,
            "{times:?}"
        );
        let taught_s = 0.4 * model().duration_s();
        let motion_s = times[1] - planned.plan.approach_s();
        assert!((motion_s * speed - taught_s).abs() < 0.01);
        assert!(times[2] <= planned.plan.duration_s());
    }
}

#[test]
fn first_the_gripper_is_as_it_was_at_the_beginning_while_the_arm_rests_at_the_start() {
    let present = JointAngles([5.0, 0.0, 10.0, 5.0, -60.0, 20.0]);
    let planned = planned(&as_taught(), Some(present));
    let first = &planned.plan.signals()[0];
    assert_eq!((first.name.as_str(), first.on), (GRIPPER, false));
    assert!(first.at_s < planned.plan.approach_s());
    let there = planned.plan.at(first.at_s).joints;
    assert!(there.max_abs_difference(&planned.start) < 1e-6);

    // A preview without an arm has no approach.
    assert_eq!(
        times_s(&plan(&gripping(), &as_taught(), None, &limits()).unwrap())[0],
        0.0
    );
}

#[test]
fn slowing_down_for_the_limits_moves_the_signals_along() {
    let mut model = taught(1.5);
    model.signals = gripping().signals;
    let planned = plan(&model, &as_taught(), None, &limits()).unwrap();
    assert!(planned.slowed_by > 1.5);
    let expected_s = 0.4 * model.duration_s() * planned.stretch;
    assert!((times_s(&planned)[1] - expected_s).abs() < 1e-9);
}

#[test]
fn signals_belong_to_the_name_of_the_plan_and_change_nothing_else() {
    let with = planned(&as_taught(), None);
    let without = plan(model(), &as_taught(), None, &limits()).unwrap();
    assert_ne!(with.plan.hash(), without.plan.hash());
    assert_eq!(with.plan.samples(), without.plan.samples());
    assert!(without.plan.signals().is_empty());
}

#[test]
fn a_gripper_that_stands_otherwise_or_is_not_ours_is_remarked_upon() {
    let planned = planned(&as_taught(), None);
    let standing = |is_on| SignalView {
        signal: SignalConfig::virtual_gripper(),
        is_on,
    };
    assert_eq!(signal_remarks(&planned.plan, &[standing(Some(false))]), []);
    assert_eq!(signal_remarks(&planned.plan, &[standing(None)]), []);
    let closed = signal_remarks(&planned.plan, &[standing(Some(true))]);
    assert_eq!(closed[0].code(), "signal_stands_otherwise");
    assert!(
        closed[0].to_string().contains("will open first"),
        "{}",
        closed[0]
    );
    let unknown = signal_remarks(&planned.plan, &[]);
    assert_eq!(unknown.len(), 1);
    assert!(unknown[0].to_string().contains(GRIPPER));
}

#[test]
fn two_signals_each_begin_as_shown() {
    let mut model = gripping();
    model.signals[1].name = "Vacuum".into();
    let planned = plan(&model, &as_taught(), None, &limits()).unwrap();
    let told: Vec<(&str, bool)> = planned
        .plan
        .signals()
        .iter()
        .map(|s: &PlanSignal| (s.name.as_str(), s.on))
        .collect();
    assert_eq!(
        told,
        [
            (GRIPPER, false),
            ("Vacuum", true),
            (GRIPPER, true),
            ("Vacuum", false)
        ]
    );
}
