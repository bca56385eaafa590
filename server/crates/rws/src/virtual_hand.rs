//! The virtual controller's hand. **Not part of ABB's interface**: a real robot answers 404.
//!
//! It is moved by scripts while lead-through is active, as a person would move the arm, or led to
//! joint angles that are named again and again.

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
    /// It leads the arm where it is told.
    Leading,
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

    /// Leads the soft arm to these joint angles, deg. The hand lets go when it does not hear of
    /// others within 300 ms.
    ///
    /// # Errors
    /// [`RwsError::Refused`] while lead-through is not active or a script is shown,
    /// [`RwsError::Missing`] on a real robot.
    pub async fn lead_virtual_hand(&self, joints_deg: &[f64; 6]) -> Result<(), RwsError> {
        let joints = joints_deg.map(|angle| angle.to_string()).join(",");
        let form = [("action", "lead"), ("joints", &joints)];
        self.post(PATH, &form).await.map(|_| ())
    }

    /// Has the virtual hand let go of an arm that it led.
    ///
    /// # Errors
    /// [`RwsError::Missing`] on a real robot.
    pub async fn release_virtual_hand(&self) -> Result<(), RwsError> {
        let form = [("action", "let_go")];
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
