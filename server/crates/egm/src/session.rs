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
//! - Setpoints are refused until somebody arms the session. When anything about an armed session
//!   looks odd it must be brought to rest: setpoints go through for a moment longer, because to
//!   stand still at once would be a jolt, and are refused from then on.
//! - While a session is armed, another address cannot take it over before it has fallen silent.

mod elapsed;
mod live;
mod types;

pub use types::{Answer, Beginning, Counters, Hold, Received, SessionConfig};

use crate::header::{ControllerTime, SequenceNumber};
use crate::messages::{MciState, MotorState, RapidExecState};
use crate::wire::{Correction, RobotFeedback};
use live::{Complete, Live};
use motion::plan::Setpoint;
use motion::{JointAngles, JointVelocities};
use std::net::SocketAddr;

/// The conversation with one controller.
#[derive(Debug, Clone)]
pub struct Session {
    config: SessionConfig,
    counters: Counters,
    live: Option<Live>,
    visitor: Option<Visitor>,
}

/// Whom the newest message came from and what it is told.
#[derive(Debug, Clone, Copy)]
struct Visitor {
    source: SocketAddr,
    measured: JointAngles,
    next_answer: SequenceNumber,
    /// The newest message is the visitor's.
    waits: bool,
}

impl Session {
    /// A conversation that has not begun.
    #[must_use]
    pub fn new(config: SessionConfig) -> Self {
        Self {
            config,
            counters: Counters::default(),
            live: None,
            visitor: None,
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
                live.brakes_for_us = None;
                true
            }
            _ => false,
        }
    }

    /// Whether the newest message came from someone who is no part of the session: the next answer
    /// is for them, and no setpoint goes into it.
    #[must_use]
    pub fn is_visited(&self) -> bool {
        self.visitor.is_some_and(|visitor| visitor.waits)
    }

    /// Nobody relies on the setpoints any more: they are let through for as long as the arm needs
    /// to come to rest, and refused from then on.
    pub fn release(&mut self) {
        if let Some(live) = self.live.as_mut().filter(|live| live.armed) {
            live.armed = false;
            live.brakes_for_us = Some(self.config.brake_us);
        }
    }

    /// Refuses setpoints from the next answer on; the reference stays where it is.
    pub fn disarm(&mut self) {
        if let Some(live) = &mut self.live {
            live.armed = false;
            live.brakes_for_us = None;
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
        if let Some(visitor) = &mut self.visitor {
            visitor.waits = false;
        }
        let complete = Complete::of(feedback);
        let began = self.beginning(complete.as_ref(), arrival_us, source);
        if let Some(beginning) = began {
            self.live = None;
            self.visitor = None;
            let complete = complete.as_ref()?;
            self.counters.sessions += 1;
            self.live = Some(Live::begin(complete, feedback, arrival_us, source));
            return self.received(Some(beginning), feedback, 0, false);
        }

        let live = self.live.as_mut()?;
        let moved = live.source != source;
        if moved {
            let complete = complete.as_ref()?;
            if !live.is_continued_by(complete, &self.config) {
                live.refuse(Hold::Stranger, &self.config);
                self.visit(complete, source);
                return self.received(None, feedback, 0, false);
            }
            live.source = source;
        }
        let waited_us = arrival_us.saturating_sub(live.last_arrival_us);
        let late = waited_us > self.config.late_after_us;
        self.counters.late += u64::from(late);
        live.last_arrival_us = live.last_arrival_us.max(arrival_us);
        let lost = live.take_in(complete, feedback, waited_us, &self.config);
        if moved {
            live.refuse(Hold::Moved, &self.config);
        }
        self.counters.lost += u64::from(lost.unwrap_or(0));
        self.counters.repeated += u64::from(lost.is_none());
        self.received(None, feedback, lost.unwrap_or(0), late)
    }

    /// The answer to the newest message, given the setpoint that somebody would like to send.
    /// Nothing when no session runs.
    ///
    /// A visitor is told its own pose, whatever the wish.
    pub fn answer(&mut self, wish: Option<&Setpoint>, now_ms: ControllerTime) -> Option<Answer> {
        if let Some(visitor) = self.visitor.as_mut().filter(|visitor| visitor.waits) {
            visitor.waits = false;
            let sequence = visitor.next_answer;
            visitor.next_answer = sequence.next();
            return Some(Answer {
                correction: Correction {
                    sequence,
                    sent_at: now_ms,
                    joints: visitor.measured,
                    velocities: JointVelocities::ZERO,
                },
                held: Some(Hold::Stranger),
            });
        }
        let live = self.live.as_mut()?;
        let elapsed_us = live.elapsed.take(self.config.max_advance_us);
        live.brakes_for_us = live
            .brakes_for_us
            .and_then(|left_us| left_us.checked_sub(elapsed_us));
        let verdict = match wish {
            _ if !live.may_be_commanded => Err(Hold::NotApplied),
            _ if !live.armed && live.brakes_for_us.is_none() => {
                Err(live.hold.unwrap_or(Hold::NotArmed))
            }
            None => Err(Hold::NoSetpoint),
            Some(wish) => live.check(wish, elapsed_us, &self.config).map(|()| *wish),
        };
        live.reference = match verdict {
            Ok(setpoint) => setpoint,
            Err(_) => Setpoint::at_rest(live.reference.joints),
        };
        if matches!(verdict, Err(Hold::NotFinite | Hold::Jump)) {
            live.armed = false;
            live.brakes_for_us = None;
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
        let silent = arrival_us.saturating_sub(live.last_arrival_us) > self.config.timeout_us;
        if live.source != source {
            // Anyone can send bytes to our port; only a robot's message takes a session over,
            // and only one that nobody relies on.
            let free = silent || !live.is_guided();
            return complete.filter(|_| free).map(|_| Beginning::SourceChanged);
        }
        if silent {
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
            // A single message out of order, or a gap, is no reason to let go of a moving arm.
            _ if live.is_guided() => None,
            ..0 => Some(Beginning::WentBack),
            1.. => Some(Beginning::SequenceJumped),
        }
    }

    fn visit(&mut self, complete: &Complete, source: SocketAddr) {
        let next_answer = self
            .visitor
            .filter(|visitor| visitor.source == source)
            .map_or(SequenceNumber(0), |visitor| visitor.next_answer);
        self.visitor = Some(Visitor {
            source,
            measured: complete.measured,
            next_answer,
            waits: true,
        });
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
            brakes: live.brakes_for_us.is_some(),
            lost,
            late,
            rapid_running: feedback.rapid_exec_state == Some(RapidExecState::Running),
            utilization_percent: feedback.utilization_rate,
            session_age_us: live.last_arrival_us.saturating_sub(live.began_us),
        })
    }
}

#[cfg(test)]
mod properties;
#[cfg(test)]
mod tests;
