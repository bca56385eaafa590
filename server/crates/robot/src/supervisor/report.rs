//! What the supervisor says of itself: the view, and its refusals.

use super::{Mode, Supervisor};
use crate::config::RobotKind;
use crate::error::RobotError;
use crate::view::{RobotState, RobotView};
use rws::Client;

impl Supervisor {
    /// Lets everyone see the robot as it is.
    pub(super) fn publish(&self) {
        let mut view = RobotView::new(self.config.kind);
        self.seen.show(&mut view, self.now_us());
        view.egm.real_time = self.links.flags.is_real_time();
        view.state = self.state();
        view.signals = self.signals.views();
        match &self.mode {
            Mode::Run(slot) => view.run = Some(slot.progress()),
            Mode::Faulted(fault) => view.fault = Some(fault.clone()),
            Mode::Guiding { .. } => {}
            _ => view.hand = None,
        }
        self.view.send_replace(view);
    }

    pub(super) fn state(&self) -> RobotState {
        match &self.mode {
            Mode::Disconnected => RobotState::Disconnected,
            Mode::Idle | Mode::EnteringGuidance(_) => RobotState::Idle,
            Mode::Guiding { .. } => RobotState::Guiding,
            Mode::LeavingGuidance(_) => RobotState::Stopping,
            Mode::Run(slot) if slot.is_stopping() => RobotState::Stopping,
            Mode::Run(_) => RobotState::Reproducing,
            Mode::Faulted(_) => RobotState::Faulted,
        }
    }

    /// The refusal of something that needs an idle arm.
    pub(super) fn busy(&self) -> RobotError {
        match &self.mode {
            _ if self.config.kind == RobotKind::None => RobotError::NoRobot,
            Mode::Disconnected => RobotError::Disconnected,
            Mode::Faulted(fault) => RobotError::Faulted(fault.clone()),
            _ => RobotError::Busy {
                state: self.state(),
            },
        }
    }

    /// The client, when the arm is idle.
    pub(super) fn idle_client(&self) -> Result<Client, RobotError> {
        match (&self.mode, &self.client) {
            (Mode::Idle, Some(client)) if self.operation.is_none() => Ok(client.clone()),
            _ => Err(self.busy()),
        }
    }
}
