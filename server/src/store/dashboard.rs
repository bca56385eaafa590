//! What the dashboard counts: the latest motions, and sums for each task. Ways back along another
//! motion are no tries at a task and are left out of both.

use serde::Serialize;
use sqlx::Row;

use super::reproductions::ReproductionState;
use super::text::parsed;
use super::{Result, Store};
use crate::clock::WallTime;
use crate::ids::{ReproductionId, TaskId};

/// A motion as one row of a list.
#[derive(Clone, Debug, PartialEq, Serialize, utoipa::ToSchema)]
pub struct RunSummary {
    /// The reproduction's identifier.
    pub id: ReproductionId,
    /// What was reproduced.
    pub task_id: TaskId,
    /// What people call that.
    pub task_name: String,
    /// The robot that made it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub robot: Option<String>,
    /// Where it is in its life.
    pub state: ReproductionState,
    /// When it was begun.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: WallTime,
    /// Distance of the measured end from the goal: the mean over the joints, in degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub e_j_deg: Option<f64>,
    /// Correlation of the measured path with the one that was learnt.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gmcc: Option<f64>,
    /// Whether a person said that it worked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub worked: Option<bool>,
}

/// How a task has gone so far.
#[derive(Clone, Debug, PartialEq, Serialize, utoipa::ToSchema)]
pub struct TaskSummary {
    /// The task.
    pub task_id: TaskId,
    /// What people call it.
    pub name: String,
    /// Motions that have ended.
    pub runs: u32,
    /// Of these, the ones in which the arm went all the way.
    pub succeeded: u32,
    /// Those of which a person said whether they worked.
    pub judged: u32,
    /// Those of which a person said that they worked.
    pub worked: u32,
    /// The mean end error in degrees, of the motions that have one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub e_j_mean_deg: Option<f64>,
    /// The mean correlation, of the motions that have one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gmcc_mean: Option<f64>,
    /// When the latest one was begun.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub last_run_at: Option<WallTime>,
}

impl Store {
    /// The latest motions, newest first, with the names of their tasks, deleted ones too.
    pub async fn latest_runs(&self, limit: u32) -> Result<Vec<RunSummary>> {
        sqlx::query(
            "SELECT reproduction.*, task.name FROM reproduction \
             JOIN task ON task.id = reproduction.task_id WHERE backwards = 0 \
             ORDER BY reproduction.created_at_ms DESC, reproduction.id DESC LIMIT ?",
        )
        .bind(limit)
        .fetch_all(&self.readers)
        .await?
        .iter()
        .map(|row| {
            Ok(RunSummary {
                id: parsed(row, "id")?,
                task_id: parsed(row, "task_id")?,
                task_name: row.try_get("name")?,
                robot: row.try_get("robot")?,
                state: parsed(row, "state")?,
                created_at: WallTime(row.try_get("created_at_ms")?),
                e_j_deg: row.try_get("e_j_deg")?,
                gmcc: row.try_get("gmcc")?,
                worked: row.try_get("worked")?,
            })
        })
        .collect()
    }

    /// How each task in sight has gone, oldest task first.
    pub async fn task_summaries(&self) -> Result<Vec<TaskSummary>> {
        sqlx::query(
            "SELECT task.id, task.name, count(run.id) AS runs, \
             count(*) FILTER (WHERE run.state = 'succeeded') AS succeeded, \
             count(run.worked) AS judged, count(*) FILTER (WHERE run.worked = 1) AS worked, \
             avg(run.e_j_deg) AS e_j_mean_deg, avg(run.gmcc) AS gmcc_mean, \
             max(run.created_at_ms) AS last_run_at_ms \
             FROM task LEFT JOIN reproduction AS run \
             ON run.task_id = task.id AND run.state <> 'running' AND run.backwards = 0 \
             WHERE task.deleted_at_ms IS NULL GROUP BY task.id \
             ORDER BY task.created_at_ms, task.id",
        )
        .fetch_all(&self.readers)
        .await?
        .iter()
        .map(|row| {
            Ok(TaskSummary {
                task_id: parsed(row, "id")?,
                name: row.try_get("name")?,
                runs: row.try_get("runs")?,
                succeeded: row.try_get("succeeded")?,
                judged: row.try_get("judged")?,
                worked: row.try_get("worked")?,
                e_j_mean_deg: row.try_get("e_j_mean_deg")?,
                gmcc_mean: row.try_get("gmcc_mean")?,
                last_run_at: row
                    .try_get::<Option<i64>, _>("last_run_at_ms")?
                    .map(WallTime),
            })
        })
        .collect()
    }
}
