//! Lead-through, and the virtual hand that uses it.

use super::{Controller, ControllerState, OperatingMode, Refusal};
use crate::events::Incident;
use crate::hand::script::Script;
use crate::hand::{Action, Doing};
use motion::JointAngles;

/// Cycles from the request to the change, about 50 ms.
const CHANGE_AFTER_CYCLES: u32 = 12;
/// Cycles after which the safety controller takes lead-through back, about 60 ms.
const REVERTED_AFTER_CYCLES: u32 = 15;

/// State of lead-through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeadThrough {
    /// The arm is stiff.
    Inactive,
    /// Asked for; the arm is still stiff.
    Starting {
        /// Cycles that this still takes.
        left: u32,
    },
    /// The arm is soft.
    Active,
    /// The arm is soft for a moment, because a test wants it to be taken back.
    Reverting {
        /// Cycles that this still takes.
        left: u32,
    },
    /// The end is asked for; the arm is still soft.
    Ending {
        /// Cycles that this still takes.
        left: u32,
    },
}

impl LeadThrough {
    /// A hand can move the arm.
    #[must_use]
    pub fn is_soft(self) -> bool {
        !matches!(self, Self::Inactive | Self::Starting { .. })
    }

    /// The arm is stiff and will stay so.
    #[must_use]
    pub fn is_off(self) -> bool {
        self == Self::Inactive
    }
}

impl Controller {
    /// State of lead-through.
    #[must_use]
    pub fn lead_through(&self) -> LeadThrough {
        self.lead_through
    }

    /// Asks for lead-through, or for its end. The change comes a little later, and may be taken
    /// back.
    ///
    /// # Errors
    /// [`Refusal::WrongState`] without automatic mode or motors, or while the program runs or the
    /// arm moves.
    pub fn set_lead_through(&mut self, active: bool) -> Result<(), Refusal> {
        if !active {
            self.hand.end_lead();
            if self.lead_through.is_soft() {
                self.lead_through = LeadThrough::Ending {
                    left: CHANGE_AFTER_CYCLES,
                };
            } else {
                self.lead_through = LeadThrough::Inactive;
            }
            return Ok(());
        }
        if self.mode != OperatingMode::Automatic {
            return Err(Refusal::WrongState("lead-through needs automatic mode"));
        }
        if self.state != ControllerState::MotorsOn {
            return Err(Refusal::WrongState("lead-through needs motors on"));
        }
        if self.program.is_running() {
            return Err(Refusal::WrongState("lead-through needs a stopped program"));
        }
        if !self.lead_through.is_soft() && !self.arm.is_at_rest() {
            return Err(Refusal::WrongState("the arm is moving"));
        }
        self.lead_through = match self.lead_through {
            LeadThrough::Inactive => LeadThrough::Starting {
                left: CHANGE_AFTER_CYCLES,
            },
            LeadThrough::Ending { .. } => LeadThrough::Active,
            other => other,
        };
        Ok(())
    }

    /// Has the hand do something.
    ///
    /// # Errors
    /// [`Refusal::WrongState`] unless lead-through is active.
    pub fn move_hand(&mut self, action: Action, script: Script, seed: u64) -> Result<(), Refusal> {
        self.check_soft()?;
        self.hand.begin(action, script, seed, self.arm.measured());
        Ok(())
    }

    /// Has the hand lead the arm to these joint angles; they must be named again before
    /// [`motion::drag::PATIENCE_S`] have passed.
    ///
    /// # Errors
    /// [`Refusal::WrongState`] unless lead-through is active, and while the hand shows a script.
    pub fn lead_hand(&mut self, to: JointAngles) -> Result<(), Refusal> {
        self.check_soft()?;
        if matches!(self.hand.doing().state, "returning" | "showing") {
            return Err(Refusal::WrongState("the hand shows a script"));
        }
        self.hand.lead(to, self.arm.measured());
        Ok(())
    }

    /// Has the hand lead the arm no longer; a script goes on.
    pub fn end_lead(&mut self) {
        self.hand.end_lead();
    }

    fn check_soft(&self) -> Result<(), Refusal> {
        if self.lead_through == LeadThrough::Active {
            Ok(())
        } else {
            Err(Refusal::WrongState(
                "the arm is stiff: lead-through is not active",
            ))
        }
    }

    /// What the hand is doing.
    #[must_use]
    pub fn hand(&self) -> Doing {
        self.hand.doing()
    }

    /// The safety controller ends lead-through, for tests.
    pub(crate) fn violate_tool_speed(&mut self) {
        if self.lead_through.is_soft() {
            self.end_lead_through();
            self.log(Incident::ToolSpeedViolation);
        }
    }

    pub(super) fn end_lead_through(&mut self) {
        self.lead_through = LeadThrough::Inactive;
        self.hand.let_go();
    }

    /// One cycle of changes that take time.
    pub(super) fn advance_lead_through(&mut self) {
        match &mut self.lead_through {
            LeadThrough::Inactive | LeadThrough::Active => {}
            LeadThrough::Starting { left: 0 } => {
                self.lead_through = if self.faults.lead_through_reverts {
                    LeadThrough::Reverting {
                        left: REVERTED_AFTER_CYCLES,
                    }
                } else {
                    LeadThrough::Active
                };
            }
            LeadThrough::Reverting { left: 0 } => self.violate_tool_speed(),
            LeadThrough::Ending { left: 0 } => self.end_lead_through(),
            LeadThrough::Starting { left }
            | LeadThrough::Reverting { left }
            | LeadThrough::Ending { left } => *left -= 1,
        }
    }
}
