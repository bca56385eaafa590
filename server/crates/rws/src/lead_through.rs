//! Lead-through: the arm goes soft and a person moves it by hand.
//!
//! The controller's "yes" is no proof: its safety side can take lead-through back at once. So
//! every change is followed until it has held, and the safety log is asked for the reason when
//! it has not.

use crate::elog::{EventMessage, SAFETY_DOMAIN};
use crate::hal::Entries;
use crate::{Client, RwsError};
use std::time::Duration;
use tokio::time::Instant;

const PATH: &str = "/rw/motionsystem/mechunits/ROB_1/lead-through";
const POLL: Duration = Duration::from_millis(50);
const ACTIVE_WITHIN: Duration = Duration::from_millis(1500);
const INACTIVE_WITHIN: Duration = Duration::from_secs(3);
// Seen once is not enough: a state that the safety controller takes back shows for a moment.
const SEEN_IN_A_ROW: u32 = 3;
const LOG_ENTRIES: u32 = 5;

impl Client {
    /// Reads whether lead-through is active.
    ///
    /// # Errors
    /// As for every call.
    pub async fn lead_through(&self) -> Result<bool, RwsError> {
        let text = self.get(PATH).await?;
        let word = Entries::parse(PATH, &text)?
            .with_field("status")?
            .text("status")?;
        Ok(word.eq_ignore_ascii_case("active"))
    }

    /// Switches lead-through and waits until the controller keeps it. Switching it on needs
    /// automatic mode, motors on and a standing program.
    ///
    /// # Errors
    /// [`RwsError::LeadThroughReverted`] with the safety log's words when the state asked for was
    /// not kept within 1.5 s (active) or 3 s (inactive); [`RwsError::Refused`] when the
    /// controller said no.
    pub async fn set_lead_through(&self, active: bool) -> Result<(), RwsError> {
        let newest_before = self.newest_safety_event().await;
        let status = if active { "active" } else { "inactive" };
        self.post(PATH, &[("status", status)]).await?;

        let within = if active {
            ACTIVE_WITHIN
        } else {
            INACTIVE_WITHIN
        };
        let deadline = Instant::now() + within;
        let mut in_a_row = 0;
        loop {
            in_a_row = if self.lead_through().await? == active {
                in_a_row + 1
            } else {
                0
            };
            if in_a_row >= SEEN_IN_A_ROW {
                return Ok(());
            }
            if Instant::now() >= deadline {
                let reason = self.safety_reason_since(newest_before.as_ref()).await;
                return Err(RwsError::LeadThroughReverted { active, reason });
            }
            tokio::time::sleep(POLL).await;
        }
    }

    /// Why lead-through ended by itself, as far as the safety log tells: its newest entry.
    pub async fn newest_safety_event(&self) -> Option<EventMessage> {
        let messages = self.events(SAFETY_DOMAIN, 1).await.ok()?;
        messages.into_iter().next()
    }

    async fn safety_reason_since(&self, before: Option<&EventMessage>) -> String {
        let messages = self
            .events(SAFETY_DOMAIN, LOG_ENTRIES)
            .await
            .unwrap_or_default();
        let new: Vec<String> = messages
            .iter()
            .take_while(|message| Some(*message) != before)
            .map(ToString::to_string)
            .collect();
        if new.is_empty() {
            "the controller took the change back without giving a reason".to_owned()
        } else {
            new.join("; ")
        }
    }
}
