//! Hand guiding as its recorder sees it: a stream of samples, with every gap named.

use motion::JointAngles;
use serde::{Deserialize, Serialize};
use tokio::sync::mpsc;

/// Time without a sample from which on it is a gap, µs.
const GAP_US: u64 = 100_000;
/// While samples come over EGM, slower sources are left aside for this long, µs.
const EGM_FRESH_US: u64 = 100_000;
/// Samples that may wait for a slow recorder: sixteen seconds at 250 Hz.
const WAITING: usize = 4096;

/// What a recorder gets.
#[derive(Debug, Clone, PartialEq)]
pub enum GuidanceEvent {
    /// One measured pose.
    Sample(GuidanceSample),
    /// Nothing was measured, or nothing could be passed on.
    Gap {
        /// When it began, since guidance began.
        at_us: u64,
        /// How long it was.
        length_us: u64,
    },
    /// A signal was set, or something in the cell changed it.
    Signal {
        /// The controller's name of it.
        name: String,
        /// Its value from then on.
        on: bool,
        /// Since guidance began; not in step with the samples' order.
        at_us: u64,
    },
    /// Guidance is over; nothing follows.
    Ended {
        /// Why, for a person.
        reason: String,
    },
}

/// One measured pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GuidanceSample {
    /// Since guidance began; strictly increasing.
    pub at_us: u64,
    /// Measured joint angles.
    pub joints: JointAngles,
}

/// A motion the virtual hand knows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum HandScript {
    /// Pick and place at a drilling machine.
    F1,
    /// The same around an obstacle.
    F2,
    /// The same with the piece turned over.
    F3,
}

impl HandScript {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::F1 => "f1",
            Self::F2 => "f2",
            Self::F3 => "f3",
        }
    }
}

/// What the virtual hand is to do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum HandCommand {
    /// Bring the arm to the start of a script.
    Return {
        /// The script.
        script: HandScript,
        /// Draws the take's variation.
        seed: u64,
    },
    /// Show the script's motion.
    Show {
        /// The script.
        script: HandScript,
        /// Draws the take's variation.
        seed: u64,
    },
    /// Lead the arm to these joint angles, and let go unless others follow within 300 ms.
    Lead(JointAngles),
    /// Let go of the arm that it leads.
    LetGo,
}

/// What the virtual hand does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum HandActivity {
    /// Nothing.
    Idle,
    /// It brings the arm to a start.
    Returning,
    /// It shows a motion.
    Showing,
    /// It leads the arm where it is told.
    Leading,
}

impl From<rws::virtual_hand::HandState> for HandActivity {
    fn from(state: rws::virtual_hand::HandState) -> Self {
        match state {
            rws::virtual_hand::HandState::Idle => Self::Idle,
            rws::virtual_hand::HandState::Returning => Self::Returning,
            rws::virtual_hand::HandState::Showing => Self::Showing,
            rws::virtual_hand::HandState::Leading => Self::Leading,
        }
    }
}

/// Where a sample was measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Source {
    Egm,
    WebServices,
}

/// The sending end of one guidance.
#[derive(Debug)]
pub(crate) struct GuidanceStream {
    events: mpsc::Sender<GuidanceEvent>,
    began_us: u64,
    last_us: Option<u64>,
    last_egm_us: Option<u64>,
    ended: Option<String>,
}

impl GuidanceStream {
    /// Begins at `began_us` of the program's time.
    pub(crate) fn begin(began_us: u64) -> (Self, mpsc::Receiver<GuidanceEvent>) {
        // One place is kept for the end.
        let (events, receiver) = mpsc::channel(WAITING + 1);
        let stream = Self {
            events,
            began_us,
            last_us: None,
            last_egm_us: None,
            ended: None,
        };
        (stream, receiver)
    }

    /// Passes on one pose measured at `at_us` of the program's time. Never waits: what a recorder
    /// is too slow for becomes a gap.
    pub(crate) fn offer(&mut self, at_us: u64, joints: JointAngles, source: Source) {
        let Some(at_us) = at_us.checked_sub(self.began_us) else {
            return;
        };
        match source {
            Source::Egm => self.last_egm_us = Some(at_us),
            Source::WebServices => {
                let egm_is_fresh = self
                    .last_egm_us
                    .is_some_and(|last| at_us.saturating_sub(last) < EGM_FRESH_US);
                if egm_is_fresh {
                    return;
                }
            }
        }
        let last_us = self.last_us.unwrap_or(0);
        if self.last_us.is_some() && at_us <= last_us {
            return;
        }
        // Sending needs two places when there is a gap, and one is kept for the end.
        if self.events.capacity() < 3 {
            return;
        }
        let length_us = at_us - last_us;
        if length_us > GAP_US {
            self.send(GuidanceEvent::Gap {
                at_us: last_us,
                length_us,
            });
        }
        self.last_us = Some(at_us);
        self.send(GuidanceEvent::Sample(GuidanceSample { at_us, joints }));
    }

    /// Passes on a change of a signal at `at_us` of the program's time.
    pub(crate) fn signal(&self, at_us: u64, name: &str, on: bool) {
        // The last place is kept for the end.
        if self.events.capacity() > 1 {
            self.send(GuidanceEvent::Signal {
                name: name.to_owned(),
                on,
                at_us: at_us.saturating_sub(self.began_us),
            });
        }
    }

    /// Says why guidance is over. Only the first reason counts.
    pub(crate) fn end(&mut self, reason: &str) {
        if self.ended.is_none() {
            self.ended = Some(reason.to_owned());
            self.send(GuidanceEvent::Ended {
                reason: reason.to_owned(),
            });
        }
    }

    fn send(&self, event: GuidanceEvent) {
        // A recorder that has gone away does not end the guidance: the arm may be led without
        // being recorded.
        let _ = self.events.try_send(event);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const POSE: JointAngles = JointAngles([1.0; 6]);

    fn drain(receiver: &mut mpsc::Receiver<GuidanceEvent>) -> Vec<GuidanceEvent> {
        std::iter::from_fn(|| receiver.try_recv().ok()).collect()
    }

    fn sample(at_us: u64) -> GuidanceEvent {
        GuidanceEvent::Sample(GuidanceSample {
            at_us,
            joints: POSE,
        })
    }

    #[test]
    fn times_count_from_the_beginning_and_never_go_back() {
        let (mut stream, mut receiver) = GuidanceStream::begin(1_000);
        for at_us in [900, 1_500, 1_500, 1_400, 11_500] {
            stream.offer(at_us, POSE, Source::WebServices);
        }
        assert_eq!(drain(&mut receiver), [sample(500), sample(10_500)]);
    }

    #[test]
    fn a_gap_is_named_with_its_place_and_length() {
        let (mut stream, mut receiver) = GuidanceStream::begin(0);
        stream.offer(10_000, POSE, Source::WebServices);
        stream.offer(160_000, POSE, Source::WebServices);
        let gap = GuidanceEvent::Gap {
            at_us: 10_000,
            length_us: 150_000,
        };
        assert_eq!(drain(&mut receiver), [sample(10_000), gap, sample(160_000)]);
    }

    #[test]
    fn egm_samples_take_precedence_while_they_come() {
        let (mut stream, mut receiver) = GuidanceStream::begin(0);
        stream.offer(10_000, POSE, Source::Egm);
        stream.offer(12_000, POSE, Source::WebServices);
        stream.offer(14_000, POSE, Source::Egm);
        stream.offer(120_000, POSE, Source::WebServices);
        let kept: Vec<_> = drain(&mut receiver)
            .into_iter()
            .filter(|event| matches!(event, GuidanceEvent::Sample(_)))
            .collect();
        assert_eq!(kept, [sample(10_000), sample(14_000), sample(120_000)]);
    }

    #[test]
    fn a_recorder_that_is_too_slow_gets_a_gap_and_always_the_end() {
        let (mut stream, mut receiver) = GuidanceStream::begin(0);
        for index in 1..=(WAITING as u64 + 500) {
            stream.offer(index * 4_000, POSE, Source::Egm);
        }
        stream.end("stopped");
        let events = drain(&mut receiver);
        let end = GuidanceEvent::Ended {
            reason: "stopped".to_owned(),
        };
        assert_eq!(events.last(), Some(&end));
        let (mut stream, mut receiver) = GuidanceStream::begin(0);
        for index in 1..=(WAITING as u64 + 500) {
            stream.offer(index * 4_000, POSE, Source::Egm);
        }
        receiver.try_recv().unwrap();
        receiver.try_recv().unwrap();
        stream.offer(40_000_000, POSE, Source::Egm);
        let events = drain(&mut receiver);
        assert!(
            events
                .iter()
                .any(|event| matches!(event, GuidanceEvent::Gap { .. }))
        );
    }
}
