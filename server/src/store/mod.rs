//! The store: one SQLite file, and the only place that knows SQL.
//!
//! One connection writes, so writes queue instead of failing as busy, and each commit is on the
//! disk when it returns. Four connections read. Every connection has a thread of its own inside
//! sqlx, so waiting for the store never blocks the async threads.

mod audit;
pub mod cycles;
pub mod dashboard;
pub mod demonstrations;
pub mod flights;
pub mod jobs;
pub mod leases;
pub mod models;
pub mod outcomes;
mod pairing;
pub mod pauses;
pub mod pictures;
pub mod positions;
pub mod questionnaire;
pub mod recordings;
pub mod reproductions;
pub mod samples;
pub mod signals;
mod tasks;
#[cfg(test)]
mod tests;
pub mod text;
pub mod trims;

use std::borrow::Cow;
use std::path::Path;
use std::time::Duration;

use sqlx::migrate::{Migration, MigrationType, Migrator};
use sqlx::sqlite::{
    SqliteConnectOptions, SqliteJournalMode, SqlitePool, SqlitePoolOptions, SqliteSynchronous,
};
use sqlx::{Sqlite, Transaction};

pub use tasks::Task;

/// What can go wrong between the server and its database.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// No such thing.
    #[error("there is no such {what}")]
    NotFound {
        /// The kind of thing.
        what: &'static str,
    },
    /// The thing is there, but not in a state that allows this.
    #[error("this {what} is {state}; it must be {wanted} for that")]
    WrongState {
        /// The kind of thing.
        what: &'static str,
        /// Its present state.
        state: &'static str,
        /// The states that would do.
        wanted: &'static str,
    },
    /// The identifier that a client made is already used for something else.
    #[error("this identifier is already used for another {what}")]
    IdTaken {
        /// The kind of thing.
        what: &'static str,
    },
    /// Something else has this name already.
    #[error("another {what} of this robot has this name")]
    NameTaken {
        /// The kind of thing.
        what: &'static str,
    },
    /// Stored bytes do not match their check sum or their shape.
    #[error("the stored {what} is damaged")]
    Damaged {
        /// The kind of thing.
        what: &'static str,
    },
    /// SQLite refused.
    #[error("the database failed: {0}")]
    Database(#[from] sqlx::Error),
    /// The database could not be brought to this program's version.
    #[error("the database could not be brought up to date: {0}")]
    Migration(#[from] sqlx::migrate::MigrateError),
}

/// Shorthand for this module's results.
pub type Result<T> = std::result::Result<T, Error>;

/// The database. Cheap to clone.
#[derive(Clone)]
pub struct Store {
    writer: SqlitePool,
    readers: SqlitePool,
}

const MIGRATIONS: [(i64, &str, &str); 9] = [
    (
        1,
        "tasks and demonstrations",
        include_str!("../../../migrations/0001_tasks_and_demonstrations.sql"),
    ),
    (
        2,
        "jobs and models",
        include_str!("../../../migrations/0002_jobs_and_models.sql"),
    ),
    (
        3,
        "reproductions",
        include_str!("../../../migrations/0003_reproductions.sql"),
    ),
    (
        4,
        "pairing and audit",
        include_str!("../../../migrations/0004_pairing_and_audit.sql"),
    ),
    (
        5,
        "robots",
        include_str!("../../../migrations/0005_robots.sql"),
    ),
    (
        6,
        "signals",
        include_str!("../../../migrations/0006_signals.sql"),
    ),
    (
        7,
        "flights",
        include_str!("../../../migrations/0007_flights.sql"),
    ),
    (
        8,
        "pictures pauses and trims",
        include_str!("../../../migrations/0008_pictures_pauses_and_trims.sql"),
    ),
    (
        9,
        "positions outcomes questionnaire",
        include_str!("../../../migrations/0009_positions_outcomes_questionnaire.sql"),
    ),
];

impl Store {
    /// Opens the database file, makes it if it is not there, and applies missing migrations.
    ///
    /// # Errors
    /// When the file can't be opened, or was written by a newer or a changed program.
    pub async fn open(file: &Path) -> Result<Self> {
        let options = SqliteConnectOptions::new()
            .filename(file)
            .create_if_missing(true)
            .journal_mode(SqliteJournalMode::Wal)
            .synchronous(SqliteSynchronous::Full)
            .foreign_keys(true)
            .busy_timeout(Duration::from_secs(5));
        let writer = pool(1).connect_with(options.clone()).await?;
        migrator().run(&writer).await?;
        let readers = pool(4)
            .connect_with(options.pragma("query_only", "ON"))
            .await?;
        Ok(Self { writer, readers })
    }

    /// Finishes what was begun and closes the file.
    pub async fn close(&self) {
        self.readers.close().await;
        self.writer.close().await;
    }

    /// A transaction that holds the write lock from its first statement.
    async fn begin(&self) -> Result<Transaction<'static, Sqlite>> {
        Ok(self.writer.begin_with("BEGIN IMMEDIATE").await?)
    }
}

fn pool(connections: u32) -> SqlitePoolOptions {
    SqlitePoolOptions::new()
        .max_connections(connections)
        .min_connections(1)
        .idle_timeout(None)
        .max_lifetime(None)
        .acquire_timeout(Duration::from_secs(10))
}

fn migrator() -> Migrator {
    Migrator::with_migrations(
        MIGRATIONS
            .into_iter()
            .map(|(version, description, sql)| {
                Migration::new(
                    version,
                    Cow::Borrowed(description),
                    MigrationType::Simple,
                    sqlx::SqlSafeStr::into_sql_str(sql),
                    false,
                )
            })
            .collect(),
    )
}
