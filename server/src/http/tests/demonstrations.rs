//! Uploading, judging, looking at and downloading demonstrations.

use serde_json::{Value, json};

use super::{Api, swing};

#[tokio::test]
async fn a_file_becomes_a_take_that_can_be_kept_and_discarded() {
    let api = Api::local().await;
    let task = api.task().await;
    let made = api
        .upload(&task, "swing.csv", swing(2.0, 1.0))
        .await
        .ok(201);
    assert_eq!(
        (made["take"].as_u64(), made["samples"].as_u64()),
        (Some(1), Some(101))
    );
    assert_eq!(
        (made["state"].as_str(), made["source"].as_str()),
        (Some("recorded"), Some("file"))
    );
    assert_eq!(made["usable"], true);
    assert_eq!(made["note"], "From the file swing.csv.");
    assert!((made["duration_s"].as_f64().unwrap() - 2.0).abs() < 1e-9);
    assert!((made["rate_hz"].as_f64().unwrap() - 50.0).abs() < 1e-6);
    let path = format!("/api/v1/demonstrations/{}", made["id"].as_str().unwrap());
    for (verb, state) in [("keep", "kept"), ("discard", "discarded"), ("keep", "kept")] {
        let judged = api
            .post(&format!("{path}/{verb}"), Value::Null)
            .await
            .ok(200);
        assert_eq!(judged["state"], state);
    }
    let back = api.post(&format!("{path}/undecide"), Value::Null).await;
    assert_eq!(back.ok(200)["state"], "recorded");
    for verb in ["pause", "resume"] {
        api.post(&format!("{path}/{verb}"), Value::Null)
            .await
            .problem(409, "wrong_state");
    }
    api.post(&format!("{path}/keep"), Value::Null).await.ok(200);
    let stopped = api.post(&format!("{path}/stop"), Value::Null).await.ok(200);
    assert_eq!(stopped["state"], "kept", "what has ended stays as it is");
    let listed = api
        .get(&format!("/api/v1/tasks/{task}/demonstrations"))
        .await
        .ok(200);
    assert_eq!(listed, json!([api.get(&path).await.ok(200)]));
}

#[tokio::test]
async fn a_trajectory_is_thinned_out_joint_by_joint() {
    let api = Api::local().await;
    let task = api.task().await;
    let id = api.kept(&task, swing(2.0, 1.0)).await;
    let path = format!("/api/v1/demonstrations/{id}/trajectory");
    let whole = api.get(&path).await.ok(200);
    assert_eq!(whole["t_s"].as_array().unwrap().len(), 101);
    let thin = api.get(&format!("{path}?max_points=11")).await.ok(200);
    assert_eq!(thin["t_s"].as_array().unwrap().len(), 11);
    assert_eq!(
        (thin["t_s"][0].as_f64(), thin["t_s"][10].as_f64()),
        (Some(0.0), Some(2.0))
    );
    assert_eq!(thin["joints_deg"].as_array().unwrap().len(), 6);
    assert_eq!(thin["joints_deg"][5][10], 25.0);
    assert_eq!(thin["tcp_mm"].as_array().unwrap().len(), 3);
    assert_eq!(thin["gaps"], json!([]));
    for bad in ["1", "20001"] {
        let answer = api.get(&format!("{path}?max_points={bad}")).await;
        assert_eq!(
            answer.problem(422, "out_of_range")["where"]["field"],
            "max_points"
        );
    }
    api.get(&format!("{path}?max_points=x"))
        .await
        .problem(400, "bad_query");
}

#[tokio::test]
async fn what_is_downloaded_can_be_uploaded_again() {
    let api = Api::local().await;
    let task = api.task().await;
    let id = api.kept(&task, swing(2.0, 1.3)).await;
    let file = api
        .get(&format!("/api/v1/demonstrations/{id}/download"))
        .await;
    assert_eq!(
        file.header("content-disposition"),
        "attachment; filename=\"take_1.json\""
    );
    let again = api.upload(&task, "take_1.json", file.text).await.ok(201);
    let trajectory = async |id: &str| {
        api.get(&format!("/api/v1/demonstrations/{id}/trajectory"))
            .await
            .ok(200)
    };
    let copy = again["id"].as_str().unwrap();
    assert_eq!(trajectory(copy).await, trajectory(&id).await);
}

#[tokio::test]
async fn files_that_can_not_be_used_are_refused_with_where_and_why() {
    let api = Api::local().await;
    let task = api.task().await;
    let good = swing(2.0, 1.0);
    let replaced = |row: usize, with: &str| {
        let mut lines: Vec<&str> = good.lines().collect();
        lines[row] = with;
        lines.join("\n")
    };
    let seven = "t_s,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,q7_deg\n".to_owned()
        + &(0..100)
            .map(|i| format!("{},{i},1,1,1,1,1,1\n", 0.02 * f64::from(i)))
            .collect::<String>();
    let cases = [
        ("hello".to_owned(), "demonstration_unreadable", None),
        (
            replaced(9, "0.16,NaN,5,20,0,-30,0"),
            "demonstration_not_finite",
            Some("row"),
        ),
        (
            replaced(9, "0.02,1,5,20,0,-30,0"),
            "demonstration_time_not_increasing",
            Some("row"),
        ),
        (
            replaced(9, "0.16,500,5,20,0,-30,0"),
            "demonstration_joint_out_of_range",
            Some("joint"),
        ),
        (replaced(9, "0.16,1,5,20"), "demonstration_ragged", None),
        (swing(0.9, 1.0), "demonstration_too_short", None),
        (seven, "demonstration_joint_count", None),
    ];
    for (text, code, place) in cases {
        let answer = api.upload(&task, "bad.csv", text).await;
        let problem = answer.problem(422, code);
        assert!(problem["advice"].is_string(), "{code}");
        if let Some(place) = place {
            assert!(problem["where"][place].is_number(), "{code}: {problem}");
        }
    }
    let binary = api.upload(&task, "bad.csv", vec![0xff, 0xfe, 0x00]).await;
    binary.problem(422, "demonstration_unreadable");
    let huge = api
        .upload(&task, "huge.csv", vec![b' '; 17 * 1024 * 1024])
        .await;
    huge.problem(413, "too_large");
    let listed = api
        .get(&format!("/api/v1/tasks/{task}/demonstrations"))
        .await
        .ok(200);
    assert_eq!(listed, json!([]), "nothing of a refused file is stored");
}

#[tokio::test]
async fn what_is_not_there_is_not_found() {
    let api = Api::local().await;
    let nobody = "0190b5a2-0000-7000-8000-000000000009";
    for what in ["", "/trajectory", "/download"] {
        let path = format!("/api/v1/demonstrations/{nobody}{what}");
        api.get(&path).await.problem(404, "not_found");
    }
    for verb in ["stop", "pause", "resume", "keep", "discard", "undecide"] {
        let path = format!("/api/v1/demonstrations/{nobody}/{verb}");
        api.post(&path, Value::Null).await.problem(404, "not_found");
    }
    api.upload(nobody, "x.csv", swing(2.0, 1.0))
        .await
        .problem(404, "not_found");
}
