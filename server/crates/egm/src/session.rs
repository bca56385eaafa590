//! The rules of one EGM conversation, as a state machine without sockets and without a clock.
//!
//! What lives here: when a new session begins, which reference may be answered, when a setpoint
//! must be refused, and the counting of what went wrong on the line.
//! What does not: where setpoints come from, and smoothing them; that is the robot crate.
//!
//! EGM has neither connect nor disconnect. The controller sends its state in every cycle and
//! applies the last reference it got until it gets another one, so what matters most is that no
//! answer is ever older or odder than the arm's present pose:
//!
//! - The first reference of a session is the measured pose, at rest.
//! - While the controller does not apply references (motors off, program stopped, an error, pure
//!   streaming), the reference follows the measured pose, so that nothing jumps when it begins to.
//! - Setpoints are refused until somebody arms the session, and from the moment on when anything
//!   about it looks odd.

mod elapsed;
mod types;

pub use types::{Answer, Beginning, Counters, Hold, Received, SessionConfig};

use crate::header::{ControllerTime, SequenceNumber};
use crate::messages::{MciState, MessageType, MotorState, RapidExecState};
use crate::wire::{Correction, RobotFeedback};
use elapsed::Elapsed;
use motion::plan::Setpoint;
use motion::{JointAngles, JointVelocities};
use std::net::SocketAddr;

/// The conversation with one controller.
#[derive(Debug, Clone)]
pub struct Session {
    config: SessionConfig,
    counters: Counters,
    live: Option<Live>,
}

/// A session that has begun.
#[derive(Debug, Clone)]
struct Live {
    source: SocketAddr,
    began_us: u64,
    last_arrival_us: u64,
    last_sequence: SequenceNumber,
    elapsed: Elapsed,
    measured: JointAngles,
    reference: Setpoint,
    may_be_commanded: bool,
    armed: bool,
    next_answer: SequenceNumber,
    /// What is wrong with the newest message, if anything.
    hold: Option<Hold>,
}

impl Session {
    /// A conversation that has not begun.
    #[must_use]
    pub fn new(config: SessionConfig) -> Self {
        Self {
            config,
            counters: Counters::default(),
            live: None,
        }
    }

    /// What was counted since the start of the program.
    #[must_use]
    pub fn counters(&self) -> Counters {
        self.counters
    }

    /// The reference that the controller was given last, or would be given now.
    #[must_use]
    pub fn reference(&self) -> Option<Setpoint> {
        self.live.as_ref().map(|live| live.reference)
    }

    /// Whether setpoints are followed at present.
    #[must_use]
    pub fn is_armed(&self) -> bool {
        self.live.as_ref().is_some_and(|live| live.armed)
    }

    /// Lets setpoints through from the next answer on. Says no unless a session runs in which
    /// the controller applies references.
    #[must_use]
    pub fn arm(&mut self) -> bool {
        match &mut self.live {
            Some(live) if live.may_be_commanded && live.hold.is_none() => {
                live.armed = true;
                true
            }
            _ => false,
        }
    }

    /// Refuses setpoints from the next answer on; the reference stays where it is.
    pub fn disarm(&mut self) {
        if let Some(live) = &mut self.live {
            live.armed = false;
        }
    }

    /// Takes in one message of the controller. Nothing happens, and nothing may be answered, when
    /// the message belongs to no session and cannot begin one because it lacks the measured pose.
    pub fn receive(
        &mut self,
        feedback: &RobotFeedback,
        arrival_us: u64,
        source: SocketAddr,
    ) -> Option<Received> {
        self.counters.cycles += 1;
        let complete = Complete::of(feedback);
        let began = self.beginning(complete.as_ref(), arrival_us, source);
        if let Some(beginning) = began {
            self.live = None;
            let complete = complete.as_ref()?;
            self.counters.sessions += 1;
            self.live = Some(Live::begin(complete, feedback, arrival_us, source));
            return self.received(Some(beginning), feedback, 0, false);
        }

        let live = self.live.as_mut().filter(|live| live.source == source)?;
        let waited_us = arrival_us.saturating_sub(live.last_arrival_us);
        let late = waited_us > self.config.late_after_us;
        self.counters.late += u64::from(late);
        live.last_arrival_us = live.last_arrival_us.max(arrival_us);
        let mut lost = 0;
        live.hold = match &complete {
            None => {
                live.armed = false;
                Some(Hold::Incomplete)
            }
            Some(complete) => {
                let steps = complete.sequence.steps_since(live.last_sequence);
                lost = u32::try_from(steps - 1).unwrap_or(0);
                self.counters.lost += u64::from(lost);
                self.counters.repeated += u64::from(steps == 0);
                live.last_sequence = complete.sequence;
                live.measured = complete.measured;
                live.elapsed.advance(feedback, waited_us);
                None
            }
        };
        live.see_states(feedback);
        self.received(None, feedback, lost, late)
    }

    /// The answer to the newest message, given the setpoint that somebody would like to send.
    /// Nothing when no session runs.
    pub fn answer(&mut self, wish: Option<&Setpoint>, now_ms: ControllerTime) -> Option<Answer> {
        let live = self.live.as_mut()?;
        let elapsed_us = live.elapsed.take(self.config.max_advance_us);
        let verdict = match wish {
            _ if live.hold.is_some() => Err(live.hold.unwrap_or(Hold::Incomplete)),
            _ if !live.may_be_commanded => Err(Hold::NotApplied),
            _ if !live.armed => Err(Hold::NotArmed),
            None => Err(Hold::NoSetpoint),
            Some(wish) => live.check(wish, elapsed_us, &self.config).map(|()| *wish),
        };
        live.reference = match verdict {
            Ok(setpoint) => setpoint,
            Err(_) => at_rest(live.reference.joints),
        };
        if matches!(verdict, Err(Hold::NotFinite | Hold::Jump)) {
            live.armed = false;
            self.counters.refused += 1;
        }
        let sequence = live.next_answer;
        live.next_answer = sequence.next();
        Some(Answer {
            correction: Correction {
                sequence,
                sent_at: now_ms,
                joints: live.reference.joints,
                velocities: live.reference.velocities,
            },
            held: verdict.err(),
        })
    }

    /// Time by which the next answer will be later than the last one, controller time, µs.
    #[must_use]
    pub fn pending_us(&self) -> u64 {
        self.live
            .as_ref()
            .map_or(0, |live| live.elapsed.pending(self.config.max_advance_us))
    }

    /// Whether this message begins a session, and why.
    fn beginning(
        &self,
        complete: Option<&Complete>,
        arrival_us: u64,
        source: SocketAddr,
    ) -> Option<Beginning> {
        let Some(live) = &self.live else {
            return Some(Beginning::First);
        };
        if live.source != source {
            // Anyone can send bytes to our port; only a robot's message takes the session over.
            return complete.map(|_| Beginning::SourceChanged);
        }
        if arrival_us.saturating_sub(live.last_arrival_us) > self.config.timeout_us {
            return Some(Beginning::Silence);
        }
        let sequence = complete?.sequence;
        let steps = sequence.steps_since(live.last_sequence);
        let plausible = 1..=self.config.max_lost.saturating_add(1);
        if plausible.contains(&steps) {
            // This includes the wrap of the counter, where 0 follows the largest number.
            return None;
        }
        match steps {
            _ if sequence == SequenceNumber(0) => Some(Beginning::Restarted),
            0 => None,
            ..0 => Some(Beginning::WentBack),
            1.. => Some(Beginning::SequenceJumped),
        }
    }

    fn received(
        &self,
        began: Option<Beginning>,
        feedback: &RobotFeedback,
        lost: u32,
        late: bool,
    ) -> Option<Received> {
        let live = self.live.as_ref()?;
        Some(Received {
            began,
            measured: live.measured,
            may_be_commanded: live.may_be_commanded,
            mci_error: feedback.mci_state == Some(MciState::Error),
            motors_on: feedback.motor_state == Some(MotorState::MotorsOn),
            hold: live.hold,
            lost,
            late,
            rapid_running: feedback.rapid_exec_state == Some(RapidExecState::Running),
            utilization_percent: feedback.utilization_rate,
            session_age_us: live.last_arrival_us.saturating_sub(live.began_us),
        })
    }
}

impl Live {
    fn begin(
        complete: &Complete,
        feedback: &RobotFeedback,
        arrival_us: u64,
        source: SocketAddr,
    ) -> Self {
        let mut live = Self {
            source,
            began_us: arrival_us,
            last_arrival_us: arrival_us,
            last_sequence: complete.sequence,
            elapsed: Elapsed::begin(feedback),
            measured: complete.measured,
            reference: at_rest(complete.measured),
            may_be_commanded: false,
            armed: false,
            next_answer: SequenceNumber(0),
            hold: None,
        };
        live.see_states(feedback);
        live
    }

    /// After a restart of the controller the program's state may stay undefined although it
    /// runs, therefore undefined counts as running. While nothing is applied the reference
    /// follows the arm.
    fn see_states(&mut self, feedback: &RobotFeedback) {
        let rapid_may_run = !matches!(feedback.rapid_exec_state, Some(RapidExecState::Stopped));
        self.may_be_commanded = feedback.motor_state == Some(MotorState::MotorsOn)
            && feedback.mci_state == Some(MciState::Running)
            && feedback.rapid_exec_state.is_some()
            && rapid_may_run;
        if !self.may_be_commanded {
            self.armed = false;
            self.reference = at_rest(self.measured);
        }
    }

    /// The last line of defence: what is checked here should never fail, because the setpoint
    /// went through the gate, the player and the limiter before.
    fn check(&self, wish: &Setpoint, elapsed_us: u64, config: &SessionConfig) -> Result<(), Hold> {
        if !wish.joints.is_finite() || !wish.velocities.is_finite() {
            return Err(Hold::NotFinite);
        }
        let elapsed_s = elapsed_us as f64 * 1e-6;
        let moves = wish.joints.0.iter().zip(&self.reference.joints.0);
        let too_far = moves
            .zip(&config.max_speed_deg_s)
            .any(|((to, from), max)| (to - from).abs() > config.largest_step_deg(*max, elapsed_s));
        let too_fast = wish
            .velocities
            .0
            .iter()
            .zip(&config.max_speed_deg_s)
            .any(|(speed, max)| speed.abs() > max * (1.0 + SessionConfig::MARGIN));
        if too_far || too_fast {
            return Err(Hold::Jump);
        }
        Ok(())
    }
}

/// What a message must hold to be of any use.
struct Complete {
    sequence: SequenceNumber,
    measured: JointAngles,
}

impl Complete {
    fn of(feedback: &RobotFeedback) -> Option<Self> {
        let from_robot = feedback.message_type == Some(MessageType::Data);
        let measured = feedback.feedback.filter(JointAngles::is_finite)?;
        let sequence = feedback.sequence?;
        from_robot.then_some(Self { sequence, measured })
    }
}

fn at_rest(joints: JointAngles) -> Setpoint {
    Setpoint {
        joints,
        velocities: JointVelocities::ZERO,
    }
}

#[cfg(test)]
mod properties;
#[cfg(test)]
mod tests;
