//! Coming and going of the controller, and a server without one.

use crate::support::{ANY_PORT, Cell, outcome, url};
use robot::{Robot, RobotConfig, RobotKind, RobotState, RunEnd};
use virtual_controller::{Config, VirtualController};

#[tokio::test(flavor = "multi_thread")]
async fn a_controller_that_goes_away_is_shown_and_comes_back_idle() {
    let mut cell = Cell::start().await;
    cell.controller
        .faults()
        .set(|faults| faults.rws_unavailable = true);
    cell.wait_for_state(RobotState::Disconnected).await;
    let aged = cell
        .wait_for("ageing joints", |view| view.age_ms > 300)
        .await;
    assert!(aged.joints_deg.is_some());
    let plan = cell.plan([1.0; 6], 2.0);
    let refusal = cell.robot.run(plan).await.unwrap_err();
    assert_eq!(refusal.code(), "robot_disconnected");
    cell.controller
        .faults()
        .set(|faults| faults.rws_unavailable = false);
    cell.wait_for_state(RobotState::Idle).await;
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn guidance_ends_when_the_controller_is_gone_and_the_arm_is_made_stiff_later() {
    let mut cell = Cell::start().await;
    let mut events = cell.robot.start_guidance().await.unwrap();
    cell.controller
        .faults()
        .set(|faults| faults.rws_unavailable = true);
    cell.wait_for_state(RobotState::Disconnected).await;
    let mut last = None;
    while let Some(event) = events.recv().await {
        last = Some(event);
    }
    assert!(matches!(last, Some(robot::GuidanceEvent::Ended { .. })));
    cell.controller
        .faults()
        .set(|faults| faults.rws_unavailable = false);
    cell.wait_for_state(RobotState::Idle).await;
    cell.wait_for("the stiff arm", |view| view.lead_through == Some(false))
        .await;
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_run_survives_the_loss_of_the_web_services() {
    let mut cell = Cell::start().await;
    let plan = cell.plan([8.0, 0.0, 0.0, 0.0, 0.0, 0.0], 3.0);
    let mut run = cell.robot.run(plan).await.unwrap();
    crate::support::progress(&mut run, |progress| progress.t_s > 0.5).await;
    cell.controller
        .faults()
        .set(|faults| faults.rws_unavailable = true);
    assert_eq!(outcome(run).await.end, RunEnd::Completed);
    cell.wait_for_state(RobotState::Disconnected).await;
    cell.controller
        .faults()
        .set(|faults| faults.rws_unavailable = false);
    cell.wait_for_state(RobotState::Idle).await;
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn without_a_robot_everything_that_needs_one_is_refused() {
    let config = RobotConfig::new(RobotKind::None, ANY_PORT);
    let robot = Robot::start(config).await.unwrap();
    assert_eq!(robot.view().borrow().state, RobotState::Disconnected);
    robot.stop();
    let codes = [
        robot.start_guidance().await.unwrap_err().code(),
        robot.stop_guidance().await.unwrap_err().code(),
        robot.reset().await.unwrap_err().code(),
    ];
    assert_eq!(codes, ["no_robot"; 3]);
    robot.shutdown().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_port_in_use_is_named() {
    let first = Robot::start(RobotConfig::new(RobotKind::None, ANY_PORT))
        .await
        .unwrap();
    let config = RobotConfig::new(RobotKind::None, first.egm_addr());
    let refusal = Robot::start(config).await.unwrap_err();
    assert_eq!(refusal.code(), "egm_port");
    let port = first.egm_addr().port().to_string();
    assert!(refusal.to_string().contains(&port), "{refusal}");
    first.shutdown().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn shutdown_stops_a_run_and_everything_afterwards_is_refused() {
    let cell = Cell::start().await;
    let plan = cell.plan([8.0, 0.0, 0.0, 0.0, 0.0, 0.0], 6.0);
    let mut run = cell.robot.run(plan.clone()).await.unwrap();
    crate::support::progress(&mut run, |progress| progress.t_s > 0.5).await;
    cell.robot.shutdown().await;
    assert_eq!(outcome(run).await.end, RunEnd::Stopped);
    let refusal = cell.robot.run(plan).await.unwrap_err();
    assert_eq!(refusal.code(), "shutting_down");
    cell.robot.shutdown().await;
    cell.controller.stop().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn the_first_controller_may_start_after_the_server() {
    let probe = std::net::TcpListener::bind(ANY_PORT).unwrap();
    let address = probe.local_addr().unwrap();
    let mut config = RobotConfig::new(RobotKind::Virtual, ANY_PORT);
    config.rws_url = Some(format!("http://{address}"));
    drop(probe);
    let robot = Robot::start(config).await.unwrap();
    let mut config = Config::new(robot.egm_addr());
    config.rws_listen = address;
    let controller = VirtualController::start(config).await.unwrap();
    assert_eq!(url(&controller), format!("http://{address}"));
    let mut cell = Cell {
        view: robot.view(),
        robot,
        controller,
    };
    cell.wait_for_state(RobotState::Idle).await;
    cell.end().await;
}
