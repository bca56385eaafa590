//! How much controller time has passed between two answers.
//!
//! Arrival times jitter with our scheduler; the controller's own clock does not. But a clock that
//! is not ours must not make the motion faster than time passes here, so what it claims is paid
//! from an allowance that fills up with arrival time, and what does not fit the number of
//! messages is replaced by their usual period.

use crate::header::ControllerTime;
use crate::wire::{ClockTime, RobotFeedback};

/// Messages that waited in our queue arrive together; this much may be made up for, µs.
const ALLOWANCE_US: u64 = 40_000;
/// A difference above this is no cycle but a clock that was set, µs.
const LONGEST_CYCLE_US: u64 = 1_000_000;

/// Period before one was seen, µs, and between which ones it may lie: EGM sends every 4 ms or at
/// a multiple of that.
const NOMINAL_US: u64 = 4_000;
const SHORTEST_US: u64 = 2_000;
const LONGEST_US: u64 = 30_000;
/// Share of a new period in the usual one: 1/8.
const MEMORY: u64 = 8;
/// From so many messages on the usual period is known, and only what fits it is learned.
const KNOWN_AFTER: u32 = 64;
/// How far a time may be from what the number of messages says: 30 % and 1 ms, for clocks that
/// count in milliseconds.
const SLACK_PERCENT: u64 = 30;
const SLACK_US: u64 = 1_000;

/// Keeps the time of one session.
#[derive(Debug, Clone)]
pub(super) struct Elapsed {
    measured_at: Option<ClockTime>,
    sent_at: Option<ControllerTime>,
    allowance_us: u64,
    pending_us: u64,
    period_us: u64,
    learned: u32,
}

impl Elapsed {
    pub(super) fn begin(feedback: &RobotFeedback) -> Self {
        Self {
            measured_at: feedback.feedback_time,
            sent_at: feedback.sent_at,
            allowance_us: ALLOWANCE_US,
            pending_us: 0,
            period_us: NOMINAL_US,
            learned: 0,
        }
    }

    /// Adds the time from the previous message to this one, `steps` numbers and `waited_us`
    /// after it.
    pub(super) fn advance(&mut self, feedback: &RobotFeedback, steps: u64, waited_us: u64) {
        let claimed_us = self
            .by_clock(feedback)
            .or_else(|| self.by_header(feedback))
            .unwrap_or(waited_us);
        let claimed_us = self.plausible(claimed_us, steps);
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

    /// The usual time from one message to the next, µs.
    pub(super) fn period_us(&self) -> u64 {
        self.period_us
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

    /// What the clock claims when it fits the number of messages, else their usual period.
    fn plausible(&mut self, claimed_us: u64, steps: u64) -> u64 {
        let expected_us = steps.saturating_mul(self.period_us);
        let slack_us = expected_us.saturating_mul(SLACK_PERCENT) / 100 + SLACK_US;
        let fits = claimed_us.abs_diff(expected_us) <= slack_us;
        if let Some(period_us) = claimed_us.checked_div(steps)
            && (fits || self.learned < KNOWN_AFTER)
        {
            let period_us = period_us.clamp(SHORTEST_US, LONGEST_US);
            self.period_us = (self.period_us * (MEMORY - 1) + period_us) / MEMORY;
            self.learned += u32::from(self.learned < KNOWN_AFTER);
        }
        if fits { claimed_us } else { expected_us }
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
