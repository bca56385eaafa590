//! Signals on the time lines of demonstrations and reproductions.

use sqlx::{Row, Sqlite, Transaction};

use super::text::unsigned;
use super::{Result, Store};
use crate::ids::{DemonstrationId, ReproductionId};

/// A signal that was set, or (at 0) how it stood when the demonstration began.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SignalEvent {
    /// Microseconds since the demonstration began.
    pub at_us: u64,
    /// The controller's name of the signal.
    pub name: String,
    /// Its value from then on.
    pub on: bool,
}

/// A signal that a reproduction set.
#[derive(Clone, Debug, PartialEq)]
pub struct RunSignal {
    /// When the controller had it, in microseconds since the motion began.
    pub at_us: u64,
    /// The controller's name of the signal.
    pub name: String,
    /// Its value from then on.
    pub on: bool,
    /// How long after its time of the plan that was, in seconds.
    pub late_s: f64,
}

impl Store {
    /// What was done with signals during a demonstration, in the order of time.
    pub async fn signals(&self, id: DemonstrationId) -> Result<Vec<SignalEvent>> {
        sqlx::query(
            "SELECT at_us, name, value FROM demonstration_signal \
             WHERE demonstration_id = ? ORDER BY at_us, id",
        )
        .bind(id.to_string())
        .fetch_all(&self.readers)
        .await?
        .iter()
        .map(|row| {
            Ok(SignalEvent {
                at_us: unsigned(row, "at_us")?,
                name: row.try_get("name")?,
                on: row.try_get("value")?,
            })
        })
        .collect()
    }

    /// Writes down the signals that a reproduction set; all of them or none.
    pub async fn add_run_signals(&self, id: ReproductionId, signals: &[RunSignal]) -> Result<()> {
        let mut transaction = self.begin().await?;
        for signal in signals {
            sqlx::query(
                "INSERT INTO reproduction_signal (reproduction_id, at_us, name, value, late_s) \
                 VALUES (?, ?, ?, ?, ?)",
            )
            .bind(id.to_string())
            .bind(signal.at_us.cast_signed())
            .bind(&signal.name)
            .bind(signal.on)
            .bind(signal.late_s)
            .execute(&mut *transaction)
            .await?;
        }
        transaction.commit().await?;
        Ok(())
    }

    /// The signals that a reproduction set, in the order in which it did.
    pub async fn run_signals(&self, id: ReproductionId) -> Result<Vec<RunSignal>> {
        sqlx::query(
            "SELECT at_us, name, value, late_s FROM reproduction_signal \
             WHERE reproduction_id = ? ORDER BY id",
        )
        .bind(id.to_string())
        .fetch_all(&self.readers)
        .await?
        .iter()
        .map(|row| {
            Ok(RunSignal {
                at_us: unsigned(row, "at_us")?,
                name: row.try_get("name")?,
                on: row.try_get("value")?,
                late_s: row.try_get("late_s")?,
            })
        })
        .collect()
    }
}

pub(super) async fn add_signals(
    transaction: &mut Transaction<'static, Sqlite>,
    id: DemonstrationId,
    signals: &[SignalEvent],
) -> Result<()> {
    for signal in signals {
        sqlx::query(
            "INSERT INTO demonstration_signal (demonstration_id, at_us, name, value) \
             VALUES (?, ?, ?, ?)",
        )
        .bind(id.to_string())
        .bind(signal.at_us.cast_signed())
        .bind(&signal.name)
        .bind(signal.on)
        .execute(&mut **transaction)
        .await?;
    }
    Ok(())
}
