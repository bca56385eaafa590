//! Holding a recording up and going on with it.
//!
//! While it is held up nothing is recorded. It goes on only from where it was held up, and the time
//! between is closed up: what follows is moved by one and the same time, so nothing is invented.

use std::collections::BTreeMap;

use robot::GuidanceSample;
use tokio::time::Instant;

use super::super::RecordingError;
use super::super::orders::{Order, Ordered};
use super::{Sample, Session, SignalEvent};
use crate::store::demonstrations::Demonstration;

/// The arm goes on from where it was held up: no joint is further from it than this, in degrees.
const NEAR_DEG: f64 = 2.0;
/// Nobody brings a joint back to the very same angle. The small step that is left is given the time
/// that a slow hand takes for it, in degrees per second, so that it is no jerk in the motion.
const SLOW_DEG_S: f64 = 25.0;
/// The time between two samples when only one was taken yet, in microseconds.
const USUAL_STEP_US: u64 = 20_000;

/// Whether samples are taken, and what has to be remembered for it.
#[derive(Default)]
pub(super) struct Flow {
    state: State,
    /// The latest sample that was taken, and the time from the one before.
    last: Option<Sample>,
    step_us: Option<u64>,
    /// How each signal stands in the recording.
    standing: BTreeMap<String, bool>,
}

#[derive(Default)]
enum State {
    /// Samples are taken.
    #[default]
    Running,
    /// None are.
    Paused {
        since: Instant,
        /// Where the arm is now.
        here_deg: Option<[f64; 6]>,
        /// What was done with signals meanwhile.
        signals: BTreeMap<String, bool>,
    },
    /// The next one is taken, right after the last one before the pause.
    Resuming,
}

impl Flow {
    /// Notes a sample that was taken.
    pub(super) fn saw(&mut self, sample: &Sample) {
        if let Some(last) = self.last {
            self.step_us = Some(sample.at_us.saturating_sub(last.at_us));
        }
        self.last = Some(*sample);
    }

    /// Notes how a signal stands.
    pub(super) fn stands(&mut self, name: &str, on: bool) {
        self.standing.insert(name.to_owned(), on);
    }

    /// Whether this sample falls into a pause.
    pub(super) fn holds_up(&mut self, sample: &GuidanceSample) -> bool {
        if let State::Paused { here_deg, .. } = &mut self.state {
            *here_deg = Some(sample.joints.0);
            return true;
        }
        false
    }

    pub(super) fn is_paused(&self) -> bool {
        matches!(self.state, State::Paused { .. })
    }

    /// Notes what was done with a signal in a pause.
    pub(super) fn meanwhile(&mut self, name: String, on: bool) {
        if let State::Paused { signals, .. } = &mut self.state {
            signals.insert(name, on);
        }
    }

    /// In a pause and until the first sample after it: its place in the recording.
    pub(super) fn place_us(&self) -> Option<u64> {
        match self.state {
            State::Running => None,
            State::Paused { .. } | State::Resuming => self.last.map(|last| last.at_us),
        }
    }

    /// For the first sample after a pause: where the recording has to have begun for it to follow
    /// the last one before.
    pub(super) fn closed_up(&mut self, next: &GuidanceSample) -> Option<u64> {
        if !matches!(self.state, State::Resuming) {
            return None;
        }
        self.state = State::Running;
        let last = self.last?;
        let (_, off_deg) = furthest(&last.joints_deg, &next.joints.0);
        let step_us = self.step_us.unwrap_or(USUAL_STEP_US).max(1);
        let step_us = step_us.max((off_deg / SLOW_DEG_S * 1e6) as u64);
        Some(next.at_us.saturating_sub(last.at_us + step_us))
    }
}

impl Session {
    /// Does what somebody asks for, and tells what came of it.
    pub(super) async fn obey(&mut self, Ordered { order, reply }: Ordered) {
        let result = match order {
            Order::Pause => self.pause().await,
            Order::Resume => self.resume().await,
        };
        if let Ok(demonstration) = &result {
            self.tools.events.tell(demonstration);
        }
        // Whoever asked may be gone; the others have heard of it.
        let _ = reply.send(result);
    }

    async fn pause(&mut self) -> Result<Demonstration, RecordingError> {
        let last = self.flow.last.ok_or(RecordingError::NothingYet)?;
        if self.flow.is_paused() {
            return Ok(self.tools.store.demonstration(self.id).await?);
        }
        let new = self.uncommitted();
        let store = &self.tools.store;
        let demonstration = store
            .pause_recording(self.id, new, last.at_us, &last.joints_deg)
            .await?;
        self.committed();
        self.flow.state = State::Paused {
            since: Instant::now(),
            here_deg: None,
            signals: BTreeMap::new(),
        };
        Ok(demonstration)
    }

    async fn resume(&mut self) -> Result<Demonstration, RecordingError> {
        let State::Paused {
            since,
            here_deg,
            signals,
        } = &self.flow.state
        else {
            return Ok(self.tools.store.demonstration(self.id).await?);
        };
        let last = self.flow.last.ok_or(RecordingError::NothingYet)?;
        let here_deg = here_deg.unwrap_or(last.joints_deg);
        let (joint, off_deg) = furthest(&last.joints_deg, &here_deg);
        if off_deg > NEAR_DEG {
            return Err(RecordingError::Elsewhere { joint, off_deg });
        }
        let length_us = u64::try_from(since.elapsed().as_micros()).unwrap_or(u64::MAX);
        let store = &self.tools.store;
        let demonstration = store.resume_recording(self.id, length_us).await?;
        // What was done with a gripper in the pause was done at its place. What was undone again
        // was not.
        let standing = &self.flow.standing;
        let changed = signals
            .iter()
            .filter(|(name, on)| standing.get(*name) != Some(on))
            .map(|(name, on)| SignalEvent {
                at_us: last.at_us,
                name: name.clone(),
                on: *on,
            })
            .collect::<Vec<_>>();
        for signal in changed {
            self.flow.stands(&signal.name, signal.on);
            self.signals.push(signal);
        }
        self.flow.state = State::Resuming;
        Ok(demonstration)
    }
}

/// The joint that is furthest off, from 1, and by how much.
fn furthest(from_deg: &[f64; 6], to_deg: &[f64; 6]) -> (usize, f64) {
    let mut worst = (1, 0.0);
    for (joint, (from, to)) in from_deg.iter().zip(to_deg).enumerate() {
        let off_deg = (to - from).abs();
        if off_deg > worst.1 {
            worst = (joint + 1, off_deg);
        }
    }
    worst
}
