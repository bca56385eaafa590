//! Hold-to-run over the live socket, and two phones at one robot.

use std::time::Duration;

use e2e::{Client, Live, SHORT, eventually};
use serde_json::{Value, json};
use tokio::sync::oneshot;
use tokio::task::JoinHandle;

use crate::prepared::with_model;
use crate::steps::{alone, ended, idle_arm, joints, number, numbers, plan, text};

const ANNA: &str = "?phone=anna&phone_name=Anna";

/// What a phone says while the button is held.
fn hold(run: &Value, press: u64) -> String {
    json!({ "type": "hold", "reproduction": run["id"], "press": press }).to_string()
}

/// A finger on the button of a phone.
struct Finger {
    lift: oneshot::Sender<()>,
    phone: JoinHandle<Live>,
}

impl Finger {
    /// The phone says twenty times a second that the button is held.
    fn press(mut live: Live, run: &Value, press: u64) -> Self {
        let message = hold(run, press);
        let (lift, mut lifted) = oneshot::channel();
        let phone = tokio::spawn(async move {
            let mut tick = tokio::time::interval(Duration::from_millis(50));
            loop {
                tokio::select! {
                    _ = tick.tick() => live.send(&message).await,
                    _ = &mut lifted => return live,
                }
            }
        });
        Self { lift, phone }
    }

    /// Nothing more is said; the socket stays open, as when a phone has lost its network.
    async fn fall_silent(self) -> Live {
        let _ = self.lift.send(());
        self.phone.await.expect("the phone is whole")
    }
}

async fn start_held(client: &Client, plan: &Value) -> Value {
    let request = json!({ "plan": plan["plan"], "hold": true });
    client.post("/reproductions", request).await.expect(202)
}

/// Waits until the run is in this phase and past this time.
async fn in_phase(client: &Client, phase: &str, t_s: f64) -> Value {
    eventually(&format!("the arm is {phase}"), SHORT, || async {
        let robot = client.get("/robots/virtual").await.expect(200);
        let run = &robot["run"];
        (run["phase"] == phase && number(run, "t_s") >= t_s).then_some(robot)
    })
    .await
}

/// When events of this kind happened, in seconds.
async fn times(client: &Client, run: &Value, code: &str) -> Vec<f64> {
    let path = format!("/reproductions/{}/events", text(run, "id"));
    let events = client.get(&path).await.expect(200);
    let events = events.as_array().expect("a list");
    let found = events.iter().filter(|event| event["code"] == code);
    found.map(|event| number(event, "at_s")).collect()
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn the_arm_moves_only_while_the_button_is_held() {
    let _turn = alone().await;
    let (_folder, server, model) = with_model("hold", &[]).await;
    let client = server.client();
    let phone = client.with_header("x-team-phone", "anna");
    idle_arm(&client).await;
    let plan = plan(&client, &model, json!("as_taught"), json!("as_taught")).await;
    let begins = joints(
        &client.get("/robots/virtual").await.expect(200),
        "joints_deg",
    );
    let run = start_held(&phone, &plan).await;
    let waits = in_phase(&client, "paused", 0.0).await;
    assert_eq!(waits["run"]["held"], false);
    for (now, begin) in joints(&waits, "joints_deg").iter().zip(begins) {
        assert!((now - begin).abs() < 0.01, "nobody held it: {waits}");
    }

    let live = Live::connect_with(client.base(), ANNA).await;
    let finger = Finger::press(live, &run, 1);
    let moves = in_phase(&client, "approach", 0.5).await;
    assert_eq!(moves["run"]["held"], true);
    let mut live = finger.fall_silent().await;
    let stands = in_phase(&client, "paused", 0.0).await;
    assert_eq!(stands["run"]["held"], false);

    // What comes late of a press that is over counts for nothing.
    live.send(&json!({ "type": "let_go" }).to_string()).await;
    for _ in 0..20 {
        live.send(&hold(&run, 1)).await;
    }
    // Pressed again, it goes on from there to the end, whatever else is asked of the arm meanwhile.
    let finger = Finger::press(live, &run, 2);
    in_phase(&client, "approach", 0.0).await;
    for hold in [true, false] {
        let another = json!({ "plan": plan["plan"], "hold": hold });
        let refused = phone.post("/reproductions", another).await;
        assert_eq!(refused.problem(&[409])["code"], "robot_busy");
    }
    let finished = ended(&client, &run).await;
    finger.fall_silent().await;
    assert_eq!(finished["state"], "succeeded", "{finished}");
    assert!(number(&finished, "e_j_deg") < 0.02, "{finished}");

    assert_eq!(times(&client, &run, "held").await.len(), 2, "two presses");
    // By the record, the arm stood soon after the last word.
    let let_go = times(&client, &run, "let_go").await[0];
    let path = format!(
        "/reproductions/{}/flight?points=2000&to_s={}",
        text(&run, "id"),
        let_go + 2.0
    );
    let flight = client.get(&path).await.expect(200);
    let (t_s, plan_t_s) = (numbers(&flight["t_s"]), numbers(&flight["plan_t_s"]));
    let stood = t_s.windows(2).zip(plan_t_s.windows(2));
    let stood = stood
        .filter(|(t, _)| t[0] > let_go - 0.2)
        .find(|(_, plan)| plan[1] - plan[0] < 1e-4)
        .map(|(t, _)| t[0])
        .expect("it stood");
    // What was not heard for 180 ms counts as let go; half a second is all there is.
    assert!(stood - (let_go - 0.18) <= 0.5, "{stood} after {let_go}");
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_phone_that_is_gone_and_a_phone_without_control_hold_nothing() {
    let _turn = alone().await;
    let (_folder, server, model) = with_model("hold-lost", &[]).await;
    let client = server.client();
    let phone = client.with_header("x-team-phone", "anna");
    idle_arm(&client).await;
    let plan = plan(&client, &model, json!("as_taught"), json!("as_taught")).await;
    let mut watching = Live::connect_with(client.base(), ANNA).await;
    let run = start_held(&phone, &plan).await;
    in_phase(&client, "paused", 0.0).await;

    let stranger = Live::connect_with(client.base(), "?phone=ben&phone_name=Ben").await;
    let finger = Finger::press(stranger, &run, 1);
    let robot = watching.wait_for("robot", |message| {
        // What was under way before the run began is told too.
        message["robot"]["control"]["phone"]["id"] == "anna" && message["robot"]["run"].is_object()
    });
    let robot = robot.await;
    assert_eq!(robot["robot"]["run"]["held"], false);
    finger.fall_silent().await;

    let live = Live::connect_with(client.base(), ANNA).await;
    let finger = Finger::press(live, &run, 2);
    in_phase(&client, "approach", 0.3).await;
    drop(finger.fall_silent().await);
    in_phase(&client, "paused", 0.3).await;
    // Stop is for everybody.
    let other = client.with_header("x-team-phone", "ben");
    let path = format!("/reproductions/{}/stop", text(&run, "id"));
    let stopped = other.post_empty(&path).await.expect(200);
    assert_eq!(stopped["state"], "stopped");
    server.terminate().await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn of_two_phones_one_has_control_and_the_other_can_ask() {
    let _turn = alone().await;
    let (_folder, server, model) = with_model("control", &[]).await;
    let client = server.client();
    idle_arm(&client).await;
    let on = |id, name| {
        client
            .with_header("x-team-phone", id)
            .with_header("x-team-phone-name", name)
    };
    let (anna, ben) = (on("anna", "Anna"), on("ben", "Ben%20%C3%84"));
    let mut anna_sees = Live::connect_with(client.base(), ANNA).await;
    let _ben_sees = Live::connect_with(client.base(), "?phone=ben&phone_name=Ben").await;
    let soft = |active: bool| json!({ "active": active });
    let lead_through = "/robots/virtual/lead-through";
    let _ = anna.post(lead_through, soft(true)).await.expect(200);

    let refused = ben.post(lead_through, soft(true)).await.problem(&[409]);
    assert_eq!(refused["code"], "robot_controlled");
    assert!(text(&refused, "detail").contains("Anna"), "{refused}");
    // A line system may not reach into it either.
    let plan = plan(&client, &model, json!("as_taught"), json!("as_taught")).await;
    let start = json!({ "plan": plan["plan"] });
    let refused = client.post("/reproductions", start).await.problem(&[409]);
    assert_eq!(refused["code"], "robot_controlled");

    let control = "/robots/virtual/control";
    let refused = ben.post(control, json!({ "action": "give" })).await;
    assert_eq!(refused.problem(&[409])["code"], "not_in_control");
    let nobody = client.post(control, json!({ "action": "ask" })).await;
    assert_eq!(nobody.problem(&[422])["code"], "phone_missing");
    let asked = ben
        .post(control, json!({ "action": "ask" }))
        .await
        .expect(200);
    assert_eq!(asked["control"]["phone"]["id"], "anna");
    let sees = anna_sees.wait_for("robot", |message| {
        message["robot"]["control"]["asked_by"]["name"] == "Ben Ä"
    });
    sees.await;
    let _ = anna.post(lead_through, soft(false)).await.expect(200);
    let given = anna.post(control, json!({ "action": "give" })).await;
    assert_eq!(given.expect(200)["control"]["phone"]["id"], "ben");
    let _ = ben.post(lead_through, soft(true)).await.expect(200);
    let refused = anna.post(lead_through, soft(true)).await.problem(&[409]);
    assert_eq!(refused["code"], "robot_controlled");
    // Whoever stops, stops.
    assert_eq!(anna.post_empty("/robots/virtual/stop").await.status, 204);
    server.terminate().await;
}
