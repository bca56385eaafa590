//! Flight records: what was commanded and measured in each cycle of a reproduction, and what
//! happened meanwhile. A record grows while the arm moves and is read in pages, so that a long one
//! never has to be in memory.

use serde::Serialize;
use sqlx::Row;
use sqlx::sqlite::SqliteRow;

use super::cycles::{Cycle, LAYOUT, decode, encode};
use super::text::unsigned;
use super::{Error, Result, Store};
use crate::clock::WallTime;
use crate::ids::ReproductionId;

const WHAT: &str = "reproduction";
/// Chunks that are read at once: three seconds of a record as it is written now.
const CHUNKS_PER_PAGE: i64 = 16;

/// Something that happened during a reproduction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FlightEvent {
    /// Microseconds since the motion was armed.
    pub at_us: u64,
    /// For programs.
    pub code: String,
    /// For people.
    pub message: String,
}

/// What came in since the last time.
#[derive(Clone, Copy, Debug)]
pub struct NewFlight<'a> {
    /// When the motion was armed; nothing before that.
    pub armed_at: Option<WallTime>,
    /// The cycles.
    pub cycles: &'a [Cycle],
    /// The events.
    pub events: &'a [FlightEvent],
}

/// How many cycles there are, and how many of them were out of the ordinary.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, utoipa::ToSchema)]
pub struct CycleCounts {
    /// Cycles in the record.
    pub total: u64,
    /// Messages of the controller that never came.
    pub lost: u64,
    /// Messages that came late.
    pub late: u64,
    /// Cycles in which the setpoint was refused and the arm held.
    pub held: u64,
    /// Cycles in which the setpoint was slowed down to stay within the limits.
    pub limited: u64,
}

/// A stretch of a record's time, both ends included, in microseconds since the motion was armed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stretch {
    /// Where it begins.
    pub from_us: u64,
    /// Where it ends.
    pub to_us: u64,
}

impl Stretch {
    /// The whole record.
    pub const ALL: Self = Self {
        from_us: 0,
        to_us: i64::MAX as u64,
    };

    fn contains(&self, at_us: u64) -> bool {
        (self.from_us..=self.to_us).contains(&at_us)
    }
}

/// Reads a record page by page.
pub struct FlightPages {
    store: Store,
    id: ReproductionId,
    stretch: Stretch,
    next_seq: i64,
}

impl Store {
    /// Adds cycles and events to a record, in one transaction.
    pub async fn append_flight(&self, id: ReproductionId, new: NewFlight<'_>) -> Result<()> {
        let mut transaction = self.begin().await?;
        if let (Some(first), Some(last)) = (new.cycles.first(), new.cycles.last()) {
            let bytes = encode(new.cycles);
            sqlx::query(
                "INSERT INTO reproduction_chunk \
                 (reproduction_id, seq, count, records, crc32, layout, first_us, last_us) \
                 SELECT ?1, COALESCE(MAX(seq) + 1, 0), ?2, ?3, ?4, ?5, ?6, ?7 \
                 FROM reproduction_chunk WHERE reproduction_id = ?1",
            )
            .bind(id.to_string())
            .bind(i64::try_from(new.cycles.len()).unwrap_or(i64::MAX))
            .bind(&bytes)
            .bind(i64::from(crc32fast::hash(&bytes)))
            .bind(LAYOUT)
            .bind(first.at_us.cast_signed())
            .bind(last.at_us.cast_signed())
            .execute(&mut *transaction)
            .await?;
        }
        for event in new.events {
            sqlx::query(
                "INSERT INTO reproduction_event (reproduction_id, position, at_us, code, message) \
                 SELECT ?1, COALESCE(MAX(position) + 1, 0), ?2, ?3, ?4 \
                 FROM reproduction_event WHERE reproduction_id = ?1",
            )
            .bind(id.to_string())
            .bind(event.at_us.cast_signed())
            .bind(&event.code)
            .bind(&event.message)
            .execute(&mut *transaction)
            .await?;
        }
        sqlx::query("UPDATE reproduction SET armed_at_ms = COALESCE(armed_at_ms, ?) WHERE id = ?")
            .bind(new.armed_at.map(|at| at.0))
            .bind(id.to_string())
            .execute(&mut *transaction)
            .await?;
        transaction.commit().await?;
        Ok(())
    }

    /// The cycles of a stretch of a record, in order, page by page.
    pub fn flight(&self, id: ReproductionId, stretch: Stretch) -> FlightPages {
        FlightPages {
            store: self.clone(),
            id,
            stretch,
            next_seq: 0,
        }
    }

    /// How many cycles a record has.
    pub async fn flight_cycles(&self, id: ReproductionId) -> Result<usize> {
        let sum: i64 = sqlx::query_scalar(
            "SELECT COALESCE(SUM(count), 0) FROM reproduction_chunk WHERE reproduction_id = ?",
        )
        .bind(id.to_string())
        .fetch_one(&self.readers)
        .await?;
        usize::try_from(sum).map_err(|_| Error::Damaged { what: WHAT })
    }

    /// The time of a record's last cycle, in microseconds since the motion was armed; nothing when
    /// there is none.
    pub async fn flight_end_us(&self, id: ReproductionId) -> Result<Option<u64>> {
        let row = sqlx::query(
            "SELECT records, layout, crc32 FROM reproduction_chunk WHERE reproduction_id = ? \
             ORDER BY seq DESC LIMIT 1",
        )
        .bind(id.to_string())
        .fetch_optional(&self.readers)
        .await?;
        let cycles = row.as_ref().map(chunk).transpose()?.unwrap_or_default();
        Ok(cycles.last().map(|cycle| cycle.at_us))
    }

    /// Everything that happened during a reproduction, in the order in which it was noted.
    pub async fn flight_events(&self, id: ReproductionId) -> Result<Vec<FlightEvent>> {
        sqlx::query(
            "SELECT at_us, code, message FROM reproduction_event \
             WHERE reproduction_id = ? ORDER BY position",
        )
        .bind(id.to_string())
        .fetch_all(&self.readers)
        .await?
        .iter()
        .map(|row| {
            Ok(FlightEvent {
                at_us: unsigned(row, "at_us")?,
                code: row.try_get("code")?,
                message: row.try_get("message")?,
            })
        })
        .collect()
    }
}

impl FlightPages {
    /// The next cycles, never none; nothing after the last ones.
    ///
    /// # Errors
    /// `Damaged` when a chunk does not match its check sum.
    pub async fn next(&mut self) -> Result<Option<Vec<Cycle>>> {
        loop {
            let rows = sqlx::query(
                "SELECT seq, records, layout, crc32 FROM reproduction_chunk \
                 WHERE reproduction_id = ? AND seq >= ? \
                 AND (last_us IS NULL OR (last_us >= ? AND first_us <= ?)) ORDER BY seq LIMIT ?",
            )
            .bind(self.id.to_string())
            .bind(self.next_seq)
            .bind(self.stretch.from_us.cast_signed())
            .bind(self.stretch.to_us.cast_signed())
            .bind(CHUNKS_PER_PAGE)
            .fetch_all(&self.store.readers)
            .await?;
            let Some(last) = rows.last() else {
                return Ok(None);
            };
            self.next_seq = last.try_get::<i64, _>("seq")? + 1;
            let mut cycles = Vec::new();
            for row in &rows {
                cycles.extend(chunk(row)?);
            }
            cycles.retain(|cycle| self.stretch.contains(cycle.at_us));
            if !cycles.is_empty() {
                return Ok(Some(cycles));
            }
        }
    }
}

fn chunk(row: &SqliteRow) -> Result<Vec<Cycle>> {
    let crc32 = u32::try_from(row.try_get::<i64, _>("crc32")?)
        .map_err(|_| Error::Damaged { what: WHAT })?;
    decode(row.try_get("records")?, row.try_get("layout")?, crc32)
}
