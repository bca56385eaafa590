//! Faults that tests can bring about: the ones that users of real cells report.
//!
//! Switches are here; what happens by script and by chance, and when, is in [`script`], and what
//! that does to the datagrams in [`link`].

mod chance;
pub mod link;
mod rewrite;
pub mod script;

use std::sync::{Arc, Mutex};

use crate::controller::Controller;
use crate::error::Error;
use crate::lock;
use script::FaultScript;

/// The faults that last.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Faults {
    /// The controller's EGM messages are lost on their way.
    pub egm_lost: bool,
    /// Lead-through is accepted, and taken back by the safety controller (event 90515).
    pub lead_through_reverts: bool,
    /// Signals that clients set are accepted, and stay as they are.
    pub signals_stuck: bool,
    /// The start of the program is accepted, and taken back.
    pub start_reverts: bool,
    /// Every request of Robot Web Services is answered with 503.
    pub rws_unavailable: bool,
}

/// Brings faults about while the controller runs.
#[derive(Clone)]
pub struct FaultSwitches(pub(crate) Arc<Mutex<Controller>>);

impl FaultSwitches {
    /// Changes the faults that last.
    pub fn set(&self, change: impl FnOnce(&mut Faults)) {
        change(lock(&self.0).faults_mut());
    }

    /// Lets a script of faults begin on the EGM line; the one before ends.
    ///
    /// # Errors
    /// [`Error::ScriptedFault`] when its numbers make no sense.
    pub fn play(&self, script: FaultScript) -> Result<(), Error> {
        script.check()?;
        lock(&self.0).set_fault_script(script);
        Ok(())
    }

    /// Opens (`true`) or closes a guard: the arm stops, its motors go off and stay off.
    pub fn guard_stop(&self, open: bool) {
        lock(&self.0).set_guard_stop(open);
    }

    /// The safety controller ends active lead-through, as it does when the tool is moved too fast.
    pub fn violate_tool_speed(&self) {
        lock(&self.0).violate_tool_speed();
    }

    /// Sets a signal as the cell's wiring does, for example a button at the arm.
    pub fn wire_signal(&self, name: &str, on: bool) {
        lock(&self.0).turn_signal(name, on);
    }

    /// How a signal stands; nothing when there is none with this name.
    #[must_use]
    pub fn signal(&self, name: &str) -> Option<bool> {
        lock(&self.0).signals().find(name).map(|signal| signal.on)
    }
}
