//! Tasks: rows that are never deleted, only put out of sight.

use serde::Serialize;
use sqlx::Row;
use sqlx::sqlite::SqliteRow;

use super::text::parsed;
use super::{Error, Result, Store};
use crate::clock::WallTime;
use crate::ids::TaskId;

/// What is to be taught.
#[derive(Clone, Debug, PartialEq, Serialize, utoipa::ToSchema)]
pub struct Task {
    /// Its identifier.
    pub id: TaskId,
    /// What people call it.
    pub name: String,
    /// When it was made.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: WallTime,
    /// Names its photo, another one by another name; missing when there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub picture: Option<String>,
}

const NOT_FOUND: Error = Error::NotFound { what: "task" };

impl Store {
    /// Makes a task. The second value is false when this identifier's task was already there.
    ///
    /// # Errors
    /// `IdTaken` when the identifier belongs to a task that was deleted.
    pub async fn create_task(&self, id: TaskId, name: &str, now: WallTime) -> Result<(Task, bool)> {
        let made = sqlx::query(
            "INSERT INTO task (id, name, created_at_ms) VALUES (?, ?, ?) ON CONFLICT (id) DO NOTHING",
        )
        .bind(id.to_string())
        .bind(name)
        .bind(now.0)
        .execute(&self.writer)
        .await?
        .rows_affected()
            == 1;
        match self.task(id).await {
            Ok(task) => Ok((task, made)),
            Err(Error::NotFound { .. }) => Err(Error::IdTaken { what: "task" }),
            Err(error) => Err(error),
        }
    }

    /// All tasks, oldest first.
    pub async fn tasks(&self) -> Result<Vec<Task>> {
        sqlx::query(
            "SELECT *, (SELECT substr(sha256, 1, 16) FROM task_picture WHERE task_id = task.id) \
             AS picture FROM task WHERE deleted_at_ms IS NULL ORDER BY created_at_ms, id",
        )
        .fetch_all(&self.readers)
        .await?
        .iter()
        .map(from_row)
        .collect()
    }

    /// One task.
    pub async fn task(&self, id: TaskId) -> Result<Task> {
        let row = sqlx::query(
            "SELECT *, (SELECT substr(sha256, 1, 16) FROM task_picture WHERE task_id = task.id) \
             AS picture FROM task WHERE id = ? AND deleted_at_ms IS NULL",
        )
        .bind(id.to_string())
        .fetch_optional(&self.readers)
        .await?;
        from_row(&row.ok_or(NOT_FOUND)?)
    }

    /// Gives a task another name.
    pub async fn rename_task(&self, id: TaskId, name: &str) -> Result<Task> {
        let changed =
            sqlx::query("UPDATE task SET name = ? WHERE id = ? AND deleted_at_ms IS NULL")
                .bind(name)
                .bind(id.to_string())
                .execute(&self.writer)
                .await?
                .rows_affected();
        if changed == 0 {
            return Err(NOT_FOUND);
        }
        self.task(id).await
    }

    /// Puts a task out of sight. Its demonstrations and models stay in the database.
    pub async fn delete_task(&self, id: TaskId, now: WallTime) -> Result<()> {
        let changed =
            sqlx::query("UPDATE task SET deleted_at_ms = ? WHERE id = ? AND deleted_at_ms IS NULL")
                .bind(now.0)
                .bind(id.to_string())
                .execute(&self.writer)
                .await?
                .rows_affected();
        if changed == 0 {
            return Err(NOT_FOUND);
        }
        Ok(())
    }

    /// Brings a task back that was put out of sight; one that is in sight stays so.
    pub async fn restore_task(&self, id: TaskId) -> Result<Task> {
        sqlx::query("UPDATE task SET deleted_at_ms = NULL WHERE id = ?")
            .bind(id.to_string())
            .execute(&self.writer)
            .await?;
        self.task(id).await
    }
}

fn from_row(row: &SqliteRow) -> Result<Task> {
    Ok(Task {
        id: parsed(row, "id")?,
        name: row.try_get("name")?,
        created_at: WallTime(row.try_get("created_at_ms")?),
        picture: row.try_get("picture")?,
    })
}
