//! Training, models, jobs, plans and reproductions, as far as they go without an arm.

use std::time::Duration;

use serde_json::{Value, json};
use tokio::time::timeout;

use super::{Api, request, swing};
use crate::jobs::Worker;

const NOBODY: &str = "0190b5a2-0000-7000-8000-000000000009";

/// A trained model's identifier. Training runs on the real worker.
async fn trained(api: &Api, task: &str) -> String {
    api.kept(task, swing(1.1, 1.0)).await;
    let mut events = api.state.events.listen();
    let asked = api
        .post(&format!("/api/v1/tasks/{task}/models"), json!({}))
        .await
        .ok(202);
    let worker = Worker::start(api.state.queue.clone(), api.state.shutdown.clone()).unwrap();
    let id = asked["model"]["id"].as_str().unwrap().to_owned();
    let path = format!("/api/v1/models/{id}");
    let ready = async {
        while api.get(&path).await.ok(200)["state"] == "training" {
            events.recv().await.ok();
        }
    };
    timeout(Duration::from_secs(120), ready).await.unwrap();
    api.state.shutdown.raise();
    worker.ended().await;
    id
}

#[tokio::test]
async fn training_needs_demonstrations_that_can_be_used() {
    let api = Api::local().await;
    let task = api.task().await;
    let path = format!("/api/v1/tasks/{task}/models");
    let none = api.post(&path, json!({})).await;
    assert!(none.problem(422, "no_demonstrations")["advice"].is_string());
    let unknown = api.post(&path, json!({"demonstrations": [NOBODY]})).await;
    let problem = unknown.problem(422, "demonstration_unknown");
    assert_eq!(problem["where"]["demonstration"], NOBODY);
    let id = api.kept(&task, swing(2.0, 1.0)).await;
    let method = api.post(&path, json!({"method": "guessing"})).await;
    assert_eq!(
        method.problem(422, "method_unknown")["where"]["field"],
        "method"
    );
    api.post(&path, json!({"seed": -1}))
        .await
        .problem(422, "bad_field");
    let elsewhere = format!("/api/v1/tasks/{NOBODY}/models");
    api.post(&elsewhere, json!({}))
        .await
        .problem(404, "not_found");
    assert_eq!(
        api.get(&path).await.ok(200),
        json!([]),
        "nothing came of the refused ones"
    );
    let chosen = api
        .post(&path, json!({"demonstrations": [id, id], "seed": 7}))
        .await
        .ok(202);
    assert_eq!(chosen["model"]["demonstrations"], json!([id]));
    assert_eq!(chosen["model"]["seed"], 7);
}

#[tokio::test]
async fn a_double_tap_is_one_job_and_a_cancelled_one_stays_cancelled() {
    let api = Api::local().await;
    let task = api.task().await;
    api.kept(&task, swing(2.0, 1.0)).await;
    let path = format!("/api/v1/tasks/{task}/models");
    let first = api.post(&path, json!({})).await;
    let job = format!(
        "/api/v1/jobs/{}",
        first.ok(202)["job"]["id"].as_str().unwrap()
    );
    assert_eq!(first.header("location"), job);
    let second = api.post(&path, json!({})).await;
    assert_eq!(second.ok(202), first.json());
    let model = format!(
        "/api/v1/models/{}",
        first.json()["model"]["id"].as_str().unwrap()
    );
    api.get(&format!("{model}/file"))
        .await
        .problem(404, "not_found");
    api.get(&format!("{model}/curve"))
        .await
        .problem(409, "wrong_state");
    let plan = api
        .post(
            "/api/v1/plans",
            json!({"model_id": first.json()["model"]["id"]}),
        )
        .await;
    plan.problem(409, "wrong_state");
    let queued = api.get("/api/v1/jobs?state=queued").await.ok(200);
    assert_eq!(queued, json!([first.json()["job"]]));
    for _ in 0..2 {
        let cancelled = api
            .post(&format!("{job}/cancel"), Value::Null)
            .await
            .ok(200);
        assert_eq!(cancelled["state"], "cancelled");
    }
    assert_eq!(api.get(&model).await.ok(200)["state"], "cancelled");
    assert_eq!(api.get(&job).await.ok(200)["state"], "cancelled");
    let again = api.post(&path, json!({})).await.ok(202);
    assert_ne!(again["job"]["id"], first.json()["job"]["id"]);
}

#[tokio::test]
async fn a_trained_model_is_shown_planned_and_refused_without_an_arm() {
    let api = Api::local().await;
    let task = api.task().await;
    let id = trained(&api, &task).await;
    let path = format!("/api/v1/models/{id}");
    let model = api.get(&path).await.ok(200);
    assert_eq!(model["state"], "ready", "{model}");
    assert!(model["summary"].is_string() && model["report"].is_object());
    assert_eq!(model["goal_deg"].as_array().unwrap().len(), 6);
    let file = api.get(&format!("{path}/file")).await;
    assert_eq!(file.ok(200)["format"], "team-model");
    let curve = api
        .get(&format!("{path}/curve?max_points=50"))
        .await
        .ok(200);
    assert_eq!(curve["t_s"].as_array().unwrap().len(), 50);
    assert_eq!(curve["mean_deg"].as_array().unwrap().len(), 6);
    assert_eq!(curve["std_deg"][5].as_array().unwrap().len(), 50);

    let plan = api
        .post(
            "/api/v1/plans",
            json!({"model_id": id, "goal": "as_taught"}),
        )
        .await
        .ok(200);
    assert_eq!(plan["goal_deg"], model["goal_deg"]);
    assert!(plan["duration_s"].as_f64().unwrap() > 1.0);
    assert_eq!(plan["joints_deg"].as_array().unwrap().len(), 6);
    let codes = |plan: &Value| -> Vec<Value> {
        let details = plan["warning_details"].as_array().unwrap();
        assert_eq!(details.len(), plan["warnings"].as_array().unwrap().len());
        details
            .iter()
            .map(|detail| detail["code"].clone())
            .collect()
    };
    assert!(codes(&plan).contains(&json!("no_arm")));
    assert!(!codes(&plan).contains(&json!("far_from_taught")));
    let mut goal_deg = model["goal_deg"].clone();
    goal_deg[3] = json!(goal_deg[3].as_f64().unwrap() + 35.0);
    let outside = json!({"model_id": id, "goal": {"joints_deg": goal_deg}});
    let outside = api.post("/api/v1/plans", outside).await.ok(200);
    let far = codes(&outside)
        .iter()
        .position(|code| code == "far_from_taught");
    let (words, detail) = (
        &outside["warnings"][far.unwrap()],
        &outside["warning_details"][far.unwrap()],
    );
    assert!(words.as_str().unwrap().contains("joint 4"), "{words}");
    assert_eq!(
        (&detail["field"], &detail["joint"]),
        (&json!("goal"), &json!(4))
    );
    assert!((detail["off_deg"].as_f64().unwrap() - 35.0).abs() < 1e-6);

    let far = json!({"model_id": id, "goal": {"joints_deg": [0, 0, 0, 0, 0, 400]}});
    let problem = api
        .post("/api/v1/plans", far)
        .await
        .problem(409, "outside_joint_range");
    assert_eq!(
        (
            problem["where"]["joint"].as_u64(),
            problem["where"]["field"].as_str()
        ),
        (Some(6), Some("goal"))
    );
    let present = json!({"model_id": id, "start": "present"});
    api.post("/api/v1/plans", present)
        .await
        .problem(409, "present_pose_unknown");
    for speed in [0.0, 1.5] {
        let answer = api
            .post("/api/v1/plans", json!({"model_id": id, "speed": speed}))
            .await;
        assert_eq!(answer.problem(422, "bad_speed")["where"]["field"], "speed");
    }
    let nonsense = json!({"model_id": id, "goal": "somewhere"});
    api.post("/api/v1/plans", nonsense)
        .await
        .problem(422, "bad_field");
    api.post("/api/v1/plans", json!({"model_id": NOBODY}))
        .await
        .problem(404, "not_found");

    let start = api
        .post("/api/v1/reproductions", json!({"plan": plan["plan"]}))
        .await;
    start.problem(409, "no_robot");
    let none = api
        .get(&format!("/api/v1/reproductions?task={task}"))
        .await
        .ok(200);
    assert_eq!(
        none,
        json!([]),
        "a motion that never began is no reproduction"
    );
}

#[tokio::test]
async fn reproductions_that_can_not_be_are_refused() {
    let api = Api::local().await;
    let path = "/api/v1/reproductions";
    let unknown = api
        .post(path, json!({"plan": "00"}))
        .await
        .problem(409, "plan_unknown");
    assert!(unknown["advice"].as_str().unwrap().contains("Preview"));
    api.post(path, json!({})).await.problem(422, "bad_field");
    let mut bad_key = request("POST", path, "{\"plan\": \"00\"}".into());
    let headers = bad_key.headers_mut();
    headers.insert("content-type", "application/json".parse().unwrap());
    headers.insert("idempotency-key", "".parse().unwrap());
    api.send(bad_key).await.problem(422, "bad_idempotency_key");
    for what in ["", "/trajectory"] {
        api.get(&format!("{path}/{NOBODY}{what}"))
            .await
            .problem(404, "not_found");
    }
    api.post(&format!("{path}/{NOBODY}/stop"), Value::Null)
        .await
        .problem(404, "not_found");
    for path in ["/api/v1/jobs", "/api/v1/models"] {
        api.get(&format!("{path}/{NOBODY}"))
            .await
            .problem(404, "not_found");
    }
    api.get(&format!("/api/v1/models/{NOBODY}/curve"))
        .await
        .problem(404, "not_found");
    api.post(&format!("/api/v1/jobs/{NOBODY}/cancel"), Value::Null)
        .await
        .problem(404, "not_found");
}
