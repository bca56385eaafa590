//! A run as its starter sees it: a handle, its progress, its end, and the record of its cycles.

use crate::error::Fault;
use crate::flight::FlightChunk;
use crate::player::RunPhase;
use crate::signals::SignalSet;
use motion::{JointAngles, JointVelocities};
use serde::Serialize;
use tokio::sync::{mpsc, oneshot, watch};

/// A run that was accepted.
#[derive(Debug)]
pub struct RunHandle {
    /// Where it is.
    pub progress: watch::Receiver<RunProgress>,
    /// The flight record, about five chunks a second; it closes when the run is over. Whoever
    /// lags behind loses nothing for a minute and never makes the arm wait.
    pub flight: mpsc::Receiver<FlightChunk>,
    /// How it ended; sent exactly once.
    pub outcome: oneshot::Receiver<RunOutcome>,
}

/// Where a run is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RunProgress {
    /// What the arm does.
    pub phase: RunPhase,
    /// Time within the plan, s.
    pub t_s: f64,
    /// Duration of the plan, s.
    pub duration_s: f64,
    /// Speed that was asked for, as a share of the plan's.
    pub speed: f64,
    /// A person asked for a pause.
    pub paused: bool,
    /// Whether somebody holds the button; nothing when the run goes by itself.
    pub held: Option<bool>,
}

/// How a run ended.
#[derive(Debug)]
pub struct RunOutcome {
    /// The end.
    pub end: RunEnd,
    /// The signals that were set on the way.
    pub signals: Vec<SignalSet>,
    /// What of the flight record did not go through [`RunHandle::flight`] any more.
    pub rest: FlightChunk,
}

/// The ways in which a run can end.
#[derive(Debug, Clone, PartialEq)]
pub enum RunEnd {
    /// The arm stands at the end of the plan.
    Completed,
    /// A person stopped it.
    Stopped,
    /// Something went wrong.
    Failed(Fault),
}

/// One cycle of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CycleRecord {
    /// Since the run was armed.
    pub at_us: u64,
    /// Reference that was answered.
    pub commanded: JointAngles,
    /// Its speed.
    pub commanded_speed: JointVelocities,
    /// Pose in the message that was answered.
    pub measured: JointAngles,
    /// Time within the plan, s.
    pub plan_t_s: f64,
    /// What the arm was doing.
    pub phase: RunPhase,
    /// Messages missing right before this one.
    pub lost: u32,
    /// The message came late.
    pub late: bool,
    /// The controller reported motors on.
    pub motors_on: bool,
    /// The controller reported that its program runs.
    pub rapid_running: bool,
    /// How much of what the arm can do the last reference needed, percent.
    pub utilization_percent: Option<f64>,
    /// The session refused the setpoint and held instead.
    pub held: bool,
    /// The limiter had to change the setpoint.
    pub limited: bool,
}
