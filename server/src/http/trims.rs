//! Cutting the ends of a take: nothing is lost, and the whole of it is one request away.

use axum::extract::State;
use serde::Serialize;
use utoipa::ToSchema;

use super::auth::Actor;
use super::error::{ApiError, Problem};
use super::extract::{Json, Path};
use super::state::AppState;
use crate::ids::DemonstrationId;
use crate::store::demonstrations::Demonstration;
use crate::store::trims::Trim;
use crate::trimming;

/// What is proposed to be cut.
#[derive(Debug, Serialize, ToSchema)]
pub struct TrimSuggestion {
    /// The stretch that is left without the standing still at both ends; missing when there is
    /// hardly any.
    #[serde(skip_serializing_if = "Option::is_none")]
    trim: Option<Trim>,
}

/// Chooses the stretch of a take that is used; what was recorded stays.
#[utoipa::path(put, path = "/demonstrations/{id}/trim", tag = "demonstrations", params(("id" = DemonstrationId, Path)), request_body = Trim, responses(
    (status = 200, body = Demonstration),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "It is still being recorded", body = Problem, content_type = "application/problem+json"),
    (status = 422, description = "Too little is left, or nothing can be learnt from it", body = Problem, content_type = "application/problem+json"),
))]
pub async fn set(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(id): Path<DemonstrationId>,
    Json(wish): Json<Trim>,
) -> Result<Json<Demonstration>, ApiError> {
    let demonstration = trimming::choose(&state.store, id, wish).await?;
    state.events.tell(&demonstration);
    state.audit(&actor, "cut a demonstration", id).await;
    Ok(Json(demonstration))
}

/// Uses the whole take again.
#[utoipa::path(delete, path = "/demonstrations/{id}/trim", tag = "demonstrations", params(("id" = DemonstrationId, Path)), responses(
    (status = 200, body = Demonstration),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 409, body = Problem, content_type = "application/problem+json"),
))]
pub async fn remove(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(id): Path<DemonstrationId>,
) -> Result<Json<Demonstration>, ApiError> {
    let demonstration = state.store.set_trim(id, None).await?;
    state.events.tell(&demonstration);
    state
        .audit(&actor, "uses a whole demonstration again", id)
        .await;
    Ok(Json(demonstration))
}

/// What could be cut of a take: the standing still before and after the motion.
#[utoipa::path(get, path = "/demonstrations/{id}/trim/suggestion", tag = "demonstrations", params(("id" = DemonstrationId, Path)), responses(
    (status = 200, body = TrimSuggestion),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn suggest(
    State(state): State<AppState>,
    Path(id): Path<DemonstrationId>,
) -> Result<Json<TrimSuggestion>, ApiError> {
    state.store.demonstration(id).await?;
    let whole = trimming::recording(&state.store, id, None).await?;
    let trim = tokio::task::spawn_blocking(move || trimming::proposal(&whole))
        .await
        .map_err(|error| ApiError::internal(&error))?;
    Ok(Json(TrimSuggestion { trim }))
}
