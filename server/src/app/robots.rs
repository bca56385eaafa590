//! Starting the robots of the cell: the real-time side of each, and the virtual arms.
//!
//! A controller that does not answer keeps nothing from starting: its arm shows as disconnected,
//! and it is asked again until it answers.

use robot::{Robot, RobotError, RobotKind};
use tracing::Instrument;
use virtual_controller::VirtualController;

use super::StartError;
use crate::arms::StartedRobot;
use crate::cell::RobotSettings;

/// Starts every robot, and for each virtual one its arm.
pub(super) async fn start(
    settings: &[RobotSettings],
) -> Result<(Vec<StartedRobot>, Vec<VirtualController>), StartError> {
    let (mut robots, mut virtual_arms) = (Vec::new(), Vec::new());
    for one in settings {
        let refused = |error: RobotError| StartError::Robot {
            robot: one.id.clone(),
            error,
        };
        let span = tracing::info_span!("robot", id = one.id);
        let starting = Robot::start(one.robot_config()).instrument(span);
        let robot = starting.await.map_err(refused)?;
        if one.kind == RobotKind::Virtual {
            let arm = virtual_controller::Config::new(robot.egm_addr());
            let arm =
                VirtualController::start(arm)
                    .await
                    .map_err(|source| StartError::VirtualArm {
                        robot: one.id.clone(),
                        source,
                    })?;
            let rws_url = format!("http://{}", arm.rws_addr());
            robot.connect(rws_url).await.map_err(refused)?;
            virtual_arms.push(arm);
        }
        robots.push(StartedRobot {
            id: one.id.clone(),
            name: one.name.clone(),
            limits: one.limits.clone(),
            continuous_run: one.continuous_run,
            robot,
        });
    }
    Ok((robots, virtual_arms))
}
