//! The robots' routes on a server without an arm: stop always works, everything else says why not.

use serde_json::{Value, json};

use super::Api;

#[tokio::test]
async fn without_an_arm_everything_but_stop_is_refused() {
    let api = Api::local().await;
    let robot = api.get("/api/v1/robots/none").await.ok(200);
    assert_eq!(
        (robot["kind"].as_str(), robot["state"].as_str()),
        (Some("none"), Some("disconnected"))
    );
    assert!(robot["joints_deg"].is_null() && robot["fault"].is_null());
    assert_eq!(
        api.post("/api/v1/robots/none/stop", Value::Null)
            .await
            .status,
        204
    );
    let soft = api
        .post("/api/v1/robots/none/lead-through", json!({"active": true}))
        .await;
    assert!(soft.problem(409, "no_robot")["advice"].is_string());
    api.post("/api/v1/robots/none/lead-through", json!({}))
        .await
        .problem(422, "bad_field");
    let hand = json!({"action": "return", "script": "f1"});
    api.post("/api/v1/robots/none/virtual-hand", hand)
        .await
        .problem(409, "no_robot");
    let gripper = "/api/v1/robots/none/signals/GripperClose";
    api.post(gripper, json!({"on": true}))
        .await
        .problem(409, "no_robot");
    api.post(gripper, json!({"on": 1}))
        .await
        .problem(422, "bad_field");
    let hand = json!({"action": "wave", "script": "f1"});
    api.post("/api/v1/robots/none/virtual-hand", hand)
        .await
        .problem(422, "bad_field");
}

#[tokio::test]
async fn a_recording_that_can_not_begin_leaves_nothing_behind() {
    let api = Api::local().await;
    let task = api.task().await;
    let path = format!("/api/v1/tasks/{task}/demonstrations");
    api.post(&path, json!({})).await.problem(409, "no_robot");
    api.post(&path, json!({"virtual_hand": "f2", "seed": 3}))
        .await
        .problem(409, "no_robot");
    api.post(&path, json!({"virtual_hand": "f9"}))
        .await
        .problem(422, "bad_field");
    assert_eq!(api.get(&path).await.ok(200), json!([]));
    let nobody = "/api/v1/tasks/0190b5a2-0000-7000-8000-000000000009/demonstrations";
    api.post(nobody, json!({})).await.problem(404, "not_found");
}

#[tokio::test]
async fn robots_are_listed_and_an_unknown_one_is_answered_with_the_known_ones() {
    let api = Api::local().await;
    let robots = api.get("/api/v1/robots").await.ok(200);
    assert_eq!(robots.as_array().map(Vec::len), Some(1));
    let one = api.get("/api/v1/robots/none").await.ok(200);
    assert_eq!(
        (&one["id"], &one["name"]),
        (&json!("none"), &json!("No robot"))
    );
    assert_eq!(
        api.post("/api/v1/robots/stop", Value::Null).await.status,
        204
    );
    let task = api.task().await;
    let model = "0190b5a2-0000-7000-8000-000000000009";
    let unknown = [
        ("/api/v1/robots/left/stop".to_owned(), Value::Null),
        ("/api/v1/robots/left/reset".to_owned(), Value::Null),
        (
            "/api/v1/robots/left/lead-through".to_owned(),
            json!({"active": true}),
        ),
        (
            "/api/v1/robots/left/virtual-hand".to_owned(),
            json!({"action": "return", "script": "f1"}),
        ),
        (
            format!("/api/v1/tasks/{task}/demonstrations"),
            json!({"robot": "left"}),
        ),
        (
            "/api/v1/plans".to_owned(),
            json!({"model_id": model, "robot": "left"}),
        ),
        (
            "/api/v1/reproductions".to_owned(),
            json!({"plan": "aa", "robot": "left"}),
        ),
    ];
    for (path, body) in unknown {
        let problem = api.post(&path, body).await.problem(404, "robot_unknown");
        let detail = problem["detail"].as_str().unwrap();
        assert!(detail.contains("\"none\""), "{path}: {detail}");
    }
    for path in ["/api/v1/robots/left", "/api/v1/live?robot=left"] {
        api.get(path).await.problem(404, "robot_unknown");
    }
}
