//! A run: from the request over the control thread's work to its outcome.

use super::signals::RunSignals;
use super::{Done, Mode, Seen, Supervisor};
use crate::control_loop::LoopEnd;
use crate::ending;
use crate::error::{Fault, RobotError};
use crate::flight::FlightWriter;
use crate::links::Command;
use crate::player::{ALIGN_LIMIT_DEG, PlayerEnd, RunPhase};
use crate::procedures::{self, Aftermath};
use crate::run::{RunEnd, RunHandle, RunOutcome, RunProgress};
use motion::JointAngles;
use motion::plan::Plan;
use rws::ControllerState;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::{oneshot, watch};

/// A pose older than this is not where the arm stands, µs.
const POSE_AGE_US: u64 = 1_000_000;
/// Longest wait for the control thread to report an end that it was asked for: an arm at the
/// limits of its joints takes about a second to come to rest.
const THREAD_PATIENCE: Duration = Duration::from_secs(2);

/// The run in the making.
pub(super) struct RunSlot {
    id: u64,
    stops: u64,
    plan: Arc<Plan>,
    held: bool,
    stage: Stage,
    progress: watch::Sender<RunProgress>,
    outcome: oneshot::Sender<RunOutcome>,
    signals: RunSignals,
    flight: FlightWriter,
}

/// How far the run is.
enum Stage {
    /// The robot program is being started.
    Starting,
    /// It runs; the controller must begin to apply references.
    Waiting {
        /// What arrived before belongs to an older session, µs of the program's time.
        since_us: u64,
        until: Instant,
    },
    /// The control thread plays the plan.
    Moving {
        since: Instant,
        stop_by: Option<Instant>,
    },
    /// The robot program is being stopped.
    Ending(Verdict),
}

/// What is known about the end before the controller was asked.
enum Verdict {
    /// It never moved; nothing to be acknowledged.
    NotBegun(RunEnd),
    /// As the control thread saw it.
    Thread(LoopEnd),
    /// As the supervisor saw it.
    Fault(Fault),
}

impl RunSlot {
    pub(super) fn progress(&self) -> RunProgress {
        *self.progress.borrow()
    }

    pub(super) fn id(&self) -> u64 {
        self.id
    }

    pub(super) fn plan_and_signals(&mut self) -> (Arc<Plan>, &mut RunSignals) {
        (Arc::clone(&self.plan), &mut self.signals)
    }

    /// Something that happened goes on the flight record's time line.
    pub(super) fn note(&mut self, code: &'static str, message: String) {
        self.flight.event(code, message);
    }

    /// What the supervisor knows goes on the flight record's time line.
    fn record(&mut self, seen: &Seen, epoch: Instant, is_stopped: bool) {
        if let Some(run) = seen.control().run.filter(|run| run.run == self.id) {
            self.flight
                .armed(epoch + Duration::from_micros(run.armed_us));
        }
        self.flight.see_controller(seen.controller.as_ref());
        self.flight.see_speed(self.progress().speed);
        self.flight.see_hold(self.progress().held);
        if is_stopped {
            self.flight.see_stop();
        }
    }

    pub(super) fn is_stopping(&self) -> bool {
        matches!(self.stage, Stage::Ending(_)) || self.progress().phase == RunPhase::Stopping
    }
}

impl Supervisor {
    /// Accepts a run or says why not. The arm does not move before the control thread is armed.
    pub(super) fn start_run(
        &mut self,
        stops: u64,
        plan: Arc<Plan>,
        held: bool,
    ) -> Result<RunHandle, RobotError> {
        let client = self.idle_client()?;
        self.check_pose(&plan.first())?;
        self.check_signals(&plan)?;
        self.runs += 1;
        self.links.flags.set_paused(false);
        self.links.flags.set_speed(1.0);
        self.links.flags.let_go();
        let duration_s = plan.duration_s();
        let (progress, progress_out) = watch::channel(RunProgress {
            phase: RunPhase::Approach,
            t_s: 0.0,
            duration_s,
            speed: 1.0,
            paused: false,
            held: held.then_some(false),
        });
        let (outcome, outcome_out) = oneshot::channel();
        let (flight, flight_out) = FlightWriter::new();
        while self.links.records.pop().is_ok() {}
        self.mode = Mode::Run(Box::new(RunSlot {
            id: self.runs,
            stops,
            plan,
            held,
            stage: Stage::Starting,
            progress,
            outcome,
            signals: RunSignals::default(),
            flight,
        }));
        let flags = Arc::clone(&self.links.flags);
        self.operation = Some(Box::pin(async move {
            let stopped = || flags.stops() != stops;
            Done::RunBegun(procedures::begin_run(&client, stopped).await)
        }));
        self.publish();
        Ok(RunHandle {
            progress: progress_out,
            flight: flight_out,
            outcome: outcome_out,
        })
    }

    fn check_pose(&self, first: &JointAngles) -> Result<(), RobotError> {
        let (joints, _) = self
            .seen
            .joints(self.now_us())
            .filter(|(_, age_us)| *age_us < POSE_AGE_US)
            .ok_or(RobotError::PoseUnknown)?;
        let differences = joints.0.iter().zip(&first.0).map(|(a, b)| (a - b).abs());
        let farthest = differences.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
        match farthest {
            Some((joint, difference_deg)) if difference_deg > ALIGN_LIMIT_DEG => {
                Err(RobotError::ArmMoved {
                    joint,
                    difference_deg,
                })
            }
            _ => Ok(()),
        }
    }

    pub(super) fn run_begun(&mut self, result: Result<(), RobotError>) {
        let Mode::Run(slot) = &mut self.mode else {
            return;
        };
        match result {
            Ok(()) => {
                self.seen.change(Some(ControllerState::MotorsOn), false);
                slot.stage = Stage::Waiting {
                    since_us: self.epoch.elapsed().as_micros() as u64,
                    until: Instant::now() + self.config.session_timeout,
                };
                self.attend_run();
            }
            Err(error) => {
                let end = match error {
                    RobotError::Stopped => RunEnd::Stopped,
                    error => RunEnd::Failed(error.to_fault()),
                };
                self.end_run(Verdict::NotBegun(end));
            }
        }
    }

    /// Looks after the present run, if there is one.
    pub(super) fn attend_run(&mut self) {
        self.attend_signals();
        let now = Instant::now();
        let egm_is_fresh = self.seen.egm_is_fresh(self.now_us());
        let flags = &self.links.flags;
        let (stops, speed, paused) = (flags.stops(), flags.speed(), flags.is_paused());
        let is_held = flags.is_held(self.now_us());
        let Mode::Run(slot) = &mut self.mode else {
            return;
        };
        let is_stopped = stops != slot.stops;
        slot.record(&self.seen, self.epoch, is_stopped);
        slot.flight.take(&mut self.links.records);
        let verdict = match &mut slot.stage {
            Stage::Starting | Stage::Ending(_) => None,
            Stage::Waiting { .. } if is_stopped => Some(Verdict::NotBegun(RunEnd::Stopped)),
            Stage::Waiting { since_us, until } => {
                let control = self.seen.control();
                let arrived = control.last_arrival_us.is_some_and(|at| at > *since_us);
                if arrived && egm_is_fresh && control.may_be_commanded {
                    let arm = Command::Arm {
                        run: slot.id,
                        stops: slot.stops,
                        plan: Arc::clone(&slot.plan),
                        held: slot.held,
                    };
                    if self.links.commands.push(arm).is_ok() {
                        slot.stage = Stage::Moving {
                            since: now,
                            stop_by: None,
                        };
                    }
                    None
                } else {
                    (now >= *until).then(|| Verdict::Fault(ending::no_session()))
                }
            }
            Stage::Moving { since, stop_by } => {
                if is_stopped && stop_by.is_none() {
                    *stop_by = Some(now + THREAD_PATIENCE);
                }
                let overdue = stop_by.is_some_and(|by| now >= by);
                let run = self.seen.control().run.filter(|run| run.run == slot.id);
                if let Some(run) = run {
                    slot.progress.send_modify(|progress| {
                        progress.phase = run.phase;
                        progress.t_s = run.plan_t_s;
                        progress.speed = speed;
                        progress.paused = paused;
                        progress.held = slot.held.then_some(is_held);
                    });
                }
                let never_began = run.is_none() && now >= *since + THREAD_PATIENCE;
                match run.and_then(|run| run.end) {
                    // The arm has arrived, and what belongs to the end is still being set.
                    Some(LoopEnd::Player(PlayerEnd::Completed))
                        if slot.signals.are_open(&slot.plan) =>
                    {
                        is_stopped.then_some(Verdict::Thread(LoopEnd::Player(PlayerEnd::Stopped)))
                    }
                    Some(end) => Some(Verdict::Thread(end)),
                    None if overdue || never_began => Some(Verdict::Fault(ending::lost())),
                    None => {
                        let stopped_by = self.seen.controller.as_ref().and_then(ending::stopped_by);
                        stopped_by.map(Verdict::Fault)
                    }
                }
            }
        };
        if let Some(verdict) = verdict {
            self.end_run(verdict);
        }
    }

    /// Takes the arm from the control thread and stops the robot program.
    fn end_run(&mut self, verdict: Verdict) {
        let Mode::Run(slot) = &mut self.mode else {
            return;
        };
        slot.stage = Stage::Ending(verdict);
        // A full ring means that the control thread is behind: it ends the run by itself.
        let _ = self.links.commands.push(Command::Disarm);
        if let Some(client) = self.client.clone() {
            self.operation = Some(Box::pin(async move {
                Done::RunEnded(procedures::end_run(&client).await)
            }));
        }
        self.publish();
    }

    pub(super) fn run_ended(&mut self, aftermath: Aftermath) {
        let mode = std::mem::replace(&mut self.mode, Mode::Disconnected);
        let Mode::Run(mut slot) = mode else {
            self.mode = mode;
            return;
        };
        slot.flight.see_controller(aftermath.controller.as_ref());
        if let Some(state) = &aftermath.controller {
            self.seen.controller = Some(state.clone());
        }
        let (end, begun) = match slot.stage {
            Stage::Ending(Verdict::NotBegun(end)) => (end, false),
            Stage::Ending(Verdict::Thread(end)) => {
                let moved = !matches!(end, LoopEnd::NotAtStart { .. });
                (ending::run_end(end, aftermath.controller.as_ref()), moved)
            }
            Stage::Ending(Verdict::Fault(fault)) => (RunEnd::Failed(fault), true),
            // Only a run that is ending stops the program.
            Stage::Starting | Stage::Waiting { .. } | Stage::Moving { .. } => {
                (RunEnd::Failed(ending::lost()), true)
            }
        };
        let end = match slot.signals.fault.take() {
            Some(fault) => RunEnd::Failed(fault),
            None => end,
        };
        if let Err(error) = &aftermath.stopped {
            tracing::warn!(%error, "the robot program could not be stopped");
            self.unfinished.run = true;
            if matches!(error, RobotError::Controller(error) if error.is_unreachable()) {
                self.seen.connected = false;
            }
        }
        match &end {
            RunEnd::Failed(fault) => {
                tracing::error!(run.fault = fault.code, message = %fault.message, "the run failed");
            }
            end => tracing::info!(run.end = ?end, "the run is over"),
        }
        match &end {
            RunEnd::Failed(fault) if begun => self.mode = Mode::Faulted(fault.clone()),
            _ => self.come_to_rest(),
        }
        self.publish();
        let rest = slot.flight.finish(&end, &mut self.links.records);
        let _ = slot.outcome.send(RunOutcome {
            end,
            signals: slot.signals.set,
            rest,
        });
    }
}
