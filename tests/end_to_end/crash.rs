//! The server is killed in the middle of its work and started again on the same data.

use std::time::Instant;

use e2e::{Client, Folder, LONG, Live, Process, eventually};
use serde_json::{Value, json};

use crate::prepared::{SEED, prepared};
use crate::steps::{alone, idle_arm, new_task, number, numbers, text, until_state};
use crate::{PROGRAM, SCRATCH};

/// What a kill may cost of a recording.
const MAY_BE_LOST_S: f64 = 0.5;

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_kill_while_recording_loses_at_most_the_last_half_second() {
    let _turn = alone().await;
    let folder = Folder::new(SCRATCH, "kill-recording");
    let server = Process::start(PROGRAM, folder.path(), &[]).await;
    let client = server.client();
    idle_arm(&client).await;
    let task = new_task(&client, "interrupted").await;
    let mut live = Live::connect(client.base()).await;
    let request = json!({ "virtual_hand": "f1", "seed": 5 });
    let path = format!("/tasks/{task}/demonstrations");
    let opened = client.post(&path, request).await.expect(201);
    let path = format!("/demonstrations/{}", text(&opened, "id"));

    // The recording is at least as long as the time between these two moments.
    let is_ours = |message: &Value| {
        let demonstration = &message["demonstration"];
        demonstration["id"] == opened["id"] && demonstration["state"] == "recording"
    };
    live.wait_for("demonstration", is_ours).await;
    let began = Instant::now();
    let long =
        |message: &Value| is_ours(message) && number(&message["demonstration"], "duration_s") > 3.2;
    live.wait_for("demonstration", long).await;
    let recorded_s = began.elapsed().as_secs_f64();
    server.kill().await;

    let server = Process::start(PROGRAM, folder.path(), &[]).await;
    let client = server.client();
    let found = client.get(&path).await.expect(200);
    assert_eq!(found["state"], "interrupted", "{found}");
    assert!(
        !text(&found, "note").is_empty(),
        "it says why it is short: {found}"
    );
    let kept_s = number(&found, "duration_s");
    assert!(
        kept_s >= recorded_s - MAY_BE_LOST_S,
        "{kept_s} s of {recorded_s} s: {found}"
    );

    // The samples are there too, not only the figure.
    let trajectory = client
        .get(&format!("{path}/trajectory?max_points=2000"))
        .await
        .expect(200);
    let t_s = numbers(&trajectory["t_s"]);
    assert!(
        (t_s[t_s.len() - 1] - t_s[0] - kept_s).abs() < 0.1,
        "{found}"
    );
    let kept = client.post_empty(&format!("{path}/keep")).await.expect(200);
    assert_eq!(
        (&kept["state"], &kept["usable"]),
        (&json!("kept"), &json!(true)),
        "{kept}"
    );
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_kill_while_training_gives_the_same_model_as_no_kill() {
    let prepared = prepared().await;
    let folder = Folder::new(SCRATCH, "kill-training");
    folder.copy_from(&prepared.taught);
    let server = Process::start(PROGRAM, folder.path(), &["--robot", "none"]).await;
    let client = server.client();
    let path = format!("/tasks/{}/models", prepared.task);
    let accepted = client
        .post(&path, json!({ "seed": SEED }))
        .await
        .expect(202);
    let job_path = format!("/jobs/{}", text(&accepted["job"], "id"));
    let model_path = format!("/models/{}", text(&accepted["model"], "id"));
    under_way(&client, &job_path).await;
    server.kill().await;

    let server = Process::start(PROGRAM, folder.path(), &["--robot", "none"]).await;
    let client = server.client();
    let job = until_state(&client, &job_path, &["succeeded", "failed", "cancelled"]).await;
    assert_eq!(
        job["state"], "succeeded",
        "it started again by itself: {job}"
    );
    assert_eq!(job["attempt"], 2, "{job}");
    let after_kill = client
        .get(&format!("{model_path}/file"))
        .await
        .expect_bytes(200);
    server.terminate().await;
    assert!(!after_kill.is_empty());
    assert!(
        after_kill == prepared.file,
        "not the model that an undisturbed training gives"
    );
}

/// Waits until the training has done some of its work and has some before it.
async fn under_way(client: &Client, job_path: &str) {
    eventually("the training is under way", LONG, || async {
        let job = client.get(job_path).await.expect(200);
        assert_ne!(
            job["state"], "succeeded",
            "the training was over before it could be disturbed"
        );
        (job["state"] == "running" && number(&job["progress"], "fraction") > 0.1).then_some(())
    })
    .await;
}
