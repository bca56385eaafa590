//! Which stretch of a recording is used. The samples themselves are never touched.

use serde::{Deserialize, Serialize};
use sqlx::Row;
use sqlx::sqlite::SqliteRow;

use super::demonstrations::{Demonstration, WHAT};
use super::{Error, Result, Store};
use crate::ids::DemonstrationId;

/// The stretch of a recording that is used, in seconds since the recording began.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Trim {
    /// What lies before is cut away.
    pub from_s: f64,
    /// What lies after is cut away.
    pub to_s: f64,
}

impl Trim {
    /// Where it begins, in microseconds.
    pub fn begin_us(self) -> u64 {
        (self.from_s * 1e6).round() as u64
    }

    /// Where it ends, in microseconds.
    pub fn end_us(self) -> u64 {
        (self.to_s * 1e6).round() as u64
    }
}

impl Store {
    /// Sets which stretch of a finished recording is used; `None` is all of it.
    ///
    /// # Errors
    /// `WrongState` while it is still being recorded.
    pub async fn set_trim(&self, id: DemonstrationId, trim: Option<Trim>) -> Result<Demonstration> {
        let (from_us, to_us) = columns(trim);
        let changed = sqlx::query(
            "UPDATE demonstration SET trim_from_us = ?, trim_to_us = ? \
             WHERE id = ? AND state NOT IN ('preparing', 'recording')",
        )
        .bind(from_us)
        .bind(to_us)
        .bind(id.to_string())
        .execute(&self.writer)
        .await?
        .rows_affected();
        let demonstration = self.demonstration(id).await?;
        if changed == 0 {
            return Err(Error::WrongState {
                what: WHAT,
                state: demonstration.state.as_str(),
                wanted: "finished",
            });
        }
        Ok(demonstration)
    }
}

/// The two columns of a trim.
pub(super) fn columns(trim: Option<Trim>) -> (Option<i64>, Option<i64>) {
    let column = |us: u64| i64::try_from(us).unwrap_or(i64::MAX);
    (
        trim.map(|trim| column(trim.begin_us())),
        trim.map(|trim| column(trim.end_us())),
    )
}

/// Reads the two columns of a trim.
pub(super) fn trim(row: &SqliteRow) -> Result<Option<Trim>> {
    let from_us: Option<i64> = row.try_get("trim_from_us")?;
    let to_us: Option<i64> = row.try_get("trim_to_us")?;
    Ok(from_us.zip(to_us).map(|(from_us, to_us)| Trim {
        from_s: from_us as f64 / 1e6,
        to_s: to_us as f64 / 1e6,
    }))
}
