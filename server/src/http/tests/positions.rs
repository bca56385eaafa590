//! Saved positions, without an arm: what is refused and why.

use serde_json::{Value, json};

use super::Api;

const POSITIONS: &str = "/api/v1/positions";
const REST: [f64; 6] = [0.0; 6];

async fn saved(api: &Api, name: &str) -> Value {
    let wish = json!({"name": name, "joints_deg": [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]});
    api.post(POSITIONS, wish).await.ok(201)
}

fn path(position: &Value) -> String {
    format!("{POSITIONS}/{}", position["id"].as_str().unwrap())
}

#[tokio::test]
async fn a_position_is_saved_renamed_moved_and_deleted() {
    let api = Api::local().await;
    let position = saved(&api, "  Fixture ").await;
    assert_eq!(position["name"], "Fixture");
    assert_eq!(position["robot"], "none");
    assert_eq!(api.get(&path(&position)).await.ok(200), position);
    assert_eq!(
        api.get("/api/v1/positions?robot=none").await.ok(200),
        json!([position])
    );
    assert_eq!(
        api.get("/api/v1/positions?robot=left").await.ok(200),
        json!([])
    );
    let renamed = api
        .json("PATCH", &path(&position), json!({"name": "Bin"}))
        .await;
    assert_eq!(renamed.ok(200)["name"], "Bin");
    let angles = json!([9.0, 8.0, 7.0, 6.0, 5.0, 4.0]);
    let moved = api
        .json("PATCH", &path(&position), json!({"joints_deg": angles}))
        .await;
    assert_eq!(
        (&moved.ok(200)["name"], &moved.json()["joints_deg"]),
        (&json!("Bin"), &angles)
    );
    let deleted = api.json("DELETE", &path(&position), json!(null)).await;
    assert_eq!(deleted.status, 204);
    api.get(&path(&position)).await.problem(404, "not_found");
    api.json("DELETE", &path(&position), json!(null))
        .await
        .problem(404, "not_found");
    assert_eq!(api.get(POSITIONS).await.ok(200), json!([]));
}

#[tokio::test]
async fn the_same_identifier_twice_is_one_position() {
    let api = Api::local().await;
    let wish = json!({
        "id": "0190b5a2-0000-7000-8000-000000000001", "name": "Bin", "joints_deg": REST,
    });
    let first = api.post(POSITIONS, wish.clone()).await.ok(201);
    assert_eq!(api.post(POSITIONS, wish).await.ok(200), first);
}

#[tokio::test]
async fn angles_beyond_the_arms_range_are_refused_with_joint_and_range() {
    let api = Api::local().await;
    let wish = |angles: Value| json!({"name": "Bin", "joints_deg": angles});
    let refused = api
        .post(POSITIONS, wish(json!([0, 0, 90.0, 0, 0, 0])))
        .await;
    let problem = refused.problem(422, "outside_joint_range");
    assert_eq!(problem["where"]["joint"], 3);
    assert_eq!(problem["where"]["max_deg"], 85.0);
    assert_eq!(
        problem["detail"],
        "Joint 3 is 90.0°, its range is -225° to 85°."
    );
    api.post(POSITIONS, wish(json!([0, 0, 0, 0, 0])))
        .await
        .problem(422, "bad_field");
    let position = saved(&api, "Bin").await;
    let change = json!({"joints_deg": [0, 0, 0, 0, 0, 270.5]});
    let refused = api.json("PATCH", &path(&position), change).await;
    refused.problem(422, "outside_joint_range");
    assert_eq!(
        api.get(&path(&position)).await.ok(200),
        position,
        "nothing changed"
    );
}

#[tokio::test]
async fn without_an_arm_the_present_pose_can_not_be_saved() {
    let api = Api::local().await;
    let refused = api.post(POSITIONS, json!({"name": "Here"})).await;
    assert!(refused.problem(409, "present_pose_unknown")["advice"].is_string());
    let position = saved(&api, "Bin").await;
    let refused = api
        .json("PATCH", &path(&position), json!({"present": true}))
        .await;
    refused.problem(409, "present_pose_unknown");
    assert_eq!(api.get(POSITIONS).await.ok(200), json!([position]));
    let elsewhere = json!({"name": "Here", "robot": "third", "joints_deg": REST});
    api.post(POSITIONS, elsewhere)
        .await
        .problem(404, "robot_unknown");
}

#[tokio::test]
async fn names_are_short_and_no_two_are_alike() {
    let api = Api::local().await;
    for name in ["", "  ", &"x".repeat(81), "a\u{7}b"] {
        let wish = json!({"name": name, "joints_deg": REST});
        let problem = api.post(POSITIONS, wish).await.problem(422, "bad_name");
        assert_eq!(problem["where"]["field"], "name");
    }
    saved(&api, &"ü".repeat(80)).await;
    saved(&api, "Bin").await;
    let wish = json!({"name": "BIN", "joints_deg": REST});
    let problem = api.post(POSITIONS, wish).await.problem(409, "name_taken");
    assert_eq!(problem["where"]["field"], "name");
}

#[tokio::test]
async fn a_motion_to_a_position_that_is_gone_or_another_robots_is_refused_in_words() {
    let api = Api::local().await;
    let goal = |position: &Value| {
        let model = "0190b5a2-0000-7000-8000-000000000009";
        json!({"model_id": model, "goal": {"position": position["id"]}})
    };
    let position = saved(&api, "Fixture").await;
    let known = api.post("/api/v1/plans", goal(&position)).await;
    let problem = known.problem(404, "not_found");
    assert_eq!(
        problem["detail"], "There is no such model.",
        "the position is fine"
    );
    api.json("DELETE", &path(&position), json!(null)).await;
    let deleted = api.post("/api/v1/plans", goal(&position)).await;
    let problem = deleted.problem(409, "position_deleted");
    assert_eq!(
        problem["detail"],
        "The saved position \"Fixture\" was deleted."
    );
    assert!(problem["advice"].is_string());
    let store = &api.state.store;
    let id = crate::ids::PositionId::new();
    store
        .save_position(id, "left", "Bin", REST, super::NOW)
        .await
        .unwrap();
    let elsewhere = api.post("/api/v1/plans", goal(&json!({"id": id}))).await;
    let problem = elsewhere.problem(409, "position_of_other_robot");
    assert_eq!(problem["where"]["robot"], "left");
    let nobody = json!({"id": "0190b5a2-0000-7000-8000-000000000008"});
    let unknown = api.post("/api/v1/plans", goal(&nobody)).await;
    unknown.problem(404, "not_found");
}
