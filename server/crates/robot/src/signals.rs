//! The signals that people may work: which there are, how they stand, and setting one so that
//! it is certain.
//!
//! Not here: when a signal is set (`supervisor::signals`), and what it moves in the cell.

use crate::error::RobotError;
use rws::{Client, RwsError};
use serde::{Deserialize, Serialize};
use std::time::{Duration, Instant};

/// Longest wait for a signal to read as it was set.
const SETTLED_WITHIN: Duration = Duration::from_millis(500);
const POLL: Duration = Duration::from_millis(10);

/// A digital signal that people may work.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct SignalConfig {
    /// The controller's name of it. Its access level must let clients write it.
    pub name: String,
    /// What people call it.
    pub label: String,
    /// What setting it does, as a verb: "close".
    pub on: String,
    /// What resetting it does: "open".
    pub off: String,
}

impl SignalConfig {
    /// The gripper of the virtual GoFa.
    #[must_use]
    pub fn virtual_gripper() -> Self {
        Self {
            name: "GripperClose".into(),
            label: "Gripper".into(),
            on: "close".into(),
            off: "open".into(),
        }
    }
}

/// A signal as it stands.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct SignalView {
    /// Which one.
    #[serde(flatten)]
    pub signal: SignalConfig,
    /// Its value; nothing while it is not known.
    pub is_on: Option<bool>,
}

/// A signal that a run has set.
#[derive(Debug, Clone, PartialEq)]
pub struct SignalSet {
    /// The controller's name of it.
    pub name: String,
    /// Its value.
    pub on: bool,
    /// When it was due, time within the plan, s.
    pub at_s: f64,
    /// How long after that the controller had it, s.
    pub late_s: f64,
}

/// The newest values of the configured signals.
#[derive(Debug)]
pub(crate) struct SignalBoard {
    known: Vec<(SignalView, Option<Instant>)>,
}

impl SignalBoard {
    pub(crate) fn new(signals: &[SignalConfig]) -> Self {
        let known = signals.iter().map(|signal| {
            let signal = signal.clone();
            let view = SignalView {
                signal,
                is_on: None,
            };
            (view, None)
        });
        Self {
            known: known.collect(),
        }
    }

    pub(crate) fn names(&self) -> Vec<String> {
        let names = self.known.iter().map(|(view, _)| view.signal.name.clone());
        names.collect()
    }

    pub(crate) fn views(&self) -> Vec<SignalView> {
        self.known.iter().map(|(view, _)| view.clone()).collect()
    }

    pub(crate) fn find(&self, name: &str) -> Option<&SignalConfig> {
        let mut signals = self.known.iter().map(|(view, _)| &view.signal);
        signals.find(|signal| signal.name == name)
    }

    /// Takes in a value that was asked for (or set) at `at`. Says whether it is a change: not
    /// when it is the first that is known, nor when a newer one is known already.
    pub(crate) fn see(&mut self, name: &str, value: Option<bool>, at: Instant) -> bool {
        let found = self
            .known
            .iter_mut()
            .find(|(view, _)| view.signal.name == name);
        let Some((view, since)) = found else {
            return false;
        };
        if since.is_some_and(|since| at < since) {
            return false;
        }
        *since = Some(at);
        let before = std::mem::replace(&mut view.is_on, value);
        before.is_some() && value.is_some() && before != value
    }

    /// Nothing is known any more: the controller does not answer.
    pub(crate) fn forget(&mut self) {
        for (view, _) in &mut self.known {
            view.is_on = None;
        }
    }
}

/// Sets a signal and waits until it reads so.
pub(crate) async fn set_and_confirm(
    client: &Client,
    signal: &SignalConfig,
    on: bool,
) -> Result<(), RobotError> {
    client
        .set_signal(&signal.name, f64::from(u8::from(on)))
        .await?;
    let deadline = Instant::now() + SETTLED_WITHIN;
    while read(client, &signal.name).await? != on {
        if Instant::now() >= deadline {
            return Err(not_set(signal, on));
        }
        tokio::time::sleep(POLL).await;
    }
    Ok(())
}

/// The refusal of a signal that does not do what it was told.
pub(crate) fn not_set(signal: &SignalConfig, on: bool) -> RobotError {
    RobotError::SignalNotSet {
        label: signal.label.clone(),
        wish: if on { &signal.on } else { &signal.off }.clone(),
    }
}

/// How a digital signal stands.
pub(crate) async fn read(client: &Client, name: &str) -> Result<bool, RwsError> {
    Ok(client.signal(name).await?.value != 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_older_answer_never_overrides_a_newer_one() {
        let gripper = SignalConfig::virtual_gripper();
        let mut board = SignalBoard::new(std::slice::from_ref(&gripper));
        let asked = Instant::now();
        let set = asked + Duration::from_millis(5);
        assert!(
            !board.see(&gripper.name, Some(false), asked),
            "the first value is no change"
        );
        assert!(board.see(&gripper.name, Some(true), set));
        assert!(
            !board.see(&gripper.name, Some(false), asked),
            "asked before it was set"
        );
        assert_eq!(board.views()[0].is_on, Some(true));
        assert!(!board.see("other", Some(true), set));
    }

    #[test]
    fn what_was_forgotten_comes_back_without_being_a_change() {
        let gripper = SignalConfig::virtual_gripper();
        let mut board = SignalBoard::new(std::slice::from_ref(&gripper));
        let now = Instant::now();
        board.see(&gripper.name, Some(true), now);
        board.forget();
        assert_eq!(board.views()[0].is_on, None);
        assert!(!board.see(&gripper.name, Some(false), now));
    }
}
