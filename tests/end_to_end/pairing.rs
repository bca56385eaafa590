//! Who may speak to the server: everybody on this machine, nobody from a foreign page, and from a
//! network only who has the pairing code.

use e2e::{Client, Folder, Process, Reply};
use reqwest::Method;
use serde_json::{Value, json};

use crate::steps::{on_the_network, pairing_code};
use crate::{PROGRAM, SCRATCH};

/// Every kind of route behind the code: what moves the arm, what makes the arm soft, what changes
/// data, and what only looks.
fn guarded() -> Vec<(Method, &'static str, Option<Value>)> {
    vec![
        (
            Method::POST,
            "/reproductions",
            Some(json!({ "plan": "00" })),
        ),
        (Method::POST, "/plans", Some(json!({}))),
        (
            Method::POST,
            "/robots/virtual/lead-through",
            Some(json!({ "active": true })),
        ),
        (
            Method::POST,
            "/robots/virtual/virtual-hand",
            Some(json!({ "action": "return", "script": "f1" })),
        ),
        (Method::POST, "/robots/virtual/reset", None),
        (Method::POST, "/robots/virtual/stop", None),
        (Method::POST, "/robots/stop", None),
        (Method::GET, "/robots", None),
        (
            Method::POST,
            "/tasks",
            Some(json!({ "name": "by a stranger" })),
        ),
        (Method::GET, "/tasks", None),
        (Method::GET, "/robots/virtual", None),
        (Method::GET, "/jobs", None),
        (Method::GET, "/reproductions", None),
        (Method::GET, "/live", None),
    ]
}

/// The server as phones reach it, and a client that has not been paired.
async fn open_to_the_network(label: &str) -> (Folder, Process, Client) {
    let folder = Folder::new(SCRATCH, label);
    let server = on_the_network(&folder).await;
    let client = server.client();
    (folder, server, client)
}

async fn send(client: &Client, method: Method, path: &str, body: Option<Value>) -> Reply {
    let body = body.map(|body| ("application/json", body.to_string()));
    client.send(method, path, body).await
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn from_a_network_nothing_answers_without_the_code_and_everything_with_it() {
    let (_folder, server, stranger) = open_to_the_network("pairing").await;
    assert_eq!(stranger.get("/health").await.expect(200)["status"], "ok");
    let session = stranger.get("/session").await.expect(200);
    assert_eq!(
        (&session["paired"], &session["pairing_required"]),
        (&json!(false), &json!(true))
    );
    assert!(
        stranger.get("//").await.status.is_success(),
        "the page that asks for the code"
    );
    for (method, path, body) in guarded() {
        let _ = send(&stranger, method, path, body).await.problem(&[401]);
    }
    let forged = stranger.with_header("cookie", "team_session=0123456789abcdef");
    for (method, path, body) in guarded() {
        let _ = send(&forged, method, path, body).await.problem(&[401]);
    }

    let paired = stranger
        .post("/session", json!({ "code": pairing_code(&server).await }))
        .await;
    assert_eq!(paired.status, 204, "{}", paired.text());
    let cookie = paired.header("set-cookie").to_owned();
    for attribute in ["team_session=", "HttpOnly", "SameSite=Strict"] {
        assert!(cookie.contains(attribute), "{cookie:?} lacks {attribute}");
    }
    let cookie = cookie.split(';').next().unwrap_or_default();
    let phone = stranger.with_header("cookie", cookie);
    assert_eq!(phone.get("/session").await.expect(200)["paired"], true);
    for (method, path, body) in guarded() {
        let reply = send(&phone, method.clone(), path, body).await;
        assert!(
            ![401, 403].contains(&reply.status.as_u16()),
            "{method} {path}: {}",
            reply.text()
        );
    }
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn guessing_the_code_is_slowed_down() {
    let (_folder, server, stranger) = open_to_the_network("guessing").await;
    let right = pairing_code(&server).await;
    let wrong = right
        .replace(|digit| digit != '0', "0")
        .replacen('0', "1", 1);
    assert_ne!(right, wrong);
    for _ in 0..5 {
        let _ = stranger
            .post("/session", json!({ "code": wrong }))
            .await
            .problem(&[401]);
    }
    let refused = stranger.post("/session", json!({ "code": wrong })).await;
    assert!(
        refused.header("retry-after").parse::<u32>().is_ok(),
        "{}",
        refused.text()
    );
    let _ = refused.problem(&[429]);
    // The right code has to wait too, or the answer would tell it apart.
    let _ = stranger
        .post("/session", json!({ "code": pairing_code(&server).await }))
        .await
        .problem(&[429]);
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn on_this_machine_no_code_is_needed_but_foreign_pages_are_refused() {
    let folder = Folder::new(SCRATCH, "loopback");
    let server = Process::start(PROGRAM, folder.path(), &["--robot", "none"]).await;
    let client = server.client();
    let session = client.get("/session").await.expect(200);
    assert_eq!(
        (&session["paired"], &session["pairing_required"]),
        (&json!(true), &json!(false))
    );
    assert_eq!(client.get("/tasks").await.expect(200), json!([]));

    // A page from elsewhere in the same browser, and a foreign name that points to this machine.
    let foreign_page = client.with_header("origin", "http://evil.example");
    let foreign_name = client.with_header("host", "evil.example");
    for foreign in [foreign_page, foreign_name] {
        for (method, path, body) in guarded() {
            let _ = send(&foreign, method, path, body)
                .await
                .problem(&[400, 403, 421]);
        }
    }
    let own_page = client.with_header("origin", client.base());
    assert_eq!(own_page.get("/tasks").await.expect(200), json!([]));
    server.terminate().await;
}
