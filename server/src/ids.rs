//! Identifiers: UUIDs of version 7, one type for each kind of thing, text in JSON and SQL.
//!
//! A client may make the identifier itself, so that a request repeated on bad Wi-Fi is harmless.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};
use uuid::Uuid;

macro_rules! define_id {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(
            Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize,
        )]
        #[serde(transparent)]
        pub struct $name(Uuid);

        impl $name {
            /// A fresh identifier; later ones sort after earlier ones.
            #[expect(
                clippy::new_without_default,
                reason = "a default identifier would suggest that there is a natural one"
            )]
            pub fn new() -> Self {
                Self(Uuid::now_v7())
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.fmt(f)
            }
        }

        impl FromStr for $name {
            type Err = uuid::Error;

            fn from_str(text: &str) -> Result<Self, Self::Err> {
                text.parse().map(Self)
            }
        }

        impl utoipa::PartialSchema for $name {
            fn schema() -> utoipa::openapi::RefOr<utoipa::openapi::schema::Schema> {
                use utoipa::openapi::schema::{KnownFormat, ObjectBuilder, SchemaFormat, Type};
                ObjectBuilder::new()
                    .schema_type(Type::String)
                    .format(Some(SchemaFormat::KnownFormat(KnownFormat::Uuid)))
                    .into()
            }
        }

        impl utoipa::ToSchema for $name {}
    };
}

define_id!(
    /// A task: what is to be taught.
    ///
    /// A task's identifier is not a model's:
    /// ```compile_fail
    /// let model: server::ids::ModelId = server::ids::TaskId::new();
    /// ```
    TaskId
);
define_id!(
    /// One shown example.
    DemonstrationId
);
define_id!(
    /// One trained version.
    ModelId
);
define_id!(
    /// One piece of background work.
    JobId
);
define_id!(
    /// One motion that the arm made.
    ReproductionId
);
define_id!(
    /// A pose of one robot that somebody gave a name.
    PositionId
);
define_id!(
    /// One set of answers to the questionnaire.
    ReplyId
);
define_id!(
    /// Whoever uses one phone: the phone makes it up, and nothing leads from it to a name.
    PersonId
);
