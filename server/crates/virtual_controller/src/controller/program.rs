//! The RAPID program and the EGM session it opens.
//!
//! The program is the cell's: it sets EGM up, runs `EGMRunJoint`, and ends. Which statements it
//! holds does not matter here, only when a session opens and ends.

use egm::messages::MciState;

use super::{Change, Controller, ControllerState, OperatingMode, Refusal};
use crate::egm_session::Session;
use crate::events::Incident;

/// For so many cycles a start lasts that is taken back.
const REVERTED_AFTER_CYCLES: u32 = 10;

/// What the program is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Program {
    /// It stands.
    Stopped,
    /// It sets EGM up.
    SettingUp {
        /// Cycles that this still takes at least.
        left: u32,
    },
    /// It waits for the EGM run to end.
    Guiding,
    /// It runs for a moment, because a test wants its start to be taken back.
    Reverting {
        /// Cycles that this still takes.
        left: u32,
    },
}

impl Program {
    /// As RAPID's execution state.
    #[must_use]
    pub fn is_running(self) -> bool {
        self != Self::Stopped
    }
}

/// What happens when the program has reached its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RunMode {
    /// It stands.
    Once,
    /// It begins anew.
    Forever,
}

impl Controller {
    /// What the program is doing.
    #[must_use]
    pub fn program(&self) -> Program {
        self.program
    }

    /// How the program runs.
    #[must_use]
    pub fn run_mode(&self) -> RunMode {
        self.run_mode
    }

    /// Starts the program; without a mode it keeps the one it has.
    ///
    /// # Errors
    /// [`Refusal::WrongState`] without automatic mode, motors, or while lead-through is active or
    /// the program runs.
    pub fn start_program(&mut self, mode: Option<RunMode>) -> Result<(), Refusal> {
        if self.mode != OperatingMode::Automatic {
            return Err(Refusal::WrongState(
                "the program start needs automatic mode",
            ));
        }
        if self.state != ControllerState::MotorsOn {
            return Err(Refusal::WrongState("the program start needs motors on"));
        }
        if !self.lead_through.is_off() {
            return Err(Refusal::WrongState("lead-through is active"));
        }
        if self.program.is_running() {
            return Err(Refusal::WrongState("the program is running"));
        }
        self.run_mode = mode.unwrap_or(self.run_mode);
        self.log(Incident::ProgramStarted);
        self.set_program(if self.faults.start_reverts {
            Program::Reverting {
                left: REVERTED_AFTER_CYCLES,
            }
        } else {
            self.setting_up()
        });
        Ok(())
    }

    /// Stops the program; an arm under guidance comes to rest and its session ends.
    pub fn stop_program(&mut self) {
        self.never_stopped = false;
        if self.program.is_running() {
            self.set_program(Program::Stopped);
            self.log(Incident::ProgramStopped);
            if self.session.as_ref().is_some_and(Session::moves_arm) {
                self.end_session(MciState::Stopped);
            }
        }
    }

    /// Puts the program pointer to main.
    ///
    /// # Errors
    /// [`Refusal::WrongState`] while the program runs.
    pub fn program_to_main(&mut self) -> Result<(), Refusal> {
        if self.program.is_running() {
            return Err(Refusal::WrongState("the program is running"));
        }
        Ok(())
    }

    /// Ends the EGM run as `EGMStop` does; the program goes on to its end.
    pub(super) fn end_guidance(&mut self) {
        let egm = self.config.egm;
        if let Some(session) = self.session.as_mut().filter(|open| open.is_guiding()) {
            session.end_normally(&egm, &self.arm);
        }
    }

    pub(super) fn end_session(&mut self, state: MciState) {
        let ramp_s = self.config.egm.ramp_s;
        if let Some(session) = &mut self.session {
            session.end(state, ramp_s);
        }
    }

    pub(super) fn set_program(&mut self, program: Program) {
        let was_running = self.program.is_running();
        self.program = program;
        if was_running != program.is_running() {
            self.report(Change::Running(program.is_running()));
        }
    }

    fn setting_up(&self) -> Program {
        Program::SettingUp {
            left: self.config.egm.set_up_cycles,
        }
    }

    /// One cycle of the program.
    pub(super) fn advance_program(&mut self) {
        match &mut self.program {
            Program::SettingUp { left } => *left = left.saturating_sub(1),
            Program::Reverting { left: 0 } => {
                self.log(Incident::StartReverted);
                self.set_program(Program::Stopped);
            }
            Program::Reverting { left } => *left -= 1,
            Program::Stopped | Program::Guiding => {}
        }
    }

    /// Opens the session that the program's state asks for.
    pub(super) fn open_session(&mut self) {
        let between = self.session.as_ref().is_none_or(|open| open.is_streaming());
        if self.program == (Program::SettingUp { left: 0 }) && between && self.arm.is_at_rest() {
            self.sessions += 1;
            self.session = Some(Session::guiding(self.sessions, self.arm.measured()));
            self.set_program(Program::Guiding);
        } else if self.session.is_none()
            && self.config.egm.stream_when_idle
            && !self.program.is_running()
        {
            self.stream_pause_s -= self.config.egm.cycle_s;
            if self.stream_pause_s <= 0.0 {
                self.sessions += 1;
                self.session = Some(Session::streaming(self.sessions, self.arm.measured()));
            }
        }
    }

    /// Closes a session that has sent its last message.
    pub(super) fn close_session(&mut self) {
        if self.session.as_ref().is_some_and(Session::is_over) {
            self.session = None;
            if self.program == Program::Guiding {
                self.set_program(match self.run_mode {
                    RunMode::Once => Program::Stopped,
                    RunMode::Forever => self.setting_up(),
                });
            }
        }
    }
}
