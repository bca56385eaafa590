//! Saved positions: poses of a robot that people give a name, to begin and end motions at.

use axum::extract::State;
use axum::http::StatusCode;
use serde::Deserialize;
use utoipa::{IntoParams, ToSchema};

use super::auth::Actor;
use super::error::{ApiError, Problem};
use super::extract::{Json, Path, Query};
use super::state::AppState;
use crate::ids::PositionId;
use crate::positions::angles_for;
use crate::store::positions::Position;

/// A position to be saved.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct NewPosition {
    /// Its identifier; the server makes one when it is missing. The same again is the same one.
    id: Option<PositionId>,
    /// Of which robot; the first one when it is missing.
    robot: Option<String>,
    /// What people call it, in at most 80 characters.
    name: String,
    /// Joint angles in degrees; where the arm stands now when they are missing.
    joints_deg: Option<[f64; 6]>,
}

/// What may be changed. What is missing stays as it is.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct PositionChange {
    /// What people call it.
    name: Option<String>,
    /// Joint angles in degrees.
    joints_deg: Option<[f64; 6]>,
    /// True: where the arm stands now takes the place of the joint angles.
    #[serde(default)]
    present: bool,
}

/// Which positions.
#[derive(Debug, Deserialize, IntoParams)]
pub struct Filter {
    /// Only of this robot.
    robot: Option<String>,
}

/// The saved positions by name.
#[utoipa::path(get, path = "/positions", tag = "positions", params(Filter), responses((status = 200, body = [Position])))]
pub async fn list(
    State(state): State<AppState>,
    Query(filter): Query<Filter>,
) -> Result<Json<Vec<Position>>, ApiError> {
    let robot = filter.robot.as_deref();
    Ok(Json(state.store.positions(robot).await?))
}

/// Saves a position: joint angles that are given, or where the arm stands now.
#[utoipa::path(post, path = "/positions", tag = "positions", request_body = NewPosition, responses(
    (status = 201, body = Position),
    (status = 200, description = "It was there already", body = Position),
    (status = 404, description = "No such robot", body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "The name is taken, or it is not known where the arm stands", body = Problem, content_type = "application/problem+json"),
    (status = 422, description = "The name or the angles can't be used", body = Problem, content_type = "application/problem+json"),
))]
pub async fn save(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Json(new): Json<NewPosition>,
) -> Result<(StatusCode, Json<Position>), ApiError> {
    let arm = state.arms.named(new.robot.as_deref())?;
    let name = checked_name(&new.name)?;
    let joints_deg = angles_for(arm, new.joints_deg)?;
    let id = new.id.unwrap_or_else(PositionId::new);
    let (position, made) = state
        .store
        .save_position(id, &arm.id, name, joints_deg, state.clock.now())
        .await?;
    if !made {
        return Ok((StatusCode::OK, Json(position)));
    }
    state.audit(&actor, "saved a position", id).await;
    Ok((StatusCode::CREATED, Json(position)))
}

/// One position.
#[utoipa::path(get, path = "/positions/{id}", tag = "positions", params(("id" = PositionId, Path)), responses(
    (status = 200, body = Position),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn show(
    State(state): State<AppState>,
    Path(id): Path<PositionId>,
) -> Result<Json<Position>, ApiError> {
    let position = state.store.position(id).await?;
    if position.deleted {
        return Err(ApiError::not_found("saved position"));
    }
    Ok(Json(position))
}

/// Gives a position another name or other angles.
#[utoipa::path(patch, path = "/positions/{id}", tag = "positions", params(("id" = PositionId, Path)), request_body = PositionChange, responses(
    (status = 200, body = Position),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "The name is taken, or it is not known where the arm stands", body = Problem, content_type = "application/problem+json"),
    (status = 422, body = Problem, content_type = "application/problem+json"),
))]
pub async fn change(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(id): Path<PositionId>,
    Json(change): Json<PositionChange>,
) -> Result<Json<Position>, ApiError> {
    let position = state.store.position(id).await?;
    let name = change.name.as_deref().map(checked_name).transpose()?;
    let joints_deg = if change.present || change.joints_deg.is_some() {
        let arm = state.arms.named(Some(&position.robot))?;
        Some(angles_for(
            arm,
            change.joints_deg.filter(|_| !change.present),
        )?)
    } else {
        None
    };
    let changed = state.store.change_position(id, name, joints_deg).await?;
    state.audit(&actor, "changed a position", id).await;
    Ok(Json(changed))
}

/// Puts a position out of sight. A motion that still names it is refused from then on.
#[utoipa::path(delete, path = "/positions/{id}", tag = "positions", params(("id" = PositionId, Path)), responses(
    (status = 204, description = "Done"),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn delete(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(id): Path<PositionId>,
) -> Result<StatusCode, ApiError> {
    state.store.delete_position(id, state.clock.now()).await?;
    state.audit(&actor, "deleted a position", id).await;
    Ok(StatusCode::NO_CONTENT)
}

fn checked_name(name: &str) -> Result<&str, ApiError> {
    let name = name.trim();
    let problem = match name.chars().count() {
        0 => "The position needs a name.",
        1..=80 if name.chars().any(char::is_control) => {
            "The name holds characters that can't be shown."
        }
        1..=80 => return Ok(name),
        _ => "The name is longer than 80 characters.",
    };
    Err(ApiError::unprocessable("bad_name", "name", problem).advise("Type a short name."))
}
