//! What a person said of a motion: that it worked or did not. Nothing until somebody says so.

use serde::Serialize;
use sqlx::Row;
use sqlx::sqlite::SqliteRow;

use super::reproductions::{Reproduction, ReproductionState};
use super::{Error, Result, Store};
use crate::clock::WallTime;
use crate::ids::ReproductionId;

/// What a person said of a motion.
#[derive(Clone, Debug, PartialEq, Serialize, utoipa::ToSchema)]
pub struct Outcome {
    /// Whether the work was done.
    pub worked: bool,
    /// What they had to say about it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
    /// When they said it.
    #[schema(value_type = String, format = DateTime)]
    pub at: WallTime,
}

impl Outcome {
    /// Reads it from a reproduction's row.
    pub(super) fn from_row(row: &SqliteRow) -> Result<Option<Self>> {
        let (Some(worked), Some(at)) = (row.try_get("worked")?, row.try_get("outcome_at_ms")?)
        else {
            return Ok(None);
        };
        Ok(Some(Self {
            worked,
            note: row.try_get("outcome_note")?,
            at: WallTime(at),
        }))
    }
}

impl Store {
    /// Stores what a person said of a motion that has ended, or that they take it back.
    ///
    /// # Errors
    /// `WrongState` while the motion runs.
    pub async fn set_outcome(
        &self,
        id: ReproductionId,
        outcome: Option<&Outcome>,
    ) -> Result<Reproduction> {
        let changed = sqlx::query(
            "UPDATE reproduction SET worked = ?, outcome_note = ?, outcome_at_ms = ? \
             WHERE id = ? AND state <> 'running'",
        )
        .bind(outcome.map(|outcome| outcome.worked))
        .bind(outcome.and_then(|outcome| outcome.note.as_deref()))
        .bind(outcome.map(|outcome| outcome.at.0))
        .bind(id.to_string())
        .execute(&self.writer)
        .await?
        .rows_affected();
        let reproduction = self.reproduction(id).await?;
        if changed == 0 {
            return Err(Error::WrongState {
                what: "motion",
                state: ReproductionState::Running.as_str(),
                wanted: "over",
            });
        }
        Ok(reproduction)
    }
}
