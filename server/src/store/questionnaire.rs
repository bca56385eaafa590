//! The questionnaire's replies, and their means for the dashboard.

use serde::Serialize;
use sqlx::Row;
use sqlx::sqlite::SqliteRow;

use super::text::{parsed, words};
use super::{Error, Result, Store};
use crate::clock::WallTime;
use crate::ids::{PersonId, ReplyId, ReproductionId, TaskId};

/// How many statements the questionnaire has.
pub const STATEMENTS: usize = 5;
/// Its columns, in the order in which the statements are shown.
const COLUMNS: [&str; STATEMENTS] = ["learned", "safe", "accurate", "simple", "enjoyable"];

words!(
    /// Over which time replies are taken together.
    Period {
        /// Over all of it.
        All = "all",
        /// From Monday to Sunday, UTC.
        Week = "week",
        /// By the calendar, UTC.
        Month = "month",
    }
);

/// One reply. Whose it is is not told.
#[derive(Clone, Debug, PartialEq, Serialize, utoipa::ToSchema)]
pub struct Reply {
    /// Its identifier.
    pub id: ReplyId,
    /// The task that it is about.
    pub task_id: TaskId,
    /// The motion after which it was given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reproduction_id: Option<ReproductionId>,
    /// When.
    #[schema(value_type = String, format = DateTime)]
    pub at: WallTime,
    /// From 1 (not at all) to 5 (completely); missing when the person did not want to answer.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<Vec<u8>>)]
    pub answers: Option<[u8; STATEMENTS]>,
}

/// What became of a reply.
#[derive(Clone, Debug, PartialEq)]
pub enum Given {
    /// It is stored.
    Stored(Reply),
    /// It was stored already.
    Known(Reply),
    /// This person gave one after the time that was named.
    TooSoon,
}

/// The means of the replies to one task in one period.
#[derive(Clone, Debug, PartialEq, Serialize, utoipa::ToSchema)]
pub struct QuestionnaireResult {
    /// The task.
    pub task_id: TaskId,
    /// What people call it.
    pub task_name: String,
    /// The period's first day; over all of the time, the day of the first reply.
    #[schema(format = Date)]
    pub from: String,
    /// How many answered.
    pub replies: u32,
    /// For each statement, the mean of the answers.
    #[schema(value_type = Vec<f64>)]
    pub mean: [f64; STATEMENTS],
}

impl Store {
    /// When this person last replied or declined to.
    pub async fn last_reply(&self, person: PersonId) -> Result<Option<WallTime>> {
        let at: Option<i64> =
            sqlx::query_scalar("SELECT max(at_ms) FROM questionnaire_reply WHERE person = ?")
                .bind(person.to_string())
                .fetch_one(&self.readers)
                .await?;
        Ok(at.map(WallTime))
    }

    /// Stores a reply, unless this person gave one after `since`.
    pub async fn add_reply(
        &self,
        person: PersonId,
        reply: &Reply,
        since: WallTime,
    ) -> Result<Given> {
        let mut transaction = self.begin().await?;
        let known = sqlx::query("SELECT * FROM questionnaire_reply WHERE id = ?")
            .bind(reply.id.to_string())
            .fetch_optional(&mut *transaction)
            .await?;
        if let Some(row) = known {
            let whose: PersonId = parsed(&row, "person")?;
            return if whose == person {
                Ok(Given::Known(from_row(&row)?))
            } else {
                Err(Error::IdTaken { what: "reply" })
            };
        }
        let too_soon: bool = sqlx::query_scalar(
            "SELECT EXISTS (SELECT 1 FROM questionnaire_reply WHERE person = ? AND at_ms > ?)",
        )
        .bind(person.to_string())
        .bind(since.0)
        .fetch_one(&mut *transaction)
        .await?;
        if too_soon {
            return Ok(Given::TooSoon);
        }
        let mut insert = sqlx::query(
            "INSERT INTO questionnaire_reply (id, person, task_id, reproduction_id, at_ms, \
             learned, safe, accurate, simple, enjoyable) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        )
        .bind(reply.id.to_string())
        .bind(person.to_string())
        .bind(reply.task_id.to_string())
        .bind(reply.reproduction_id.map(|id| id.to_string()))
        .bind(reply.at.0);
        for statement in 0..STATEMENTS {
            insert = insert.bind(reply.answers.map(|answers| answers[statement]));
        }
        insert.execute(&mut *transaction).await?;
        transaction.commit().await?;
        Ok(Given::Stored(reply.clone()))
    }

    /// The means for each task in sight and each period that has answers, tasks and periods oldest
    /// first.
    pub async fn questionnaire_results(&self, by: Period) -> Result<Vec<QuestionnaireResult>> {
        sqlx::query(
            "SELECT task_id, name, count(*) AS replies, avg(learned) AS learned, \
             avg(safe) AS safe, avg(accurate) AS accurate, avg(simple) AS simple, \
             avg(enjoyable) AS enjoyable, \
             CASE ?1 WHEN 'all' THEN date(min(at_ms) / 1000, 'unixepoch') ELSE period END \
             AS from_date \
             FROM (SELECT reply.*, task.name, task.created_at_ms, CASE ?1 \
               WHEN 'week' THEN date(at_ms / 1000, 'unixepoch', 'weekday 0', '-6 days') \
               WHEN 'month' THEN date(at_ms / 1000, 'unixepoch', 'start of month') \
               ELSE '' END AS period \
               FROM questionnaire_reply AS reply JOIN task ON task.id = reply.task_id \
               WHERE learned IS NOT NULL AND task.deleted_at_ms IS NULL) \
             GROUP BY task_id, period ORDER BY created_at_ms, task_id, period",
        )
        .bind(by.as_str())
        .fetch_all(&self.readers)
        .await?
        .iter()
        .map(|row| {
            let mut mean = [0.0; STATEMENTS];
            for (mean, column) in mean.iter_mut().zip(COLUMNS) {
                *mean = row.try_get(column)?;
            }
            Ok(QuestionnaireResult {
                task_id: parsed(row, "task_id")?,
                task_name: row.try_get("name")?,
                from: row.try_get("from_date")?,
                replies: row.try_get("replies")?,
                mean,
            })
        })
        .collect()
    }
}

fn from_row(row: &SqliteRow) -> Result<Reply> {
    let mut answers = [0; STATEMENTS];
    let mut given = true;
    for (answer, column) in answers.iter_mut().zip(COLUMNS) {
        match row.try_get::<Option<u8>, _>(column)? {
            Some(value) => *answer = value,
            None => given = false,
        }
    }
    let reproduction: Option<String> = row.try_get("reproduction_id")?;
    let reproduction = reproduction.map(|id| id.parse()).transpose();
    Ok(Reply {
        id: parsed(row, "id")?,
        task_id: parsed(row, "task_id")?,
        reproduction_id: reproduction.map_err(|_| Error::Damaged { what: "reply" })?,
        at: WallTime(row.try_get("at_ms")?),
        answers: given.then_some(answers),
    })
}
