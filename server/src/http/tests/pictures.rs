//! Photos of tasks.

use axum::body::Body;
use serde_json::{Value, json};

use super::{Answer, Api, request};

/// What a JPEG begins with; nobody decodes it.
const JPEG: &[u8] = b"\xff\xd8\xff\xe0 a drilling machine";

async fn put(api: &Api, task: &str, body: impl Into<Body>) -> Answer {
    let path = format!("/api/v1/tasks/{task}/picture");
    api.send(request("PUT", &path, body.into())).await
}

#[tokio::test]
async fn a_photo_is_shown_replaced_and_taken_away() {
    let api = Api::local().await;
    let task = api.task().await;
    let path = format!("/api/v1/tasks/{task}/picture");
    api.get(&path).await.problem(404, "not_found");
    let text: &[u8] = b"\x89PNG\r\n\x1a\n";
    let first = put(&api, &task, JPEG).await.ok(200);
    let second = put(&api, &task, text).await.ok(200);
    let names = [&first["picture"], &second["picture"]];
    assert!(names[0].is_string() && names[0] != names[1], "{names:?}");
    assert_eq!(api.get("/api/v1/tasks").await.ok(200), json!([second]));

    let webp: &[u8] = b"RIFF\x10\x00\x00\x00WEBPVP8 ";
    put(&api, &task, webp).await.ok(200);
    let shown = api.get(&path).await;
    assert_eq!(shown.status, 200);
    assert_eq!(shown.header("content-type"), "image/webp");
    assert_eq!(shown.header("x-content-type-options"), "nosniff");
    assert_eq!(shown.text.as_bytes(), webp);

    for _ in 0..2 {
        let bare = api.json("DELETE", &path, Value::Null).await.ok(200);
        assert_eq!(bare.get("picture"), None);
    }
    api.get(&path).await.problem(404, "not_found");
}

#[tokio::test]
async fn what_is_no_photo_or_too_large_is_refused_and_the_old_one_stays() {
    let api = Api::local().await;
    let task = api.task().await;
    let kept = put(&api, &task, JPEG).await.ok(200);
    for other in [&b""[..], b"<svg onload='alert(1)'/>", b"GIF89a", b"<html>"] {
        let problem = put(&api, &task, other)
            .await
            .problem(422, "picture_unreadable");
        assert!(problem["advice"].is_string());
    }
    for bytes in [101 * 1024, 300 * 1024] {
        let mut large = JPEG.to_vec();
        large.resize(bytes, 0);
        let problem = put(&api, &task, large).await.problem(413, "too_large");
        assert!(
            problem["detail"].as_str().unwrap().contains("100 kB"),
            "{problem}"
        );
    }
    assert_eq!(
        api.get(&format!("/api/v1/tasks/{task}")).await.ok(200),
        kept
    );
    let nobody = "0190b5a2-0000-7000-8000-000000000009";
    put(&api, nobody, JPEG).await.problem(404, "not_found");
}
