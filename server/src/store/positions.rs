//! Saved positions: poses of one robot that people gave a name. Never erased, only put out of sight,
//! so that a request that still names one can be told what became of it.

use serde::Serialize;
use sqlx::Row;
use sqlx::sqlite::SqliteRow;

use super::text::{json, parsed, to_json};
use super::{Error, Result, Store};
use crate::clock::WallTime;
use crate::ids::PositionId;

/// A pose of one robot under a name.
#[derive(Clone, Debug, PartialEq, Serialize, utoipa::ToSchema)]
pub struct Position {
    /// Its identifier.
    pub id: PositionId,
    /// The robot that it belongs to: the same angles are another place for another one.
    pub robot: String,
    /// What people call it; no other position of this robot is called so.
    pub name: String,
    /// Joint angles in degrees.
    #[schema(value_type = Vec<f64>)]
    pub joints_deg: [f64; 6],
    /// When it was saved.
    #[schema(value_type = String, format = DateTime)]
    pub created_at: WallTime,
    /// Whether it was put out of sight.
    #[serde(skip)]
    pub deleted: bool,
}

const WHAT: &str = "saved position";

impl Store {
    /// Saves a position. The second value is false when this identifier's position was there.
    ///
    /// # Errors
    /// `NameTaken` when this robot has another one of that name, `IdTaken` when the identifier
    /// belongs to one that was deleted.
    pub async fn save_position(
        &self,
        id: PositionId,
        robot: &str,
        name: &str,
        joints_deg: [f64; 6],
        now: WallTime,
    ) -> Result<(Position, bool)> {
        let made = sqlx::query(
            "INSERT INTO saved_position (id, robot, name, joints_deg, created_at_ms) \
             VALUES (?, ?, ?, ?, ?) ON CONFLICT (id) DO NOTHING",
        )
        .bind(id.to_string())
        .bind(robot)
        .bind(name)
        .bind(to_json(&joints_deg, WHAT)?)
        .bind(now.0)
        .execute(&self.writer)
        .await
        .map_err(name_taken)?
        .rows_affected()
            == 1;
        let position = self.position(id).await?;
        if position.deleted {
            return Err(Error::IdTaken { what: WHAT });
        }
        Ok((position, made))
    }

    /// The positions in sight by name; only those of `robot` when it is given.
    pub async fn positions(&self, robot: Option<&str>) -> Result<Vec<Position>> {
        sqlx::query(
            "SELECT * FROM saved_position WHERE deleted_at_ms IS NULL \
             AND (?1 IS NULL OR robot = ?1) ORDER BY robot, name COLLATE NOCASE",
        )
        .bind(robot)
        .fetch_all(&self.readers)
        .await?
        .iter()
        .map(from_row)
        .collect()
    }

    /// One position, also when it was deleted.
    pub async fn position(&self, id: PositionId) -> Result<Position> {
        let row = sqlx::query("SELECT * FROM saved_position WHERE id = ?")
            .bind(id.to_string())
            .fetch_optional(&self.readers)
            .await?;
        from_row(&row.ok_or(Error::NotFound { what: WHAT })?)
    }

    /// Gives a position another name, other angles, or both.
    pub async fn change_position(
        &self,
        id: PositionId,
        name: Option<&str>,
        joints_deg: Option<[f64; 6]>,
    ) -> Result<Position> {
        let joints_deg = joints_deg
            .map(|joints_deg| to_json(&joints_deg, WHAT))
            .transpose()?;
        let changed = sqlx::query(
            "UPDATE saved_position SET name = coalesce(?, name), \
             joints_deg = coalesce(?, joints_deg) WHERE id = ? AND deleted_at_ms IS NULL",
        )
        .bind(name)
        .bind(joints_deg)
        .bind(id.to_string())
        .execute(&self.writer)
        .await
        .map_err(name_taken)?
        .rows_affected();
        if changed == 0 {
            return Err(Error::NotFound { what: WHAT });
        }
        self.position(id).await
    }

    /// Puts a position out of sight.
    pub async fn delete_position(&self, id: PositionId, now: WallTime) -> Result<()> {
        let changed = sqlx::query(
            "UPDATE saved_position SET deleted_at_ms = ? WHERE id = ? AND deleted_at_ms IS NULL",
        )
        .bind(now.0)
        .bind(id.to_string())
        .execute(&self.writer)
        .await?
        .rows_affected();
        if changed == 0 {
            return Err(Error::NotFound { what: WHAT });
        }
        Ok(())
    }
}

/// The identifier's conflict is taken care of by the statement, so what is left is the name's.
fn name_taken(error: sqlx::Error) -> Error {
    let unique = error
        .as_database_error()
        .is_some_and(sqlx::error::DatabaseError::is_unique_violation);
    if unique {
        Error::NameTaken { what: WHAT }
    } else {
        error.into()
    }
}

fn from_row(row: &SqliteRow) -> Result<Position> {
    Ok(Position {
        id: parsed(row, "id")?,
        robot: row.try_get("robot")?,
        name: row.try_get("name")?,
        joints_deg: json(row, "joints_deg")?.ok_or(Error::Damaged { what: WHAT })?,
        created_at: WallTime(row.try_get("created_at_ms")?),
        deleted: row.try_get::<Option<i64>, _>("deleted_at_ms")?.is_some(),
    })
}
