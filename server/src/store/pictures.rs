//! Photos of tasks: small, one for each task, beside its row.

use sqlx::Row;

use super::text::{parsed, words};
use super::{Error, Result, Store};
use crate::ids::TaskId;

words!(
    /// What a picture is.
    PictureKind {
        /// A JPEG file.
        Jpeg = "image/jpeg",
        /// A PNG file.
        Png = "image/png",
        /// A WebP file.
        Webp = "image/webp",
    }
);

/// A task's photo.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// What it is.
    pub kind: PictureKind,
    /// The file.
    pub body: Vec<u8>,
}

impl Store {
    /// Gives a task a photo instead of the one that it may have.
    pub async fn set_picture(&self, id: TaskId, picture: &Picture, sha256: &str) -> Result<()> {
        self.task(id).await?;
        sqlx::query(
            "INSERT INTO task_picture (task_id, kind, body, sha256) VALUES (?, ?, ?, ?) \
             ON CONFLICT (task_id) DO UPDATE SET \
             kind = excluded.kind, body = excluded.body, sha256 = excluded.sha256",
        )
        .bind(id.to_string())
        .bind(picture.kind.as_str())
        .bind(&picture.body)
        .bind(sha256)
        .execute(&self.writer)
        .await?;
        Ok(())
    }

    /// A task's photo.
    pub async fn picture(&self, id: TaskId) -> Result<Picture> {
        self.task(id).await?;
        let row = sqlx::query("SELECT kind, body FROM task_picture WHERE task_id = ?")
            .bind(id.to_string())
            .fetch_optional(&self.readers)
            .await?
            .ok_or(Error::NotFound { what: "picture" })?;
        Ok(Picture {
            kind: parsed(&row, "kind")?,
            body: row.try_get("body")?,
        })
    }

    /// Takes a task's photo away; there need not be one.
    pub async fn remove_picture(&self, id: TaskId) -> Result<()> {
        self.task(id).await?;
        sqlx::query("DELETE FROM task_picture WHERE task_id = ?")
            .bind(id.to_string())
            .execute(&self.writer)
            .await?;
        Ok(())
    }
}
