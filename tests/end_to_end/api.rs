//! Every route of the REST interface with things that do not exist, are in the wrong state, or make
//! no sense: each is answered by a problem document, and nothing changes.

mod uploads;
mod wrong_states;

use e2e::{Folder, Process};
use reqwest::Method;
use serde_json::{Value, json};

use crate::steps::{new_task, text};
use crate::{PROGRAM, SCRATCH};

/// A well-formed identifier that nothing has.
const NOBODY: &str = "01930000-0000-7000-8000-000000000000";

/// A server without an arm, which is quick to start.
async fn armless(label: &str) -> (Folder, Process) {
    let folder = Folder::new(SCRATCH, label);
    let server = Process::start(PROGRAM, folder.path(), &["--robot", "none"]).await;
    (folder, server)
}

/// Every route with an identifier in it, and a body that it would accept.
fn routes_with_identifiers() -> Vec<(Method, &'static str, Option<Value>)> {
    vec![
        (Method::GET, "/tasks/{id}", None),
        (
            Method::PATCH,
            "/tasks/{id}",
            Some(json!({ "name": "another" })),
        ),
        (Method::DELETE, "/tasks/{id}", None),
        (Method::GET, "/tasks/{id}/demonstrations", None),
        (Method::POST, "/tasks/{id}/demonstrations", Some(json!({}))),
        (Method::GET, "/tasks/{id}/agreement", None),
        (Method::POST, "/tasks/{id}/models", Some(json!({}))),
        (Method::GET, "/tasks/{id}/models", None),
        (Method::GET, "/demonstrations/{id}", None),
        (Method::GET, "/demonstrations/{id}/trajectory", None),
        (Method::GET, "/demonstrations/{id}/download", None),
        (Method::POST, "/demonstrations/{id}/stop", None),
        (Method::POST, "/demonstrations/{id}/keep", None),
        (Method::POST, "/demonstrations/{id}/discard", None),
        (Method::GET, "/models/{id}", None),
        (Method::GET, "/models/{id}/file", None),
        (Method::GET, "/models/{id}/curve", None),
        (Method::GET, "/jobs/{id}", None),
        (Method::POST, "/jobs/{id}/cancel", None),
        (Method::GET, "/reproductions/{id}", None),
        (Method::POST, "/reproductions/{id}/stop", None),
        (Method::GET, "/reproductions/{id}/trajectory", None),
        (Method::GET, "/reproductions/{id}/flight", None),
        (Method::GET, "/reproductions/{id}/flight.csv", None),
        (Method::GET, "/reproductions/{id}/flight.mcap", None),
        (Method::GET, "/reproductions/{id}/events", None),
        (
            Method::PUT,
            "/reproductions/{id}/outcome",
            Some(json!({ "worked": true })),
        ),
        (Method::DELETE, "/reproductions/{id}/outcome", None),
        (Method::GET, "/positions/{id}", None),
        (
            Method::PATCH,
            "/positions/{id}",
            Some(json!({ "name": "another" })),
        ),
        (Method::DELETE, "/positions/{id}", None),
    ]
}

async fn send(server: &Process, method: &Method, path: &str, body: Option<&Value>) -> e2e::Reply {
    let body = body.map(|body| ("application/json", body.to_string()));
    server.client().send(method.clone(), path, body).await
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn what_does_not_exist_is_not_found() {
    let (_folder, server) = armless("unknown").await;
    for (method, route, body) in routes_with_identifiers() {
        let path = route.replace("{id}", NOBODY);
        let reply = send(&server, &method, &path, body.as_ref()).await;
        let _ = reply.problem(&[404]);
        // An identifier that is none is not found either, or malformed; never a fault of ours.
        let path = route.replace("{id}", "not-an-identifier");
        let _ = send(&server, &method, &path, body.as_ref())
            .await
            .problem(&[400, 404]);
    }
    let path = format!("/tasks/{NOBODY}/demonstrations/upload?name=a.csv");
    let csv = e2e::take(1, 3.0).csv();
    let _ = server
        .client()
        .post_text(&path, "text/csv", csv)
        .await
        .problem(&[404]);
    let plan = json!({ "model_id": NOBODY, "start": "as_taught", "goal": "as_taught" });
    let _ = server.client().post("/plans", plan).await.problem(&[404]);
    let _ = server.client().get("/no-such-route").await.problem(&[404]);
    let wrong_verb = server.client().send(Method::DELETE, "/health", None).await;
    let _ = wrong_verb.problem(&[405]);
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn bodies_that_make_no_sense_are_refused_with_the_field() {
    let (_folder, server) = armless("bodies").await;
    let client = server.client();
    let task = new_task(&client, "bodies").await;
    let demonstrations = format!("/tasks/{task}/demonstrations");
    let models = format!("/tasks/{task}/models");
    let long = "n".repeat(500);
    let bad = [
        ("/tasks", json!({})),
        ("/tasks", json!({ "name": 7 })),
        ("/tasks", json!({ "name": "" })),
        ("/tasks", json!({ "name": "   " })),
        ("/tasks", json!({ "name": long })),
        ("/tasks", json!({ "name": "a", "id": "seven" })),
        ("/tasks", json!([])),
        (&*demonstrations, json!({ "virtual_hand": "f9" })),
        (
            &*demonstrations,
            json!({ "virtual_hand": "f1", "seed": -1 }),
        ),
        (&*demonstrations, json!({ "id": 5 })),
        (&*models, json!({ "method": "magic" })),
        (&*models, json!({ "seed": "one" })),
        (&*models, json!({ "demonstrations": "all" })),
        ("/plans", json!({})),
        (
            "/plans",
            json!({ "model_id": NOBODY, "start": "elsewhere", "goal": "as_taught" }),
        ),
        (
            "/plans",
            json!({ "model_id": NOBODY, "start": "as_taught",
            "goal": { "joints_deg": [1, 2, 3] } }),
        ),
        ("/reproductions", json!({})),
        ("/reproductions", json!({ "plan": 12 })),
        ("/robots/virtual/lead-through", json!({ "active": "yes" })),
        (
            "/robots/virtual/virtual-hand",
            json!({ "action": "wave", "script": "f1" }),
        ),
        ("/session", json!({ "code": 123 })),
    ];
    for (path, body) in bad {
        let problem = client.post(path, body.clone()).await.problem(&[400, 422]);
        assert!(
            !text(&problem, "detail").is_empty(),
            "{path} {body}: {problem}"
        );
    }
    for path in [
        "/tasks",
        &models,
        "/plans",
        "/reproductions",
        "/robots/virtual/lead-through",
        "/session",
    ] {
        let broken = client
            .post_text(path, "application/json", "{\"name\":".to_owned())
            .await;
        let _ = broken.problem(&[400]);
        let no_json = client
            .post_text(path, "text/plain", "name".to_owned())
            .await;
        let _ = no_json.problem(&[400, 415, 422]);
    }
    let tasks = client.get("/tasks").await.expect(200);
    assert_eq!(
        tasks.as_array().map(Vec::len),
        Some(1),
        "nothing was made: {tasks}"
    );
    let made = client.get(&demonstrations).await.expect(200);
    assert_eq!(made, json!([]), "nothing was made");
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn the_description_names_every_route() {
    let (_folder, server) = armless("openapi").await;
    let client = server.client();
    assert_eq!(client.get("/health").await.expect(200)["status"], "ok");
    let description = client.get("/openapi.json").await.expect(200);
    assert!(text(&description, "openapi").starts_with("3."), "OpenAPI 3");
    let described: Vec<String> = description["paths"]
        .as_object()
        .into_iter()
        .flatten()
        .flat_map(|(path, verbs)| {
            let verbs = verbs
                .as_object()
                .into_iter()
                .flatten()
                .map(|(verb, _)| verb.clone());
            let path = shape(path);
            verbs
                .map(move |verb| format!("{} {path}", verb.to_uppercase()))
                .collect::<Vec<_>>()
        })
        .collect();
    let others = [
        "GET /health",
        "GET /session",
        "POST /session",
        "GET /tasks",
        "POST /tasks",
        "POST /tasks/{}/demonstrations/upload",
        "GET /jobs",
        "GET /robots",
        "POST /robots/stop",
        "GET /robots/{}",
        "POST /robots/{}/stop",
        "POST /robots/{}/reset",
        "POST /robots/{}/lead-through",
        "POST /robots/{}/virtual-hand",
        "POST /plans",
        "POST /reproductions",
        "GET /reproductions",
    ];
    let with_identifiers = routes_with_identifiers()
        .into_iter()
        .map(|(method, route, _)| format!("{method} {}", shape(route)));
    let missing: Vec<String> = others
        .into_iter()
        .map(str::to_owned)
        .chain(with_identifiers)
        .filter(|route| !described.contains(route))
        .collect();
    assert!(
        missing.is_empty(),
        "not described: {missing:#?}\ndescribed: {described:#?}"
    );
    server.terminate().await;
}

/// A route with the names of its parameters left out and without the common prefix.
fn shape(path: &str) -> String {
    let path = path.strip_prefix("/api/v1").unwrap_or(path);
    let parts = path
        .split('/')
        .map(|part| if part.starts_with('{') { "{}" } else { part });
    parts.collect::<Vec<_>>().join("/")
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_request_repeated_with_the_same_identifier_makes_nothing_twice() {
    let (_folder, server) = armless("repeated").await;
    let client = server.client();
    let request = json!({ "id": NOBODY, "name": "once" });
    let first = client.post("/tasks", request.clone()).await.expect(201);
    let again = client.post("/tasks", request).await;
    assert!(
        [200, 201].contains(&again.status.as_u16()),
        "{}",
        again.text()
    );
    let status = again.status.as_u16();
    assert_eq!(again.expect(status), first);
    let tasks = client.get("/tasks").await.expect(200);
    assert_eq!(tasks, json!([first]));

    let path = format!("/tasks/{NOBODY}");
    let name = json!({ "name": "renamed" });
    let renamed = send(&server, &Method::PATCH, &path, Some(&name)).await;
    assert_eq!(renamed.expect(200)["name"], "renamed");
    let deleted = send(&server, &Method::DELETE, &format!("/tasks/{NOBODY}"), None).await;
    assert!(deleted.status.is_success(), "{}", deleted.text());
    let _ = client
        .get(&format!("/tasks/{NOBODY}"))
        .await
        .problem(&[404]);
    assert_eq!(client.get("/tasks").await.expect(200), json!([]));
    server.terminate().await;
}
