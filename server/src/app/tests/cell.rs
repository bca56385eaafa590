//! Several robots on one server, by a configuration file.

use std::fmt::Write;
use std::net::{SocketAddr, TcpListener, UdpSocket};
use std::path::Path;
use std::time::Duration;

use futures_util::SinkExt;
use robot::{HandScript, RobotState, RobotView};
use tokio::time::timeout;
use tokio_tungstenite::connect_async;
use tokio_tungstenite::tungstenite::Message;
use virtual_controller::VirtualController;

use super::super::StartError;
use super::reproducing::{plan_for, trained};
use super::sockets::next;
use super::{App, RunningApp, by_hand, config, heard, state_of};
use crate::announcement;
use crate::arms::Arm;
use crate::config::{Config, RobotChoice};
use crate::ids::TaskId;
use crate::plans::KnownPlan;
use crate::recording::{HandShowing, RecordingError, RecordingRequest};
use crate::reproducing::{ReproducingError, StartRequest};
use crate::store::demonstrations::DemonstrationState;
use crate::store::reproductions::ReproductionState;
use crate::test_support::TestFolder;

/// A server with the robots of this configuration file, and a task.
async fn with_cell(folder: &Path, cell: &str) -> Result<(RunningApp, TaskId), StartError> {
    let file = folder.join("cell.toml");
    std::fs::write(&file, cell).unwrap();
    let app = App::start(Config {
        config: Some(file),
        ..config(folder, RobotChoice::Virtual)
    })
    .await?;
    let task = TaskId::new();
    let now = app.state.clock.now();
    app.state
        .store
        .create_task(task, "Drill", now)
        .await
        .unwrap();
    Ok((app, task))
}

fn virtual_robots(ids: impl IntoIterator<Item = String>) -> String {
    ids.into_iter().fold(String::new(), |mut text, id| {
        writeln!(text, "[[robot]]\nid = \"{id}\"\nkind = \"virtual\"").unwrap();
        text
    })
}

async fn two() -> (RunningApp, TaskId, TestFolder) {
    let folder = TestFolder::new();
    let cell = virtual_robots(["left", "right"].map(String::from));
    let (app, task) = with_cell(folder.path(), &cell).await.unwrap();
    for arm in app.state.arms.all() {
        state_of(arm, RobotState::Idle).await;
    }
    (app, task, folder)
}

async fn seen(arm: &Arm, fits: impl FnMut(&RobotView) -> bool) -> RobotView {
    let mut view = arm.robot.view();
    let wait = timeout(Duration::from_secs(30), view.wait_for(fits));
    wait.await.unwrap().unwrap().clone()
}

fn start_of(plan: &KnownPlan, key: Option<&str>) -> StartRequest {
    StartRequest {
        plan: plan.plan.hash().to_owned(),
        id: None,
        key: key.map(str::to_owned),
        hold: false,
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn two_robots_move_at_once_and_stopping_one_leaves_the_other_moving() {
    let (app, task, _folder) = two().await;
    let [left, right] = app.state.arms.all() else {
        panic!("there are two robots")
    };
    let model = trained(&app, task).await;
    let plan = plan_for(&app, left, task, model).await;
    let refused = right.reproducer.start(start_of(&plan, None)).await;
    let Err(ReproducingError::OtherRobot { of, robot }) = refused else {
        panic!("{refused:?}")
    };
    assert_eq!((&*of, &*robot), ("left", "right"));
    assert!(
        app.state
            .store
            .reproductions(None, 200)
            .await
            .unwrap()
            .is_empty()
    );

    // Both stand alike, so it is the same motion; each has its own plan all the same.
    let other = plan_for(&app, right, task, model).await;
    assert_eq!(other.plan.hash(), plan.plan.hash());
    let first = left
        .reproducer
        .start(start_of(&plan, Some("k")))
        .await
        .unwrap();
    let reused = right.reproducer.start(start_of(&other, Some("k"))).await;
    assert!(
        matches!(reused, Err(ReproducingError::KeyReused)),
        "{reused:?}"
    );
    let second = right
        .reproducer
        .start(start_of(&other, None))
        .await
        .unwrap();
    assert_eq!(
        (first.robot.as_deref(), second.robot.as_deref()),
        (Some("left"), Some("right"))
    );
    let on_its_way = |view: &RobotView| view.run.is_some_and(|run| run.t_s > 0.1);
    seen(left, on_its_way).await;
    seen(right, on_its_way).await;
    let stopped = left.reproducer.stop(first.id).await.unwrap();
    assert_eq!(stopped.state, ReproductionState::Stopped);
    right.reproducer.settled().await;
    let ended = app.state.store.reproduction(second.id).await.unwrap();
    assert_eq!(ended.state, ReproductionState::Succeeded, "{ended:?}");
    app.shutdown().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn two_robots_are_recorded_at_once_and_a_shutdown_closes_both() {
    let (app, task, folder) = two().await;
    let [left, right] = app.state.arms.all() else {
        panic!("there are two robots")
    };
    let mut events = app.state.events.listen();
    let (first, _) = left.recorder.start(by_hand(task)).await.unwrap();
    let (second, _) = right.recorder.start(by_hand(task)).await.unwrap();
    assert_eq!(
        (first.robot.as_deref(), second.robot.as_deref()),
        (Some("left"), Some("right"))
    );
    heard(&mut events, |d| d.id == second.id && d.duration_s > 0.3).await;
    let ended = left.recorder.stop(first.id).await.unwrap();
    assert_eq!(ended.state, DemonstrationState::Recorded);
    state_of(left, RobotState::Idle).await;
    assert_eq!(right.robot.view().borrow().state, RobotState::Guiding);
    let (third, _) = left.recorder.start(by_hand(task)).await.unwrap();
    heard(&mut events, |d| d.id == third.id && d.samples > 0).await;
    app.shutdown().await;

    let cell = virtual_robots([String::from("left")]);
    let (app, _) = with_cell(folder.path(), &cell).await.unwrap();
    for id in [second.id, third.id] {
        let kept = app.state.store.demonstration(id).await.unwrap();
        assert_eq!(kept.state, DemonstrationState::Recorded, "{kept:?}");
        assert!(kept.note.unwrap().contains("server was stopped"));
    }
    let gone = app.state.store.demonstration(second.id).await.unwrap();
    assert_eq!(
        gone.robot.as_deref(),
        Some("right"),
        "robots may be removed"
    );
    app.shutdown().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_live_socket_shows_one_robot_and_stops_only_that_one() {
    let (app, task, _folder) = two().await;
    let [left, right] = app.state.arms.all() else {
        panic!("there are two robots")
    };
    let url = format!("{}api/v1/live?robot=right", app.url().replace("http", "ws"));
    let (mut socket, _) = connect_async(&url).await.unwrap();
    let snapshot = next(&mut socket, "snapshot").await;
    assert_eq!(snapshot["robot"]["id"], "right");
    left.recorder.start(by_hand(task)).await.unwrap();
    let (begun, _) = right.recorder.start(by_hand(task)).await.unwrap();
    let told = next(&mut socket, "demonstration").await;
    assert_eq!(told["demonstration"]["id"], begun.id.to_string());
    socket
        .send(Message::text("{\"type\": \"stop\"}"))
        .await
        .unwrap();
    state_of(right, RobotState::Idle).await;
    assert_eq!(left.robot.view().borrow().state, RobotState::Guiding);
    app.shutdown().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn thirty_two_robots_share_one_server() {
    let folder = TestFolder::new();
    let cell = virtual_robots((1..=32).map(|number| format!("arm-{number}")));
    let (app, task) = with_cell(folder.path(), &cell).await.unwrap();
    assert_eq!(app.state.arms.all().len(), 32);
    for arm in app.state.arms.all() {
        seen(arm, |view| {
            view.state == RobotState::Idle && view.joints_deg.is_some()
        })
        .await;
    }
    let mut events = app.state.events.listen();
    let last = app.state.arms.named(Some("arm-32")).unwrap();
    let (begun, _) = last.recorder.start(by_hand(task)).await.unwrap();
    heard(&mut events, |d| d.id == begun.id && d.samples > 5).await;
    let soft = app.state.arms.all().iter();
    let soft = soft.filter(|arm| arm.robot.view().borrow().state == RobotState::Guiding);
    assert_eq!(soft.count(), 1);
    app.shutdown().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_gofa_that_does_not_answer_keeps_nothing_from_starting_and_is_found_later() {
    let folder = TestFolder::new();
    // Both sockets are closed again here: nobody answers at these addresses for now.
    let rws = TcpListener::bind("127.0.0.1:0").and_then(|s| s.local_addr());
    let egm = UdpSocket::bind("127.0.0.1:0").and_then(|s| s.local_addr());
    let (rws, egm): (SocketAddr, SocketAddr) = (rws.unwrap(), egm.unwrap());
    let cell = format!(
        "{}[[robot]]\nid = \"real\"\nname = \"Real arm\"\nkind = \"gofa\"\n\
         egm_listen = \"{egm}\"\nrws_url = \"http://{rws}\"\n\
         silence_limit_ms = 1000\n",
        virtual_robots([String::from("left")])
    );
    let (app, task) = with_cell(folder.path(), &cell).await.unwrap();
    let text = announcement(&app);
    assert!(text.contains(&format!(
        "Real arm (real): a GoFa at http://{rws}, EGM on {egm}"
    )));
    let [left, real] = app.state.arms.all() else {
        panic!("there are two robots")
    };
    state_of(left, RobotState::Idle).await;
    assert_eq!(real.robot.view().borrow().state, RobotState::Disconnected);
    let refused = real.recorder.start(by_hand(task)).await.unwrap_err();
    assert!(refused.to_string().contains("not connected"), "{refused}");

    let mut controller = virtual_controller::Config::new(egm);
    controller.rws_listen = rws;
    let controller = VirtualController::start(controller).await.unwrap();
    state_of(real, RobotState::Idle).await;
    let by_itself = RecordingRequest {
        hand: Some(HandShowing {
            script: HandScript::F1,
            seed: 1,
        }),
        ..by_hand(task)
    };
    let refused = real.recorder.start(by_itself).await;
    assert!(matches!(refused, Err(RecordingError::NoVirtualHand)));
    assert_eq!(real.robot.view().borrow().state, RobotState::Idle);
    let model = trained(&app, task).await;
    let plan = plan_for(&app, real, task, model).await;
    let begun = real.reproducer.start(start_of(&plan, None)).await.unwrap();
    real.reproducer.settled().await;
    let ended = app.state.store.reproduction(begun.id).await.unwrap();
    assert_eq!(ended.robot.as_deref(), Some("real"));
    assert_eq!(ended.state, ReproductionState::Succeeded, "{ended:?}");
    app.shutdown().await;
    controller.stop().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_port_that_is_taken_is_said_with_the_robots_name_and_nothing_stays() {
    let folder = TestFolder::new();
    let taken = UdpSocket::bind("127.0.0.1:0").unwrap();
    let egm = taken.local_addr().unwrap();
    let cell = format!(
        "{}egm_listen = \"{egm}\"\n",
        virtual_robots(["left", "right"].map(String::from))
    );
    let refused = with_cell(folder.path(), &cell).await.err().unwrap();
    let words = refused.to_string();
    assert!(
        words.contains("\"right\"") && words.contains(&egm.to_string()),
        "{words}"
    );
    drop(taken);
    let (app, _) = with_cell(folder.path(), &cell).await.unwrap();
    app.shutdown().await;
}
