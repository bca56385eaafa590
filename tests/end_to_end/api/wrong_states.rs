//! Requests that would be right at another moment.

use e2e::take;
use serde_json::json;

use super::{NOBODY, armless};
use crate::prepared::{SEED, with_model};
use crate::steps::{new_task, text, until_state, upload_and_keep};

const ARMLESS: &[&str] = &["--robot", "none"];

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn stopping_again_changes_nothing_and_keeping_undoes_discarding() {
    let (_folder, server) = armless("states").await;
    let client = server.client();
    let task = new_task(&client, "states").await;
    let kept = upload_and_keep(&client, &task, "take-1.csv", take(1, 3.0).csv()).await;
    let path = format!("/demonstrations/{}", text(&kept, "id"));
    // A second tap on Stop is no mistake, but it changes nothing any more.
    let stopped = client.post_empty(&format!("{path}/stop")).await;
    assert_eq!(stopped.expect(200), kept);

    let discarded = client
        .post_empty(&format!("{path}/discard"))
        .await
        .expect(200);
    assert_eq!(discarded["state"], "discarded");
    let again = client.post_empty(&format!("{path}/keep")).await.expect(200);
    assert_eq!(again, kept, "nothing of it was lost");
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn the_same_training_asked_for_twice_is_one_job() {
    let (_folder, server, model) = with_model("double-tap", ARMLESS).await;
    let client = server.client();
    let models = format!("/tasks/{}/models", text(&model, "task_id"));
    let again = client
        .post(&models, json!({ "seed": SEED }))
        .await
        .expect(202);
    assert_eq!(again["model"], model);
    assert_eq!(again["job"]["id"], model["job_id"]);
    let other = client
        .post(&models, json!({ "seed": SEED + 1 }))
        .await
        .expect(202);
    assert_ne!(
        other["model"]["id"], model["id"],
        "another seed is another model"
    );
    let all = client.get(&models).await.expect(200);
    assert_eq!(all.as_array().map(Vec::len), Some(2));
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_plan_that_nobody_saw_does_not_run_and_a_goal_out_of_range_makes_none() {
    let (_folder, server, model) = with_model("plans", ARMLESS).await;
    let client = server.client();
    let unknown = json!({ "plan": "00".repeat(32), "id": NOBODY });
    let problem = client
        .post("/reproductions", unknown)
        .await
        .problem(&[404, 409]);
    assert!(!text(&problem, "advice").is_empty(), "{problem}");

    // Joint 3 of the arm ends at 85 degrees.
    let goal = json!({ "joints_deg": [10, 10, 95, 0, -45, 0] });
    let request = json!({ "model_id": model["id"], "start": "as_taught", "goal": goal });
    let problem = client.post("/plans", request).await.problem(&[409, 422]);
    let words = format!("{} {}", problem["detail"], problem["where"]);
    assert!(words.contains('3') && words.contains("85"), "{problem}");
    assert!(!text(&problem, "advice").is_empty(), "{problem}");
    for speed in [-1.0, 0.0, 1.5] {
        let request = json!({ "model_id": model["id"], "speed": speed });
        let problem = client.post("/plans", request).await.problem(&[422]);
        assert!(!text(&problem, "advice").is_empty(), "{problem}");
    }
    let none = client.get("/reproductions").await.expect(200);
    assert_eq!(none, json!([]), "nothing ran");
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_training_that_is_over_cannot_be_cancelled_and_a_running_one_can() {
    let (_folder, server, model) = with_model("cancel", ARMLESS).await;
    let client = server.client();
    let job = format!("/jobs/{}", text(&model, "job_id"));
    let after = client.post_empty(&format!("{job}/cancel")).await;
    match after.status.as_u16() {
        200 => assert_eq!(
            after.expect(200)["state"],
            "succeeded",
            "a result is not taken back"
        ),
        _ => drop(after.problem(&[409])),
    }
    assert_eq!(client.get(&job).await.expect(200)["state"], "succeeded");

    let models = format!("/tasks/{}/models", text(&model, "task_id"));
    let accepted = client
        .post(&models, json!({ "seed": SEED + 1 }))
        .await
        .expect(202);
    let job = format!("/jobs/{}", text(&accepted["job"], "id"));
    let _ = client
        .post_empty(&format!("{job}/cancel"))
        .await
        .expect(200);
    let ended = until_state(&client, &job, &["cancelled", "succeeded"]).await;
    assert_eq!(ended["state"], "cancelled", "{ended}");
    let model = format!("/models/{}", text(&accepted["model"], "id"));
    assert_eq!(client.get(&model).await.expect(200)["state"], "cancelled");
    let _ = client
        .get(&format!("{model}/file"))
        .await
        .problem(&[409, 404]);
    server.terminate().await;
}
