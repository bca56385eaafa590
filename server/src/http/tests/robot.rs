//! The arm's routes on a server without an arm: stop always works, everything else says why not.

use serde_json::{Value, json};

use super::Api;

#[tokio::test]
async fn without_an_arm_everything_but_stop_is_refused() {
    let api = Api::local().await;
    let robot = api.get("/api/v1/robot").await.ok(200);
    assert_eq!(
        (robot["kind"].as_str(), robot["state"].as_str()),
        (Some("none"), Some("disconnected"))
    );
    assert!(robot["joints_deg"].is_null() && robot["fault"].is_null());
    assert_eq!(
        api.post("/api/v1/robot/stop", Value::Null).await.status,
        204
    );
    let soft = api
        .post("/api/v1/robot/lead-through", json!({"active": true}))
        .await;
    assert!(soft.problem(409, "no_robot")["advice"].is_string());
    api.post("/api/v1/robot/lead-through", json!({}))
        .await
        .problem(422, "bad_field");
    let hand = json!({"action": "return", "script": "f1"});
    api.post("/api/v1/robot/virtual-hand", hand)
        .await
        .problem(409, "no_robot");
    let gripper = "/api/v1/robot/signals/GripperClose";
    api.post(gripper, json!({"on": true}))
        .await
        .problem(409, "no_robot");
    api.post(gripper, json!({"on": 1}))
        .await
        .problem(422, "bad_field");
    let hand = json!({"action": "wave", "script": "f1"});
    api.post("/api/v1/robot/virtual-hand", hand)
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
