//! How much controller time has passed between two answers.
//!
//! Arrival times jitter with our scheduler; the controller's own clock does not. But a clock that
//! is not ours must not make the motion faster than time passes here, so what it claims is paid
//! from an allowance that fills up with arrival time.

use crate::header::ControllerTime;
use crate::wire::{ClockTime, RobotFeedback};

/// Messages that waited in our queue arrive together; this much may be made up for, µs.
const ALLOWANCE_US: u64 = 40_000;
/// A difference above this is no cycle but a clock that was set, µs.
const LONGEST_CYCLE_US: u64 = 1_000_000;

/// Keeps the time of one session.
#[derive(Debug, Clone)]
pub(super) struct Elapsed {
    measured_at: Option<ClockTime>,
    sent_at: Option<ControllerTime>,
    allowance_us: u64,
    pending_us: u64,
}

impl Elapsed {
    pub(super) fn begin(feedback: &RobotFeedback) -> Self {
        Self {
            measured_at: feedback.feedback_time,
            sent_at: feedback.sent_at,
            allowance_us: ALLOWANCE_US,
            pending_us: 0,
        }
    }

    /// Adds the time from the previous message to this one, `waited_us` after it.
    pub(super) fn advance(&mut self, feedback: &RobotFeedback, waited_us: u64) {
        let claimed_us = self
            .by_clock(feedback)
            .or_else(|| self.by_header(feedback))
            .unwrap_or(waited_us);
        self.measured_at = feedback.feedback_time;
        self.sent_at = feedback.sent_at;
        self.allowance_us = self.allowance_us.saturating_add(waited_us).min(
            // A long wait may be passed on in one piece, but not be saved up.
            ALLOWANCE_US.max(waited_us),
        );
        let granted_us = claimed_us.min(self.allowance_us);
        self.allowance_us -= granted_us;
        self.pending_us += granted_us;
    }

    /// Time since the last answer, at most `max_us`.
    pub(super) fn pending(&self, max_us: u64) -> u64 {
        self.pending_us.min(max_us)
    }

    /// As [`Self::pending`], and starts anew: what is above `max_us` is given up.
    pub(super) fn take(&mut self, max_us: u64) -> u64 {
        let taken = self.pending(max_us);
        self.pending_us = 0;
        taken
    }

    fn by_clock(&self, feedback: &RobotFeedback) -> Option<u64> {
        let microseconds = |time: ClockTime| {
            time.seconds
                .checked_mul(1_000_000)?
                .checked_add(time.microseconds)
        };
        let before = microseconds(self.measured_at?)?;
        let now = microseconds(feedback.feedback_time?)?;
        now.checked_sub(before)
            .filter(|elapsed| (1..=LONGEST_CYCLE_US).contains(elapsed))
    }

    fn by_header(&self, feedback: &RobotFeedback) -> Option<u64> {
        let ms = feedback.sent_at?.ms_since(self.sent_at?);
        let elapsed = u64::try_from(ms).ok()? * 1000;
        (elapsed <= LONGEST_CYCLE_US).then_some(elapsed)
    }
}
