//! Signals: set by a person, changed by the cell, and set by a run when its plan comes to them.

use super::{Mode, Reply, Request, Supervisor};
use crate::config::RobotKind;
use crate::control_loop::{LoopEnd, RunState};
use crate::error::{Fault, RobotError};
use crate::player::{PlayerEnd, RunPhase};
use crate::signals::{self, SignalConfig, SignalSet};
use motion::plan::{Plan, PlanSignal};
use std::time::{Duration, Instant};
use tokio::sync::mpsc;

/// A signal's time of the plan counts as reached this much before, s: less than a cycle.
const REACHED_S: f64 = 1e-6;
/// Longest time for a running motion's signal.
const SET_WITHIN: Duration = Duration::from_millis(500);

/// The signals of a run: which were set, and which one is being set.
#[derive(Debug, Default)]
pub(super) struct RunSignals {
    /// How many of the plan's have been begun. It never goes back: only a plan that goes forward
    /// sets signals, and each of them once.
    begun: usize,
    in_flight: bool,
    pub set: Vec<SignalSet>,
    pub fault: Option<Fault>,
}

impl RunSignals {
    /// What the plan has come to and is not begun yet. At its end everything is due.
    fn due<'a>(&self, plan: &'a Plan, run: &RunState) -> &'a [PlanSignal] {
        let left = &plan.signals()[self.begun..];
        let count = match run.end {
            Some(LoopEnd::Player(PlayerEnd::Completed)) => left.len(),
            Some(_) => 0,
            None => left.partition_point(|signal| signal.at_s <= run.plan_t_s + REACHED_S),
        };
        &left[..count]
    }

    /// Whether a plan that is over still has to set something.
    pub(super) fn are_open(&self, plan: &Plan) -> bool {
        self.fault.is_none() && (self.in_flight || self.begun < plan.signals().len())
    }
}

/// A signal that a run had set, or not.
pub(crate) struct RunSignal {
    run: u64,
    at: Instant,
    set: SignalSet,
    result: Result<(), RobotError>,
    /// The last one of those that were due together.
    is_last: bool,
}

impl Supervisor {
    /// A person sets a signal, beside everything else.
    pub(super) fn set_signal(&mut self, name: &str, on: bool, reply: Reply<()>) {
        let (signal, client) = match self.settable(name) {
            Ok(found) => found,
            Err(error) => {
                let _ = reply.send(Err(error));
                return;
            }
        };
        let requests = self.requests.clone();
        tokio::spawn(async move {
            let at = Instant::now();
            match (
                signals::set_and_confirm(&client, &signal, on).await,
                requests.upgrade(),
            ) {
                (Err(error), _) => {
                    let _ = reply.send(Err(error));
                }
                (Ok(()), None) => {
                    let _ = reply.send(Err(RobotError::ShuttingDown));
                }
                (Ok(()), Some(requests)) => {
                    let name = signal.name;
                    let seen = Request::SignalIs {
                        name,
                        on,
                        at,
                        reply,
                    };
                    // When the supervisor is gone its caller sees the reply dropped.
                    let _ = requests.send(seen).await;
                }
            }
        });
    }

    fn settable(&self, name: &str) -> Result<(SignalConfig, rws::Client), RobotError> {
        if self.config.kind == RobotKind::None {
            return Err(RobotError::NoRobot);
        }
        let signal = self.known_signal(name)?;
        match (&self.mode, &self.client) {
            // A run sets its signals itself: nobody opens the gripper in the middle of it.
            (Mode::Run(_) | Mode::Disconnected, _) | (_, None) => Err(self.busy()),
            (_, Some(client)) => Ok((signal, client.clone())),
        }
    }

    fn known_signal(&self, name: &str) -> Result<SignalConfig, RobotError> {
        let unknown = || RobotError::SignalUnknown { name: name.into() };
        self.signals.find(name).cloned().ok_or_else(unknown)
    }

    /// Every signal of a plan must be one that may be set.
    pub(super) fn check_signals(&self, plan: &Plan) -> Result<(), RobotError> {
        plan.signals()
            .iter()
            .try_for_each(|signal| self.known_signal(&signal.name).map(|_| ()))
    }

    /// A signal stands like this since `at`, or was found so then.
    pub(super) fn see_signal(&mut self, name: &str, value: Option<bool>, at: Instant) {
        let changed = self.signals.see(name, value, at);
        let at_us = at.saturating_duration_since(self.epoch).as_micros() as u64;
        if let (true, Some(on), Mode::Guiding { stream, .. }) = (changed, value, &self.mode) {
            stream.signal(at_us, name, on);
        }
    }

    /// Sets the signals that the running plan has come to. Never waits: what is set tells later.
    pub(super) fn attend_signals(&mut self) {
        let Mode::Run(slot) = &mut self.mode else {
            return;
        };
        let run = self.seen.control().run.filter(|run| run.run == slot.id());
        let (Some(run), Some(client)) = (run, self.client.clone()) else {
            return;
        };
        // An arm that comes to a standstill works nothing any more.
        let is_stopped = slot.is_stopping() || run.phase == RunPhase::Stopping;
        let (plan, signals) = slot.plan_and_signals();
        if is_stopped || signals.in_flight || signals.fault.is_some() {
            return;
        }
        let due: Vec<(PlanSignal, Option<SignalConfig>)> = signals
            .due(&plan, &run)
            .iter()
            .map(|signal| (signal.clone(), self.signals.find(&signal.name).cloned()))
            .collect();
        if due.is_empty() {
            return;
        }
        signals.begun += due.len();
        signals.in_flight = true;
        let (id, plan_t_s, seen_at) = (slot.id(), run.plan_t_s, Instant::now());
        let requests = self.requests.clone();
        tokio::spawn(async move {
            let Some(requests) = requests.upgrade() else {
                return;
            };
            set_in_order(id, due, plan_t_s, seen_at, &client, &requests).await;
        });
    }

    /// What came of a signal that a run had to set.
    pub(super) fn run_signal_set(&mut self, done: RunSignal) {
        if done.result.is_ok() {
            self.see_signal(&done.set.name.clone(), Some(done.set.on), done.at);
        }
        let Mode::Run(slot) = &mut self.mode else {
            return;
        };
        if slot.id() != done.run {
            return;
        }
        let (_, signals) = slot.plan_and_signals();
        signals.in_flight &= !done.is_last;
        match done.result {
            Ok(()) => {
                tracing::info!(
                    signal = done.set.name,
                    on = done.set.on,
                    late_ms = 1000.0 * done.set.late_s,
                    "a signal of the motion is set"
                );
                let words = format!(
                    "Signal {} was set to {}.",
                    done.set.name,
                    u8::from(done.set.on)
                );
                signals.set.push(done.set);
                slot.note("signal_set", words);
            }
            Err(error) => {
                tracing::error!(signal = done.set.name, %error, "a signal of the motion is not set");
                signals.in_flight = false;
                signals.fault = Some(fault(&error));
                // The control thread slows down along the path and reports the standstill.
                self.links.flags.stop();
            }
        }
        self.attend_run();
        self.publish();
    }
}

/// One after the other, because the order may matter; the first failure ends it.
async fn set_in_order(
    run: u64,
    due: Vec<(PlanSignal, Option<SignalConfig>)>,
    plan_t_s: f64,
    seen_at: Instant,
    client: &rws::Client,
    requests: &mpsc::Sender<Request>,
) {
    let count = due.len();
    for (index, (signal, config)) in due.into_iter().enumerate() {
        let at = Instant::now();
        let result = match &config {
            Some(config) => in_time(client, config, signal.on).await,
            None => Err(RobotError::SignalUnknown {
                name: signal.name.clone(),
            }),
        };
        let failed = result.is_err();
        let set = SignalSet {
            late_s: (plan_t_s - signal.at_s).max(0.0) + seen_at.elapsed().as_secs_f64(),
            name: signal.name,
            on: signal.on,
            at_s: signal.at_s,
        };
        let done = RunSignal {
            run,
            at,
            set,
            result,
            is_last: index + 1 == count,
        };
        // Without a supervisor nobody moves the arm any more.
        if requests.send(Request::RunSignal(done)).await.is_err() || failed {
            return;
        }
    }
}

/// The arm goes on meanwhile: what takes too long has failed.
async fn in_time(client: &rws::Client, signal: &SignalConfig, on: bool) -> Result<(), RobotError> {
    let setting = signals::set_and_confirm(client, signal, on);
    match tokio::time::timeout(SET_WITHIN, setting).await {
        Ok(result) => result,
        Err(_) => Err(signals::not_set(signal, on)),
    }
}

fn fault(error: &RobotError) -> Fault {
    Fault::new(
        "signal_failed",
        format!("the motion was stopped because a signal could not be set: {error}"),
        "Look whether the gripper holds the part as it should. Check its signal on the FlexPendant.",
    )
}
