//! Holding up a recording, and going on with it.

use axum::extract::State;

use super::auth::Actor;
use super::error::{ApiError, Problem};
use super::extract::{Json, Path};
use super::state::AppState;
use crate::ids::DemonstrationId;
use crate::recording::Order;
use crate::store::demonstrations::Demonstration;

/// Holds up a recording by hand: the arm stays soft, and what it does is not recorded.
#[utoipa::path(post, path = "/demonstrations/{id}/pause", tag = "demonstrations", params(("id" = DemonstrationId, Path)), responses(
    (status = 200, body = Demonstration),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "It is not being recorded, or by the virtual hand", body = Problem, content_type = "application/problem+json"),
))]
pub async fn pause(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(id): Path<DemonstrationId>,
) -> Result<Json<Demonstration>, ApiError> {
    let paused = ordered(&state, id, Order::Pause).await?;
    state.audit(&actor, "held up a recording", id).await;
    Ok(paused)
}

/// Goes on with a recording where it was held up. The arm has to be there again.
#[utoipa::path(post, path = "/demonstrations/{id}/resume", tag = "demonstrations", params(("id" = DemonstrationId, Path)), responses(
    (status = 200, body = Demonstration),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "The arm is elsewhere", body = Problem, content_type = "application/problem+json"),
))]
pub async fn resume(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(id): Path<DemonstrationId>,
) -> Result<Json<Demonstration>, ApiError> {
    let going_on = ordered(&state, id, Order::Resume).await?;
    state.audit(&actor, "went on with a recording", id).await;
    Ok(going_on)
}

async fn ordered(
    state: &AppState,
    id: DemonstrationId,
    order: Order,
) -> Result<Json<Demonstration>, ApiError> {
    let open = state.store.demonstration(id).await?;
    let arm = state.arms.that_made(open.robot.as_deref());
    Ok(Json(arm.recorder.order(id, order).await?))
}
