//! How another phone comes in: the address that works for the one that asks, and the code.

use axum::body::Body;
use axum::http::header;
use serde_json::json;

use super::{Answer, Api, request};

/// Asks as a paired phone that reached the server under this name.
async fn under(api: &Api, name: &str, path: &str) -> Answer {
    let code = api.state.gatekeeper.as_ref().unwrap().code();
    let pairing = json!({ "code": code.as_str() });
    let paired = api.post("/api/v1/session", pairing).await;
    let token = paired.header("set-cookie").split(';').next().unwrap();
    let mut request = request("GET", path, Body::empty());
    let headers = request.headers_mut();
    headers.insert(header::COOKIE, token.parse().unwrap());
    headers.insert(header::HOST, name.parse().unwrap());
    api.send(request).await
}

#[tokio::test]
async fn another_phone_is_sent_to_the_address_that_works_for_this_one() {
    let mut api = Api::networked().await;
    api.found_at("192.168.7.20:8080");
    for (name, address) in [
        ("10.0.0.5:8080", "http://10.0.0.5:8080/"),
        ("cell.local:8080", "http://cell.local:8080/"),
        // What the server's own browser calls it leads a phone to itself.
        ("localhost:8080", "http://192.168.7.20:8080/"),
        ("127.0.0.1:8080", "http://192.168.7.20:8080/"),
    ] {
        let joining = under(&api, name, "/api/v1/join").await.ok(200);
        assert_eq!(joining["address"], address, "{name}");
        assert_eq!(joining["code"].as_str().map(str::len), Some(8));
        assert!(joining["certificate_sha256"].is_null());
        let picture = under(&api, name, "/api/v1/join.svg").await;
        assert_eq!(picture.status, 200);
        assert_eq!(picture.header("content-type"), "image/svg+xml");
        assert_eq!(picture.header("cache-control"), "no-store");
    }
}

#[tokio::test]
async fn a_server_for_this_computer_only_has_no_place_to_send_phones_to() {
    let api = Api::local().await;
    assert_eq!(api.get("/api/v1/join").await.ok(200), json!({}));
    let refusal = api.get("/api/v1/join.svg").await.problem(404, "not_found");
    assert!(refusal["advice"].as_str().unwrap().contains("--listen"));
    let refusal = api.get("/team-cell.crt").await.problem(404, "not_found");
    assert!(refusal["advice"].as_str().unwrap().contains("--https"));
}
