//! Signals that were worked while a motion was shown: a gripper, a vacuum.
//!
//! Here: what counts as a change of a signal, whether the demonstrations of a task
//! tell the same story, and where on the common time each change belongs. Not here:
//! what a signal does to the cell, and how it is set.

use serde::{Deserialize, Serialize};

use crate::{Demonstration, Error, regression::Course};

/// Most events of one demonstration.
pub const MAX_EVENTS: usize = 1_000;
/// Longest name of a signal, characters.
pub const MAX_NAME: usize = 64;

/// A signal of a demonstration: set at a moment, or (at the first sample's time) as
/// it stood when the demonstration began.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SignalEvent {
    /// The controller's name of the signal.
    pub name: String,
    /// When, on the demonstration's own clock, seconds.
    pub at_s: f64,
    /// The value from then on.
    pub on: bool,
}

/// A change of a signal that belongs to a learned motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ModelSignal {
    /// The controller's name of the signal.
    pub name: String,
    /// The value from then on.
    pub on: bool,
    /// When, as a share of the taught motion's duration, 0 to 1: the median of the
    /// demonstrations.
    pub phase: f64,
    /// Largest distance of a demonstration's own event from it, seconds of the common
    /// time.
    pub spread_s: f64,
}

/// Checks the events of a demonstration that lasts from `first_s` to `last_s` and
/// puts them in the order of time.
pub(crate) fn checked(
    name: &str,
    mut events: Vec<SignalEvent>,
    first_s: f64,
    last_s: f64,
) -> Result<Vec<SignalEvent>, Error> {
    let bad = |row: usize, reason: String| Error::BadSignal {
        name: name.into(),
        row,
        reason,
    };
    if events.len() > MAX_EVENTS {
        let reason = format!(
            "{} events; at most {MAX_EVENTS} can be learned",
            events.len()
        );
        return Err(bad(MAX_EVENTS + 1, reason));
    }
    for (i, event) in events.iter().enumerate() {
        if event.name.is_empty() || event.name.chars().count() > MAX_NAME {
            let reason = format!("its name must have 1 to {MAX_NAME} characters");
            return Err(bad(i + 1, reason));
        }
        if !(first_s..=last_s).contains(&event.at_s) {
            let reason = format!(
                "it lies at {} s, the recording lasts from {first_s} s to {last_s} s",
                event.at_s
            );
            return Err(bad(i + 1, reason));
        }
    }
    events.sort_by(|a, b| a.at_s.total_cmp(&b.at_s));
    Ok(events)
}

/// The events that change something: what only says how a signal stood at the
/// beginning (`first_s`), or sets it to what it is already, is left out.
pub(crate) fn changes(events: &[SignalEvent], first_s: f64) -> Vec<&SignalEvent> {
    let mut changes: Vec<&SignalEvent> = Vec::new();
    for (i, event) in events.iter().enumerate() {
        let before = events[..i].iter().rev().find(|e| e.name == event.name);
        let is_known = before.is_some_and(|before| before.on == event.on);
        if event.at_s > first_s && !is_known {
            changes.push(event);
        }
    }
    changes
}

/// Refuses demonstrations that do not work the same signals in the same order.
///
/// Errors: [`Error::SignalsDiffer`], naming a demonstration that tells another story
/// than most.
pub fn check_same(demonstrations: &[Demonstration]) -> Result<(), Error> {
    let stories: Vec<Vec<(&str, bool)>> = demonstrations
        .iter()
        .map(|d| {
            let changes = d.signal_changes();
            changes.iter().map(|e| (e.name.as_str(), e.on)).collect()
        })
        .collect();
    let alike = |i: usize| stories.iter().filter(|s| **s == stories[i]).count();
    // Of equally frequent stories the first one is the measure.
    let usual = (1..stories.len()).fold(0, |best, i| if alike(i) > alike(best) { i } else { best });
    match (0..stories.len()).find(|&i| stories[i] != stories[usual]) {
        None => Ok(()),
        Some(odd) => Err(Error::SignalsDiffer {
            name: demonstrations[odd].name().into(),
            does: told(&stories[odd]),
            other: demonstrations[usual].name().into(),
            other_does: told(&stories[usual]),
        }),
    }
}

fn told(story: &[(&str, bool)]) -> String {
    let steps = story.iter().map(|(name, on)| match on {
        true => format!("{name} switched on"),
        false => format!("{name} switched off"),
    });
    steps
        .reduce(|before, step| format!("{before}, then {step}"))
        .unwrap_or_else(|| "no signal is worked".into())
}

/// Where the changes that the demonstrations have in common belong. `clocks_s` holds
/// each demonstration's own time (on its own clock) at each common time `t_s`; the
/// learned motion runs over the common time as `course` says.
///
/// The demonstrations must have passed [`check_same`]. The result is in the order of
/// time: in each demonstration a later event lies later on the common time, and so do
/// the medians.
pub(crate) fn learned(
    demonstrations: &[Demonstration],
    t_s: &[f64],
    clocks_s: &[Vec<f64>],
    course: &Course,
) -> Vec<ModelSignal> {
    let changes: Vec<Vec<&SignalEvent>> = demonstrations
        .iter()
        .map(Demonstration::signal_changes)
        .collect();
    let Some(story) = changes.first() else {
        return Vec::new();
    };
    (0..story.len())
        .map(|step| {
            let mut at_s: Vec<f64> = changes
                .iter()
                .zip(clocks_s)
                .map(|(changes, clock_s)| common_time_s(t_s, clock_s, changes[step].at_s))
                .collect();
            at_s.sort_by(f64::total_cmp);
            let median_s = 0.5 * (at_s[(at_s.len() - 1) / 2] + at_s[at_s.len() / 2]);
            let spread_s = at_s
                .iter()
                .map(|t| (t - median_s).abs())
                .fold(0.0, f64::max);
            ModelSignal {
                name: story[step].name.clone(),
                on: story[step].on,
                phase: course.phase_at(median_s),
                spread_s,
            }
        })
        .collect()
}

/// The common time at which a demonstration's clock shows `own_s`: linear between
/// samples, the middle of the stretch over which the clock stands still, and held at
/// both ends. It never decreases with `own_s`.
fn common_time_s(t_s: &[f64], clock_s: &[f64], own_s: f64) -> f64 {
    let last = t_s.len() - 1;
    let below = clock_s.partition_point(|&c| c < own_s);
    let up_to = clock_s.partition_point(|&c| c <= own_s);
    if below < up_to {
        return 0.5 * (t_s[below] + t_s[up_to - 1]);
    }
    if below == 0 || below > last {
        return t_s[below.min(last)];
    }
    let (a, b) = (clock_s[below - 1], clock_s[below]);
    t_s[below - 1] + (own_s - a) / (b - a) * (t_s[below] - t_s[below - 1])
}

/// Why the signals of a model file cannot be used.
pub(crate) fn check_model(signals: &[ModelSignal]) -> Result<(), String> {
    let fits = |s: &ModelSignal| {
        !s.name.is_empty() && (0.0..=1.0).contains(&s.phase) && s.spread_s.is_finite()
    };
    if !signals.iter().all(fits) || !signals.is_sorted_by(|a, b| a.phase <= b.phase) {
        return Err("the signals do not fit the motion".into());
    }
    Ok(())
}

#[cfg(test)]
mod tests;
