//! Recordings: the chunks that hold what was recorded, and how a recording grows and ends.

use sqlx::{Row, Sqlite, Transaction};

use super::demonstrations::{Demonstration, DemonstrationState, WHAT, from_row};
use super::samples::{Sample, columns, decode_samples, encode_samples};
use super::signals::{SignalEvent, add_signals};
use super::text::unsigned;
use super::{Error, Result, Store};
use crate::ids::DemonstrationId;

/// A stretch without samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gap {
    /// Where it begins, in microseconds since the demonstration began.
    pub at_us: u64,
    /// How long it is, in microseconds.
    pub length_us: u64,
}

/// What came in since the last chunk was committed.
#[derive(Clone, Copy, Debug)]
pub struct NewSamples<'a> {
    /// The number of the chunk that it becomes.
    pub seq: usize,
    /// The samples.
    pub samples: &'a [Sample],
    /// Stretches without samples.
    pub gaps: &'a [Gap],
    /// What was done with signals.
    pub signals: &'a [SignalEvent],
}

/// How a recording ends.
#[derive(Clone, Copy, Debug)]
pub struct Closing<'a> {
    /// The state that it ends in.
    pub state: DemonstrationState,
    /// Something that a person should know about it.
    pub note: Option<&'a str>,
    /// Why a model can't be trained from it.
    pub problem: Option<&'a str>,
}

impl Store {
    /// Adds samples and gaps to an open recording, with its counters, in one transaction.
    pub async fn append_samples(
        &self,
        id: DemonstrationId,
        last: NewSamples<'_>,
    ) -> Result<Demonstration> {
        let mut transaction = self.begin().await?;
        add_new(&mut transaction, id, last).await?;
        transaction.commit().await?;
        self.demonstration(id).await
    }

    /// Ends an open recording: the last samples, totals, state, note and problem in one
    /// transaction.
    pub async fn close_demonstration(
        &self,
        id: DemonstrationId,
        last: NewSamples<'_>,
        closing: &Closing<'_>,
    ) -> Result<Demonstration> {
        let mut transaction = self.begin().await?;
        let changed = sqlx::query(
            "UPDATE demonstration SET state = ?, note = ?, problem = ?, paused_at_deg = NULL \
             WHERE id = ? AND state IN ('preparing', 'recording')",
        )
        .bind(closing.state.as_str())
        .bind(closing.note)
        .bind(closing.problem)
        .bind(id.to_string())
        .execute(&mut *transaction)
        .await?
        .rows_affected();
        if changed == 0 {
            transaction.rollback().await?;
            return Err(Error::WrongState {
                what: WHAT,
                state: self.demonstration(id).await?.state.as_str(),
                wanted: "preparing or recording",
            });
        }
        add_new(&mut transaction, id, last).await?;
        transaction.commit().await?;
        self.demonstration(id).await
    }

    /// At start-up: recordings that the last run left open keep everything they have and become
    /// interrupted; one that has no samples yet is nothing to offer and is discarded.
    pub async fn recover_recordings(&self, note: &str) -> Result<Vec<Demonstration>> {
        let mut transaction = self.begin().await?;
        let rows = sqlx::query(
            "UPDATE demonstration SET note = ?, paused_at_deg = NULL, \
             state = CASE WHEN samples > 0 THEN 'interrupted' ELSE 'discarded' END \
             WHERE state IN ('preparing', 'recording') RETURNING *",
        )
        .bind(note)
        .fetch_all(&mut *transaction)
        .await?;
        transaction.commit().await?;
        rows.iter().map(from_row).collect()
    }

    /// Everything that was recorded, in order.
    ///
    /// # Errors
    /// `Damaged` when a chunk does not match its check sum.
    pub async fn samples(&self, id: DemonstrationId) -> Result<Vec<Sample>> {
        let rows = sqlx::query(
            "SELECT columns, samples, crc32 FROM demonstration_chunk \
             WHERE demonstration_id = ? ORDER BY seq",
        )
        .bind(id.to_string())
        .fetch_all(&self.readers)
        .await?;
        let mut samples = Vec::new();
        for row in &rows {
            let bytes: &[u8] = row.try_get("samples")?;
            let columns = if row.try_get::<i64, _>("columns")? == 9 {
                9
            } else {
                6
            };
            let crc32 = u32::try_from(row.try_get::<i64, _>("crc32")?)
                .map_err(|_| Error::Damaged { what: "recording" })?;
            samples.extend(decode_samples(bytes, columns, crc32)?);
        }
        Ok(samples)
    }

    /// The stretches without samples, in order.
    pub async fn gaps(&self, id: DemonstrationId) -> Result<Vec<Gap>> {
        sqlx::query(
            "SELECT at_us, length_us FROM demonstration_gap \
             WHERE demonstration_id = ? ORDER BY at_us",
        )
        .bind(id.to_string())
        .fetch_all(&self.readers)
        .await?
        .iter()
        .map(|row| {
            Ok(Gap {
                at_us: unsigned(row, "at_us")?,
                length_us: unsigned(row, "length_us")?,
            })
        })
        .collect()
    }
}

/// Adds what came in since the last chunk.
pub(super) async fn add_new(
    transaction: &mut Transaction<'static, Sqlite>,
    id: DemonstrationId,
    new: NewSamples<'_>,
) -> Result<()> {
    append(transaction, id, new.seq, new.samples).await?;
    add_gaps(transaction, id, new.gaps).await?;
    add_signals(transaction, id, new.signals).await
}

async fn add_gaps(
    transaction: &mut Transaction<'static, Sqlite>,
    id: DemonstrationId,
    gaps: &[Gap],
) -> Result<()> {
    for gap in gaps {
        sqlx::query(
            "INSERT INTO demonstration_gap (demonstration_id, at_us, length_us) VALUES (?, ?, ?)",
        )
        .bind(id.to_string())
        .bind(gap.at_us.cast_signed())
        .bind(gap.length_us.cast_signed())
        .execute(&mut **transaction)
        .await?;
    }
    sqlx::query("UPDATE demonstration SET gaps = gaps + ? WHERE id = ?")
        .bind(i64::try_from(gaps.len()).unwrap_or(i64::MAX))
        .bind(id.to_string())
        .execute(&mut **transaction)
        .await?;
    Ok(())
}

pub(super) async fn append(
    transaction: &mut Transaction<'static, Sqlite>,
    id: DemonstrationId,
    seq: usize,
    samples: &[Sample],
) -> Result<()> {
    let (Some(first), Some(last)) = (samples.first(), samples.last()) else {
        return Ok(());
    };
    let columns = columns(samples);
    let bytes = encode_samples(samples, columns);
    let count = i64::try_from(samples.len()).unwrap_or(i64::MAX);
    sqlx::query(
        "INSERT INTO demonstration_chunk \
         (demonstration_id, seq, first_us, count, columns, samples, crc32) \
         VALUES (?, ?, ?, ?, ?, ?, ?)",
    )
    .bind(id.to_string())
    .bind(i64::try_from(seq).unwrap_or(i64::MAX))
    .bind(first.at_us.cast_signed())
    .bind(count)
    .bind(if columns == 9 { 9 } else { 6 })
    .bind(&bytes)
    .bind(i64::from(crc32fast::hash(&bytes)))
    .execute(&mut **transaction)
    .await?;
    sqlx::query("UPDATE demonstration SET samples = samples + ?, duration_us = ? WHERE id = ?")
        .bind(count)
        .bind(last.at_us.cast_signed())
        .bind(id.to_string())
        .execute(&mut **transaction)
        .await?;
    Ok(())
}
