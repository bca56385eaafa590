//! Signals in a plan: what they change of its name, and where they may lie.

use sha2::{Digest, Sha256};

use super::*;
use crate::gate::{ProposedMotion, Refusal, approve};
use crate::limits::RobotLimits;

/// Two seconds of standing.
fn standing(signals: Vec<PlanSignal>) -> ProposedMotion {
    ProposedMotion {
        period_s: 0.004,
        approach_samples: 125,
        joints: vec![JointAngles([0.0, 0.0, 0.0, 0.0, -45.0, 0.0]); 501],
        signals,
    }
}

fn signal(name: &str, at_s: f64, on: bool) -> PlanSignal {
    PlanSignal {
        name: name.into(),
        at_s,
        on,
    }
}

fn approved(signals: Vec<PlanSignal>) -> Result<Plan, Refusal> {
    approve(&standing(signals), &RobotLimits::gofa5())
}

#[test]
fn a_plan_without_signals_is_named_by_its_samples_alone() {
    let mut digest = Sha256::new();
    digest.update(0.004_f64.to_le_bytes());
    digest.update(125_u64.to_le_bytes());
    for _ in 0..501 {
        for value in [0.0, 0.0, 0.0, 0.0, -45.0, 0.0] {
            digest.update(f64::to_le_bytes(value));
        }
        digest.update([0; 48]);
    }
    let expected: String = digest
        .finalize()
        .iter()
        .map(|b| format!("{b:02x}"))
        .collect();
    assert_eq!(approved(Vec::new()).unwrap().hash(), expected);
}

#[test]
fn every_part_of_a_signal_belongs_to_the_name_of_the_plan() {
    let hash = |name, at_s, on| {
        let plan = approved(vec![signal(name, at_s, on)]).unwrap();
        assert_eq!(plan.signals(), [signal(name, at_s, on)]);
        plan.hash().to_owned()
    };
    let names = [
        approved(Vec::new()).unwrap().hash().to_owned(),
        hash("Gripper", 1.0, true),
        hash("Gripper", 1.0, false),
        hash("Gripper", 1.5, true),
        hash("Vacuum", 1.0, true),
    ];
    for (i, name) in names.iter().enumerate() {
        assert!(!names[..i].contains(name));
    }
    assert_eq!(names[1], hash("Gripper", 1.0, true));
}

#[test]
fn a_signal_lies_within_the_motion_and_behind_the_one_before() {
    assert!(approved(vec![signal("A", 0.0, true), signal("B", 2.0, true)]).is_ok());
    for (signals, which) in [
        (vec![signal("A", 2.001, true)], "A"),
        (vec![signal("A", -0.001, true)], "A"),
        (vec![signal("A", f64::NAN, true)], "A"),
        (vec![signal("A", 1.0, true), signal("B", 0.5, true)], "B"),
        (vec![signal("", 1.0, true)], ""),
    ] {
        let refusal = approved(signals).unwrap_err();
        assert!(matches!(&refusal, Refusal::SignalMisplaced { name, .. } if name == which));
        assert_eq!(refusal.code(), "signal_misplaced");
    }
}
