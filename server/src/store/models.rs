//! Models: versions that never change once they are ready, and the file that holds each.

use serde::Serialize;
use sqlx::sqlite::SqliteRow;
use sqlx::{Row, Sqlite, Transaction};

use super::text::{Failure, failure, json, parsed, to_json, words};
use super::trims::{Trim, columns, trim};
use super::{Error, Result, Store};
use crate::clock::WallTime;
use crate::ids::{DemonstrationId, JobId, ModelId, TaskId};

words!(
    /// Where a model is in its life.
    ModelState {
        /// A job is making it.
        Training = "training",
        /// It can be previewed and reproduced.
        Ready = "ready",
        /// Training came to nothing.
        Failed = "failed",
        /// Somebody called training off.
        Cancelled = "cancelled",
    }
);

/// One trained version of a task.
#[derive(Clone, Debug, PartialEq, Serialize, utoipa::ToSchema)]
pub struct Model {
    /// Its identifier.
    pub id: ModelId,
    /// What was taught.
    pub task_id: TaskId,
    /// Its number within the task, from 1.
    pub version: u32,
    /// Where it is in its life.
    pub state: ModelState,
    /// The job that makes or made it.
    pub job_id: JobId,
    /// What it was trained from.
    pub demonstrations: Vec<DemonstrationId>,
    /// For each of these, the stretch of it that was used; all of it where nothing stands.
    pub trims: Vec<Option<Trim>>,
    /// How it was trained.
    pub method: String,
    /// The seed of everything random in the training.
    pub seed: u64,
    /// When training was asked for.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: WallTime,
    /// The result in a sentence.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub summary: Option<String>,
    /// The figures of the training, as `team train --json` prints them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub report: Option<serde_json::Value>,
    /// Where the taught motion begins, in degrees per joint.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub start_deg: Option<Vec<f64>>,
    /// Where the taught motion ends, in degrees per joint.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub goal_deg: Option<Vec<f64>>,
    /// How long the taught motion takes, in seconds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub duration_s: Option<f64>,
    /// Why training came to nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<Failure>,
}

/// One thing that a model is trained from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Source {
    /// The demonstration.
    pub id: DemonstrationId,
    /// The stretch of it; all of it when missing.
    pub trim: Option<Trim>,
}

impl Model {
    /// What it was trained from.
    pub fn sources(&self) -> impl Iterator<Item = Source> {
        let pairs = self.demonstrations.iter().zip(&self.trims);
        pairs.map(|(id, trim)| Source {
            id: *id,
            trim: *trim,
        })
    }
}

/// What training makes of a model's row.
#[derive(Clone, Debug)]
pub struct TrainedModel {
    /// The result in a sentence.
    pub summary: String,
    /// The figures of the training.
    pub report: serde_json::Value,
    /// Where the taught motion begins, in degrees per joint.
    pub start_deg: Vec<f64>,
    /// Where the taught motion ends, in degrees per joint.
    pub goal_deg: Vec<f64>,
    /// How long the taught motion takes, in seconds.
    pub duration_s: f64,
    /// The model file.
    pub body: Vec<u8>,
    /// Its SHA-256 in hexadecimal.
    pub sha256: String,
}

const NOT_FOUND: Error = Error::NotFound { what: "model" };

impl Store {
    /// One model.
    pub async fn model(&self, id: ModelId) -> Result<Model> {
        let row = sqlx::query("SELECT * FROM model WHERE id = ?")
            .bind(id.to_string())
            .fetch_optional(&self.readers)
            .await?;
        self.with_sources(&row.ok_or(NOT_FOUND)?).await
    }

    /// A task's models by version.
    pub async fn models(&self, task: TaskId) -> Result<Vec<Model>> {
        let rows = sqlx::query("SELECT * FROM model WHERE task_id = ? ORDER BY version")
            .bind(task.to_string())
            .fetch_all(&self.readers)
            .await?;
        let mut models = Vec::with_capacity(rows.len());
        for row in &rows {
            models.push(self.with_sources(row).await?);
        }
        Ok(models)
    }

    /// The model file and its SHA-256 in hexadecimal.
    pub async fn model_file(&self, id: ModelId) -> Result<(Vec<u8>, String)> {
        let row = sqlx::query("SELECT body, sha256 FROM model_file WHERE model_id = ?")
            .bind(id.to_string())
            .fetch_optional(&self.readers)
            .await?
            .ok_or(Error::NotFound { what: "model file" })?;
        Ok((row.try_get("body")?, row.try_get("sha256")?))
    }

    async fn with_sources(&self, row: &SqliteRow) -> Result<Model> {
        let mut model = from_row(row)?;
        let sources = sqlx::query(
            "SELECT demonstration_id, trim_from_us, trim_to_us FROM model_source \
             WHERE model_id = ? ORDER BY position",
        )
        .bind(model.id.to_string())
        .fetch_all(&self.readers)
        .await?;
        model.demonstrations = sources
            .iter()
            .map(|row| parsed(row, "demonstration_id"))
            .collect::<Result<_>>()?;
        model.trims = sources.iter().map(trim).collect::<Result<_>>()?;
        Ok(model)
    }
}

/// What is known of a model when training is asked for.
pub(super) struct NewModel<'a> {
    pub id: ModelId,
    pub task_id: TaskId,
    pub job_id: JobId,
    pub sources: &'a [Source],
    pub method: &'a str,
    pub seed: u64,
}

pub(super) async fn insert(
    transaction: &mut Transaction<'static, Sqlite>,
    new: NewModel<'_>,
    now: WallTime,
) -> Result<()> {
    sqlx::query(
        "INSERT INTO model (id, task_id, version, state, job_id, method, seed, created_at_ms) \
         VALUES (?1, ?2, (SELECT COALESCE(MAX(version), 0) + 1 FROM model WHERE task_id = ?2), \
         'training', ?3, ?4, ?5, ?6)",
    )
    .bind(new.id.to_string())
    .bind(new.task_id.to_string())
    .bind(new.job_id.to_string())
    .bind(new.method)
    .bind(new.seed.cast_signed())
    .bind(now.0)
    .execute(&mut **transaction)
    .await?;
    for (position, source) in new.sources.iter().enumerate() {
        let (from_us, to_us) = columns(source.trim);
        sqlx::query(
            "INSERT INTO model_source \
             (model_id, position, demonstration_id, trim_from_us, trim_to_us) \
             VALUES (?, ?, ?, ?, ?)",
        )
        .bind(new.id.to_string())
        .bind(i64::try_from(position).unwrap_or(i64::MAX))
        .bind(source.id.to_string())
        .bind(from_us)
        .bind(to_us)
        .execute(&mut **transaction)
        .await?;
    }
    Ok(())
}

/// Fills in the row of a model whose training succeeded, and stores its file.
pub(super) async fn make_ready(
    transaction: &mut Transaction<'static, Sqlite>,
    id: &str,
    trained: &TrainedModel,
) -> Result<()> {
    sqlx::query(
        "UPDATE model SET state = 'ready', summary = ?, report = ?, start_deg = ?, goal_deg = ?, \
         duration_s = ? WHERE id = ?",
    )
    .bind(&trained.summary)
    .bind(to_json(&trained.report, "report")?)
    .bind(to_json(&trained.start_deg, "start")?)
    .bind(to_json(&trained.goal_deg, "goal")?)
    .bind(trained.duration_s)
    .bind(id)
    .execute(&mut **transaction)
    .await?;
    sqlx::query("INSERT INTO model_file (model_id, body, sha256) VALUES (?, ?, ?)")
        .bind(id)
        .bind(&trained.body)
        .bind(&trained.sha256)
        .execute(&mut **transaction)
        .await?;
    Ok(())
}

/// Closes the row of a model that will not come, with the reason if there is one.
pub(super) async fn give_up(
    transaction: &mut Transaction<'static, Sqlite>,
    id: &str,
    state: ModelState,
    failure: Option<&Failure>,
) -> Result<()> {
    sqlx::query(
        "UPDATE model SET state = ?, failure_code = ?, failure_message = ?, failure_advice = ? \
         WHERE id = ?",
    )
    .bind(state.as_str())
    .bind(failure.map(|f| f.code.as_str()))
    .bind(failure.map(|f| f.message.as_str()))
    .bind(failure.map(|f| f.advice.as_str()))
    .bind(id)
    .execute(&mut **transaction)
    .await?;
    Ok(())
}

fn from_row(row: &SqliteRow) -> Result<Model> {
    Ok(Model {
        id: parsed(row, "id")?,
        task_id: parsed(row, "task_id")?,
        version: row.try_get("version")?,
        state: parsed(row, "state")?,
        job_id: parsed(row, "job_id")?,
        demonstrations: Vec::new(),
        trims: Vec::new(),
        method: row.try_get("method")?,
        seed: row.try_get::<i64, _>("seed")?.cast_unsigned(),
        created_at: WallTime(row.try_get("created_at_ms")?),
        summary: row.try_get("summary")?,
        report: json(row, "report")?,
        start_deg: json(row, "start_deg")?,
        goal_deg: json(row, "goal_deg")?,
        duration_s: row.try_get("duration_s")?,
        failure: failure(row)?,
    })
}
