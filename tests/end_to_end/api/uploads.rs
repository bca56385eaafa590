//! Files: what is accepted comes back as it was; what is not is refused with what, where and advice,
//! and leaves nothing behind.

use e2e::{Client, take};
use serde_json::{Value, json};

use super::armless;
use crate::steps::{new_task, number, numbers, text};

const HEADER: &str = "t_s,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg";

/// Three seconds of a good recording, one line per sample.
fn good_lines() -> Vec<String> {
    take(1, 3.0).csv().lines().map(str::to_owned).collect()
}

/// The good recording with one line replaced; line 0 is the header.
fn with_line(at: usize, line: &str) -> String {
    let mut lines = good_lines();
    lines[at] = line.to_owned();
    lines.join("\n")
}

/// Files that must be refused, with a word that the answer must contain.
fn bad_files() -> Vec<(&'static str, &'static str, String)> {
    let csv = "text/csv";
    let json_text = "application/json";
    let short: Vec<String> = good_lines().into_iter().take(60).collect();
    let still: Vec<String> = (0..300)
        .map(|i| format!("{:.2},0,0,0,0,-45,0", f64::from(i) * 0.01))
        .collect();
    vec![
        (csv, "empty", String::new()),
        (csv, "column", "hello, world\n1,2\n".to_owned()),
        (csv, "", HEADER.to_owned()),
        (csv, "100", with_line(100, "0.99,1,2,3")),
        (csv, "100", with_line(100, "0.99,1,2,3,-45,5,6,7,8")),
        (csv, "100", with_line(100, "0.99,10,10,20,NaN,-45,5")),
        (csv, "100", with_line(100, "0.99,10,inf,20,0,-45,5")),
        (csv, "100", with_line(100, "0.99,10,ten,20,0,-45,5")),
        (csv, "time", with_line(100, "0.10,10,10,20,0,-45,5")),
        (csv, "time", with_line(100, "-5,10,10,20,0,-45,5")),
        (csv, "1 s", short.join("\n")),
        (csv, "joint 3", with_line(100, "0.99,10,10,99,0,-45,5")),
        (csv, "", format!("{HEADER}\n{}", still.join("\n"))),
        (
            csv,
            "column",
            good_lines().join("\n").replace("q3_deg", "q3_rad"),
        ),
        (
            json_text,
            "",
            "{\"format\": \"team-demonstration\"".to_owned(),
        ),
        (json_text, "", "{}".to_owned()),
        (json_text, "", "[1, 2, 3]".to_owned()),
        (
            json_text,
            "",
            json!({ "format": "team-demonstration", "version": 99,
            "t_s": [0.0, 2.0], "joints_deg": [[0, 0, 0, 0, 0, 0], [1, 1, 1, 1, 1, 1]] })
            .to_string(),
        ),
        (
            json_text,
            "",
            json!({ "format": "team-demonstration", "version": 1,
            "t_s": [0.0, 1.0, 2.0], "joints_deg": [[0, 0, 0, 0, 0, 0], [1, 1, 1, 1, 1, 1]] })
            .to_string(),
        ),
        (json_text, "", "\u{0}\u{1}\u{2}".to_owned()),
    ]
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_bad_file_is_refused_with_what_where_and_advice_and_leaves_nothing() {
    let (_folder, server) = armless("bad-files").await;
    let client = server.client();
    let task = new_task(&client, "bad files").await;
    let before = upload(&client, &task, "good.csv", good_lines().join("\n")).await;
    let path = format!("/tasks/{task}/demonstrations/upload?name=bad.csv");
    for (kind, word, content) in bad_files() {
        let shown: String = content.chars().take(60).collect();
        let problem = client
            .post_text(&path, kind, content)
            .await
            .problem(&[400, 422]);
        let words = format!("{} {}", text(&problem, "detail"), problem["where"]).to_lowercase();
        assert!(
            words.contains(word),
            "{shown:?} should be refused for {word:?}: {problem}"
        );
        assert!(!text(&problem, "advice").is_empty(), "{shown:?}: {problem}");
    }
    let after = client
        .get(&format!("/tasks/{task}/demonstrations"))
        .await
        .expect(200);
    assert_eq!(
        after,
        json!([before]),
        "only the good file is there, as it was"
    );
    server.terminate().await;
}

async fn upload(client: &Client, task: &str, name: &str, content: String) -> Value {
    let path = format!("/tasks/{task}/demonstrations/upload?name={name}");
    client
        .post_text(&path, "text/csv", content)
        .await
        .expect(201)
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_file_comes_back_as_it_was() {
    let (_folder, server) = armless("good-files").await;
    let client = server.client();
    let task = new_task(&client, "good files").await;
    let shown = take(2, 3.0);
    let stored = upload(&client, &task, "take-2.csv", shown.csv()).await;
    assert_eq!(
        (&stored["source"], &stored["usable"]),
        (&json!("file"), &json!(true)),
        "{stored}"
    );
    let (first, last) = (shown.t_s[0], shown.t_s[shown.t_s.len() - 1]);
    assert!(
        (number(&stored, "duration_s") - (last - first)).abs() < 0.002,
        "{stored}"
    );
    assert_eq!(stored["samples"], shown.t_s.len(), "{stored}");

    let path = format!("/demonstrations/{}", text(&stored, "id"));
    let trajectory = client
        .get(&format!("{path}/trajectory?max_points=50"))
        .await
        .expect(200);
    let times = numbers(&trajectory["t_s"]);
    assert!(
        times.len() <= 50 && times.len() > 20,
        "{} points",
        times.len()
    );
    for joint in trajectory["joints_deg"].as_array().into_iter().flatten() {
        assert_eq!(numbers(joint).len(), times.len());
    }

    // The download, uploaded again, is the same recording.
    let download = client
        .get(&format!("{path}/download"))
        .await
        .expect_bytes(200);
    let again = format!("/tasks/{task}/demonstrations/upload?name=again.json");
    let body = String::from_utf8(download.clone()).expect("a download is text");
    let copy = client
        .post_text(&again, "application/json", body)
        .await
        .expect(201);
    assert_eq!(copy["samples"], stored["samples"]);
    let second = client
        .get(&format!("/demonstrations/{}/download", text(&copy, "id")))
        .await;
    let second: Value = second.expect(200);
    let first: Value = serde_json::from_slice(&download).expect("a download is JSON");
    for member in ["t_s", "joints_deg"] {
        assert_eq!(second[member], first[member], "{member}");
    }
    let q1 = numbers(&first["joints_deg"][100]);
    for (stored, shown) in q1.iter().zip(shown.joints_deg[100]) {
        assert!((stored - shown).abs() < 1e-4, "{q1:?}");
    }
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn demonstrations_that_do_not_fit_together_are_refused_or_spoken_of() {
    let (_folder, server) = armless("unusable").await;
    let client = server.client();
    let task = new_task(&client, "nothing yet").await;
    let models = format!("/tasks/{task}/models");
    let problem = client.post(&models, json!({})).await.problem(&[422]);
    assert!(
        !text(&problem, "advice").is_empty(),
        "no demonstrations: {problem}"
    );

    // A demonstration that was not kept does not count, and one of another task cannot be used.
    let stored = upload(&client, &task, "take-1.csv", take(1, 3.0).csv()).await;
    let discard = format!("/demonstrations/{}/discard", text(&stored, "id"));
    assert_eq!(
        client.post_empty(&discard).await.expect(200)["state"],
        "discarded"
    );
    let _ = client.post(&models, json!({})).await.problem(&[422]);
    let other = new_task(&client, "another").await;
    let foreign = json!({ "demonstrations": [stored["id"]] });
    let _ = client
        .post(&format!("/tasks/{other}/models"), foreign)
        .await
        .problem(&[404, 422]);
    assert_eq!(
        client.get(&models).await.expect(200),
        json!([]),
        "no model was begun"
    );
    assert_eq!(
        client.get("/jobs").await.expect(200),
        json!([]),
        "no job was begun"
    );
    server.terminate().await;
}
