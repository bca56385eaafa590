//! Dragging the virtual arm with a finger: hand guiding for those without a robot.

use std::f64::consts::TAU;
use std::time::Duration;

use e2e::{Client, Folder, Live, Process, SHORT, eventually};
use motion::{JointAngles, Position, kinematics, limits::RobotLimits};
use serde_json::{Value, json};
use tokio::time::{Instant, interval};

use crate::steps::{alone, idle_arm, joints, new_task, numbers, text, until_state};
use crate::{PROGRAM, SCRATCH};

/// About how often a phone says where its finger is.
const FINGER: Duration = Duration::from_millis(16);
const RADIUS_MM: f64 = 60.0;
/// One turn takes so long, s: the tool moves at 63 mm/s.
const TURN_S: f64 = 6.0;

async fn server(label: &str) -> (Folder, Process) {
    let folder = Folder::new(SCRATCH, label);
    let server = Process::start(PROGRAM, folder.path(), &[]).await;
    (folder, server)
}

fn flange(robot: &Value) -> [f64; 3] {
    kinematics::tool0(&JointAngles(joints(robot, "joints_deg")))
        .position
        .0
}

async fn robot(client: &Client) -> Value {
    client.get("/robots/virtual").await.expect(200)
}

async fn make_soft(client: &Client) {
    let request = json!({ "active": true });
    let soft = client.post("/robots/virtual/lead-through", request).await;
    let _ = soft.expect(200);
}

async fn drag_to(live: &mut Live, tool_mm: [f64; 3]) {
    live.send(&json!({ "type": "drag", "tool_mm": tool_mm }).to_string())
        .await;
}

/// Where a finger on the circle is: it begins and ends where the arm stands, along y and z.
fn on_circle(from: [f64; 3], turn: f64) -> [f64; 3] {
    let angle = TAU * turn;
    let [x, y, z] = from;
    [
        x,
        y + RADIUS_MM * angle.sin(),
        z + RADIUS_MM * (angle.cos() - 1.0),
    ]
}

/// Waits until the arm has shown the same place for a while.
async fn at_rest(client: &Client) -> [f64; 3] {
    let seen = std::cell::Cell::new(([f64::NAN; 3], 0));
    eventually("the arm rests", SHORT, || async {
        let now = flange(&robot(client).await);
        let (before, same) = seen.get();
        let moved = Position(now).distance(&Position(before));
        let same = if moved < 0.01 { same + 1 } else { 0 };
        seen.set((now, same));
        (same >= 10).then_some(now)
    })
    .await
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_circle_of_the_finger_is_recorded_as_a_take_of_hand_guiding() {
    let _turn = alone().await;
    let (_folder, server) = server("drag-circle").await;
    let client = server.client();
    let from = flange(&idle_arm(&client).await);
    make_soft(&client).await;
    let mut live = Live::connect(client.base()).await;
    let task = new_task(&client, "A circle").await;
    let take = client
        .post(&format!("/tasks/{task}/demonstrations"), json!({}))
        .await
        .expect(201);
    let path = format!("/demonstrations/{}", text(&take, "id"));
    until_state(&client, &path, &["recording"]).await;

    let mut finger = interval(FINGER);
    let began = Instant::now();
    loop {
        finger.tick().await;
        let turn = (began.elapsed().as_secs_f64() / TURN_S).min(1.0);
        drag_to(&mut live, on_circle(from, turn)).await;
        if turn >= 1.0 && Position(flange(&robot(&client).await)).distance(&Position(from)) < 1.0 {
            break;
        }
        assert!(began.elapsed() < SHORT, "the arm does not follow");
    }
    assert_eq!(robot(&client).await["hand"], "leading");
    live.send("{\"type\": \"drag_end\"}").await;
    at_rest(&client).await;
    let take = client.post_empty(&format!("{path}/stop")).await.expect(200);
    assert_eq!(take["source"], "hand_guiding", "{take}");
    assert_eq!(take["state"], "recorded", "{take}");
    assert!(
        take["problem"].is_null() && take["note"].is_null(),
        "{take}"
    );
    let _ = client.post_empty(&format!("{path}/keep")).await.expect(200);

    let path = format!("{path}/trajectory?max_points=20000");
    let trajectory = client.get(&path).await.expect(200);
    follows_the_circle(&trajectory, from);
    server.terminate().await;
}

fn follows_the_circle(trajectory: &Value, from: [f64; 3]) {
    let t_s = numbers(&trajectory["t_s"]);
    // One list for each joint.
    let by_joint = trajectory["joints_deg"].as_array().expect("angles");
    let by_joint: Vec<_> = by_joint.iter().map(numbers).collect();
    let places: Vec<_> = (0..t_s.len())
        .map(|at| JointAngles(std::array::from_fn(|joint| by_joint[joint][at])))
        .collect();
    assert!(t_s.len() > 200, "{} samples", t_s.len());
    let [x, y, z] = from;
    let centre = Position([x, y, z - RADIUS_MM]);
    let limits = RobotLimits::gofa5();
    let mut turned = 0.0;
    let mut farthest: f64 = 0.0;
    let mut before: Option<f64> = None;
    for joints in &places {
        assert_eq!(limits.joint_out_of_range(joints), None);
        let [px, py, pz] = kinematics::tool0(joints).position.0;
        let radius = Position([px, py, pz]).distance(&centre);
        farthest = farthest.max((radius - RADIUS_MM).abs()).max((px - x).abs());
        let angle = (py - centre.0[1]).atan2(pz - centre.0[2]);
        if let Some(before) = before {
            turned += (angle - before + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
        }
        before = Some(angle);
    }
    assert!(farthest < 3.0, "{farthest} mm beside the circle");
    assert!((turned - TAU).abs() < 0.1, "{turned} of a turn");
    // Over a tenth of a second, because a single sample's time is only known to a few milliseconds.
    let mut first = 0;
    for last in 0..t_s.len() {
        while t_s[last] - t_s[first] > 0.1 {
            let [a, b] = [first, last].map(|at| kinematics::tool0(&places[at]).position);
            let speed = a.distance(&b) / (t_s[last] - t_s[first]);
            assert!(speed < 250.0, "{speed} mm/s at {} s", t_s[last]);
            first += 1;
        }
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_stiff_arm_is_not_dragged_and_says_so_once() {
    let _turn = alone().await;
    let (_folder, server) = server("drag-stiff").await;
    let client = server.client();
    let from = flange(&idle_arm(&client).await);
    let mut live = Live::connect(client.base()).await;
    let beside = [from[0], from[1] + 100.0, from[2]];
    for _ in 0..5 {
        drag_to(&mut live, beside).await;
    }
    let refused = live.wait_for("drag_refused", |_| true).await;
    assert_eq!(refused["code"], "robot_not_guiding", "{refused}");
    for member in ["detail", "advice"] {
        assert!(!text(&refused, member).is_empty(), "{refused}");
    }
    // The next attempt is told again, and between the two nothing was.
    live.send("{\"type\": \"drag_end\"}").await;
    drag_to(&mut live, beside).await;
    let mut told = 0;
    while told == 0 {
        let message = live.next().await.expect("the socket stays");
        told += u32::from(message["type"] == "drag_refused");
    }
    assert_eq!(at_rest(&client).await, from);
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn an_arm_is_dragged_no_farther_than_it_reaches_and_rests_when_the_socket_is_lost() {
    let _turn = alone().await;
    let (_folder, server) = server("drag-far").await;
    let client = server.client();
    let from = flange(&idle_arm(&client).await);
    make_soft(&client).await;
    let mut live = Live::connect(client.base()).await;
    let mut finger = interval(FINGER);
    let began = Instant::now();
    // Far beyond the arm's reach: it stretches and stays within its ranges.
    loop {
        finger.tick().await;
        drag_to(&mut live, [4_000.0, 0.0, 700.0]).await;
        let view = robot(&client).await;
        let angles = JointAngles(joints(&view, "joints_deg"));
        assert_eq!(RobotLimits::gofa5().joint_out_of_range(&angles), None);
        if flange(&view)[0] > 900.0 {
            break;
        }
        assert!(began.elapsed() < SHORT, "the arm does not stretch");
    }
    // Another socket may not drag it at the same time.
    let mut other = Live::connect(client.base()).await;
    drag_to(&mut other, from).await;
    let refused = other.wait_for("drag_refused", |_| true).await;
    assert_eq!(refused["code"], "drag_taken", "{refused}");

    // Back home it is led until the socket breaks; there is still most of the way to go.
    let begins = flange(&robot(&client).await);
    for way_mm in [20.0, 140.0] {
        while Position(flange(&robot(&client).await)).distance(&Position(begins)) < way_mm {
            finger.tick().await;
            drag_to(&mut live, from).await;
            assert!(began.elapsed() < SHORT, "the arm does not come back");
        }
        // Let go and taken again at once, as fingers do, it is led on all the same.
        live.send("{\"type\": \"drag_end\"}").await;
        drag_to(&mut live, from).await;
    }
    drop(live);
    let rests = at_rest(&client).await;
    assert!(
        Position(rests).distance(&Position(from)) > 100.0,
        "it went on to {rests:?}"
    );
    assert_eq!(robot(&client).await["state"], "guiding");
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn stop_ends_a_drag_and_the_finger_moves_nothing_any_more() {
    let _turn = alone().await;
    let (_folder, server) = server("drag-stop").await;
    let client = server.client();
    let from = flange(&idle_arm(&client).await);
    make_soft(&client).await;
    let mut live = Live::connect(client.base()).await;
    let far = [from[0], from[1] + 500.0, from[2]];
    let mut finger = interval(FINGER);
    let began = Instant::now();
    while Position(flange(&robot(&client).await)).distance(&Position(from)) < 30.0 {
        finger.tick().await;
        drag_to(&mut live, far).await;
        assert!(began.elapsed() < SHORT, "the arm does not move");
    }
    live.send("{\"type\": \"stop\"}").await;
    let rests = eventually("the arm is stiff", SHORT, || async {
        let view = robot(&client).await;
        (view["state"] == "idle").then(|| flange(&view))
    })
    .await;
    drag_to(&mut live, far).await;
    drag_to(&mut live, far).await;
    live.wait_for("drag_refused", |told| told["code"] == "robot_not_guiding")
        .await;
    let after = at_rest(&client).await;
    assert!(Position(after).distance(&Position(rests)) < 5.0);
    assert!(Position(after).distance(&Position(far)) > 100.0);
    server.terminate().await;
}
