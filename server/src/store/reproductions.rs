//! Reproductions: the motions that the arm really made, with their records.

use serde::Serialize;
use sqlx::Row;
use sqlx::sqlite::SqliteRow;

use super::samples::{Cycle, decode_cycles, encode_cycles};
use super::text::{json, parsed, to_json, words};
use super::{Error, Result, Store};
use crate::clock::WallTime;
use crate::ids::{ModelId, ReproductionId, TaskId};

words!(
    /// Where a reproduction is in its life.
    ReproductionState {
        /// The arm moves.
        Running = "running",
        /// The arm went all the way.
        Succeeded = "succeeded",
        /// Somebody stopped it.
        Stopped = "stopped",
        /// It broke off by itself.
        Failed = "failed",
    }
);

/// How far the arm was from where it was asked to be, in degrees over all joints and cycles.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, utoipa::ToSchema)]
pub struct TrackingError {
    /// On average.
    pub mean: f64,
    /// At worst.
    pub max: f64,
}

/// One motion that the arm made.
#[derive(Clone, Debug, PartialEq, Serialize, utoipa::ToSchema)]
pub struct Reproduction {
    /// Its identifier.
    pub id: ReproductionId,
    /// What was reproduced.
    pub task_id: TaskId,
    /// By which model.
    pub model_id: ModelId,
    /// The robot that made it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub robot: Option<String>,
    /// The plan that was run: its SHA-256.
    pub plan: String,
    /// Where it is in its life.
    pub state: ReproductionState,
    /// Why it ended like that.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// When it was begun.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: WallTime,
    /// When it ended.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub finished_at: Option<WallTime>,
    /// Where the motion was to begin, in degrees per joint.
    pub start_deg: Vec<f64>,
    /// Where the motion was to end, in degrees per joint.
    pub goal_deg: Vec<f64>,
    /// How long the plan takes with its approach, in seconds.
    pub duration_s: f64,
    /// Distance of the measured end from the goal: the mean over the joints, in degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub e_j_deg: Option<f64>,
    /// The same of the commanded end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub e_j_commanded_deg: Option<f64>,
    /// Correlation of the measured path with the one that was learnt.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gmcc: Option<f64>,
    /// How well the arm followed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tracking_error_deg: Option<TrackingError>,
}

/// What is known of a reproduction when it begins.
#[derive(Clone, Debug)]
pub struct NewReproduction<'a> {
    /// Its identifier.
    pub id: ReproductionId,
    /// What is reproduced.
    pub task_id: TaskId,
    /// By which model.
    pub model_id: ModelId,
    /// By which robot.
    pub robot: &'a str,
    /// The plan's SHA-256.
    pub plan: &'a str,
    /// Where the motion is to begin.
    pub start_deg: &'a [f64],
    /// Where the motion is to end.
    pub goal_deg: &'a [f64],
    /// How long the plan takes, in seconds.
    pub duration_s: f64,
    /// The client's key for this start, if it sent one.
    pub idempotency_key: Option<&'a str>,
}

/// What is known of a reproduction when it has ended.
#[derive(Clone, Debug)]
pub struct ReproductionResult {
    /// How it ended.
    pub state: ReproductionState,
    /// Why.
    pub reason: Option<String>,
    /// Distance of the measured end from the goal.
    pub e_j_deg: Option<f64>,
    /// Distance of the commanded end from the goal.
    pub e_j_commanded_deg: Option<f64>,
    /// Correlation of the measured path with the learnt one.
    pub gmcc: Option<f64>,
    /// How well the arm followed.
    pub tracking_error_deg: Option<TrackingError>,
}

const WHAT: &str = "reproduction";
const NOT_FOUND: Error = Error::NotFound { what: WHAT };

/// About 110 kB of cycles per row.
const CYCLES_PER_CHUNK: usize = 1_000;

impl Store {
    /// Makes the row of a motion that is about to begin.
    pub async fn create_reproduction(
        &self,
        new: NewReproduction<'_>,
        now: WallTime,
    ) -> Result<Reproduction> {
        sqlx::query(
            "INSERT INTO reproduction (id, task_id, model_id, plan, state, created_at_ms, \
             start_deg, goal_deg, duration_s, idempotency_key, robot) \
             VALUES (?, ?, ?, ?, 'running', ?, ?, ?, ?, ?, ?)",
        )
        .bind(new.id.to_string())
        .bind(new.task_id.to_string())
        .bind(new.model_id.to_string())
        .bind(new.plan)
        .bind(now.0)
        .bind(to_json(&new.start_deg, "start")?)
        .bind(to_json(&new.goal_deg, "goal")?)
        .bind(new.duration_s)
        .bind(new.idempotency_key)
        .bind(new.robot)
        .execute(&self.writer)
        .await?;
        self.reproduction(new.id).await
    }

    /// Takes back the row of a motion that the robot refused before it moved.
    pub async fn withdraw_reproduction(&self, id: ReproductionId) -> Result<()> {
        sqlx::query("DELETE FROM reproduction WHERE id = ? AND state = 'running'")
            .bind(id.to_string())
            .execute(&self.writer)
            .await?;
        Ok(())
    }

    /// One reproduction.
    pub async fn reproduction(&self, id: ReproductionId) -> Result<Reproduction> {
        let row = sqlx::query("SELECT * FROM reproduction WHERE id = ?")
            .bind(id.to_string())
            .fetch_optional(&self.readers)
            .await?;
        from_row(&row.ok_or(NOT_FOUND)?)
    }

    /// The reproduction that was begun with this key.
    pub async fn reproduction_by_key(&self, key: &str) -> Result<Option<Reproduction>> {
        sqlx::query("SELECT * FROM reproduction WHERE idempotency_key = ?")
            .bind(key)
            .fetch_optional(&self.readers)
            .await?
            .as_ref()
            .map(from_row)
            .transpose()
    }

    /// The reproduction that this robot is running.
    pub async fn running_reproduction(&self, robot: &str) -> Result<Option<Reproduction>> {
        sqlx::query("SELECT * FROM reproduction WHERE state = 'running' AND robot = ? LIMIT 1")
            .bind(robot)
            .fetch_optional(&self.readers)
            .await?
            .as_ref()
            .map(from_row)
            .transpose()
    }

    /// The latest 200 reproductions, newest first; only those of `task` when it is given.
    pub async fn reproductions(&self, task: Option<TaskId>) -> Result<Vec<Reproduction>> {
        sqlx::query(
            "SELECT * FROM reproduction WHERE ?1 IS NULL OR task_id = ?1 \
             ORDER BY created_at_ms DESC, id DESC LIMIT 200",
        )
        .bind(task.map(|task| task.to_string()))
        .fetch_all(&self.readers)
        .await?
        .iter()
        .map(from_row)
        .collect()
    }

    /// Ends a reproduction: record, figures and state in one transaction.
    pub async fn finish_reproduction(
        &self,
        id: ReproductionId,
        result: &ReproductionResult,
        cycles: &[Cycle],
        now: WallTime,
    ) -> Result<Reproduction> {
        let mut transaction = self.begin().await?;
        for (seq, chunk) in cycles.chunks(CYCLES_PER_CHUNK).enumerate() {
            let bytes = encode_cycles(chunk);
            sqlx::query(
                "INSERT INTO reproduction_chunk (reproduction_id, seq, count, records, crc32) \
                 VALUES (?, ?, ?, ?, ?)",
            )
            .bind(id.to_string())
            .bind(i64::try_from(seq).unwrap_or(i64::MAX))
            .bind(i64::try_from(chunk.len()).unwrap_or(i64::MAX))
            .bind(&bytes)
            .bind(i64::from(crc32fast::hash(&bytes)))
            .execute(&mut *transaction)
            .await?;
        }
        sqlx::query(
            "UPDATE reproduction SET state = ?, reason = ?, finished_at_ms = ?, e_j_deg = ?, \
             e_j_commanded_deg = ?, gmcc = ?, tracking_mean_deg = ?, tracking_max_deg = ? \
             WHERE id = ? AND state = 'running'",
        )
        .bind(result.state.as_str())
        .bind(&result.reason)
        .bind(now.0)
        .bind(result.e_j_deg)
        .bind(result.e_j_commanded_deg)
        .bind(result.gmcc)
        .bind(result.tracking_error_deg.map(|t| t.mean))
        .bind(result.tracking_error_deg.map(|t| t.max))
        .bind(id.to_string())
        .execute(&mut *transaction)
        .await?;
        transaction.commit().await?;
        self.reproduction(id).await
    }

    /// At start-up: motions that the last run left running have failed.
    pub async fn fail_running_reproductions(&self, reason: &str, now: WallTime) -> Result<u64> {
        let changed = sqlx::query(
            "UPDATE reproduction SET state = 'failed', reason = ?, finished_at_ms = ? \
             WHERE state = 'running'",
        )
        .bind(reason)
        .bind(now.0)
        .execute(&self.writer)
        .await?
        .rows_affected();
        Ok(changed)
    }

    /// Everything that was commanded and measured, in order.
    ///
    /// # Errors
    /// `Damaged` when a chunk does not match its check sum.
    pub async fn cycles(&self, id: ReproductionId) -> Result<Vec<Cycle>> {
        let rows = sqlx::query(
            "SELECT records, crc32 FROM reproduction_chunk WHERE reproduction_id = ? ORDER BY seq",
        )
        .bind(id.to_string())
        .fetch_all(&self.readers)
        .await?;
        let mut cycles = Vec::new();
        for row in &rows {
            let crc32 = u32::try_from(row.try_get::<i64, _>("crc32")?)
                .map_err(|_| Error::Damaged { what: WHAT })?;
            cycles.extend(decode_cycles(row.try_get("records")?, crc32)?);
        }
        Ok(cycles)
    }
}

fn from_row(row: &SqliteRow) -> Result<Reproduction> {
    let mean: Option<f64> = row.try_get("tracking_mean_deg")?;
    let max: Option<f64> = row.try_get("tracking_max_deg")?;
    Ok(Reproduction {
        id: parsed(row, "id")?,
        task_id: parsed(row, "task_id")?,
        model_id: parsed(row, "model_id")?,
        robot: row.try_get("robot")?,
        plan: row.try_get("plan")?,
        state: parsed(row, "state")?,
        reason: row.try_get("reason")?,
        created_at: WallTime(row.try_get("created_at_ms")?),
        finished_at: row
            .try_get::<Option<i64>, _>("finished_at_ms")?
            .map(WallTime),
        start_deg: json(row, "start_deg")?.unwrap_or_default(),
        goal_deg: json(row, "goal_deg")?.unwrap_or_default(),
        duration_s: row.try_get("duration_s")?,
        e_j_deg: row.try_get("e_j_deg")?,
        e_j_commanded_deg: row.try_get("e_j_commanded_deg")?,
        gmcc: row.try_get("gmcc")?,
        tracking_error_deg: mean.zip(max).map(|(mean, max)| TrackingError { mean, max }),
    })
}
