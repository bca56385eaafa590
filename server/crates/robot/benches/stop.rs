//! How soon the arm slows down after Stop: from the moment the server has it to the first answer
//! that is on its way to standstill.
//!
//! `cargo bench -p robot --bench stop -- [STOPS]`: motions of a virtual arm, each stopped at
//! another instant of its cycle, with and without real-time priority, while every core computes at
//! the priority of a training.

mod load;

use motion::JointAngles;
use motion::gate::{ProposedMotion, approve};
use motion::limits::RobotLimits;
use motion::plan::Plan;
use robot::{CycleRecord, Robot, RobotConfig, RobotKind, RobotState, RunPhase};
use std::net::{Ipv4Addr, SocketAddr};
use std::sync::Arc;
use std::time::{Duration, Instant};
use virtual_controller::{Config, VirtualController};

const LOCAL: SocketAddr = SocketAddr::new(std::net::IpAddr::V4(Ipv4Addr::LOCALHOST), 0);
const TRAVEL_DEG: f64 = 20.0;
const DURATION_S: f64 = 3.0;

fn main() {
    let stops = load::argument(40);
    let runtime = load::runtime();
    let _load = load::Load::on_every_core();
    println!("priority  stops  ms to the first slower answer: median  largest  answers before it");
    for real_time in [true, false] {
        runtime.block_on(measure(real_time, stops));
    }
}

async fn measure(real_time: bool, stops: u32) {
    let mut config = RobotConfig::new(RobotKind::Virtual, LOCAL);
    config.real_time = real_time;
    config.silence = Duration::from_secs(2);
    let robot = Robot::start(config).await.expect("a robot");
    let controller = VirtualController::start(Config::new(robot.egm_addr()));
    let controller = controller.await.expect("an arm");
    let url = format!("http://{}", controller.rws_addr());
    robot.connect(url).await.expect("a connection");
    let mut view = robot.view();
    let (mut waits_ms, mut most_before) = (Vec::new(), 0);
    for stop in 0..stops {
        let idle =
            view.wait_for(|view| view.state == RobotState::Idle && view.joints_deg.is_some());
        let from = JointAngles(idle.await.expect("the arm").joints_deg.expect("its pose"));
        let towards = if from.0[5] > 0.0 { -1.0 } else { 1.0 };
        let plan = plan(from, towards * TRAVEL_DEG);
        let mut run = robot.run(Arc::new(plan)).await.expect("a run");
        // Another instant of the cycle each time: the golden ratio spreads them evenly.
        let share = (f64::from(stop) * 0.618_034).fract();
        let far = 1.2 + 0.004 * share;
        let under_way = run.progress.wait_for(|progress| progress.t_s > far);
        under_way.await.expect("the run goes on");
        tokio::time::sleep(Duration::from_secs_f64(0.004 * share)).await;
        let at = Instant::now();
        robot.stop();
        let (mut armed, mut record) = (None, Vec::new());
        while let Some(chunk) = run.flight.recv().await {
            armed = armed.or(chunk.armed);
            record.extend(chunk.cycles);
        }
        let outcome = run.outcome.await.expect("an end");
        armed = armed.or(outcome.rest.armed);
        record.extend(outcome.rest.cycles);
        let armed = armed.expect("the run was armed");
        let (wait, before) = reaction(&record, at.saturating_duration_since(armed));
        waits_ms.push(wait.as_secs_f64() * 1e3);
        most_before = most_before.max(before);
    }
    waits_ms.sort_by(f64::total_cmp);
    println!(
        "{:8}  {stops:5}  {:36.2}  {:7.2}  {most_before:17}",
        if view.borrow().egm.real_time {
            "FIFO"
        } else {
            "raised"
        },
        waits_ms[waits_ms.len() / 2],
        waits_ms[waits_ms.len() - 1],
    );
    robot.shutdown().await;
    controller.stop().await;
}

/// From the stop to the arrival of the message whose answer was slower, and how many messages
/// that arrived after the stop were answered as if there had been none.
fn reaction(record: &[CycleRecord], stop: Duration) -> (Duration, usize) {
    let after = |cycle: &&CycleRecord| Duration::from_micros(cycle.at_us) > stop;
    let slower = |cycle: &CycleRecord| cycle.phase == RunPhase::Stopping;
    let first = record
        .iter()
        .find(|cycle| slower(cycle))
        .expect("it stopped");
    let before = record
        .iter()
        .filter(after)
        .take_while(|cycle| !slower(cycle));
    let wait = Duration::from_micros(first.at_us).saturating_sub(stop);
    (wait, before.count())
}

fn plan(from: JointAngles, travel_deg: f64) -> Plan {
    let period_s = 0.004;
    let count = (DURATION_S / period_s).round() as usize;
    let joints = (0..=count)
        .map(|index| {
            let u = index as f64 / count as f64;
            let mut joints = from;
            joints.0[5] += travel_deg * u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
            joints
        })
        .collect();
    let motion = ProposedMotion {
        period_s,
        approach_samples: 0,
        joints,
        signals: Vec::new(),
    };
    approve(&motion, &RobotLimits::gofa5()).expect("a legal motion")
}
