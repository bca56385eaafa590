//! While the arm moves and after it was stopped: another speed, a pause, and the way back.

use axum::extract::State;
use axum::http::StatusCode;
use serde::Deserialize;
use utoipa::ToSchema;

use super::auth::Actor;
use super::control::OnPhone;
use super::error::{ApiError, Problem};
use super::extract::{Json, Path};
use super::plans::{Plan, answer};
use super::state::AppState;
use crate::ids::ReproductionId;

/// How a running motion is to go on. What is missing stays as it is.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Pace {
    /// Speed as a share of the plan's, 0.05 to 1. It holds until the motion ends.
    speed: Option<f64>,
    /// True: slow down to standstill on the path. False: go on.
    paused: Option<bool>,
}

/// Changes the speed of a running motion, pauses it, or lets it go on.
#[utoipa::path(post, path = "/reproductions/{id}/pace", tag = "reproductions", request_body = Pace,
    params(("id" = ReproductionId, Path)),
    responses(
        (status = 204, description = "The arm follows from its next cycle on"),
        (status = 404, body = Problem, content_type = "application/problem+json"),
        (status = 409, description = "The motion is over", body = Problem, content_type = "application/problem+json"),
        (status = 422, description = "The speed is no speed", body = Problem, content_type = "application/problem+json"),
    )
)]
pub async fn pace(
    State(state): State<AppState>,
    Actor(actor): Actor,
    OnPhone(phone): OnPhone,
    Path(id): Path<ReproductionId>,
    Json(Pace { speed, paused }): Json<Pace>,
) -> Result<StatusCode, ApiError> {
    let running = state.store.reproduction(id).await?;
    let arm = state.arms.that_made(running.robot.as_deref());
    // Whoever sees a reason may let the arm stand still.
    let only_pauses = paused == Some(true) && speed.is_none();
    if !only_pauses {
        arm.claim(phone.as_ref())?;
    }
    arm.reproducer.pace(&running, speed, paused)?;
    let action = match (paused, speed) {
        (Some(true), _) => "paused a motion",
        (Some(false), _) => "let a motion go on",
        (None, Some(_)) => "changed the speed of a motion",
        (None, None) => return Ok(StatusCode::NO_CONTENT),
    };
    state.audit(&actor, action, id).await;
    Ok(StatusCode::NO_CONTENT)
}

/// Plans the way back of a motion that was stopped, along the path that the arm came, and has it
/// checked. It runs like any other plan.
#[utoipa::path(post, path = "/reproductions/{id}/back", tag = "reproductions",
    params(("id" = ReproductionId, Path)),
    responses(
        (status = 200, body = Plan),
        (status = 404, body = Problem, content_type = "application/problem+json"),
        (status = 409, description = "There is no way back, with the reason", body = Problem, content_type = "application/problem+json"),
    )
)]
pub async fn back(
    State(state): State<AppState>,
    Path(id): Path<ReproductionId>,
) -> Result<Json<Plan>, ApiError> {
    let stopped = state.store.reproduction(id).await?;
    let arm = state.arms.that_made(stopped.robot.as_deref());
    let way = arm
        .reproducer
        .way_back(&stopped, arm.limits.clone())
        .await?;
    Ok(Json(answer(&way)))
}
