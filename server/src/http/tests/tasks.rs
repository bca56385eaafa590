//! Tasks, and the refusals that every route shares.

use axum::body::Body;
use axum::http::header;
use serde_json::json;

use super::{Api, request, swing};

#[tokio::test]
async fn a_task_is_made_renamed_and_put_out_of_sight() {
    let api = Api::local().await;
    let made = api
        .post("/api/v1/tasks", json!({"name": "  Drill "}))
        .await
        .ok(201);
    assert_eq!(made["name"], "Drill");
    assert_eq!(made["created_at"], "2023-11-14T22:13:20.000Z");
    let path = format!("/api/v1/tasks/{}", made["id"].as_str().unwrap());
    assert_eq!(api.get(&path).await.ok(200), made);
    assert_eq!(api.get("/api/v1/tasks").await.ok(200), json!([made]));
    let renamed = api.json("PATCH", &path, json!({"name": "Mill"})).await;
    assert_eq!(renamed.ok(200)["name"], "Mill");
    let deleted = api.json("DELETE", &path, json!(null)).await;
    assert_eq!(deleted.status, 204);
    assert_eq!(api.get("/api/v1/tasks").await.ok(200), json!([]));
    api.get(&path).await.problem(404, "not_found");
    api.json("DELETE", &path, json!(null))
        .await
        .problem(404, "not_found");
    api.get(&format!("{path}/demonstrations"))
        .await
        .problem(404, "not_found");
    api.get(&format!("{path}/models"))
        .await
        .problem(404, "not_found");
}

#[tokio::test]
async fn a_deleted_task_comes_back_with_everything_that_belongs_to_it() {
    let api = Api::local().await;
    let task = api.task().await;
    let take = api.kept(&task, swing(2.0, 1.0)).await;
    let path = format!("/api/v1/tasks/{task}");
    let before = api.get(&path).await.ok(200);
    assert_eq!(api.json("DELETE", &path, json!(null)).await.status, 204);
    for _ in 0..2 {
        let restored = api.post(&format!("{path}/restore"), json!(null)).await;
        assert_eq!(restored.ok(200), before);
    }
    let takes = api.get(&format!("{path}/demonstrations")).await.ok(200);
    assert_eq!(
        (&takes[0]["id"], &takes[0]["state"]),
        (&json!(take), &json!("kept"))
    );
    let nobody = "/api/v1/tasks/0190b5a2-0000-7000-8000-000000000009/restore";
    api.post(nobody, json!(null))
        .await
        .problem(404, "not_found");
}

#[tokio::test]
async fn the_same_identifier_twice_is_one_task() {
    let api = Api::local().await;
    let wish = json!({"id": "0190b5a2-0000-7000-8000-000000000001", "name": "Drill"});
    let first = api.post("/api/v1/tasks", wish.clone()).await.ok(201);
    let second = api.post("/api/v1/tasks", wish).await.ok(200);
    assert_eq!(first, second);
    assert_eq!(api.get("/api/v1/tasks").await.ok(200), json!([first]));
}

#[tokio::test]
async fn names_that_can_not_be_shown_are_refused() {
    let api = Api::local().await;
    for name in [
        String::new(),
        "  ".into(),
        "x".repeat(121),
        "a\u{7}b".into(),
    ] {
        let answer = api.post("/api/v1/tasks", json!({"name": name})).await;
        let problem = answer.problem(422, "bad_name");
        assert_eq!(problem["where"]["field"], "name");
        assert!(problem["advice"].is_string());
    }
    assert_eq!(api.get("/api/v1/tasks").await.ok(200), json!([]));
}

#[tokio::test]
async fn bad_bodies_are_problems_too() {
    let api = Api::local().await;
    let with_type = |body: &'static str, kind: &'static str| {
        let mut request = request("POST", "/api/v1/tasks", Body::from(body));
        let kind = kind.parse().unwrap();
        request.headers_mut().insert(header::CONTENT_TYPE, kind);
        request
    };
    let json = "application/json";
    api.send(with_type("{", json))
        .await
        .problem(400, "bad_json");
    api.send(with_type("{}", json))
        .await
        .problem(422, "bad_field");
    api.send(with_type("{\"name\": 3}", json))
        .await
        .problem(422, "bad_field");
    api.send(with_type("{\"name\": \"x\"}", "text/plain"))
        .await
        .problem(415, "json_expected");
    let long = format!("{{\"name\": \"{}\"}}", "x".repeat(300_000));
    let mut long = request("POST", "/api/v1/tasks", Body::from(long));
    long.headers_mut()
        .insert(header::CONTENT_TYPE, json.parse().unwrap());
    api.send(long).await.problem(413, "too_large");
}

#[tokio::test]
async fn unknown_addresses_and_methods_are_problems_too() {
    let api = Api::local().await;
    for path in [
        "/api/v1/nothing",
        "/api/v1/tasks/3",
        "/api/v2/tasks",
        "/api",
    ] {
        api.get(path).await.problem(404, "not_found");
    }
    let put = api.json("PUT", "/api/v1/tasks", json!({})).await;
    put.problem(405, "method_not_allowed");
    let post = api.post("/", json!({})).await;
    post.problem(405, "method_not_allowed");
    api.get("/api/v1/jobs?state=lost")
        .await
        .problem(400, "bad_query");
}

#[tokio::test]
async fn what_was_done_is_written_down() {
    let api = Api::local().await;
    api.task().await;
    let trail = api.state.store.audit_trail().await.unwrap();
    assert_eq!(trail.len(), 1);
    assert_eq!(
        (trail[0].0.as_str(), trail[0].1.as_str()),
        ("this computer", "made a task")
    );
}
