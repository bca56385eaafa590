//! The virtual controller's hand. **Not part of ABB's interface**: a real robot answers 404.
//!
//! It is moved by scripts while lead-through is active, as a person would move the arm.

use crate::{Client, RwsError};
use serde::Deserialize;

const PATH: &str = "/virtual/hand";

/// What the hand is asked to do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Action {
    /// Bring the arm to the start of the script.
    Return,
    /// Show the script's motion.
    Show,
}

/// What the hand does now.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum HandState {
    /// Nothing.
    Idle,
    /// It brings the arm to a start.
    Returning,
    /// It shows a motion.
    Showing,
}

#[derive(Deserialize)]
struct HandAnswer {
    state: HandState,
}

impl Client {
    /// Sets the virtual hand going.
    ///
    /// # Errors
    /// [`RwsError::Refused`] while lead-through is not active, [`RwsError::Missing`] on a real
    /// robot.
    pub async fn move_virtual_hand(
        &self,
        action: Action,
        script: &str,
        seed: u64,
    ) -> Result<(), RwsError> {
        let action = match action {
            Action::Return => "return",
            Action::Show => "show",
        };
        let seed = seed.to_string();
        let form = [("action", action), ("script", script), ("seed", &seed)];
        self.post(PATH, &form).await.map(|_| ())
    }

    /// Reads what the virtual hand does.
    ///
    /// # Errors
    /// [`RwsError::Missing`] on a real robot.
    pub async fn virtual_hand_state(&self) -> Result<HandState, RwsError> {
        let text = self.get(PATH).await?;
        let answer: HandAnswer =
            serde_json::from_str(&text).map_err(|error| RwsError::Unreadable {
                path: PATH.to_owned(),
                reason: error.to_string(),
            })?;
        Ok(answer.state)
    }
}
