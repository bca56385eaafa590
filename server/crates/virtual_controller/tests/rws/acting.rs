//! What can be done, when, and what is taken back.

use std::time::Instant;

use reqwest::StatusCode;
use serde_json::Value;

use crate::cell::{Cell, PATIENCE, UNIT, code_of};

#[tokio::test]
async fn the_panel_and_the_program_follow_their_rules() {
    let cell = Cell::start().await;
    let start = "/rw/rapid/execution/start";
    let refused = cell.post(start, "cycle=once").await;
    assert_eq!(refused.status(), StatusCode::FORBIDDEN);
    assert_eq!(code_of(refused).await, -1_073_442_809);

    cell.act("/rw/panel/ctrl-state", "ctrl-state=motoron").await;
    assert_eq!(
        cell.read("/rw/panel/ctrl-state").await["ctrlstate"],
        "motoron"
    );
    assert_eq!(cell.read("/rw/panel/opmode").await["opmode"], "AUTO");
    cell.act(start, "regain=continue&execmode=continue&cycle=once&condition=none&stopatbp=disabled&alltaskbytsp=false").await;
    assert_eq!(
        cell.read("/rw/rapid/execution").await["ctrlexecstate"],
        "running"
    );

    let lead_through = format!("{UNIT}/lead-through");
    let refused = cell.post(&lead_through, "status=active").await;
    assert_eq!(refused.status(), StatusCode::FORBIDDEN);
    cell.act("/rw/rapid/execution/stop", "stopmode=stop&usetsp=normal")
        .await;
    assert_eq!(
        cell.read("/rw/rapid/execution").await["ctrlexecstate"],
        "stopped"
    );

    cell.act(
        "/rw/panel/speedratio?action=setspeedratio",
        "speed-ratio=40",
    )
    .await;
    assert_eq!(cell.read("/rw/panel/speedratio").await["speedratio"], "40");
    cell.controller.faults().guard_stop(true);
    assert_eq!(
        cell.read("/rw/panel/ctrl-state").await["ctrlstate"],
        "guardstop"
    );
    let refused = cell
        .post("/rw/panel/ctrl-state", "ctrl-state=motoron")
        .await;
    assert_eq!(refused.status(), StatusCode::FORBIDDEN);
    cell.controller.stop().await;
}

#[tokio::test]
async fn signals_are_written_where_their_access_allows_it() {
    let cell = Cell::start().await;
    let gripper = "/rw/iosystem/signals/GripperClose";
    cell.act(&format!("{gripper}/set-value"), "lvalue=1").await;
    assert_eq!(cell.read(gripper).await["lvalue"], "1");
    let button = "/rw/iosystem/signals/IntBus/Asi/Asi1Button1";
    let refused = cell.post(&format!("{button}/set-value"), "lvalue=1").await;
    assert_eq!(refused.status(), StatusCode::FORBIDDEN);
    assert_eq!(code_of(refused).await, -1_073_445_881);
    cell.controller.faults().wire_signal("Asi1Button1", true);
    assert_eq!(cell.read(button).await["lvalue"], "1");
    let unknown = cell.get("/rw/iosystem/signals/Nothing").await;
    assert_eq!(unknown.status(), StatusCode::NOT_FOUND);
    cell.controller.stop().await;
}

#[tokio::test]
async fn the_hand_waits_for_lead_through_and_then_moves_the_arm() {
    let cell = Cell::start().await;
    let order = "action=show&script=f1&seed=5";
    assert_eq!(
        cell.post("/virtual/hand", order).await.status(),
        StatusCode::CONFLICT
    );
    cell.make_soft().await;
    for bad in [
        "action=show&script=f9&seed=5",
        "action=show&script=f1&seed=x",
        "script=f1",
        "action=lead&joints=1,2,3",
        "action=lead&joints=0,0,0,0,0,NaN",
        "action=lead&joints=0,0,0,0,0,271",
    ] {
        assert_eq!(
            cell.post("/virtual/hand", bad).await.status(),
            StatusCode::BAD_REQUEST
        );
    }
    let before = cell.read(&format!("{UNIT}/jointtarget")).await["rax_1"].clone();
    cell.act("/virtual/hand", order).await;
    let hand: Value = cell.get("/virtual/hand").await.json().await.unwrap();
    assert_eq!(hand["state"], "showing");
    let deadline = Instant::now() + PATIENCE;
    while cell.read(&format!("{UNIT}/jointtarget")).await["rax_1"] == before {
        assert!(Instant::now() < deadline, "the arm does not move");
    }
    cell.act(&format!("{UNIT}/lead-through"), "status=inactive")
        .await;
    cell.wait_for(&format!("{UNIT}/lead-through"), "status", "Inactive")
        .await;
    let hand: Value = cell.get("/virtual/hand").await.json().await.unwrap();
    assert_eq!(hand["state"], "idle");
    cell.controller.stop().await;
}

#[tokio::test]
async fn lead_through_can_be_accepted_and_taken_back() {
    let cell = Cell::start().await;
    cell.controller
        .faults()
        .set(|faults| faults.lead_through_reverts = true);
    cell.act("/rw/panel/ctrl-state", "ctrl-state=motoron").await;
    cell.act(&format!("{UNIT}/lead-through"), "status=active")
        .await;
    let log = "/rw/elog/9?lang=en&order=lifo&limit=1";
    let deadline = Instant::now() + PATIENCE;
    loop {
        let body: Value = cell.get(log).await.json().await.unwrap();
        if let Some(event) = body.pointer("/_embedded/resources/0") {
            assert_eq!(event["code"], "90515");
            assert_eq!(event["msgtype"], "3");
            break;
        }
        assert!(Instant::now() < deadline, "no safety event");
    }
    cell.wait_for(&format!("{UNIT}/lead-through"), "status", "Inactive")
        .await;
    cell.controller.stop().await;
}

#[tokio::test]
async fn a_start_can_be_accepted_and_taken_back() {
    let cell = Cell::start().await;
    cell.controller
        .faults()
        .set(|faults| faults.start_reverts = true);
    cell.act("/rw/panel/ctrl-state", "ctrl-state=motoron").await;
    cell.act("/rw/rapid/execution/start", "cycle=once").await;
    cell.wait_for("/rw/rapid/execution", "ctrlexecstate", "stopped")
        .await;
    cell.controller.stop().await;
}
