//! A saved position by name: where the arm stands is saved, and a motion ends there.

use serde_json::json;

use crate::prepared::with_model;
use crate::steps::{alone, ended, idle_arm, joints, number, plan, start, text};

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_motion_ends_where_the_arm_stood_when_the_position_was_saved() {
    let _turn = alone().await;
    let (_folder, server, model) = with_model("positions", &[]).await;
    let client = server.client();
    let stood = joints(&idle_arm(&client).await, "joints_deg");
    let saved = client
        .post("/positions", json!({ "name": "Home of the arm" }))
        .await
        .expect(201);
    for (saved, stood) in joints(&saved, "joints_deg").iter().zip(stood) {
        assert!((saved - stood).abs() < 0.01, "{saved} for {stood}");
    }

    let there = json!({ "position": saved["id"] });
    let plan = plan(&client, &model, json!("as_taught"), there.clone()).await;
    assert_eq!(plan["goal_deg"], saved["joints_deg"], "{plan}");
    let running = start(&client, &plan).await;
    let result = ended(&client, &running).await;
    assert_eq!(result["state"], "succeeded", "{result}");
    assert!(number(&result, "e_j_deg") < 0.05, "{result}");

    let path = format!("/reproductions/{}/outcome", text(&result, "id"));
    let worked = ("application/json", json!({ "worked": true }).to_string());
    let said = client
        .send(reqwest::Method::PUT, &path, Some(worked))
        .await
        .expect(200);
    assert_eq!(said["outcome"]["worked"], true, "{said}");
    let dashboard = client.get("/dashboard").await.expect(200);
    assert_eq!(dashboard["runs"][0]["id"], result["id"], "{dashboard}");
    assert_eq!(dashboard["tasks"][0]["worked"], 1, "{dashboard}");

    let path = format!("/positions/{}", text(&saved, "id"));
    let gone = client.send(reqwest::Method::DELETE, &path, None).await;
    assert_eq!(gone.status, 204);
    let request = json!({ "model_id": model["id"], "start": there });
    let refused = client.post("/plans", request).await.problem(&[409]);
    assert_eq!(refused["code"], "position_deleted", "{refused}");
    server.terminate().await;
}
