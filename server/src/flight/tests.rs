//! Files read back and compared with the record that was stored.

use ::mcap::MessageStream;
use proptest::prelude::*;
use serde_json::Value;

use super::*;
use crate::clock::WallTime;
use crate::ids::{ModelId, ReproductionId, TaskId};
use crate::store::cycles::tests::record;
use crate::store::flights::FlightEvent;
use crate::store::reproductions::ReproductionState;

const ARMED: WallTime = WallTime(1_764_000_000_123);

fn reproduction() -> Reproduction {
    Reproduction {
        id: ReproductionId::new(),
        task_id: TaskId::new(),
        model_id: ModelId::new(),
        robot: Some("left".into()),
        plan: "aa".into(),
        state: ReproductionState::Succeeded,
        reason: None,
        created_at: WallTime(ARMED.0 - 1_500),
        armed_at: Some(ARMED),
        finished_at: None,
        start_deg: vec![0.0; 6],
        goal_deg: vec![1.0; 6],
        duration_s: 1.0,
        e_j_deg: None,
        e_j_commanded_deg: None,
        gmcc: None,
        tracking_error_deg: None,
        cycles: None,
        backwards: false,
        outcome: None,
    }
}

fn events(cycles: &[Cycle]) -> Vec<FlightEvent> {
    let event = |at_us, code: &str| FlightEvent {
        at_us,
        code: code.into(),
        message: format!("{code}, as \"words\""),
    };
    let end_us = cycles[cycles.len() - 1].at_us;
    vec![
        event(0, "armed"),
        event(end_us / 2, "motion"),
        event(end_us + 1, "completed"),
    ]
}

fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

proptest! {
    #[test]
    fn the_rows_of_the_csv_file_are_the_stored_cycles(cycles in record(60)) {
        let text = csv::header() + &csv::rows(&cycles);
        let mut lines = text.lines();
        let names: Vec<&str> = lines.next().unwrap().split(',').collect();
        let at = |name: &str| names.iter().position(|one| *one == name).unwrap();
        for cycle in &cycles {
            let row: Vec<&str> = lines.next().unwrap().split(',').collect();
            prop_assert_eq!(row.len(), names.len());
            let details = cycle.details.unwrap();
            prop_assert_eq!((number(row[at("t_s")]) * 1e6).round() as u64, cycle.at_us);
            prop_assert_eq!(number(row[at("plan_t_s")]), cycle.plan_t_s);
            prop_assert_eq!(row[at("phase")], details.phase.as_str());
            for joint in 0..6 {
                let value = |name: &str, unit: &str| row[at(&format!("{name}_{}_{unit}", joint + 1))];
                prop_assert_eq!(number(value("commanded", "deg")), cycle.commanded_deg[joint]);
                prop_assert_eq!(number(value("measured", "deg")), cycle.measured_deg[joint]);
                let speed: f32 = value("commanded_speed", "deg_s").parse().unwrap();
                prop_assert_eq!(speed, details.commanded_deg_s[joint]);
            }
            prop_assert_eq!(row[at("lost")], details.lost.to_string());
            prop_assert_eq!(row[at("late")] == "1", details.late);
            prop_assert_eq!(row[at("held")] == "1", details.held);
            prop_assert_eq!(row[at("limited")] == "1", details.limited);
            prop_assert_eq!(row[at("motors_on")] == "1", details.motors_on);
            prop_assert_eq!(row[at("rapid_running")] == "1", details.rapid_running);
            let percent: Option<f32> = row[at("utilization_percent")].parse().ok();
            prop_assert_eq!(percent, details.utilization_percent);
        }
        prop_assert!(lines.next().is_none());
    }

    #[test]
    fn the_messages_of_the_mcap_file_are_the_stored_cycles(cycles in record(60)) {
        let happened = events(&cycles);
        let mut recorder = mcap::Recorder::new(&reproduction(), happened.clone()).unwrap();
        let mut bytes = Vec::new();
        for page in cycles.chunks(9) {
            bytes.extend(recorder.write(page).unwrap());
        }
        bytes.extend(recorder.finish().unwrap());

        let mut topics: std::collections::BTreeMap<String, Vec<(u64, String, Value)>> = Default::default();
        for message in MessageStream::new(&bytes).unwrap() {
            let message = message.unwrap();
            let schema = message.channel.schema.as_ref().unwrap();
            prop_assert_eq!((message.channel.message_encoding.as_str(), schema.encoding.as_str()), ("json", "jsonschema"));
            let body: Value = serde_json::from_slice(&message.data).unwrap();
            let ns = body["timestamp"]["sec"].as_u64().unwrap() * 1_000_000_000
                + body["timestamp"]["nsec"].as_u64().unwrap();
            prop_assert_eq!(ns, message.log_time);
            let place = topics.entry(message.channel.topic.clone()).or_default();
            place.push((ns, schema.name.clone(), body));
        }
        let began_ns = ARMED.0.cast_unsigned() * 1_000_000;
        for (topic, angles) in [
            ("/commanded", cycles.iter().map(|c| c.commanded_deg).collect::<Vec<_>>()),
            ("/measured", cycles.iter().map(|c| c.measured_deg).collect()),
        ] {
            prop_assert_eq!(topics[topic].len(), cycles.len());
            for ((ns, schema, body), (cycle, angles)) in topics[topic].iter().zip(cycles.iter().zip(angles)) {
                prop_assert_eq!(schema, "foxglove.JointStates");
                prop_assert_eq!(*ns, began_ns + cycle.at_us * 1_000);
                for joint in 0..6 {
                    let state = &body["joints"][joint];
                    prop_assert_eq!(state["name"].as_str().unwrap(), format!("joint_{}", joint + 1));
                    let half_turns = state["position"].as_f64().unwrap() / std::f64::consts::PI;
                    prop_assert!((180.0 * half_turns - angles[joint]).abs() < 1e-9);
                }
            }
        }
        for ((_, schema, body), cycle) in topics["/cycle"].iter().zip(&cycles) {
            let details = cycle.details.unwrap();
            prop_assert_eq!(schema, "team.Cycle");
            prop_assert_eq!(body["plan_t_s"].as_f64().unwrap(), cycle.plan_t_s);
            prop_assert_eq!(body["phase"].as_str().unwrap(), details.phase.as_str());
            prop_assert_eq!(body["lost"].as_u64().unwrap(), u64::from(details.lost));
            prop_assert_eq!(body["late"].as_bool().unwrap(), details.late);
        }
        let told: Vec<(u64, String)> = topics["/events"]
            .iter()
            .map(|(ns, schema, body)| {
                assert_eq!(schema, "foxglove.Log");
                (*ns, format!("{}: {}", body["name"].as_str().unwrap(), body["message"].as_str().unwrap()))
            })
            .collect();
        let expected: Vec<(u64, String)> = happened
            .iter()
            .map(|event| (began_ns + event.at_us * 1_000, format!("{}: {}", event.code, event.message)))
            .collect();
        prop_assert_eq!(told, expected);
    }
}

#[test]
fn a_file_is_named_after_its_time_and_its_motion() {
    let reproduction = reproduction();
    let id = reproduction.id.to_string();
    let name = file_name(&reproduction, Format::Mcap);
    assert_eq!(
        name,
        format!("motion_20251124T160000Z_{}.mcap", &id[id.len() - 8..])
    );
}
