//! Motors, stops, mode switch, speed ratio and signals.

use egm::messages::MciState;

use super::{Change, Controller, Refusal};
use crate::events::Incident;
use crate::signals::EGM_STOP;

/// Motors and stops.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ControllerState {
    /// Motors off.
    MotorsOff,
    /// Motors on.
    MotorsOn,
    /// A guard is open.
    GuardStop,
}

impl ControllerState {
    /// As Robot Web Services write it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::MotorsOff => "motoroff",
            Self::MotorsOn => "motoron",
            Self::GuardStop => "guardstop",
        }
    }
}

/// Position of the mode switch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OperatingMode {
    /// Automatic.
    Automatic,
    /// Manual at reduced speed.
    ManualReduced,
    /// Manual at full speed.
    ManualFull,
}

impl OperatingMode {
    /// As Robot Web Services write it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Automatic => "AUTO",
            Self::ManualReduced => "MANR",
            Self::ManualFull => "MANF",
        }
    }
}

impl Controller {
    /// Motors and stops.
    #[must_use]
    pub fn state(&self) -> ControllerState {
        self.state
    }

    /// Switches the motors.
    ///
    /// # Errors
    /// [`Refusal::WrongState`] when they are to be switched on in manual mode or while a guard is
    /// open.
    pub fn set_motors(&mut self, on: bool) -> Result<(), Refusal> {
        match (on, self.state) {
            (true, ControllerState::GuardStop) => Err(Refusal::WrongState(
                "motors on is not possible in guard stop",
            )),
            (true, _) if self.mode != OperatingMode::Automatic => {
                Err(Refusal::WrongState("motors on needs automatic mode"))
            }
            (true, ControllerState::MotorsOff) => {
                self.set_state(ControllerState::MotorsOn);
                self.log(Incident::MotorsOn);
                Ok(())
            }
            (false, ControllerState::MotorsOn) => {
                self.leave_motors_on(ControllerState::MotorsOff);
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// Opens or closes a guard, for tests.
    pub(crate) fn set_guard_stop(&mut self, open: bool) {
        match (open, self.state) {
            (true, ControllerState::GuardStop) => {}
            (true, _) => {
                self.log(Incident::GuardStop);
                self.leave_motors_on(ControllerState::GuardStop);
            }
            (false, ControllerState::GuardStop) => self.set_state(ControllerState::MotorsOff),
            (false, _) => {}
        }
    }

    /// Ends everything that needs motors.
    pub(super) fn leave_motors_on(&mut self, to: ControllerState) {
        if self.state == ControllerState::MotorsOn {
            self.log(Incident::MotorsOff);
        }
        self.end_lead_through();
        if self
            .session
            .as_ref()
            .is_some_and(|session| session.moves_arm())
        {
            self.end_session(MciState::Stopped);
        }
        self.set_program(super::Program::Stopped);
        self.arm.brake_anew();
        self.set_state(to);
    }

    fn set_state(&mut self, state: ControllerState) {
        self.state = state;
        self.report(Change::State(state));
    }

    /// Position of the mode switch.
    #[must_use]
    pub fn mode(&self) -> OperatingMode {
        self.mode
    }

    /// Turns the mode switch; the motors go off with it.
    pub fn set_mode(&mut self, mode: OperatingMode) {
        if mode != self.mode {
            if self.state == ControllerState::MotorsOn {
                self.leave_motors_on(ControllerState::MotorsOff);
            }
            self.mode = mode;
            self.report(Change::Mode(mode));
        }
    }

    /// Speed ratio, percent. EGM does not look at it.
    #[must_use]
    pub fn speed_ratio(&self) -> u8 {
        self.speed_ratio
    }

    /// Sets the speed ratio, at most 100 percent.
    pub fn set_speed_ratio(&mut self, percent: u8) {
        self.speed_ratio = percent.min(100);
        self.report(Change::SpeedRatio(self.speed_ratio));
    }

    /// Sets a signal as a client does.
    ///
    /// # Errors
    /// [`Refusal::Missing`] when there is none with this name or path, [`Refusal::Rejected`] when
    /// clients may not write it.
    pub fn set_signal(&mut self, path: &str, on: bool) -> Result<(), Refusal> {
        let signal = self
            .signals
            .find(path)
            .ok_or(Refusal::Missing("no such signal"))?;
        if !signal.writable {
            return Err(Refusal::Rejected);
        }
        let name = signal.name;
        if !self.faults.signals_stuck {
            self.turn_signal(name, on);
        }
        Ok(())
    }

    /// Sets a signal as the wiring does.
    pub(crate) fn turn_signal(&mut self, name: &str, on: bool) {
        if self.signals.set(name, on) == Some(true) {
            let name = name.to_owned();
            let stops_egm = on && name == EGM_STOP;
            self.report(Change::Signal { name, on });
            if stops_egm {
                self.end_guidance();
            }
        }
    }
}
