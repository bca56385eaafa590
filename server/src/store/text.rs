//! How words, identifiers and small lists are kept in columns.

use std::str::FromStr;

use sqlx::Row;
use sqlx::sqlite::SqliteRow;

use super::{Error, Result};

/// A set of words: the variants of an enum, as they stand in JSON and in SQL.
macro_rules! words {
    ($(#[$doc:meta])* $name:ident { $($(#[$variant_doc:meta])* $variant:ident = $text:literal,)+ }) => {
        $(#[$doc])*
        #[derive(
            Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize,
            utoipa::ToSchema,
        )]
        pub enum $name {
            $($(#[$variant_doc])* #[serde(rename = $text)] $variant,)+
        }

        impl $name {
            /// The word for it.
            pub fn as_str(self) -> &'static str {
                match self {
                    $(Self::$variant => $text,)+
                }
            }
        }

        impl std::str::FromStr for $name {
            type Err = ();

            fn from_str(text: &str) -> std::result::Result<Self, ()> {
                match text {
                    $($text => Ok(Self::$variant),)+
                    _ => Err(()),
                }
            }
        }
    };
}
pub(super) use words;

/// Reads a column that holds an identifier or a word.
pub(super) fn parsed<T: FromStr>(row: &SqliteRow, column: &'static str) -> Result<T> {
    let text: String = row.try_get(column)?;
    text.parse().map_err(|_| Error::Damaged { what: column })
}

/// Reads a column that may hold JSON.
pub(super) fn json<T: serde::de::DeserializeOwned>(
    row: &SqliteRow,
    column: &'static str,
) -> Result<Option<T>> {
    let text: Option<String> = row.try_get(column)?;
    text.map(|text| serde_json::from_str(&text))
        .transpose()
        .map_err(|_| Error::Damaged { what: column })
}

/// JSON for a column. Lists of numbers and report objects can't fail to become JSON.
pub(super) fn to_json<T: serde::Serialize>(value: &T, what: &'static str) -> Result<String> {
    serde_json::to_string(value).map_err(|_| Error::Damaged { what })
}

/// Reads a count or a number of microseconds, which are never negative.
pub(super) fn unsigned(row: &SqliteRow, column: &'static str) -> Result<u64> {
    let value: i64 = row.try_get(column)?;
    u64::try_from(value).map_err(|_| Error::Damaged { what: column })
}

/// What went wrong with a job or a model, in the three columns that both have.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, utoipa::ToSchema)]
pub struct Failure {
    /// For programs.
    pub code: String,
    /// What was wrong.
    pub message: String,
    /// What to do.
    pub advice: String,
}

/// Reads the three columns of a failure.
pub(super) fn failure(row: &SqliteRow) -> Result<Option<Failure>> {
    let code: Option<String> = row.try_get("failure_code")?;
    let message: Option<String> = row.try_get("failure_message")?;
    let advice: Option<String> = row.try_get("failure_advice")?;
    Ok(code.map(|code| Failure {
        code,
        message: message.unwrap_or_default(),
        advice: advice.unwrap_or_default(),
    }))
}
