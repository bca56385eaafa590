//! Reproductions: the motions that the arm really made, with their records.

use serde::Serialize;
use sqlx::Row;
use sqlx::sqlite::SqliteRow;

use super::flights::CycleCounts;
use super::outcomes::Outcome;
use super::text::{json, parsed, to_json, unsigned, words};
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
    /// For each joint, at worst.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<Vec<f64>>)]
    pub max_by_joint: Option<[f64; 6]>,
    /// For each joint, the root of the mean square.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<Vec<f64>>)]
    pub rms_by_joint: Option<[f64; 6]>,
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
    /// When the server took the arm over: the zero of the flight record's times.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub armed_at: Option<WallTime>,
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
    /// What the control cycles of the flight record count up to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cycles: Option<CycleCounts>,
    /// Whether it led back along another motion, which is no try at the task.
    pub backwards: bool,
    /// What a person said of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outcome: Option<Outcome>,
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
    /// Whether it leads back along another motion.
    pub backwards: bool,
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
    /// What the record's cycles count up to.
    pub cycles: Option<CycleCounts>,
}

const WHAT: &str = "reproduction";
const NOT_FOUND: Error = Error::NotFound { what: WHAT };

impl Store {
    /// Makes the row of a motion that is about to begin.
    pub async fn create_reproduction(
        &self,
        new: NewReproduction<'_>,
        now: WallTime,
    ) -> Result<Reproduction> {
        sqlx::query(
            "INSERT INTO reproduction (id, task_id, model_id, plan, state, created_at_ms, \
             start_deg, goal_deg, duration_s, idempotency_key, robot, backwards) \
             VALUES (?, ?, ?, ?, 'running', ?, ?, ?, ?, ?, ?, ?)",
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
        .bind(new.backwards)
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

    /// A reproduction that is stored as running, whichever robot makes it.
    pub async fn any_running_reproduction(&self) -> Result<Option<Reproduction>> {
        sqlx::query("SELECT * FROM reproduction WHERE state = 'running' LIMIT 1")
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

    /// The latest reproductions, newest first; only those of `task` when it is given.
    pub async fn reproductions(
        &self,
        task: Option<TaskId>,
        limit: u32,
    ) -> Result<Vec<Reproduction>> {
        sqlx::query(
            "SELECT * FROM reproduction WHERE ?1 IS NULL OR task_id = ?1 \
             ORDER BY created_at_ms DESC, id DESC LIMIT ?2",
        )
        .bind(task.map(|task| task.to_string()))
        .bind(limit)
        .fetch_all(&self.readers)
        .await?
        .iter()
        .map(from_row)
        .collect()
    }

    /// Ends a reproduction, of which the record is stored already, with its state and figures.
    pub async fn finish_reproduction(
        &self,
        id: ReproductionId,
        result: &ReproductionResult,
        now: WallTime,
    ) -> Result<Reproduction> {
        let count =
            |of: fn(&CycleCounts) -> u64| result.cycles.as_ref().map(|c| of(c).cast_signed());
        sqlx::query(
            "UPDATE reproduction SET state = ?, reason = ?, finished_at_ms = ?, e_j_deg = ?, \
             e_j_commanded_deg = ?, gmcc = ?, tracking_mean_deg = ?, tracking_max_deg = ?, \
             tracking_max_by_joint_deg = ?, tracking_rms_by_joint_deg = ?, cycles = ?, \
             cycles_lost = ?, cycles_late = ?, cycles_held = ?, cycles_limited = ? \
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
        .bind(by_joint(
            result.tracking_error_deg.and_then(|t| t.max_by_joint),
        )?)
        .bind(by_joint(
            result.tracking_error_deg.and_then(|t| t.rms_by_joint),
        )?)
        .bind(count(|counts| counts.total))
        .bind(count(|counts| counts.lost))
        .bind(count(|counts| counts.late))
        .bind(count(|counts| counts.held))
        .bind(count(|counts| counts.limited))
        .bind(id.to_string())
        .execute(&self.writer)
        .await?;
        self.reproduction(id).await
    }
}

fn by_joint(values: Option<[f64; 6]>) -> Result<Option<String>> {
    values.map(|values| to_json(&values, WHAT)).transpose()
}

fn counts(row: &SqliteRow) -> Result<Option<CycleCounts>> {
    if row.try_get::<Option<i64>, _>("cycles")?.is_none() {
        return Ok(None);
    }
    Ok(Some(CycleCounts {
        total: unsigned(row, "cycles")?,
        lost: unsigned(row, "cycles_lost")?,
        late: unsigned(row, "cycles_late")?,
        held: unsigned(row, "cycles_held")?,
        limited: unsigned(row, "cycles_limited")?,
    }))
}

fn from_row(row: &SqliteRow) -> Result<Reproduction> {
    let mean: Option<f64> = row.try_get("tracking_mean_deg")?;
    let max: Option<f64> = row.try_get("tracking_max_deg")?;
    let max_by_joint = json(row, "tracking_max_by_joint_deg")?;
    let rms_by_joint = json(row, "tracking_rms_by_joint_deg")?;
    Ok(Reproduction {
        id: parsed(row, "id")?,
        task_id: parsed(row, "task_id")?,
        model_id: parsed(row, "model_id")?,
        robot: row.try_get("robot")?,
        plan: row.try_get("plan")?,
        state: parsed(row, "state")?,
        reason: row.try_get("reason")?,
        created_at: WallTime(row.try_get("created_at_ms")?),
        armed_at: row.try_get::<Option<i64>, _>("armed_at_ms")?.map(WallTime),
        finished_at: row
            .try_get::<Option<i64>, _>("finished_at_ms")?
            .map(WallTime),
        start_deg: json(row, "start_deg")?.unwrap_or_default(),
        goal_deg: json(row, "goal_deg")?.unwrap_or_default(),
        duration_s: row.try_get("duration_s")?,
        e_j_deg: row.try_get("e_j_deg")?,
        e_j_commanded_deg: row.try_get("e_j_commanded_deg")?,
        gmcc: row.try_get("gmcc")?,
        tracking_error_deg: mean.zip(max).map(|(mean, max)| TrackingError {
            mean,
            max,
            max_by_joint,
            rms_by_joint,
        }),
        cycles: counts(row)?,
        backwards: row.try_get("backwards")?,
        outcome: Outcome::from_row(row)?,
    })
}
