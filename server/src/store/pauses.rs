//! Pauses within a recording: where it was held up, and for how long.

use sqlx::Row;

use super::demonstrations::{Demonstration, WHAT};
use super::recordings::{NewSamples, add_new};
use super::text::{to_json, unsigned};
use super::{Error, Result, Store};
use crate::ids::DemonstrationId;

/// A place where a recording was held up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pause {
    /// Where it is in the recording, in microseconds since it began.
    pub at_us: u64,
    /// How long it was; nothing when the recording ended in it.
    pub length_us: Option<u64>,
}

impl Store {
    /// Holds an open recording up at `at_us`: what came in until then and the mark in one
    /// transaction.
    pub async fn pause_recording(
        &self,
        id: DemonstrationId,
        last: NewSamples<'_>,
        at_us: u64,
        at_deg: &[f64; 6],
    ) -> Result<Demonstration> {
        let mut transaction = self.begin().await?;
        let changed = sqlx::query(
            "UPDATE demonstration SET paused_at_deg = ?, pauses = pauses + 1 \
             WHERE id = ? AND state = 'recording' AND paused_at_deg IS NULL",
        )
        .bind(to_json(at_deg, "pause")?)
        .bind(id.to_string())
        .execute(&mut *transaction)
        .await?
        .rows_affected();
        if changed == 0 {
            transaction.rollback().await?;
            return Err(Error::WrongState {
                what: WHAT,
                state: self.demonstration(id).await?.state.as_str(),
                wanted: "recording",
            });
        }
        add_new(&mut transaction, id, last).await?;
        sqlx::query("INSERT INTO demonstration_pause (demonstration_id, at_us) VALUES (?, ?)")
            .bind(id.to_string())
            .bind(at_us.cast_signed())
            .execute(&mut *transaction)
            .await?;
        transaction.commit().await?;
        self.demonstration(id).await
    }

    /// Goes on with a recording that was held up for `length_us`.
    pub async fn resume_recording(
        &self,
        id: DemonstrationId,
        length_us: u64,
    ) -> Result<Demonstration> {
        let mut transaction = self.begin().await?;
        sqlx::query("UPDATE demonstration SET paused_at_deg = NULL WHERE id = ?")
            .bind(id.to_string())
            .execute(&mut *transaction)
            .await?;
        sqlx::query(
            "UPDATE demonstration_pause SET length_us = ? \
             WHERE demonstration_id = ? AND length_us IS NULL",
        )
        .bind(length_us.cast_signed())
        .bind(id.to_string())
        .execute(&mut *transaction)
        .await?;
        transaction.commit().await?;
        self.demonstration(id).await
    }

    /// Where a recording was held up, in order.
    pub async fn pauses(&self, id: DemonstrationId) -> Result<Vec<Pause>> {
        sqlx::query(
            "SELECT at_us, length_us FROM demonstration_pause \
             WHERE demonstration_id = ? ORDER BY at_us, id",
        )
        .bind(id.to_string())
        .fetch_all(&self.readers)
        .await?
        .iter()
        .map(|row| {
            let length_us: Option<i64> = row.try_get("length_us")?;
            Ok(Pause {
                at_us: unsigned(row, "at_us")?,
                length_us: length_us.map(i64::cast_unsigned),
            })
        })
        .collect()
    }
}
