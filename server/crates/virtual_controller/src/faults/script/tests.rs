//! Reading scripts, and when their faults are there.

use super::*;

fn at(from_s: f64, for_s: Option<f64>, every_s: Option<f64>) -> ScriptedFault {
    ScriptedFault {
        from_s,
        for_s,
        every_s,
        ..Fault::Loss.into()
    }
}

#[test]
fn a_script_is_read_with_what_it_leaves_out() {
    let script = FaultScript::from_json(
        r#"{"seed": 7, "faults": [
            {"fault": "loss", "direction": "to_server", "from_s": 2, "for_s": 5, "share": 0.1},
            {"fault": {"delay": {"delay_s": 0.02}}},
            {"fault": {"duplicate": {}}, "every_s": 3}
        ]}"#,
    )
    .unwrap();
    let loss = ScriptedFault {
        direction: Direction::ToServer,
        share: 0.1,
        ..at(2.0, Some(5.0), None)
    };
    let delay = Fault::Delay {
        delay_s: 0.02,
        spread_s: 0.0,
    };
    let twice = Fault::Duplicate {
        copies: 1,
        apart_s: 0.0,
    };
    let twice = ScriptedFault {
        every_s: Some(3.0),
        ..twice.into()
    };
    assert_eq!(script.seed, 7);
    assert_eq!(script.faults, [loss, delay.into(), twice]);
}

#[test]
fn a_script_with_a_mistake_is_refused_with_the_place() {
    let misspelt = r#"{"faults": [{"fault": "loss", "shar": 0.1}]}"#;
    let error = FaultScript::from_json(misspelt).unwrap_err().to_string();
    assert!(
        error.contains("shar") && error.contains("line 1"),
        "{error}"
    );
    for (fault, word) in [
        (r#"{"fault": "loss", "share": 1.5}"#, "share"),
        (r#"{"fault": "loss", "from_s": -1}"#, "from_s"),
        (r#"{"fault": "cut", "every_s": 0}"#, "every_s"),
        (
            r#"{"fault": {"angle": {"joint": 7, "angle_deg": 0}}}"#,
            "joint",
        ),
        (r#"{"fault": {"delay": {"delay_s": -1}}}"#, "delay_s"),
        (r#"{"fault": {"duplicate": {"copies": 101}}}"#, "copies"),
        (r#"{"fault": {"reorder": {"behind": 101}}}"#, "behind"),
    ] {
        let text = format!(r#"{{"faults": [{{"fault": "repeat"}}, {fault}]}}"#);
        let error = FaultScript::from_json(&text).unwrap_err().to_string();
        assert!(error.contains("fault 2") && error.contains(word), "{error}");
    }
}

#[test]
fn a_fault_is_there_from_its_beginning_for_its_time() {
    let fault = at(1.0, Some(0.5), None);
    let seen: Vec<bool> = [0.9, 1.0, 1.4, 1.5, 4.0]
        .map(|t_s| fault.is_active(t_s))
        .to_vec();
    assert_eq!(seen, [false, true, true, false, false]);
    assert_eq!([0.0, 1.0, 9.0].map(|t_s| fault.beginnings(t_s)), [0, 1, 1]);
    assert!(at(1.0, None, None).is_active(1e6));
}

#[test]
fn a_fault_with_a_period_comes_again() {
    let fault = at(1.0, Some(0.5), Some(2.0));
    let seen = [0.9, 1.2, 2.0, 3.2, 4.0, 5.4].map(|t_s| fault.is_active(t_s));
    assert_eq!(seen, [false, true, false, true, false, true]);
    assert_eq!(
        [0.0, 1.0, 2.9, 3.0].map(|t_s| fault.beginnings(t_s)),
        [0, 1, 1, 2]
    );
}

#[test]
fn random_scripts_are_sound_and_differ() {
    let scripts: Vec<_> = (0..100)
        .map(|seed| FaultScript::random(seed, 10.0))
        .collect();
    for script in &scripts {
        script.check().unwrap();
        assert!(!script.faults.is_empty());
        let text = serde_json::to_string(script).unwrap();
        assert_eq!(&FaultScript::from_json(&text).unwrap(), script);
    }
    assert!(
        scripts
            .windows(2)
            .all(|pair| pair[0].faults != pair[1].faults)
    );
}
