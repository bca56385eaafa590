//! The main job: show a motion three times, train, and have the arm do it from somewhere else to
//! somewhere else. Everything is judged by the controller's feedback.

use e2e::{Client, Folder, Process};
use serde_json::{Value, json};

use crate::steps::until_state;
use crate::steps::{alone, ended, idle_arm, joints, new_task, number, numbers, start, text, train};
use crate::{PROGRAM, SCRATCH};

/// Largest mean joint error at the end of the motion, measured by the arm.
const END_ERROR_DEG: f64 = 0.05;
/// Smallest similarity of the measured path and the regression.
const GMCC: f64 = 0.99;
const START_OFF_DEG: f64 = 20.0;
const GOAL_OFF_DEG: f64 = 5.0;

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn three_takes_by_the_hand_make_a_motion_that_the_arm_reproduces() {
    let _turn = alone().await;
    let folder = Folder::new(SCRATCH, "teach");
    let server = Process::start(PROGRAM, folder.path(), &[]).await;
    let client = server.client();
    idle_arm(&client).await;

    let task = new_task(&client, "Drilling machine").await;
    for seed in 1..=3 {
        show(&client, &task, seed).await;
    }
    let model = train(&client, &task, json!({})).await;
    assert!(!text(&model, "summary").is_empty(), "{model}");
    assert_eq!(
        model["demonstrations"].as_array().map(Vec::len),
        Some(3),
        "{model}"
    );

    let plan = approved_plan(&client, &model).await;
    let (from, to) = (joints(&plan, "start_deg"), joints(&plan, "goal_deg"));
    assert_off(&from, &joints(&model, "start_deg"), START_OFF_DEG);
    assert_off(&to, &joints(&model, "goal_deg"), GOAL_OFF_DEG);

    let running = start(&client, &plan).await;
    let result = ended(&client, &running).await;
    assert_eq!(result["state"], "succeeded", "{result}");
    assert!(number(&result, "gmcc") >= GMCC, "{result}");
    assert!(number(&result, "e_j_deg") <= END_ERROR_DEG, "{result}");
    assert_measured(&client, &result, &from, &to).await;
    server.terminate().await;
}

/// One take by the virtual hand, kept.
async fn show(client: &Client, task: &str, seed: u64) {
    let request = json!({ "virtual_hand": "f1", "seed": seed });
    let path = format!("/tasks/{task}/demonstrations");
    let opened = client.post(&path, request).await.expect(201);
    let path = format!("/demonstrations/{}", text(&opened, "id"));
    let recorded = until_state(client, &path, &["recorded", "interrupted"]).await;
    assert_eq!(recorded["state"], "recorded", "{recorded}");
    assert_eq!(recorded["usable"], true, "{recorded}");
    let kept = client.post_empty(&format!("{path}/keep")).await.expect(200);
    assert_eq!(
        (&kept["state"], &kept["take"]),
        (&json!("kept"), &json!(seed)),
        "{kept}"
    );
    idle_arm(client).await;
}

/// The first plan that the gate approves among all choices of signs: every joint of the start is
/// off by 20 degrees and every joint of the goal by 5, to one side or the other.
async fn approved_plan(client: &Client, model: &Value) -> Value {
    let (taught_start, taught_goal) = (joints(model, "start_deg"), joints(model, "goal_deg"));
    let mut refusals = Vec::new();
    for signs in 0..64_u32 {
        let sign = |joint: usize| if signs & (1 << joint) == 0 { 1.0 } else { -1.0 };
        let from: [f64; 6] = std::array::from_fn(|j| taught_start[j] + sign(j) * START_OFF_DEG);
        let to: [f64; 6] = std::array::from_fn(|j| taught_goal[j] + sign(j) * GOAL_OFF_DEG);
        let request = json!({
            "model_id": model["id"],
            "start": { "joints_deg": from },
            "goal": { "joints_deg": to },
        });
        let reply = client.post("/plans", request).await;
        if reply.status == 200 {
            return reply.expect(200);
        }
        refusals.push(reply.problem(&[409])["detail"].to_string());
    }
    panic!("the gate refuses every choice of signs: {refusals:#?}");
}

fn assert_off(angles: &[f64; 6], taught: &[f64; 6], off_deg: f64) {
    for (angle, taught) in angles.iter().zip(taught) {
        let difference = (angle - taught).abs();
        assert!(
            (difference - off_deg).abs() < 1e-6,
            "{angles:?} against {taught:?}"
        );
    }
}

/// The figures once more from the flight record, without believing the server's arithmetic.
async fn assert_measured(client: &Client, result: &Value, from: &[f64; 6], to: &[f64; 6]) {
    let path = format!(
        "/reproductions/{}/trajectory?max_points=2000",
        text(result, "id")
    );
    let record = client.get(&path).await.expect(200);
    let measured: Vec<Vec<f64>> = record["measured_deg"]
        .as_array()
        .into_iter()
        .flatten()
        .map(numbers)
        .collect();
    assert_eq!(measured.len(), 6, "six joints");
    let last: Vec<f64> = measured
        .iter()
        .map(|joint| joint[joint.len() - 1])
        .collect();
    let errors = last
        .iter()
        .zip(to)
        .map(|(angle, goal)| (angle - goal).abs());
    let e_j_deg = errors.sum::<f64>() / 6.0;
    assert!(
        e_j_deg <= END_ERROR_DEG,
        "measured {last:?} for the goal {to:?}"
    );
    assert!(
        (e_j_deg - number(result, "e_j_deg")).abs() < 0.01,
        "{e_j_deg} against {result}"
    );

    // The arm really was at the start that was asked for, which it had to approach first.
    let nearest = (0..measured[0].len())
        .map(|at| {
            (0..6)
                .map(|j| (measured[j][at] - from[j]).abs())
                .fold(0.0, f64::max)
        })
        .fold(f64::INFINITY, f64::min);
    assert!(
        nearest < 0.5,
        "the arm never came nearer to its start than {nearest} degrees"
    );
}
