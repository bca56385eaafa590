//! Everything that ends a motion before its goal, and what a server without an arm refuses.

use std::cell::Cell;

use e2e::{Client, LONG, Live, SHORT, eventually, take};
use serde_json::{Value, json};

use crate::prepared::{SEED, with_model};
use crate::steps::{alone, ended, idle_arm, in_motion, joints, new_task, plan, start, text};
use crate::steps::{until_state, upload_and_keep};

/// A run of the prepared model that is past its approach.
async fn running(client: &Client, model: &Value) -> Value {
    idle_arm(client).await;
    let plan = plan(client, model, json!("as_taught"), json!("as_taught")).await;
    let reproduction = start(client, &plan).await;
    in_motion(client, 0.5).await;
    reproduction
}

/// Waits until the arm is idle and has shown the same angles for a while.
async fn at_rest(client: &Client) -> [f64; 6] {
    let (last, same) = (Cell::new([f64::NAN; 6]), Cell::new(0));
    eventually("the arm rests", SHORT, || async {
        let robot = client.get("/robots/virtual").await.expect(200);
        let now = joints(&robot, "joints_deg");
        let before = last.replace(now);
        let still = now.iter().zip(before).all(|(a, b)| (a - b).abs() < 1e-3);
        same.set(if still { same.get() + 1 } else { 0 });
        // The view is refreshed less often than it is asked for.
        (same.get() >= 10 && robot["state"] == "idle").then_some(now)
    })
    .await
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn stop_ends_the_motion_and_the_arm_can_go_on_from_there() {
    let _turn = alone().await;
    let (_folder, server, model) = with_model("stop", &[]).await;
    let client = server.client();
    let reproduction = running(&client, &model).await;

    // While it moves, nothing else may use the arm.
    let task = new_task(&client, "meanwhile").await;
    let path = format!("/tasks/{task}/demonstrations");
    let _ = client.post(&path, json!({})).await.problem(&[409]);
    let _ = client
        .post("/robots/virtual/lead-through", json!({ "active": true }))
        .await
        .problem(&[409]);

    assert_eq!(client.post_empty("/robots/virtual/stop").await.status, 204);
    let stopped = ended(&client, &reproduction).await;
    assert_eq!(stopped["state"], "stopped", "{stopped}");
    assert!(!text(&stopped, "reason").is_empty(), "{stopped}");
    let resting = at_rest(&client).await;
    let goal = joints(&model, "goal_deg");
    let left = goal
        .iter()
        .zip(resting)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max);
    assert!(left > 1.0, "it stopped before the goal: {resting:?}");

    // From where it rests it may go on, once somebody has asked for a new plan.
    let plan = plan(&client, &model, json!("as_taught"), json!("as_taught")).await;
    let again = start(&client, &plan).await;
    let finished = ended(&client, &again).await;
    assert_eq!(finished["state"], "succeeded", "{finished}");
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn stop_works_on_the_live_socket_and_on_the_reproduction_too() {
    let _turn = alone().await;
    let (_folder, server, model) = with_model("stop-live", &[]).await;
    let client = server.client();
    let mut live = Live::connect(client.base()).await;
    let reproduction = running(&client, &model).await;
    live.send("{\"type\": \"dance\"}").await;
    live.send("not even JSON").await;
    live.send("{\"type\": \"stop\"}").await;
    assert_eq!(ended(&client, &reproduction).await["state"], "stopped");
    live.wait_for("reproduction", |message| {
        message["reproduction"]["state"] == "stopped"
    })
    .await;
    at_rest(&client).await;

    let reproduction = running(&client, &model).await;
    let path = format!("/reproductions/{}/stop", text(&reproduction, "id"));
    let _ = client.post_empty(&path).await.expect(200);
    assert_eq!(ended(&client, &reproduction).await["state"], "stopped");
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_plan_made_before_the_arm_moved_does_not_run() {
    let _turn = alone().await;
    let (_folder, server, model) = with_model("arm-moved", &[]).await;
    let client = server.client();
    idle_arm(&client).await;
    let old = plan(&client, &model, json!("as_taught"), json!("as_taught")).await;
    let run = start(&client, &old).await;
    assert_eq!(ended(&client, &run).await["state"], "succeeded");
    at_rest(&client).await;
    let refused = client
        .post("/reproductions", json!({ "plan": old["plan"] }))
        .await;
    let problem = refused.problem(&[409]);
    assert!(
        ["arm_moved", "plan_unknown"].contains(&text(&problem, "code")),
        "{problem}"
    );

    // The same start sent twice moves the arm once.
    let fresh = plan(&client, &model, json!("as_taught"), json!("as_taught")).await;
    let id = "01930000-0000-7000-8000-00000000000a";
    let request = json!({ "plan": fresh["plan"], "id": id });
    let first = client
        .post("/reproductions", request.clone())
        .await
        .expect(202);
    let again = client.post("/reproductions", request).await;
    assert!(again.status.is_success(), "{}", again.text());
    assert_eq!(
        (&first["id"], ended(&client, &first).await["state"].clone()),
        (&json!(id), json!("succeeded"))
    );
    let all = client.get("/reproductions").await.expect(200);
    assert_eq!(all.as_array().map(Vec::len), Some(2), "{all}");
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn when_packets_stop_the_run_fails_and_a_person_has_to_start_again() {
    let _turn = alone().await;
    let folder = crate::prepared::copy("packets").await;
    let model = &crate::prepared::prepared().await.model;
    let server = crate::in_process::start(folder.path()).await;
    let client = server.client();
    let reproduction = running(&client, model).await;
    server.controller_goes_silent(true);
    let failed = ended(&client, &reproduction).await;
    assert_eq!(failed["state"], "failed", "{failed}");
    assert!(!text(&failed, "reason").is_empty(), "{failed}");
    let robot = client.get("/robots/virtual").await.expect(200);
    assert_eq!(robot["state"], "faulted", "{robot}");
    for member in ["message", "advice"] {
        assert!(!text(&robot["fault"], member).is_empty(), "{robot}");
    }

    // Packets alone do not bring it back: somebody has to say so.
    server.controller_goes_silent(false);
    let request = json!({ "model_id": model["id"], "start": "as_taught", "goal": "as_taught" });
    let reply = client.post("/plans", request).await;
    if reply.status == 200 {
        let plan = reply.expect(200);
        let refused = client
            .post("/reproductions", json!({ "plan": plan["plan"] }))
            .await;
        let _ = refused.problem(&[409]);
    } else {
        let _ = reply.problem(&[409, 503]);
    }
    eventually("a person's reset is accepted", LONG, || async {
        client
            .post_empty("/robots/virtual/reset")
            .await
            .status
            .is_success()
            .then_some(())
    })
    .await;
    let again = running(&client, model).await;
    let finished = ended(&client, &again).await;
    assert_eq!(finished["state"], "succeeded", "{finished}");
    server.shutdown().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_server_without_an_arm_refuses_motion_and_still_trains() {
    let (_folder, server, model) = with_model("no-arm", &["--robot", "none"]).await;
    let client = server.client();
    let robots = client.get("/robots").await.expect(200);
    assert_eq!(robots[0]["kind"], "none", "{robots}");
    let task = text(&model, "task_id").to_owned();
    let demonstrations = format!("/tasks/{task}/demonstrations");
    let refusals = [
        (&*demonstrations, json!({})),
        (&demonstrations, json!({ "virtual_hand": "f1" })),
        ("/robots/none/lead-through", json!({ "active": true })),
        (
            "/robots/none/virtual-hand",
            json!({ "action": "return", "script": "f1" }),
        ),
    ];
    let before = client.get(&demonstrations).await.expect(200);
    for (path, body) in refusals {
        let problem = client.post(path, body).await.problem(&[409, 503]);
        assert!(!text(&problem, "advice").is_empty(), "{path}: {problem}");
    }
    assert_eq!(
        client.get(&demonstrations).await.expect(200),
        before,
        "nothing half-made is left"
    );
    assert_eq!(
        client.post_empty("/robots/none/stop").await.status,
        204,
        "Stop is always accepted"
    );

    let request = json!({ "model_id": model["id"], "start": "as_taught", "goal": "as_taught" });
    let reply = client.post("/plans", request).await;
    let plan = if reply.status == 200 {
        reply.expect(200)["plan"].clone()
    } else {
        let _ = reply.problem(&[409, 503]);
        json!("00".repeat(32))
    };
    let _ = client
        .post("/reproductions", json!({ "plan": plan }))
        .await
        .problem(&[409, 503]);
    assert_eq!(client.get("/reproductions").await.expect(200), json!([]));

    // Training goes on as ever: a new take is accepted and a new job begins its work.
    upload_and_keep(&client, &task, "another.csv", take(4, 4.0).csv()).await;
    let path = format!("/tasks/{task}/models");
    let accepted = client
        .post(&path, json!({ "seed": SEED }))
        .await
        .expect(202);
    let job = format!("/jobs/{}", text(&accepted["job"], "id"));
    until_state(&client, &job, &["running", "succeeded"]).await;
    server.terminate().await;
}
