//! Who is let in: pairing on the network, names and origins on this computer.

use axum::body::Body;
use axum::http::{Request, header};
use serde_json::{Value, json};

use super::{Answer, Api, request};

async fn with(api: &Api, path: &str, name: header::HeaderName, value: &str) -> Answer {
    let mut request = request("GET", path, Body::empty());
    request.headers_mut().insert(name, value.parse().unwrap());
    api.send(request).await
}

/// All routes that the document describes, as method and path with identifiers filled in.
async fn routes(api: &Api) -> Vec<(String, String)> {
    let document: Value = api.get("/api/v1/openapi.json").await.ok(200);
    let id = "0190b5a2-0000-7000-8000-000000000001";
    let paths = document["paths"].as_object().unwrap();
    paths
        .iter()
        .flat_map(|(path, methods)| {
            let path = path.replace("{task}", id).replace("{id}", id);
            let path = format!("/api/v1{path}");
            methods
                .as_object()
                .unwrap()
                .keys()
                .map(move |m| (m.to_uppercase(), path.clone()))
        })
        .collect()
}

#[tokio::test]
async fn the_document_describes_every_route() {
    let api = Api::local().await;
    let document = api.get("/api/v1/openapi.json").await.ok(200);
    assert!(document["openapi"].as_str().unwrap().starts_with("3."));
    assert_eq!(document["servers"][0]["url"], "/api/v1");
    let routes = routes(&api).await;
    assert_eq!(routes.len(), 71);
    for (method, path) in routes {
        let answer = api.json(&method, &path, json!({})).await;
        assert_ne!(answer.status, 405, "{method} {path}");
        assert!(
            answer.status.is_success() || answer.json()["code"].is_string(),
            "{method} {path}: {}",
            answer.text
        );
    }
}

#[tokio::test]
async fn on_the_network_nothing_works_without_the_code() {
    let described = routes(&Api::local().await).await;
    let api = Api::networked().await;
    let document = ("GET".to_owned(), "/api/v1/openapi.json".to_owned());
    for (method, path) in described.into_iter().chain([document]) {
        if path.ends_with("/health") || path.ends_with("/session") {
            continue;
        }
        let answer = api.json(&method, &path, json!({})).await;
        answer.problem(401, "not_paired");
    }
    api.get("/api/v1/health").await.ok(200);
    assert_eq!(api.get("/").await.status, 200);
    let session = api.get("/api/v1/session").await.ok(200);
    assert_eq!(session["paired"], false);
    assert_eq!(session["pairing_required"], true);
}

#[tokio::test]
async fn the_code_is_exchanged_for_a_cookie() {
    let api = Api::networked().await;
    let code = api
        .state
        .gatekeeper
        .as_ref()
        .unwrap()
        .code()
        .as_str()
        .to_owned();
    let paired = api.post("/api/v1/session", json!({"code": code})).await;
    assert_eq!(paired.status, 204);
    let cookie = paired.header("set-cookie");
    for property in ["HttpOnly", "SameSite=Strict", "Path=/"] {
        assert!(cookie.contains(property), "{cookie}");
    }
    let token = cookie.split(';').next().unwrap();
    let tasks = with(&api, "/api/v1/tasks", header::COOKIE, token).await;
    assert_eq!(tasks.ok(200), json!([]));
    let session = with(&api, "/api/v1/session", header::COOKIE, token)
        .await
        .ok(200);
    assert_eq!(session["paired"], true);
    let other = with(&api, "/api/v1/tasks", header::COOKIE, "team_session=00").await;
    other.problem(401, "not_paired");
    api.clock.advance_ms(super::super::auth::PAIRED_FOR_MS);
    let late = with(&api, "/api/v1/tasks", header::COOKIE, token).await;
    late.problem(401, "not_paired");
}

#[tokio::test]
async fn guessing_the_code_is_slowed_down() {
    let api = Api::networked().await;
    let code = api
        .state
        .gatekeeper
        .as_ref()
        .unwrap()
        .code()
        .as_str()
        .to_owned();
    let wrong = if code == "00000000" {
        "00000001"
    } else {
        "00000000"
    };
    for _ in 0..5 {
        let answer = api.post("/api/v1/session", json!({"code": wrong})).await;
        answer.problem(401, "wrong_code");
    }
    let limited = api.post("/api/v1/session", json!({"code": code})).await;
    limited.problem(429, "too_many_attempts");
    assert_eq!(limited.header("retry-after"), "60");
    api.clock.advance_ms(60_000);
    let paired = api.post("/api/v1/session", json!({"code": code})).await;
    assert_eq!(paired.status, 204);
}

#[tokio::test]
async fn this_computer_needs_no_code() {
    let api = Api::local().await;
    let session = api.get("/api/v1/session").await.ok(200);
    assert_eq!(session["paired"], true);
    assert_eq!(session["pairing_required"], false);
    let pointless = api.post("/api/v1/session", json!({"code": "1"})).await;
    assert_eq!(pointless.status, 204);
}

#[tokio::test]
async fn a_foreign_name_for_this_computer_is_refused() {
    let api = Api::local().await;
    for host in ["evil.example", "192.0.2.1:8080"] {
        let answer = with(&api, "/api/v1/tasks", header::HOST, host).await;
        answer.problem(403, "host_refused");
    }
    with(&api, "/api/v1/tasks", header::HOST, "127.0.0.1:8080")
        .await
        .ok(200);
    let nameless = Request::get("/api/v1/tasks").body(Body::empty()).unwrap();
    api.send(nameless).await.problem(400, "host_missing");
}

#[tokio::test]
async fn requests_from_other_pages_are_refused() {
    for api in [Api::local().await, Api::networked().await] {
        for origin in ["http://evil.example", "null", "https://localhost"] {
            let answer = with(&api, "/api/v1/health", header::ORIGIN, origin).await;
            answer.problem(403, "origin_refused");
        }
        with(&api, "/api/v1/health", header::ORIGIN, "http://localhost")
            .await
            .ok(200);
    }
}

#[tokio::test]
async fn every_answer_carries_the_security_headers() {
    let api = Api::networked().await;
    for path in ["/", "/api/v1/health", "/api/v1/tasks", "/api/v1/nothing"] {
        let answer = api.get(path).await;
        assert_eq!(answer.header("x-content-type-options"), "nosniff", "{path}");
        assert_eq!(answer.header("x-frame-options"), "DENY");
        let policy = answer.header("content-security-policy");
        assert!(policy.contains("default-src 'self'") && !policy.contains("unsafe"));
        assert!(policy.contains("frame-ancestors 'none'"));
        let cache = if path == "/" { "no-cache" } else { "no-store" };
        assert_eq!(answer.header("cache-control"), cache, "{path}");
    }
}
