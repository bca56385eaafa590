//! The whole robot side over HTTPS, with the controller's certificate pinned.

use crate::support::{ANY_PORT, Cell, outcome};
use robot::{Robot, RobotConfig, RobotKind, RobotState, RunEnd};
use std::net::UdpSocket;
use std::time::Duration;
use virtual_controller::{Config, VirtualController};

/// A controller with HTTPS, and the robot side's configuration for it.
async fn controller() -> (VirtualController, RobotConfig) {
    let probe = UdpSocket::bind(ANY_PORT).unwrap();
    let egm = probe.local_addr().unwrap();
    let mut config = Config::new(egm);
    config.rws_https = true;
    let controller = VirtualController::start(config).await.unwrap();
    let mut robot = RobotConfig::new(RobotKind::Virtual, egm);
    robot.rws_url = Some(controller.rws_url());
    robot.rws_certificate_sha256 = controller.certificate_sha256().map(str::to_owned);
    robot.session_timeout = Duration::from_secs(2);
    robot.silence = Duration::from_secs(2);
    (controller, robot)
}

#[tokio::test(flavor = "multi_thread")]
async fn a_motion_runs_with_the_controller_whose_certificate_is_pinned() {
    let (controller, config) = controller().await;
    let robot = Robot::start(config).await.unwrap();
    let mut cell = Cell {
        view: robot.view(),
        robot,
        controller,
    };
    cell.wait_for_state(RobotState::Idle).await;
    cell.wait_for("the pose", |view| view.joints_deg.is_some())
        .await;
    let plan = cell.plan([5.0, 0.0, 0.0, 0.0, 0.0, 0.0], 2.0);
    let run = cell.robot.run(plan).await.unwrap();
    assert_eq!(outcome(run).await.end, RunEnd::Completed);
    cell.end().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_fingerprint_that_is_none_is_refused() {
    let (controller, mut config) = controller().await;
    config.rws_certificate_sha256 = Some("AA:BB".to_owned());
    let url = config.rws_url.take().unwrap();
    let robot = Robot::start(config).await.unwrap();
    let refusal = robot.connect(url).await.unwrap_err();
    assert_eq!(refusal.code(), "robot_fingerprint");
    robot.shutdown().await;
    controller.stop().await;
}
