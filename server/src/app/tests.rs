//! The whole server with the virtual arm, on real sockets.

mod cell;
mod recording;
mod reproducing;
mod sockets;

use std::path::Path;
use std::time::Duration;

use robot::RobotState;
use tokio::sync::broadcast;
use tokio::time::timeout;

use super::{App, RunningApp};
use crate::arms::Arm;
use crate::config::{Config, RobotChoice};
use crate::events::Event;
use crate::ids::{DemonstrationId, TaskId};
use crate::recording::RecordingRequest;
use crate::store::demonstrations::Demonstration;

fn config(data: &Path, robot: RobotChoice) -> Config {
    Config {
        listen: ([127, 0, 0, 1], 0).into(),
        egm_port: 0,
        data: data.to_owned(),
        robot,
        https: false,
        config: None,
    }
}

/// The first robot, which is the only one without a configuration file.
fn arm(app: &RunningApp) -> &Arm {
    app.state.arms.that_made(None)
}

/// A server whose virtual arm is ready, and a task.
async fn with_arm(data: &Path) -> (RunningApp, TaskId) {
    let app = App::start(config(data, RobotChoice::Virtual))
        .await
        .unwrap();
    robot_is(&app, RobotState::Idle).await;
    let task = TaskId::new();
    app.state
        .store
        .create_task(task, "Drill", app.state.clock.now())
        .await
        .unwrap();
    (app, task)
}

async fn robot_is(app: &RunningApp, state: RobotState) {
    state_of(arm(app), state).await;
}

async fn state_of(arm: &Arm, state: RobotState) {
    let mut view = arm.robot.view();
    let wait = view.wait_for(|view| view.state == state);
    timeout(Duration::from_secs(20), wait)
        .await
        .unwrap()
        .unwrap();
}

/// Waits until the demonstration is heard of in a way that fits.
async fn heard(
    events: &mut broadcast::Receiver<Event>,
    fits: impl Fn(&Demonstration) -> bool,
) -> Demonstration {
    let wait = async {
        loop {
            if let Ok(Event::Demonstration { demonstration }) = events.recv().await
                && fits(&demonstration)
            {
                return demonstration;
            }
        }
    };
    timeout(Duration::from_secs(60), wait).await.unwrap()
}

fn by_hand(task_id: TaskId) -> RecordingRequest {
    RecordingRequest {
        id: DemonstrationId::new(),
        task_id,
        hand: None,
    }
}
