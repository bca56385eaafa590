//! A cell for one test: the robot side and a virtual controller of its own.

use motion::JointAngles;
use motion::gate::{ProposedMotion, approve};
use motion::limits::RobotLimits;
use motion::plan::Plan;
use robot::{
    CycleRecord, FlightEvent, Robot, RobotConfig, RobotKind, RobotState, RobotView, RunEnd,
    RunHandle, SignalSet,
};
use std::net::{Ipv4Addr, SocketAddr};
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::watch;
use virtual_controller::{Config, VirtualController};

/// Nothing in these tests takes longer.
const PATIENCE: Duration = Duration::from_secs(30);

pub const ANY_PORT: SocketAddr = SocketAddr::new(std::net::IpAddr::V4(Ipv4Addr::LOCALHOST), 0);

pub struct Cell {
    pub robot: Robot,
    pub controller: VirtualController,
    pub view: watch::Receiver<RobotView>,
}

impl Cell {
    /// Both started, connected, and idle.
    pub async fn start() -> Self {
        Self::with(|_| ()).await
    }

    /// The same with a change to the controller's configuration.
    pub async fn with(change: impl FnOnce(&mut Config)) -> Self {
        let mut config = RobotConfig::new(RobotKind::Virtual, ANY_PORT);
        config.session_timeout = Duration::from_secs(2);
        // A test machine may stand still for a while; when silence ends a run is tested apart.
        config.silence = Duration::from_secs(2);
        let robot = Robot::start(config).await.unwrap();
        let mut config = Config::new(robot.egm_addr());
        change(&mut config);
        let controller = VirtualController::start(config).await.unwrap();
        robot.connect(url(&controller)).await.unwrap();
        let view = robot.view();
        let mut cell = Self {
            robot,
            controller,
            view,
        };
        cell.wait_for_state(RobotState::Idle).await;
        cell.wait_for("the pose", |view| view.joints_deg.is_some())
            .await;
        cell
    }

    /// Waits until the view is as `wanted`.
    pub async fn wait_for(
        &mut self,
        what: &str,
        wanted: impl FnMut(&RobotView) -> bool,
    ) -> RobotView {
        let waits = tokio::time::timeout(PATIENCE, self.view.wait_for(wanted));
        match waits.await {
            Ok(view) => view.unwrap().clone(),
            Err(_) => panic!(
                "waited in vain for {what}: {:?}",
                self.robot.view().borrow()
            ),
        }
    }

    pub async fn wait_for_state(&mut self, state: RobotState) -> RobotView {
        self.wait_for(state.words(), |view| view.state == state)
            .await
    }

    pub fn pose(&self) -> JointAngles {
        JointAngles(self.view.borrow().joints_deg.unwrap())
    }

    /// A motion from where the arm stands.
    pub fn plan(&self, travel_deg: [f64; 6], duration_s: f64) -> Arc<Plan> {
        Arc::new(minimum_jerk(self.pose(), travel_deg, duration_s))
    }

    pub async fn end(self) {
        self.robot.shutdown().await;
        self.controller.stop().await;
    }
}

pub fn url(controller: &VirtualController) -> String {
    format!("http://{}", controller.rws_addr())
}

/// A run that is over, with its whole flight record.
pub struct Ended {
    pub end: RunEnd,
    pub record: Vec<CycleRecord>,
    pub events: Vec<FlightEvent>,
    pub signals: Vec<SignalSet>,
    /// Chunks that came while the run went on.
    pub chunks: usize,
}

/// Waits for the end of a run.
pub async fn outcome(mut run: RunHandle) -> Ended {
    let (mut record, mut events, mut chunks) = (Vec::new(), Vec::new(), 0);
    let ended = async {
        while let Some(chunk) = run.flight.recv().await {
            record.extend(chunk.cycles);
            events.extend(chunk.events);
            chunks += 1;
        }
        run.outcome.await.unwrap()
    };
    let outcome = tokio::time::timeout(PATIENCE, ended)
        .await
        .expect("the run must end");
    record.extend(outcome.rest.cycles);
    events.extend(outcome.rest.events);
    Ended {
        end: outcome.end,
        record,
        events,
        signals: outcome.signals,
        chunks,
    }
}

/// Waits until a run's progress is as `wanted`.
pub async fn progress(run: &mut RunHandle, wanted: impl FnMut(&robot::RunProgress) -> bool) {
    tokio::time::timeout(PATIENCE, run.progress.wait_for(wanted))
        .await
        .expect("the run must go on")
        .unwrap();
}

pub fn minimum_jerk(from: JointAngles, travel_deg: [f64; 6], duration_s: f64) -> Plan {
    let period_s = 0.004;
    let count = (duration_s / period_s).round() as usize;
    let joints = (0..=count)
        .map(|index| {
            let u = index as f64 / count as f64;
            let share = u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
            let mut joints = from;
            for (joint, travel) in joints.0.iter_mut().zip(&travel_deg) {
                *joint += share * travel;
            }
            joints
        })
        .collect();
    let motion = ProposedMotion {
        period_s,
        approach_samples: 0,
        joints,
        signals: Vec::new(),
    };
    approve(&motion, &RobotLimits::gofa5()).unwrap()
}
