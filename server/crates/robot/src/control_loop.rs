//! One cycle of the control loop, without socket and clock: bytes in, bytes out.
//!
//! Nothing here allocates, locks, logs or waits. What the outside needs to know goes into a
//! triple buffer and rings; a full ring loses its newest entry and counts it.

use crate::links::{Command, FeedbackSample, ThreadLinks};
use crate::player::{Orders, Player, PlayerEnd, RunPhase};
use crate::rate_limit::RateLimiter;
use crate::run::CycleRecord;
use egm::session::{Beginning, Counters, Hold, Received, Session, SessionConfig};
use egm::{ControllerTime, RobotFeedback, encode_correction, read_feedback};
use motion::JointAngles;
use motion::limits::RobotLimits;
use motion::plan::{Plan, Setpoint};
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

/// Messages that may be lost in a row without the arm being stopped. A cable loses none; what
/// is lost all the same is made up for by the reference's speed.
const LOST_TOLERATED: i32 = 3;
/// Longest time that an arm may take to come to rest on its path, µs.
const BRAKE_US: u64 = 1_500_000;

/// What the outside can see of the loop.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct LoopState {
    /// Since the start of the program.
    pub last_arrival_us: Option<u64>,
    pub measured: Option<JointAngles>,
    pub may_be_commanded: bool,
    pub counters: Counters,
    /// Datagrams that were no EGM messages.
    pub unreadable: u64,
    /// Records and samples that found their ring full.
    pub overruns: u64,
    /// The newest run, also after its end.
    pub run: Option<RunState>,
}

/// How far a run is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RunState {
    pub run: u64,
    pub phase: RunPhase,
    pub plan_t_s: f64,
    /// Since the start of the program: the zero of the run's own time line.
    pub armed_us: u64,
    pub end: Option<LoopEnd>,
}

/// Why the loop ended a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum LoopEnd {
    /// The plan's own end, a stop, or an arm that does not follow.
    Player(PlayerEnd),
    /// The arm was not where the plan begins.
    NotAtStart { distance_deg: f64 },
    /// The controller does not apply references (any more).
    NotApplied { mci_error: bool, motors_on: bool },
    /// A new session began in the middle.
    SessionBegan(Beginning),
    /// The session refused to go on.
    Held(Hold),
    /// No messages.
    Silence,
    /// Ordered by the supervisor.
    Disarmed,
    /// The loop itself failed.
    Panicked,
}

/// A run in the making.
struct Active {
    run: u64,
    stops: u64,
    armed_us: u64,
    held: bool,
    player: Player,
    /// Why the arm is being brought to rest, when nobody asked for it.
    trouble: Option<LoopEnd>,
}

/// Everything the control thread works on.
pub(crate) struct ControlLoop {
    links: ThreadLinks,
    session_config: SessionConfig,
    session: Session,
    limits: RobotLimits,
    limiter: RateLimiter,
    active: Option<Active>,
    /// Where the reference goes when nothing is played.
    rest: JointAngles,
    latest: Option<Received>,
    latest_us: u64,
    state: LoopState,
}

impl ControlLoop {
    pub(crate) fn new(links: ThreadLinks, limits: &RobotLimits, silence: Duration) -> Self {
        let session_config = SessionConfig {
            timeout_us: silence.as_micros() as u64,
            late_after_us: 10_000,
            max_lost: LOST_TOLERATED,
            max_advance_us: silence.as_micros() as u64,
            brake_us: BRAKE_US,
            // The limiter before it has a headroom of its own.
            max_speed_deg_s: limits.joint_speed_deg_s.map(|limit| limit * 1.05),
        };
        let nowhere = JointAngles([0.0; 6]);
        Self {
            links,
            session: Session::new(session_config.clone()),
            session_config,
            limits: limits.clone(),
            limiter: RateLimiter::new(limits, nowhere),
            active: None,
            rest: nowhere,
            latest: None,
            latest_us: 0,
            state: LoopState::default(),
        }
    }

    /// Takes in one datagram. Says whether it is to be answered.
    pub(crate) fn receive(&mut self, datagram: &[u8], at_us: u64, source: SocketAddr) -> bool {
        let feedback = read_feedback(datagram).unwrap_or_else(|_| {
            self.state.unreadable += 1;
            // An incomplete message makes the session hold.
            RobotFeedback::default()
        });
        let Some(received) = self.session.receive(&feedback, at_us, source) else {
            return false;
        };
        if self.session.is_visited() {
            self.bring_to_rest(LoopEnd::Held(Hold::Stranger));
            return true;
        }
        self.latest = Some(received);
        self.latest_us = at_us;
        if let Some(beginning) = received.began {
            self.end_run(LoopEnd::SessionBegan(beginning));
            self.rest_at_reference();
        } else if !received.may_be_commanded {
            self.end_run(LoopEnd::NotApplied {
                mci_error: received.mci_error,
                motors_on: received.motors_on,
            });
            self.rest_at_reference();
        } else if let Some(hold) = received.hold {
            self.bring_to_rest(LoopEnd::Held(hold));
        }
        if self.links.flags.streams() {
            let joints = received.measured;
            let sample = FeedbackSample { at_us, joints };
            self.state.overruns += u64::from(self.links.samples.push(sample).is_err());
        }
        true
    }

    /// Writes the answer to the newest datagram and returns its length.
    pub(crate) fn answer(&mut self, reply: &mut [u8]) -> Option<usize> {
        let sent_at = ControllerTime((self.latest_us / 1000) as u32);
        if self.session.is_visited() {
            let answer = self.session.answer(None, sent_at)?;
            return encode_correction(&answer.correction, reply).ok();
        }
        self.take_commands();
        let received = self.latest?;
        let elapsed_s = self.session.pending_us() as f64 * 1e-6;
        let flags = &self.links.flags;
        let now_us = self.latest_us;
        let step = self.active.as_mut().map(|active| {
            let orders = Orders {
                stop: flags.stops() != active.stops || active.trouble.is_some(),
                pause: flags.is_paused() || (active.held && !flags.is_held(now_us)),
                speed: flags.speed(),
            };
            active.player.advance(elapsed_s, &received.measured, orders)
        });
        let wish = step.map_or_else(|| Setpoint::at_rest(self.rest), |step| step.setpoint);
        let limited = self.limiter.limit(&wish, elapsed_s);
        let answer = self.session.answer(Some(&limited), sent_at)?;
        if let (Some(step), Some(active)) = (step, &self.active) {
            let record = CycleRecord {
                at_us: self.latest_us.saturating_sub(active.armed_us),
                commanded: answer.correction.joints,
                commanded_speed: answer.correction.velocities,
                measured: received.measured,
                plan_t_s: step.plan_t_s,
                phase: step.phase,
                lost: received.lost,
                late: received.late,
                motors_on: received.motors_on,
                rapid_running: received.rapid_running,
                utilization_percent: received.utilization_percent,
                held: answer.held.is_some(),
                limited: limited.joints != wish.joints,
            };
            self.state.overruns += u64::from(self.links.records.push(record).is_err());
            self.state.run = Some(RunState {
                run: active.run,
                phase: step.phase,
                plan_t_s: step.plan_t_s,
                armed_us: active.armed_us,
                end: None,
            });
        }
        if let Some(hold) = answer.held {
            self.end_run(LoopEnd::Held(hold));
            self.rest_at_reference();
        } else if let Some(end) = step.and_then(|step| step.end) {
            let trouble = self.active.as_ref().and_then(|active| active.trouble);
            self.rest = match end {
                // There is no time left but for coming to rest where the reference is.
                _ if trouble.is_some() => answer.correction.joints,
                // An arm that is held up by something must not be pushed any further.
                PlayerEnd::NotFollowing { .. } | PlayerEnd::NotSettled { .. } => received.measured,
                PlayerEnd::Completed | PlayerEnd::Stopped => answer.correction.joints,
            };
            self.end_run(trouble.unwrap_or(LoopEnd::Player(end)));
        }
        encode_correction(&answer.correction, reply).ok()
    }

    /// Called when nothing has come for a while.
    pub(crate) fn silence(&mut self, now_us: u64) {
        if now_us.saturating_sub(self.latest_us) > self.session_config.timeout_us {
            self.take_commands();
            self.end_run(LoopEnd::Silence);
            self.session.disarm();
        }
    }

    /// Called after a panic in one of the other functions: forgets the session, so that the next
    /// message is answered with its own pose, and the run.
    pub(crate) fn recover(&mut self) {
        self.session = Session::new(self.session_config.clone());
        self.latest = None;
        self.end_run(LoopEnd::Panicked);
    }

    /// Lets the outside see the loop's state.
    pub(crate) fn publish(&mut self) {
        self.state.counters = self.session.counters();
        if let Some(received) = self.latest {
            self.state.measured = Some(received.measured);
            self.state.may_be_commanded = received.may_be_commanded;
            self.state.last_arrival_us = Some(self.latest_us);
        }
        self.links.state.write(self.state);
    }

    fn take_commands(&mut self) {
        while let Ok(command) = self.links.commands.pop() {
            match command {
                Command::Disarm => {
                    self.bring_to_rest(LoopEnd::Disarmed);
                    self.session.release();
                }
                Command::Arm {
                    run,
                    stops,
                    plan,
                    held,
                } => {
                    self.end_run(LoopEnd::Disarmed);
                    self.arm(run, stops, plan, held);
                }
            }
        }
    }

    fn arm(&mut self, run: u64, stops: u64, plan: Arc<Plan>, held: bool) {
        self.state.run = Some(RunState {
            run,
            phase: RunPhase::Approach,
            plan_t_s: 0.0,
            armed_us: self.latest_us,
            end: None,
        });
        let reference = self.session.reference();
        let begin = |reference: Setpoint| Player::new(plan, reference.joints, &self.limits);
        let refusal = match reference.map(begin) {
            Some(Ok(player)) if self.session.arm() => {
                self.active = Some(Active {
                    run,
                    stops,
                    armed_us: self.latest_us,
                    held,
                    player: if held { player.waiting() } else { player },
                    trouble: None,
                });
                return;
            }
            Some(Err(distance_deg)) => LoopEnd::NotAtStart { distance_deg },
            _ => LoopEnd::NotApplied {
                mci_error: self.latest.is_some_and(|received| received.mci_error),
                motors_on: self.latest.is_some_and(|received| received.motors_on),
            },
        };
        self.set_end(refusal);
    }

    /// Something is odd, but the controller still applies what it is told: to stand still at
    /// once would be a jolt, so the run goes on along its path until it stands.
    fn bring_to_rest(&mut self, trouble: LoopEnd) {
        if let Some(active) = &mut self.active {
            active.trouble = active.trouble.or(Some(trouble));
        }
    }

    fn end_run(&mut self, end: LoopEnd) {
        let Some(active) = self.active.take() else {
            return;
        };
        self.set_end(end);
        // The supervisor holds every plan too, so that a full ring costs nothing.
        let _ = self.links.retired.push(active.player.into_plan());
    }

    fn set_end(&mut self, end: LoopEnd) {
        if let Some(run) = &mut self.state.run {
            run.end = run.end.or(Some(end));
        }
    }

    fn rest_at_reference(&mut self) {
        if let Some(reference) = self.session.reference() {
            self.rest = reference.joints;
            self.limiter.reset(reference.joints);
        }
    }
}

#[cfg(test)]
mod faults;
#[cfg(test)]
mod tests;
