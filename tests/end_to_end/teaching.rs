//! Cut ends and pauses through the front door: what is trained is what is used, and a kill in a
//! pause loses nothing.

use e2e::{Client, Folder, LONG, Process, eventually};
use reqwest::Method;
use serde_json::{Value, json};

use crate::steps::{alone, idle_arm, new_task, number, numbers, plan, text, train};
use crate::{PROGRAM, SCRATCH};

/// Two seconds of standing still, four of a swing, three of standing still, as a file.
fn with_rests(size: f64) -> String {
    let mut csv = "t_s,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n".to_owned();
    for row in 0..=450 {
        let t_s = 0.02 * f64::from(row);
        let share = ((t_s - 2.0) / 4.0).clamp(0.0, 1.0);
        let turn = size * (0.5 - 0.5 * (std::f64::consts::PI * share).cos());
        let (first, second) = (30.0 * turn, 8.0 + 12.0 * turn);
        csv += &format!("{t_s},{first},{second},24,0,-45,0\n");
    }
    csv
}

async fn put(client: &Client, path: &str, body: &Value) -> Value {
    let body = Some(("application/json", body.to_string()));
    client.send(Method::PUT, path, body).await.expect(200)
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn takes_with_cut_ends_are_learned_without_the_standing_still() {
    let _turn = alone().await;
    let folder = Folder::new(SCRATCH, "cut-takes");
    let server = Process::start(PROGRAM, folder.path(), &[]).await;
    let client = server.client();
    idle_arm(&client).await;
    let task = new_task(&client, "Cut takes").await;
    let mut takes = Vec::new();
    for size in [0.97, 1.0, 1.03] {
        let path = format!("/tasks/{task}/demonstrations/upload?name=take.csv");
        let take = client.post_text(&path, "text/csv", with_rests(size)).await;
        let path = format!("/demonstrations/{}", text(&take.expect(201), "id"));
        let _ = client.post_empty(&format!("{path}/keep")).await.expect(200);
        takes.push(path);
    }
    let whole = train(&client, &task, json!({})).await;
    for take in &takes {
        let proposed = client
            .get(&format!("{take}/trim/suggestion"))
            .await
            .expect(200);
        let cut = put(&client, &format!("{take}/trim"), &proposed["trim"]).await;
        assert_eq!(cut["trim"], proposed["trim"], "{cut}");
    }
    let cut = train(&client, &task, json!({})).await;
    assert_ne!(
        cut["id"], whole["id"],
        "other stretches are another training"
    );
    let learned_s = |model: &Value| number(&model["report"]["demonstrations"][0], "duration_s");
    assert!((learned_s(&whole) - 9.0).abs() < 1e-6, "{whole}");
    assert!((learned_s(&cut) - 4.2).abs() < 0.2, "{cut}");
    let planned = plan(&client, &cut, json!("as_taught"), json!("as_taught")).await;
    assert!(number(&planned, "duration_s") > 0.0);

    // The first model is what it was, and the recordings are all there.
    let path = format!("/models/{}", text(&whole, "id"));
    assert_eq!(client.get(&path).await.expect(200), whole);
    let raw = format!("{}/trajectory?raw=true&max_points=20000", takes[0]);
    let raw = client.get(&raw).await.expect(200);
    assert_eq!(numbers(&raw["t_s"]).len(), 451);
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_kill_in_a_pause_loses_nothing_that_was_recorded() {
    let _turn = alone().await;
    let folder = Folder::new(SCRATCH, "kill-in-pause");
    let server = Process::start(PROGRAM, folder.path(), &[]).await;
    let client = server.client();
    idle_arm(&client).await;
    let task = new_task(&client, "Held up").await;
    let path = format!("/tasks/{task}/demonstrations");
    let take = client.post(&path, json!({})).await.expect(201);
    let path = format!("/demonstrations/{}", text(&take, "id"));
    eventually("a second is recorded", LONG, || async {
        let take = client.get(&path).await.expect(200);
        (number(&take, "duration_s") > 1.0).then_some(())
    })
    .await;
    let paused = client
        .post_empty(&format!("{path}/pause"))
        .await
        .expect(200);
    assert_eq!(numbers(&paused["paused_at_deg"]).len(), 6);
    server.kill().await;

    let server = Process::start(PROGRAM, folder.path(), &[]).await;
    let client = server.client();
    let found = client.get(&path).await.expect(200);
    assert_eq!(found["state"], "interrupted", "{found}");
    assert_eq!(found["samples"], paused["samples"], "{found}");
    assert_eq!(
        (&found["pauses"], found.get("paused_at_deg")),
        (&json!(1), None)
    );
    let refused = client.post_empty(&format!("{path}/resume")).await;
    let problem = refused.problem(&[409]);
    assert_eq!(problem["code"], "wrong_state", "{problem}");
    let trajectory = client.get(&format!("{path}/trajectory")).await.expect(200);
    assert_eq!(
        trajectory["pauses"][0]["length_s"],
        Value::Null,
        "{}",
        trajectory["pauses"]
    );
    server.terminate().await;
}
