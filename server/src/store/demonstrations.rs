//! Demonstrations: their rows and their states. The samples are in `recordings`.

use serde::Serialize;
use sqlx::sqlite::SqliteRow;
use sqlx::{Row, Sqlite, Transaction};

use super::recordings::append;
use super::samples::Sample;
use super::signals::{SignalEvent, add_signals};
use super::text::{json, parsed, unsigned, words};
use super::trims::{Trim, trim};
use super::{Error, Result, Store};
use crate::clock::WallTime;
use crate::ids::{DemonstrationId, TaskId};

words!(
    /// Where a demonstration is in its life.
    DemonstrationState {
        /// The virtual hand brings the arm to where the showing begins.
        Preparing = "preparing",
        /// Samples are coming in.
        Recording = "recording",
        /// Finished, and nobody has judged it yet.
        Recorded = "recorded",
        /// To be trained from.
        Kept = "kept",
        /// Not to be trained from; the data stays.
        Discarded = "discarded",
        /// The server stopped while it was recorded; what came until then is there.
        Interrupted = "interrupted",
    }
);

words!(
    /// Where the samples came from.
    DemonstrationSource {
        /// A person's hand.
        HandGuiding = "hand_guiding",
        /// The virtual controller's scripted hand.
        VirtualHand = "virtual_hand",
        /// A file.
        File = "file",
    }
);

/// One shown example of a task.
#[derive(Clone, Debug, PartialEq, Serialize, utoipa::ToSchema)]
pub struct Demonstration {
    /// Its identifier.
    pub id: DemonstrationId,
    /// What it is an example of.
    pub task_id: TaskId,
    /// Its number within the task, from 1.
    pub take: u32,
    /// Where it is in its life.
    pub state: DemonstrationState,
    /// Where the samples came from.
    pub source: DemonstrationSource,
    /// The robot that it was recorded from; files come from none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub robot: Option<String>,
    /// When it was begun.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: WallTime,
    /// From the first sample to the last, in seconds.
    pub duration_s: f64,
    /// How many samples there are.
    pub samples: u64,
    /// Samples per second on average; 0 when there are less than two.
    pub rate_hz: f64,
    /// How many stretches without samples there are.
    pub gaps: u64,
    /// How often it was held up.
    pub pauses: u64,
    /// Where the arm was when it was held up, in degrees per joint; missing unless it is now.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<Vec<f64>>)]
    pub paused_at_deg: Option<[f64; 6]>,
    /// The stretch of it that is used; all of it when missing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub trim: Option<Trim>,
    /// Something that a person should know about how it ended.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
    /// Whether a model can be trained from it.
    pub usable: bool,
    /// Why not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub problem: Option<String>,
}

/// What a person decides about a demonstration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decision {
    /// Train from it.
    Keep,
    /// Don't; the data stays, and keeping it later undoes this.
    Discard,
    /// Nothing yet: what was decided before is taken back.
    Reconsider,
}

impl Demonstration {
    /// How long the stretch is that is used, in seconds.
    pub fn used_s(&self) -> f64 {
        self.trim
            .map_or(self.duration_s, |trim| trim.to_s - trim.from_s)
    }
}

/// What is known of a demonstration when its row is made.
#[derive(Clone, Copy, Debug)]
pub struct NewDemonstration<'a> {
    /// Its identifier.
    pub id: DemonstrationId,
    /// What it is an example of.
    pub task_id: TaskId,
    /// The state that it begins in.
    pub state: DemonstrationState,
    /// Where the samples come from.
    pub source: DemonstrationSource,
    /// The robot that it is recorded from; files come from none.
    pub robot: Option<&'a str>,
}

pub(super) const WHAT: &str = "demonstration";
const NOT_FOUND: Error = Error::NotFound { what: WHAT };

impl Store {
    /// Makes a demonstration's row with the task's next take number.
    pub async fn create_demonstration(
        &self,
        new: NewDemonstration<'_>,
        now: WallTime,
    ) -> Result<Demonstration> {
        let mut transaction = self.begin().await?;
        insert(&mut transaction, new, None, now).await?;
        transaction.commit().await?;
        self.demonstration(new.id).await
    }

    /// Stores a whole demonstration that came as a file; all of it or nothing.
    pub async fn store_demonstration(
        &self,
        new: NewDemonstration<'_>,
        samples: &[Sample],
        signals: &[SignalEvent],
        note: &str,
        now: WallTime,
    ) -> Result<Demonstration> {
        let mut transaction = self.begin().await?;
        insert(&mut transaction, new, Some(note), now).await?;
        for (seq, chunk) in samples.chunks(SAMPLES_PER_FILE_CHUNK).enumerate() {
            append(&mut transaction, new.id, seq, chunk).await?;
        }
        add_signals(&mut transaction, new.id, signals).await?;
        transaction.commit().await?;
        self.demonstration(new.id).await
    }

    /// One demonstration.
    pub async fn demonstration(&self, id: DemonstrationId) -> Result<Demonstration> {
        let row = sqlx::query("SELECT * FROM demonstration WHERE id = ?")
            .bind(id.to_string())
            .fetch_optional(&self.readers)
            .await?;
        from_row(&row.ok_or(NOT_FOUND)?)
    }

    /// A task's demonstrations by take.
    pub async fn demonstrations(&self, task: TaskId) -> Result<Vec<Demonstration>> {
        sqlx::query("SELECT * FROM demonstration WHERE task_id = ? ORDER BY take")
            .bind(task.to_string())
            .fetch_all(&self.readers)
            .await?
            .iter()
            .map(from_row)
            .collect()
    }

    /// The demonstration that is being recorded from this robot, if there is one.
    pub async fn open_demonstration(&self, robot: &str) -> Result<Option<Demonstration>> {
        sqlx::query(
            "SELECT * FROM demonstration WHERE state IN ('preparing', 'recording') \
             AND robot = ? ORDER BY created_at_ms DESC LIMIT 1",
        )
        .bind(robot)
        .fetch_optional(&self.readers)
        .await?
        .as_ref()
        .map(from_row)
        .transpose()
    }

    /// The arm has been brought to where the showing begins: samples count from now on.
    pub async fn begin_recording(&self, id: DemonstrationId) -> Result<Demonstration> {
        self.change(id, "preparing", |state| {
            (state == DemonstrationState::Preparing).then_some(DemonstrationState::Recording)
        })
        .await
    }

    /// Keeps or discards a demonstration, or takes such a decision back. Deciding the same again changes nothing.
    pub async fn decide(&self, id: DemonstrationId, decision: Decision) -> Result<Demonstration> {
        use DemonstrationState::{Discarded, Interrupted, Kept, Recorded};
        self.change(id, "finished", |state| match (decision, state) {
            (Decision::Keep, Recorded | Interrupted | Discarded | Kept) => Some(Kept),
            (Decision::Discard, Recorded | Interrupted | Kept | Discarded) => Some(Discarded),
            (Decision::Reconsider, Interrupted) => Some(Interrupted),
            (Decision::Reconsider, Recorded | Kept | Discarded) => Some(Recorded),
            _ => None,
        })
        .await
    }

    async fn change(
        &self,
        id: DemonstrationId,
        wanted: &'static str,
        next: impl Fn(DemonstrationState) -> Option<DemonstrationState>,
    ) -> Result<Demonstration> {
        let mut transaction = self.begin().await?;
        let row = sqlx::query("SELECT state FROM demonstration WHERE id = ?")
            .bind(id.to_string())
            .fetch_optional(&mut *transaction)
            .await?;
        let state: DemonstrationState = parsed(&row.ok_or(NOT_FOUND)?, "state")?;
        let next = next(state).ok_or(Error::WrongState {
            what: WHAT,
            state: state.as_str(),
            wanted,
        })?;
        sqlx::query("UPDATE demonstration SET state = ? WHERE id = ?")
            .bind(next.as_str())
            .bind(id.to_string())
            .execute(&mut *transaction)
            .await?;
        transaction.commit().await?;
        self.demonstration(id).await
    }
}

/// About 100 kB of a file's samples per row.
const SAMPLES_PER_FILE_CHUNK: usize = 1_500;

async fn insert(
    transaction: &mut Transaction<'static, Sqlite>,
    new: NewDemonstration<'_>,
    note: Option<&str>,
    now: WallTime,
) -> Result<()> {
    sqlx::query(
        "INSERT INTO demonstration (id, task_id, take, state, source, created_at_ms, note, robot) \
         VALUES (?1, ?2, (SELECT COALESCE(MAX(take), 0) + 1 FROM demonstration WHERE task_id = ?2), \
         ?3, ?4, ?5, ?6, ?7)",
    )
    .bind(new.id.to_string())
    .bind(new.task_id.to_string())
    .bind(new.state.as_str())
    .bind(new.source.as_str())
    .bind(now.0)
    .bind(note)
    .bind(new.robot)
    .execute(&mut **transaction)
    .await?;
    Ok(())
}

pub(super) fn from_row(row: &SqliteRow) -> Result<Demonstration> {
    let state: DemonstrationState = parsed(row, "state")?;
    let samples = unsigned(row, "samples")?;
    let duration_s = unsigned(row, "duration_us")? as f64 / 1e6;
    let intervals = samples.saturating_sub(1) as f64;
    let trim = trim(row)?;
    // That is about the whole of it. A stretch is only chosen when something can be learnt from it.
    let problem: Option<String> = row.try_get("problem")?;
    let problem = problem.filter(|_| trim.is_none());
    let open = matches!(
        state,
        DemonstrationState::Preparing | DemonstrationState::Recording
    );
    Ok(Demonstration {
        id: parsed(row, "id")?,
        task_id: parsed(row, "task_id")?,
        take: row.try_get("take")?,
        state,
        source: parsed(row, "source")?,
        robot: row.try_get("robot")?,
        created_at: WallTime(row.try_get("created_at_ms")?),
        duration_s,
        samples,
        rate_hz: if duration_s > 0.0 {
            intervals / duration_s
        } else {
            0.0
        },
        gaps: unsigned(row, "gaps")?,
        pauses: unsigned(row, "pauses")?,
        paused_at_deg: json(row, "paused_at_deg")?,
        trim,
        note: row.try_get("note")?,
        usable: !open && samples > 1 && problem.is_none(),
        problem,
    })
}
