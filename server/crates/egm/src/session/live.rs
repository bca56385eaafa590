//! A session that has begun: what one message does to it, and which setpoints it lets through.

use super::elapsed::Elapsed;
use super::types::{Hold, SessionConfig};
use crate::header::SequenceNumber;
use crate::messages::{MciState, MessageType, MotorState, RapidExecState};
use crate::wire::RobotFeedback;
use motion::JointAngles;
use motion::plan::Setpoint;
use std::net::SocketAddr;

/// A session that has begun.
#[derive(Debug, Clone)]
pub(super) struct Live {
    pub(super) source: SocketAddr,
    pub(super) began_us: u64,
    pub(super) last_arrival_us: u64,
    pub(super) last_sequence: SequenceNumber,
    /// Messages since then that could not be used.
    pub(super) skipped: i32,
    pub(super) elapsed: Elapsed,
    pub(super) measured: JointAngles,
    pub(super) reference: Setpoint,
    pub(super) may_be_commanded: bool,
    pub(super) armed: bool,
    /// For how much longer, in the arm's own time, setpoints go through although the session is
    /// not armed any more.
    pub(super) brakes_for_us: Option<u64>,
    pub(super) next_answer: SequenceNumber,
    /// What is wrong with the newest message, if anything.
    pub(super) hold: Option<Hold>,
}

impl Live {
    pub(super) fn begin(
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
            skipped: 0,
            elapsed: Elapsed::begin(feedback),
            measured: complete.measured,
            reference: Setpoint::at_rest(complete.measured),
            may_be_commanded: false,
            armed: false,
            brakes_for_us: None,
            next_answer: SequenceNumber(0),
            hold: None,
        };
        live.see_states(feedback);
        live
    }

    /// Somebody relies on the references that this session is given.
    pub(super) fn is_guided(&self) -> bool {
        self.armed || self.brakes_for_us.is_some()
    }

    /// Ends being armed because of something odd; the arm may be brought to rest.
    pub(super) fn refuse(&mut self, hold: Hold, config: &SessionConfig) {
        self.hold = Some(hold);
        if self.armed {
            self.armed = false;
            self.brakes_for_us = Some(config.brake_us);
        }
    }

    /// Takes in a message of this session. Says how many are missing before it; nothing when it
    /// is none that goes on counting.
    pub(super) fn take_in(
        &mut self,
        complete: Option<Complete>,
        feedback: &RobotFeedback,
        waited_us: u64,
        config: &SessionConfig,
    ) -> Option<u32> {
        self.hold = None;
        let lacks_states = feedback.motor_state.is_none()
            || feedback.mci_state.is_none()
            || feedback.rapid_exec_state.is_none();
        let Some(complete) = complete.filter(|_| !(lacks_states && self.is_guided())) else {
            self.refuse(Hold::Incomplete, config);
            self.pass_without_number(feedback, waited_us);
            return Some(0);
        };
        let steps = complete.sequence.steps_since(self.last_sequence);
        if steps < 0 {
            // It says what was, not what is.
            self.refuse(Hold::OutOfOrder, config);
            return Some(0);
        }
        if steps == 0 {
            if self.pass_without_number(feedback, waited_us) {
                self.refuse(Hold::OutOfOrder, config);
            }
            return None;
        }
        let lost = steps - 1 - self.skipped.min(steps);
        self.elapsed.advance(
            feedback,
            (steps - self.skipped.min(steps)) as u64,
            waited_us,
        );
        self.skipped = 0;
        self.last_sequence = complete.sequence;
        if lost > config.max_lost {
            self.refuse(Hold::Gap, config);
        }
        if self.is_guided() && !self.can_have_gone_to(&complete.measured, steps, waited_us, config)
        {
            self.refuse(Hold::Implausible, config);
        } else {
            self.measured = complete.measured;
        }
        self.see_states(feedback);
        u32::try_from(lost).ok()
    }

    /// A message whose number says nothing. It stands for a cycle of its own when about as much
    /// time has passed; a copy does not.
    fn pass_without_number(&mut self, feedback: &RobotFeedback, waited_us: u64) -> bool {
        let own_cycle = waited_us >= self.elapsed.period_us() / 2;
        if own_cycle {
            self.elapsed.advance(feedback, 1, waited_us);
            self.skipped = self.skipped.saturating_add(1);
        }
        own_cycle
    }

    /// Whether a message from another address can only be this arm's next one.
    pub(super) fn is_continued_by(&self, next: &Complete, config: &SessionConfig) -> bool {
        let steps = next.sequence.steps_since(self.last_sequence);
        (1..=config.max_lost.saturating_add(1)).contains(&steps)
            && self.can_have_gone_to(&next.measured, steps, 0, config)
    }

    /// Whether the arm can have gone from where it was to `to` within so many cycles, or in the
    /// time that has passed here meanwhile: a controller that was held up sends one message for
    /// all that time.
    pub(super) fn can_have_gone_to(
        &self,
        to: &JointAngles,
        steps: i32,
        waited_us: u64,
        config: &SessionConfig,
    ) -> bool {
        let period_s = self.elapsed.period_us() as f64 * 1e-6;
        let time_s = period_s + (f64::from(steps) * period_s).max(waited_us as f64 * 1e-6);
        let ways = to.0.iter().zip(&self.measured.0);
        ways.zip(&config.max_speed_deg_s)
            .all(|((to, from), max)| (to - from).abs() <= max * time_s)
    }

    /// After a restart of the controller the program's state may stay undefined although it
    /// runs, therefore undefined counts as running. While nothing is applied the reference
    /// follows the arm.
    pub(super) fn see_states(&mut self, feedback: &RobotFeedback) {
        let rapid_may_run = !matches!(feedback.rapid_exec_state, Some(RapidExecState::Stopped));
        self.may_be_commanded = feedback.motor_state == Some(MotorState::MotorsOn)
            && feedback.mci_state == Some(MciState::Running)
            && feedback.rapid_exec_state.is_some()
            && rapid_may_run;
        if !self.may_be_commanded {
            self.armed = false;
            self.brakes_for_us = None;
            self.reference = Setpoint::at_rest(self.measured);
        }
    }

    /// The last line of defence: what is checked here should never fail, because the setpoint
    /// went through the gate, the player and the limiter before.
    pub(super) fn check(
        &self,
        wish: &Setpoint,
        elapsed_us: u64,
        config: &SessionConfig,
    ) -> Result<(), Hold> {
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
pub(super) struct Complete {
    pub(super) sequence: SequenceNumber,
    pub(super) measured: JointAngles,
}

impl Complete {
    pub(super) fn of(feedback: &RobotFeedback) -> Option<Self> {
        let from_robot = feedback.message_type == Some(MessageType::Data);
        let measured = feedback.feedback.filter(JointAngles::is_finite)?;
        let sequence = feedback.sequence?;
        from_robot.then_some(Self { sequence, measured })
    }
}
