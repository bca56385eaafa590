//! What is said of a task's takes before any training.

use std::f64::consts::PI;

use serde_json::{Value, json};

use super::{Api, NOW, swing};
use crate::ids::DemonstrationId;
use crate::store::demonstrations::{DemonstrationSource, DemonstrationState, NewDemonstration};
use crate::store::samples::Sample;

const NOBODY: &str = "0190b5a2-0000-7000-8000-000000000009";

/// Joint 1 turns by 40 deg in four seconds, and joint 5 nods by `nod_deg` in the middle.
fn turn(nod_deg: f64) -> String {
    let rows = (0..=200).map(|row| {
        let share = f64::from(row) / 200.0;
        let turned = 20.0 - 20.0 * (PI * share).cos();
        let nod = nod_deg * (-((share - 0.5) / 0.1).powi(2)).exp();
        format!("{},{turned},10,20,0,{},0\n", 4.0 * share, nod - 45.0)
    });
    let header = "t_s,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n".to_owned();
    rows.fold(header, |text, row| text + &row)
}

async fn agreement(api: &Api, task: &str) -> Value {
    let answer = api.get(&format!("/api/v1/tasks/{task}/agreement")).await;
    answer.ok(200)
}

fn verdicts(agreement: &Value) -> Vec<&str> {
    let takes = agreement["takes"].as_array().unwrap();
    takes
        .iter()
        .map(|take| take["verdict"].as_str().unwrap())
        .collect()
}

fn advice(agreement: &Value) -> &str {
    agreement["advice"].as_str().unwrap()
}

async fn decide(api: &Api, id: &str, verb: &str) {
    let path = format!("/api/v1/demonstrations/{id}/{verb}");
    api.post(&path, Value::Null).await.ok(200);
}

#[tokio::test]
async fn after_each_take_it_is_said_whether_to_record_another() {
    let api = Api::local().await;
    let task = api.task().await;
    let none = agreement(&api, &task).await;
    assert_eq!(
        (&none["takes"], &none["enough"]),
        (&json!([]), &json!(false))
    );
    assert!(advice(&none).contains("first take"), "{none}");

    let first = api.kept(&task, turn(0.0)).await;
    let one = agreement(&api, &task).await;
    assert_eq!(verdicts(&one), ["open"]);
    assert!(advice(&one).contains("one more"), "{one}");

    // A take counts before anybody has decided about it: this is to help with deciding.
    api.upload(&task, "take.csv", turn(0.5)).await.ok(201);
    let two = agreement(&api, &task).await;
    assert_eq!(verdicts(&two), ["open", "open"]);
    assert!(advice(&two).contains("one more"), "{two}");
    assert_eq!(two["enough"], false);

    let third = api.kept(&task, turn(-0.5)).await;
    let three = agreement(&api, &task).await;
    assert_eq!(verdicts(&three), ["agrees", "agrees", "agrees"]);
    assert_eq!(three["enough"], true, "{three}");
    assert!(advice(&three).contains("that's enough"), "{three}");
    assert_eq!(three["takes"][0]["id"], first);
    assert_eq!(agreement(&api, &task).await, three, "asked again");

    decide(&api, &third, "discard").await;
    assert_eq!(agreement(&api, &task).await, two, "a discarded take is out");
    decide(&api, &third, "keep").await;
    assert_eq!(agreement(&api, &task).await, three);
}

#[tokio::test]
async fn the_take_that_differs_is_named_with_joint_and_place() {
    let api = Api::local().await;
    let task = api.task().await;
    for nod_deg in [0.0, 30.0, 0.5, -0.5] {
        api.kept(&task, turn(nod_deg)).await;
    }
    let agreement = agreement(&api, &task).await;
    assert_eq!(
        verdicts(&agreement),
        ["agrees", "differs", "agrees", "agrees"]
    );
    assert_eq!(agreement["enough"], false);
    let words = advice(&agreement);
    assert!(
        words.starts_with("Take 2 differs") && words.contains("around the middle at joint 5"),
        "{words}"
    );
    let odd = &agreement["takes"][1];
    assert_eq!(odd["words"], "Differs most around the middle at joint 5");
    let worst = &odd["worst"];
    assert_eq!(worst["joint"], 5);
    assert!(
        (worst["phase"].as_f64().unwrap() - 0.5).abs() < 0.1,
        "{worst}"
    );
    assert!(
        (worst["off_deg"].as_f64().unwrap() - 30.0).abs() < 3.0,
        "{worst}"
    );
}

#[tokio::test]
async fn takes_that_training_would_refuse_are_an_answer_in_words() {
    let api = Api::local().await;
    let task = api.task().await;
    api.kept(&task, turn(0.0)).await;
    let other = api.kept(&task, swing(3.0, 1.0)).await;
    let two = agreement(&api, &task).await;
    assert_eq!(verdicts(&two), ["other_motion", "other_motion"]);
    assert_eq!(two["problem"]["code"], "demonstrations_different_motions");
    assert!(
        advice(&two).starts_with("Take 1 and take 2 show different motions."),
        "{two}"
    );
    api.kept(&task, turn(0.5)).await;
    let three = agreement(&api, &task).await;
    assert_eq!(verdicts(&three), ["open", "other_motion", "open"]);
    assert!(
        advice(&three).starts_with("Take 2 shows another motion than take 1 and take 3."),
        "{three}"
    );
    assert_eq!(three["enough"], false);
    decide(&api, &other, "discard").await;
    assert_eq!(agreement(&api, &task).await["problem"], Value::Null);
}

#[tokio::test]
async fn a_take_that_nothing_can_be_learnt_from_is_named_and_the_others_are_compared() {
    let api = Api::local().await;
    let task = api.task().await;
    api.kept(&task, turn(0.0)).await;
    // The hand let go at once. An uploaded file like this would have been refused.
    let still = [0, 400_000].map(|at_us| Sample {
        at_us,
        joints_deg: [0.0, 10.0, 20.0, 0.0, -45.0, 0.0],
        tcp_mm: None,
    });
    let new = NewDemonstration {
        id: DemonstrationId::new(),
        task_id: task.parse().unwrap(),
        state: DemonstrationState::Recorded,
        source: DemonstrationSource::HandGuiding,
        robot: Some("left"),
    };
    let stored = api
        .state
        .store
        .store_demonstration(new, &still, &[], "", NOW);
    stored.await.unwrap();
    for nod_deg in [0.5, -0.5] {
        api.kept(&task, turn(nod_deg)).await;
    }
    let agreement = agreement(&api, &task).await;
    assert_eq!(
        verdicts(&agreement),
        ["agrees", "unusable", "agrees", "agrees"]
    );
    assert_eq!(agreement["enough"], false, "training would refuse");
    assert_eq!(agreement["problem"]["code"], "demonstration_too_short");
    let words = advice(&agreement);
    assert!(
        words.contains("take 2") && words.contains("0.40 s"),
        "{words}"
    );
    assert!(words.ends_with("Discard take 2."), "{words}");
}

#[tokio::test]
async fn takes_too_long_to_be_compared_at_once_are_left_to_the_training() {
    let api = Api::local().await;
    let task = api.task().await;
    for _ in 0..3 {
        let uploaded = api.upload(&task, "long.csv", swing(200.0, 1.0)).await;
        uploaded.ok(201);
    }
    let agreement = agreement(&api, &task).await;
    assert_eq!(verdicts(&agreement), ["open", "open", "open"]);
    assert!(advice(&agreement).contains("too long"), "{agreement}");
}

#[tokio::test]
async fn a_task_that_is_not_there_has_no_takes_to_compare() {
    let api = Api::local().await;
    let path = format!("/api/v1/tasks/{NOBODY}/agreement");
    api.get(&path).await.problem(404, "not_found");
}
