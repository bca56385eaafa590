//! Another speed, a pause and the way back, as the phone asks for them.

use e2e::{Client, SHORT, eventually};
use serde_json::{Value, json};

use crate::prepared::with_model;
use crate::steps::{alone, ended, idle_arm, in_motion, joints, number, plan, start, text};

async fn robot_in_phase(client: &Client, phase: &str) -> Value {
    eventually(&format!("the arm is {phase}"), SHORT, || async {
        let robot = client.get("/robots/virtual").await.expect(200);
        (robot["run"]["phase"] == phase).then_some(robot)
    })
    .await
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_motion_is_slowed_paused_stopped_and_led_back_along_its_path() {
    let _turn = alone().await;
    let (_folder, server, model) = with_model("pace", &[]).await;
    let client = server.client();
    idle_arm(&client).await;
    let there = plan(&client, &model, json!("as_taught"), json!("as_taught")).await;
    let run = start(&client, &there).await;
    let path = format!("/reproductions/{}", text(&run, "id"));
    let pace = format!("{path}/pace");
    in_motion(&client, number(&there, "approach_s") + 0.5).await;

    let slow = client.post(&pace, json!({ "speed": 0.3 })).await;
    assert_eq!(slow.status, 204);
    eventually("the view shows the speed", SHORT, || async {
        let robot = client.get("/robots/virtual").await.expect(200);
        (robot["run"]["speed"] == 0.3).then_some(())
    })
    .await;
    for wrong in [json!({ "speed": 0.01 }), json!({ "speed": 1.2 })] {
        let problem = client.post(&pace, wrong).await.problem(&[422]);
        assert_eq!(problem["code"], "bad_speed", "{problem}");
    }

    client.post(&pace, json!({ "paused": true })).await;
    let paused = robot_in_phase(&client, "paused").await;
    assert_eq!(paused["run"]["paused"], true);
    let rests = number(&paused["run"], "t_s");
    client.post(&pace, json!({ "paused": false })).await;
    let on = robot_in_phase(&client, "motion").await;
    assert!(number(&on["run"], "t_s") >= rests);
    in_motion(&client, rests + 0.2).await;

    // There is no way back from a motion that goes on, and none to pause when it is over.
    let back = format!("{path}/back");
    let _ = client.post_empty(&back).await.problem(&[409]);
    let _ = client.post_empty(&format!("{path}/stop")).await.expect(200);
    assert_eq!(ended(&client, &run).await["state"], "stopped");
    let over = client.post(&pace, json!({ "paused": true })).await;
    assert_eq!(over.problem(&[409])["code"], "robot_not_running");

    // Back to the start of the motion, along the path, as a plan that is checked and then run.
    idle_arm(&client).await;
    let way = client.post_empty(&back).await.expect(200);
    let begins = joints(&there, "start_deg");
    for (end, start) in joints(&way, "goal_deg").iter().zip(begins) {
        assert!((end - start).abs() < 1e-6, "{way}");
    }
    let returning = start(&client, &way).await;
    let finished = ended(&client, &returning).await;
    assert_eq!(finished["state"], "succeeded", "{finished}");
    assert!(number(&finished, "e_j_deg") < 0.02, "{finished}");
    let robot = client.get("/robots/virtual").await.expect(200);
    for (now, start) in joints(&robot, "joints_deg").iter().zip(begins) {
        assert!((now - start).abs() < 0.05, "{robot}");
    }

    let events = client.get(&format!("{path}/events")).await.expect(200);
    let codes: Vec<&str> = events
        .as_array()
        .expect("a list")
        .iter()
        .map(|event| text(event, "code"))
        .collect();
    for code in ["speed", "paused", "stop_requested", "stopped"] {
        assert!(codes.contains(&code), "{codes:?}");
    }
    server.terminate().await;
}
