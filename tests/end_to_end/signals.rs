//! The gripper from the phone into the motion and back: worked while a motion is shown, learned,
//! and worked by the arm where it was shown.

use e2e::{Client, Folder, LONG, Process, eventually};
use motion::{JointAngles, kinematics};
use serde_json::{Value, json};

use crate::steps::until_state;
use crate::steps::{alone, ended, idle_arm, new_task, number, numbers, plan, start, text, train};
use crate::{PROGRAM, SCRATCH, in_process};

const GRIPPER: &str = "GripperClose";
/// How far from the shown places the gripper may be worked, mm.
const NEAR_MM: f64 = 8.0;

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn the_gripper_closes_where_it_was_shown_to() {
    let _turn = alone().await;
    let folder = Folder::new(SCRATCH, "signals");
    let server = Process::start(PROGRAM, folder.path(), &[]).await;
    let client = server.client();
    let robot = idle_arm(&client).await;
    assert_eq!(robot["signals"][0]["label"], "Gripper", "{robot}");

    let task = new_task(&client, "Pick and place").await;
    let mut shown = Vec::new();
    for seed in 1..=3 {
        let take = showing(&client, &task, "f1", seed).await;
        shown.push(places(&client, &recorded(&client, &take).await).await);
        idle_arm(&client).await;
    }
    for events in &shown {
        let told: Vec<bool> = events.iter().map(|(on, _)| *on).collect();
        assert_eq!(
            told,
            [true, false],
            "closed at the tray, opened in the machine"
        );
    }
    let model = train(&client, &task, json!({})).await;

    let planned = plan(&client, &model, json!("as_taught"), json!("as_taught")).await;
    let signals = planned["signals"].as_array().expect("the plan's signals");
    let words: Vec<&Value> = signals.iter().map(|signal| &signal["on"]).collect();
    assert_eq!(words, [false, true, false], "{signals:?}");
    assert!(number(&signals[0], "at_s") <= number(&planned, "approach_s"));

    let running = start(&client, &planned).await;
    let refused = work_gripper(&client, true).await;
    let _ = refused.problem(&[409]);
    let result = ended(&client, &running).await;
    assert_eq!(result["state"], "succeeded", "{result}");

    let path = format!(
        "/reproductions/{}/trajectory?max_points=20000",
        text(&result, "id")
    );
    let record = client.get(&path).await.expect(200);
    let set = record["signals"].as_array().expect("what was set");
    assert_eq!(set.len(), 3, "{set:?}");
    for (step, signal) in set[1..].iter().enumerate() {
        let here = tool_at(&record, "measured_deg", number(signal, "at_s"));
        let nearest_mm = shown
            .iter()
            .map(|events| distance_mm(&events[step].1, &here));
        let nearest_mm = nearest_mm.fold(f64::INFINITY, f64::min);
        assert!(
            nearest_mm < NEAR_MM,
            "{nearest_mm} mm from every take at {signal}"
        );
    }
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn takes_that_work_the_gripper_differently_are_refused_before_training() {
    let _turn = alone().await;
    let folder = Folder::new(SCRATCH, "signals-differ");
    let server = Process::start(PROGRAM, folder.path(), &[]).await;
    let client = server.client();
    idle_arm(&client).await;
    let task = new_task(&client, "By the phone").await;

    // F2 works no gripper by itself; the phone closes it in one of two takes.
    let plain = showing(&client, &task, "f2", 1).await;
    let _ = recorded(&client, &plain).await;
    idle_arm(&client).await;
    let take = showing(&client, &task, "f2", 2).await;
    let path = format!("/demonstrations/{}", text(&take, "id"));
    until_state(&client, &path, &["recording"]).await;
    eventually("a second is recorded", LONG, || async {
        let take = client.get(&path).await.expect(200);
        (number(&take, "duration_s") > 1.0).then_some(())
    })
    .await;
    let robot = work_gripper(&client, true).await.expect(200);
    assert_eq!(robot["signals"][0]["is_on"], true, "{robot}");
    let events = places(&client, &recorded(&client, &take).await).await;
    assert_eq!(events.len(), 1, "{events:?}");

    let agreement = client
        .get(&format!("/tasks/{task}/agreement"))
        .await
        .expect(200);
    assert_eq!(
        agreement["problem"]["code"], "signals_differ",
        "{agreement}"
    );
    let refused = client
        .post(&format!("/tasks/{task}/models"), json!({}))
        .await;
    let problem = refused.problem(&[422]);
    assert_eq!(problem["code"], "signals_differ", "{problem}");
    assert!(text(&problem, "detail").contains("Take 2"), "{problem}");

    // What was downloaded and uploaded again tells the same story.
    let file = client.get(&format!("{path}/download")).await.expect(200);
    assert_eq!(file["signals"][1]["on"], true, "{}", file["signals"]);
    let other = new_task(&client, "From the file").await;
    let upload = format!("/tasks/{other}/demonstrations/upload?name=take.json");
    let again = client
        .post_text(&upload, "application/json", file.to_string())
        .await;
    assert_eq!(places(&client, &again.expect(201)).await.len(), 1);
    let _ = client
        .post("/robots/virtual/signals/Unknown", json!({ "on": true }))
        .await
        .problem(&[404]);
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_gripper_that_does_not_close_stops_the_arm_with_words() {
    let _turn = alone().await;
    let folder = Folder::new(SCRATCH, "signals-stuck");
    let server = in_process::start(folder.path()).await;
    let client = server.client();
    idle_arm(&client).await;
    let task = new_task(&client, "Stuck").await;
    let path = format!("/tasks/{task}/demonstrations/upload?name=take.json");
    let file = gripping_file().to_string();
    let take = client
        .post_text(&path, "application/json", file)
        .await
        .expect(201);
    let path = format!("/demonstrations/{}/keep", text(&take, "id"));
    let _ = client.post_empty(&path).await.expect(200);
    let model = train(&client, &task, json!({})).await;
    let planned = plan(&client, &model, json!("as_taught"), json!("as_taught")).await;
    let closes = &planned["signals"][1];
    assert_eq!(closes["on"], true, "{}", planned["signals"]);

    server.signals_get_stuck(true);
    let running = start(&client, &planned).await;
    let result = ended(&client, &running).await;
    assert_eq!(result["state"], "failed", "{result}");
    assert!(
        text(&result, "reason").contains("\"Gripper\" did not close"),
        "{result}"
    );
    let robot = client.get("/robots/virtual").await.expect(200);
    assert_eq!(robot["fault"]["code"], "signal_failed", "{robot}");
    // It stands on the planned path, behind the place of the signal and far from the end.
    let path = format!(
        "/reproductions/{}/trajectory?max_points=20000",
        text(&result, "id")
    );
    let record = client.get(&path).await.expect(200);
    let last = numbers(&record["measured_deg"][0]).pop().expect("a record");
    let goal = numbers(&planned["joints_deg"][0]).pop().expect("a plan");
    assert!(
        (goal - last).abs() > 3.0,
        "stopped at {last} on the way to {goal}"
    );
    server.signals_get_stuck(false);
    let _ = client.post_empty("/robots/virtual/reset").await.expect(200);
    let _ = work_gripper(&client, true).await.expect(200);
    server.shutdown().await;
}

/// A take as a file; the gripper closes after a third of it.
fn gripping_file() -> Value {
    let take = e2e::take(1, 6.0);
    let closes_s = take.t_s[take.t_s.len() / 3];
    json!({
        "format": "team-demonstration",
        "version": 1,
        "t_s": take.t_s,
        "joints_deg": take.joints_deg,
        "signals": [
            { "name": GRIPPER, "at_s": 0.0, "on": false },
            { "name": GRIPPER, "at_s": closes_s, "on": true },
        ],
    })
}

async fn work_gripper(client: &Client, on: bool) -> e2e::Reply {
    client
        .post(
            &format!("/robots/virtual/signals/{GRIPPER}"),
            json!({ "on": on }),
        )
        .await
}

/// Begins a take by the virtual hand.
async fn showing(client: &Client, task: &str, script: &str, seed: u64) -> Value {
    let request = json!({ "virtual_hand": script, "seed": seed });
    client
        .post(&format!("/tasks/{task}/demonstrations"), request)
        .await
        .expect(201)
}

/// The take when it is over, kept.
async fn recorded(client: &Client, take: &Value) -> Value {
    let path = format!("/demonstrations/{}", text(take, "id"));
    let recorded = until_state(client, &path, &["recorded", "interrupted"]).await;
    assert_eq!(recorded["state"], "recorded", "{recorded}");
    client.post_empty(&format!("{path}/keep")).await.expect(200)
}

/// The changes of the gripper in a take: to what, and where the tool was.
async fn places(client: &Client, take: &Value) -> Vec<(bool, [f64; 3])> {
    let path = format!(
        "/demonstrations/{}/trajectory?max_points=20000",
        text(take, "id")
    );
    let trajectory = client.get(&path).await.expect(200);
    let signals = trajectory["signals"]
        .as_array()
        .expect("the take's signals");
    assert_eq!(
        signals[0]["at_s"], 0.0,
        "how it stood at the beginning comes first"
    );
    signals[1..]
        .iter()
        .map(|signal| {
            assert_eq!(signal["name"], GRIPPER);
            let place = tool_at(&trajectory, "joints_deg", number(signal, "at_s"));
            (signal["on"] == true, place)
        })
        .collect()
}

/// Where the tool was at `at_s`, from the joints of that moment.
fn tool_at(trajectory: &Value, joints: &str, at_s: f64) -> [f64; 3] {
    let times = numbers(&trajectory["t_s"]);
    let row = times.partition_point(|t| *t < at_s).min(times.len() - 1);
    let angles = std::array::from_fn(|joint| numbers(&trajectory[joints][joint])[row]);
    kinematics::tool0(&JointAngles(angles)).position.0
}

fn distance_mm(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b).powi(2))
        .sum::<f64>()
        .sqrt()
}
