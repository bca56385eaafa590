//! A recording as it is used: the stretch that was chosen of it, and which stretch is worth
//! choosing. The stored samples stay as they were recorded.

use crate::ids::DemonstrationId;
use crate::jobs::demonstration_with;
use crate::store::demonstrations::{Demonstration, DemonstrationState};
use crate::store::pauses::Pause;
use crate::store::recordings::Gap;
use crate::store::samples::Sample;
use crate::store::signals::SignalEvent;
use crate::store::trims::Trim;
use crate::store::{self, Store};

/// What has to be left of a recording at least, in seconds.
const LEAST_S: f64 = 1.0;
/// What is left of standing still at an end when it is proposed to cut it, in seconds.
const MARGIN_S: f64 = 0.3;
/// A shorter stretch of standing still is not worth a proposal, in seconds.
const WORTH_S: f64 = 0.5;
/// Proposals are rounded to what the phone's buttons step by: so many of these are a second.
const STEPS: f64 = 10.0;

/// Why a recording can't be cut like that.
#[derive(Debug, thiserror::Error)]
pub enum TrimError {
    /// The store refused.
    #[error(transparent)]
    Store(#[from] store::Error),
    /// It is not inside the recording.
    #[error("from {from_s:.1} s to {to_s:.1} s is no stretch of a recording of {duration_s:.1} s")]
    Outside {
        /// Where it was to begin.
        from_s: f64,
        /// Where it was to end.
        to_s: f64,
        /// How long the recording is.
        duration_s: f64,
    },
    /// Too little would be left.
    #[error("only {left_s:.1} s would be left; at least {LEAST_S:.0} s must remain")]
    TooLittle {
        /// How much.
        left_s: f64,
    },
    /// Nothing can be learnt from what would be left.
    #[error(transparent)]
    Learning(#[from] learning::Error),
    /// A thread broke off.
    #[error("reading broke off: {0}")]
    Broke(#[from] tokio::task::JoinError),
}

/// What was recorded. Times begin at its first sample.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Recording {
    pub(crate) samples: Vec<Sample>,
    pub(crate) signals: Vec<SignalEvent>,
    pub(crate) gaps: Vec<Gap>,
    pub(crate) pauses: Vec<Pause>,
}

/// A recording, or the stretch of it that `trim` says.
pub(crate) async fn recording(
    store: &Store,
    id: DemonstrationId,
    trim: Option<Trim>,
) -> store::Result<Recording> {
    let whole = Recording {
        samples: store.samples(id).await?,
        signals: store.signals(id).await?,
        gaps: store.gaps(id).await?,
        pauses: store.pauses(id).await?,
    };
    Ok(match trim {
        Some(trim) => whole.cut(trim),
        None => whole,
    })
}

/// Chooses which stretch of a recording is used. The whole of it is no choice.
///
/// # Errors
/// When too little is left or nothing can be learnt from it; then nothing changes.
pub(crate) async fn choose(
    store: &Store,
    id: DemonstrationId,
    wish: Trim,
) -> Result<Demonstration, TrimError> {
    let demonstration = store.demonstration(id).await?;
    let open = matches!(
        demonstration.state,
        DemonstrationState::Preparing | DemonstrationState::Recording
    );
    if !open {
        let duration_s = demonstration.duration_s;
        let Trim { from_s, to_s } = wish;
        if from_s < 0.0 || from_s >= to_s || to_s > duration_s + 1e-6 {
            return Err(TrimError::Outside {
                from_s,
                to_s,
                duration_s,
            });
        }
        if to_s - from_s < LEAST_S {
            return Err(TrimError::TooLittle {
                left_s: to_s - from_s,
            });
        }
        if from_s == 0.0 && to_s >= duration_s - 1e-6 {
            return Ok(store.set_trim(id, None).await?);
        }
        let left = recording(store, id, Some(wish)).await?;
        let name = format!("take {}", demonstration.take);
        tokio::task::spawn_blocking(move || {
            demonstration_with(&name, &left.samples, &left.signals)
        })
        .await??;
    }
    // The store refuses what is still open.
    Ok(store.set_trim(id, Some(wish)).await?)
}

/// The stretch that is left when standing still at both ends is cut; nothing when that is hardly
/// shorter, or nothing can be learnt from the recording anyway. CPU-heavy for long recordings.
pub(crate) fn proposal(whole: &Recording) -> Option<Trim> {
    let demonstration = demonstration_with("recording", &whole.samples, &whole.signals).ok()?;
    let times_s = demonstration.times_s();
    let moving = demonstration.moving();
    let (mut from_s, mut to_s) = (times_s[*moving.start()], times_s[*moving.end()]);
    // The arm stands still while a gripper works; that is part of what was shown.
    for change in demonstration.signal_changes() {
        from_s = from_s.min(change.at_s);
        to_s = to_s.max(change.at_s);
    }
    let end_s = times_s[times_s.len() - 1];
    from_s = ((from_s - MARGIN_S) * STEPS).floor() / STEPS;
    to_s = ((to_s + MARGIN_S) * STEPS).ceil() / STEPS;
    if from_s < WORTH_S {
        from_s = 0.0;
    }
    if end_s - to_s < WORTH_S {
        to_s = end_s;
    }
    let is_shorter = from_s > 0.0 || to_s < end_s;
    (is_shorter && to_s - from_s > LEAST_S).then_some(Trim { from_s, to_s })
}

impl Recording {
    /// The stretch from the first sample inside to the last, with times that begin at it.
    fn cut(self, trim: Trim) -> Self {
        let all = self.samples.len();
        let first = self.samples.partition_point(|s| s.at_us < trim.begin_us());
        let end = self.samples.partition_point(|s| s.at_us <= trim.end_us());
        let Some(kept) = self.samples.get(first..end).filter(|kept| !kept.is_empty()) else {
            return Self::default();
        };
        let begin_us = kept[0].at_us;
        // What came after the last sample is only cut away with samples.
        let last_us = if end < all {
            kept[kept.len() - 1].at_us
        } else {
            u64::MAX
        };
        let samples = kept.iter().map(|sample| Sample {
            at_us: sample.at_us - begin_us,
            ..*sample
        });
        Self {
            samples: samples.collect(),
            signals: cut_signals(self.signals, begin_us, last_us),
            gaps: self
                .gaps
                .into_iter()
                .filter_map(|gap| {
                    let (at_us, length_us) = overlap(gap.at_us, gap.length_us, begin_us, last_us)?;
                    Some(Gap { at_us, length_us })
                })
                .collect(),
            pauses: self
                .pauses
                .into_iter()
                .filter(|pause| (begin_us..=last_us).contains(&pause.at_us))
                .map(|pause| Pause {
                    at_us: pause.at_us - begin_us,
                    ..pause
                })
                .collect(),
        }
    }
}

/// How each signal stood at the beginning comes first, then what was done with them.
fn cut_signals(signals: Vec<SignalEvent>, begin_us: u64, last_us: u64) -> Vec<SignalEvent> {
    let mut left: Vec<SignalEvent> = Vec::new();
    for signal in signals {
        if signal.at_us <= begin_us {
            match left.iter_mut().find(|known| known.name == signal.name) {
                Some(known) => known.on = signal.on,
                None => left.push(SignalEvent { at_us: 0, ..signal }),
            }
        } else if signal.at_us <= last_us {
            left.push(SignalEvent {
                at_us: signal.at_us - begin_us,
                ..signal
            });
        }
    }
    left
}

/// The part of a stretch that lies between two times, counted from the first of them.
fn overlap(at_us: u64, length_us: u64, begin_us: u64, last_us: u64) -> Option<(u64, u64)> {
    let from_us = at_us.max(begin_us);
    let to_us = at_us.saturating_add(length_us).min(last_us);
    (from_us < to_us).then(|| (from_us - begin_us, to_us - from_us))
}

#[cfg(test)]
mod tests;
