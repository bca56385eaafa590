//! Cutting the ends of takes.

use serde_json::{Value, json};

use super::{Api, swing};

const NOBODY: &str = "0190b5a2-0000-7000-8000-000000000009";

/// A swing between two stretches of standing still, with a gripper that closes before it.
fn with_rests() -> String {
    let mut rows = Vec::new();
    for row in 0..=300 {
        let t_s = 0.02 * f64::from(row);
        let share = ((t_s - 2.0) / 2.0).clamp(0.0, 1.0);
        let turn = 0.5 - 0.5 * (std::f64::consts::PI * share).cos();
        rows.push((
            t_s,
            [10.0, 20.0, -15.0, 12.0, -18.0, 25.0].map(|span| span * turn),
        ));
    }
    let signal = |at_s: f64, on: bool| json!({"name": "GripperClose", "at_s": at_s, "on": on});
    json!({
        "format": "team-demonstration",
        "version": 1,
        "t_s": rows.iter().map(|(t_s, _)| t_s).collect::<Vec<_>>(),
        "joints_deg": rows.iter().map(|(_, joints)| joints).collect::<Vec<_>>(),
        "signals": [signal(0.0, false), signal(1.0, true), signal(3.0, false)],
    })
    .to_string()
}

async fn take(api: &Api, task: &str) -> String {
    let made = api.upload(task, "take.json", with_rests()).await.ok(201);
    let id = made["id"].as_str().unwrap();
    format!("/api/v1/demonstrations/{id}")
}

#[tokio::test]
async fn the_ends_are_cut_and_the_whole_take_is_still_there() {
    let api = Api::local().await;
    let task = api.task().await;
    let path = take(&api, &task).await;
    let whole = api.get(&format!("{path}/trajectory")).await.ok(200);
    let wish = json!({"from_s": 1.5, "to_s": 4.5});
    let cut = api
        .json("PUT", &format!("{path}/trim"), wish.clone())
        .await
        .ok(200);
    assert_eq!(cut["trim"], wish);
    assert_eq!(cut["duration_s"], 6.0, "the recording is as long as it was");
    assert_eq!(api.get(&path).await.ok(200), cut);

    let used = api.get(&format!("{path}/trajectory")).await.ok(200);
    let times = used["t_s"].as_array().unwrap();
    assert_eq!(times[0], 0.0);
    assert!((times[times.len() - 1].as_f64().unwrap() - 3.0).abs() < 1e-6);
    // Closed before the cut: it stands closed at the beginning, and opens 1.5 s later.
    let told = |at_s: f64, on: bool| json!({"name": "GripperClose", "at_s": at_s, "on": on});
    assert_eq!(used["signals"], json!([told(0.0, true), told(1.5, false)]));
    let raw = api
        .get(&format!("{path}/trajectory?raw=true"))
        .await
        .ok(200);
    assert_eq!(raw, whole);
    let file = api.get(&format!("{path}/download")).await.ok(200);
    assert!(
        (file["t_s"]
            .as_array()
            .unwrap()
            .last()
            .unwrap()
            .as_f64()
            .unwrap()
            - 3.0)
            .abs()
            < 1e-6
    );

    let restored = api
        .json("DELETE", &format!("{path}/trim"), Value::Null)
        .await
        .ok(200);
    assert_eq!(restored.get("trim"), None);
    assert_eq!(api.get(&format!("{path}/trajectory")).await.ok(200), whole);
    let all = json!({"from_s": 0.0, "to_s": 6.0});
    let none = api.json("PUT", &format!("{path}/trim"), all).await.ok(200);
    assert_eq!(none.get("trim"), None, "all of it is not cut");
}

#[tokio::test]
async fn cuts_that_leave_nothing_to_learn_from_are_refused_and_change_nothing() {
    let api = Api::local().await;
    let task = api.task().await;
    let path = take(&api, &task).await;
    let trim = format!("{path}/trim");
    let good = api
        .json("PUT", &trim, json!({"from_s": 1.0, "to_s": 5.0}))
        .await
        .ok(200);
    for (from_s, to_s, code) in [
        (-0.1, 4.0, "trim_outside"),
        (4.0, 3.0, "trim_outside"),
        (1.0, 6.5, "trim_outside"),
        (2.0, 2.9, "trim_too_short"),
        (0.0, 1.8, "demonstration_no_motion"),
    ] {
        let wish = json!({"from_s": from_s, "to_s": to_s});
        let problem = api.json("PUT", &trim, wish).await.problem(422, code);
        assert!(problem["advice"].is_string(), "{problem}");
    }
    for bad in [json!({"from_s": 1.0}), json!({"from_s": "x", "to_s": 2.0})] {
        api.json("PUT", &trim, bad).await.problem(422, "bad_field");
    }
    assert_eq!(api.get(&path).await.ok(200), good);
    for (method, what) in [
        ("PUT", "trim"),
        ("DELETE", "trim"),
        ("GET", "trim/suggestion"),
    ] {
        let nobody = format!("/api/v1/demonstrations/{NOBODY}/{what}");
        let wish = json!({"from_s": 1.0, "to_s": 3.0});
        api.json(method, &nobody, wish)
            .await
            .problem(404, "not_found");
    }
}

#[tokio::test]
async fn standing_still_is_proposed_to_be_cut_but_not_what_the_gripper_did() {
    let api = Api::local().await;
    let task = api.task().await;
    let path = take(&api, &task).await;
    let proposed = api.get(&format!("{path}/trim/suggestion")).await.ok(200);
    let (from_s, to_s) = (&proposed["trim"]["from_s"], &proposed["trim"]["to_s"]);
    assert!((from_s.as_f64().unwrap() - 0.7).abs() < 0.11, "{proposed}");
    assert!((to_s.as_f64().unwrap() - 4.3).abs() < 0.11, "{proposed}");
    api.json("PUT", &format!("{path}/trim"), proposed["trim"].clone())
        .await
        .ok(200);
    let busy = api.kept(&task, swing(2.0, 1.0)).await;
    let path = format!("/api/v1/demonstrations/{busy}/trim/suggestion");
    assert_eq!(api.get(&path).await.ok(200), json!({}));
}

#[tokio::test]
async fn takes_are_compared_and_trained_as_they_are_cut() {
    let api = Api::local().await;
    let task = api.task().await;
    let path = take(&api, &task).await;
    api.post(&format!("{path}/keep"), Value::Null).await.ok(200);
    let other = take(&api, &task).await;
    api.post(&format!("{other}/keep"), Value::Null)
        .await
        .ok(200);
    let agreement = format!("/api/v1/tasks/{task}/agreement");
    assert_eq!(api.get(&agreement).await.ok(200)["problem"], Value::Null);
    let models = format!("/api/v1/tasks/{task}/models");
    let whole = api.post(&models, json!({})).await.ok(202);
    assert_eq!(whole["model"]["trims"], json!([null, null]));

    // Without its first seconds the second take never closes the gripper.
    let wish = json!({"from_s": 1.5, "to_s": 6.0});
    api.json("PUT", &format!("{other}/trim"), wish.clone())
        .await
        .ok(200);
    assert_eq!(
        api.get(&agreement).await.ok(200)["problem"]["code"],
        "signals_differ"
    );
    api.post(&models, json!({}))
        .await
        .problem(422, "signals_differ");
    api.json("PUT", &format!("{path}/trim"), wish.clone())
        .await
        .ok(200);
    let cut = api.post(&models, json!({})).await.ok(202);
    assert_ne!(
        cut["job"]["id"], whole["job"]["id"],
        "other inputs, another training"
    );
    assert_eq!(cut["model"]["trims"], json!([wish, wish]));
    let again = api.post(&models, json!({})).await.ok(202);
    assert_eq!(again["job"]["id"], cut["job"]["id"]);

    // Whole again: what was trained first is what would be trained.
    for take in [&path, &other] {
        api.json("DELETE", &format!("{take}/trim"), Value::Null)
            .await
            .ok(200);
    }
    let first = api.post(&models, json!({})).await.ok(202);
    assert_eq!(first["job"]["id"], whole["job"]["id"]);
    let kept = format!("/api/v1/models/{}", cut["model"]["id"].as_str().unwrap());
    assert_eq!(api.get(&kept).await.ok(200)["trims"], json!([wish, wish]));
}
