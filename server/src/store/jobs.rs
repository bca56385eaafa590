//! Jobs: asking for work, looking at it, and calling it off. Working on it is in `leases`.

use serde::Serialize;
use sqlx::Row;
use sqlx::sqlite::SqliteRow;

use super::models::{Model, ModelState, NewModel, Source, give_up, insert};
use super::text::{Failure, failure, parsed, unsigned, words};
use super::{Error, Result, Store};
use crate::clock::WallTime;
use crate::ids::{JobId, ModelId, TaskId};

words!(
    /// What a job does.
    JobKind {
        /// Makes a model from demonstrations.
        TrainModel = "train_model",
    }
);

words!(
    /// Where a job is in its life.
    JobState {
        /// Waiting for a worker.
        Queued = "queued",
        /// A worker has it.
        Running = "running",
        /// Done.
        Succeeded = "succeeded",
        /// Came to nothing.
        Failed = "failed",
        /// Called off.
        Cancelled = "cancelled",
    }
);

/// How far a job is.
#[derive(Clone, Debug, Default, PartialEq, Serialize, utoipa::ToSchema)]
pub struct JobProgress {
    /// The stage, for programs.
    pub stage: String,
    /// The stage in words.
    pub words: String,
    /// Steps of this stage that are done.
    pub done: u64,
    /// Steps of this stage.
    pub total: u64,
    /// Of the whole job, from 0 to 1.
    pub fraction: f64,
}

/// One piece of background work.
#[derive(Clone, Debug, PartialEq, Serialize, utoipa::ToSchema)]
pub struct Job {
    /// Its identifier.
    pub id: JobId,
    /// What it does.
    pub kind: JobKind,
    /// Where it is in its life.
    pub state: JobState,
    /// The task that it works for.
    pub task_id: TaskId,
    /// The model that it makes.
    pub model_id: ModelId,
    /// How many times it was begun.
    pub attempt: u32,
    /// How far it is.
    pub progress: JobProgress,
    /// Why it came to nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<Failure>,
    /// When it was asked for.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: WallTime,
    /// When a worker last began it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub started_at: Option<WallTime>,
    /// When it ended.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub finished_at: Option<WallTime>,
}

/// A training that somebody asks for.
#[derive(Clone, Debug)]
pub struct NewTraining<'a> {
    /// The task.
    pub task_id: TaskId,
    /// What to train from, in order.
    pub sources: &'a [Source],
    /// How to train.
    pub method: &'a str,
    /// The seed of everything random.
    pub seed: u64,
    /// The same for the same inputs and parameters.
    pub unique_key: &'a str,
    /// How often it may be begun.
    pub max_attempts: u32,
}

const NOT_FOUND: Error = Error::NotFound { what: "job" };

impl Store {
    /// Makes a job and its model in one transaction. When the same was asked for before and did
    /// not fail, that job and model come back, and the third value is false.
    pub async fn create_training(
        &self,
        new: NewTraining<'_>,
        now: WallTime,
    ) -> Result<(Job, Model, bool)> {
        let mut transaction = self.begin().await?;
        let known = sqlx::query(
            "SELECT * FROM job WHERE unique_key = ? AND state IN ('queued', 'running', 'succeeded')",
        )
        .bind(new.unique_key)
        .fetch_optional(&mut *transaction)
        .await?;
        if let Some(row) = known {
            let job = from_row(&row)?;
            transaction.rollback().await?;
            let model = self.model(job.model_id).await?;
            return Ok((job, model, false));
        }
        let (job_id, model_id) = (JobId::new(), ModelId::new());
        sqlx::query(
            "INSERT INTO job (id, kind, task_id, model_id, state, unique_key, max_attempts, \
             created_at_ms) VALUES (?, ?, ?, ?, 'queued', ?, ?, ?)",
        )
        .bind(job_id.to_string())
        .bind(JobKind::TrainModel.as_str())
        .bind(new.task_id.to_string())
        .bind(model_id.to_string())
        .bind(new.unique_key)
        .bind(new.max_attempts)
        .bind(now.0)
        .execute(&mut *transaction)
        .await?;
        let model = NewModel {
            id: model_id,
            task_id: new.task_id,
            job_id,
            sources: new.sources,
            method: new.method,
            seed: new.seed,
        };
        insert(&mut transaction, model, now).await?;
        transaction.commit().await?;
        Ok((self.job(job_id).await?, self.model(model_id).await?, true))
    }

    /// One job.
    pub async fn job(&self, id: JobId) -> Result<Job> {
        let row = sqlx::query("SELECT * FROM job WHERE id = ?")
            .bind(id.to_string())
            .fetch_optional(&self.readers)
            .await?;
        from_row(&row.ok_or(NOT_FOUND)?)
    }

    /// The latest 500 jobs, newest first; only those in `state` when it is given.
    pub async fn jobs(&self, state: Option<JobState>) -> Result<Vec<Job>> {
        sqlx::query(
            "SELECT * FROM job WHERE ?1 IS NULL OR state = ?1 \
             ORDER BY created_at_ms DESC, id DESC LIMIT 500",
        )
        .bind(state.map(JobState::as_str))
        .fetch_all(&self.readers)
        .await?
        .iter()
        .map(from_row)
        .collect()
    }

    /// Jobs that have not ended, oldest first.
    pub async fn open_jobs(&self) -> Result<Vec<Job>> {
        sqlx::query(
            "SELECT * FROM job WHERE state IN ('queued', 'running') ORDER BY created_at_ms, id",
        )
        .fetch_all(&self.readers)
        .await?
        .iter()
        .map(from_row)
        .collect()
    }

    /// At start-up: jobs that the last run left running wait again.
    pub async fn requeue_running_jobs(&self) -> Result<u64> {
        let changed = sqlx::query(
            "UPDATE job SET state = 'queued', lease_token = NULL, lease_until_ms = NULL \
             WHERE state = 'running'",
        )
        .execute(&self.writer)
        .await?
        .rows_affected();
        Ok(changed)
    }

    /// Ends the jobs that were begun as often as allowed and never came to an end.
    pub async fn fail_exhausted_jobs(&self, failure: &Failure, now: WallTime) -> Result<Vec<Job>> {
        let mut transaction = self.begin().await?;
        let rows = sqlx::query(
            "UPDATE job SET state = 'failed', lease_token = NULL, lease_until_ms = NULL, \
             failure_code = ?1, failure_message = ?2, failure_advice = ?3, finished_at_ms = ?4 \
             WHERE attempt >= max_attempts AND \
             (state = 'queued' OR (state = 'running' AND lease_until_ms <= ?4)) RETURNING *",
        )
        .bind(&failure.code)
        .bind(&failure.message)
        .bind(&failure.advice)
        .bind(now.0)
        .fetch_all(&mut *transaction)
        .await?;
        let jobs = rows.iter().map(from_row).collect::<Result<Vec<_>>>()?;
        for job in &jobs {
            let model = job.model_id.to_string();
            give_up(&mut transaction, &model, ModelState::Failed, Some(failure)).await?;
        }
        transaction.commit().await?;
        Ok(jobs)
    }

    /// Calls a job off, whether it waits or runs: from now on nobody holds its lease. A job that
    /// has ended stays as it is.
    pub async fn cancel_job(&self, id: JobId, now: WallTime) -> Result<Job> {
        let mut transaction = self.begin().await?;
        let row = sqlx::query(
            "UPDATE job SET state = 'cancelled', lease_token = NULL, lease_until_ms = NULL, \
             finished_at_ms = ? WHERE id = ? AND state IN ('queued', 'running') RETURNING model_id",
        )
        .bind(now.0)
        .bind(id.to_string())
        .fetch_optional(&mut *transaction)
        .await?;
        if let Some(row) = row {
            let model_id: String = row.try_get("model_id")?;
            give_up(&mut transaction, &model_id, ModelState::Cancelled, None).await?;
        }
        transaction.commit().await?;
        self.job(id).await
    }
}

pub(super) fn from_row(row: &SqliteRow) -> Result<Job> {
    Ok(Job {
        id: parsed(row, "id")?,
        kind: parsed(row, "kind")?,
        state: parsed(row, "state")?,
        task_id: parsed(row, "task_id")?,
        model_id: parsed(row, "model_id")?,
        attempt: row.try_get("attempt")?,
        progress: JobProgress {
            stage: row.try_get("stage")?,
            words: row.try_get("words")?,
            done: unsigned(row, "done")?,
            total: unsigned(row, "total")?,
            fraction: row.try_get("fraction")?,
        },
        failure: failure(row)?,
        created_at: WallTime(row.try_get("created_at_ms")?),
        started_at: row
            .try_get::<Option<i64>, _>("started_at_ms")?
            .map(WallTime),
        finished_at: row
            .try_get::<Option<i64>, _>("finished_at_ms")?
            .map(WallTime),
    })
}
