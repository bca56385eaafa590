//! Whether the server is up.

use serde::Serialize;
use utoipa::ToSchema;

use super::extract::Json;

/// The server is up.
#[derive(Debug, Serialize, ToSchema)]
pub struct Health {
    /// Always "ok".
    status: &'static str,
    /// The server's version.
    version: &'static str,
}

/// Says that the server is up.
#[utoipa::path(get, path = "/health", tag = "session", responses((status = 200, body = Health)))]
pub async fn show() -> Json<Health> {
    Json(Health {
        status: "ok",
        version: env!("CARGO_PKG_VERSION"),
    })
}
