//! Reproductions: having the arm make a planned motion, and what came of it.

use axum::extract::State;
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::Deserialize;
use utoipa::{IntoParams, ToSchema};

use super::auth::Actor;
use super::control::OnPhone;
use super::error::{ApiError, Problem};
use super::extract::{Json, Path, Query};
use super::signals::RunSignalMark;
use super::state::AppState;
use super::trajectories::{MaxPoints, RunTrajectory, picks, run_trajectory_of};
use crate::ids::{ReproductionId, TaskId};
use crate::reproducing::{ReproducingError, StartRequest};
use crate::store::flights::Stretch;
use crate::store::reproductions::Reproduction;

/// A motion to be started.
#[derive(Debug, Deserialize, ToSchema)]
pub struct NewReproduction {
    /// The plan to run.
    plan: String,
    /// The robot that shall make it; the first one when it is missing. Only the robot that the
    /// plan was made for may.
    robot: Option<String>,
    /// The reproduction's identifier; the server makes one when it is missing. The same again
    /// does not start a second motion.
    id: Option<ReproductionId>,
    /// True: the arm moves only while somebody holds the button on a phone, which says so on the
    /// live socket.
    #[serde(default)]
    hold: bool,
}

/// Which reproductions.
#[derive(Debug, Deserialize, IntoParams)]
pub struct Filter {
    /// Only of this task.
    task: Option<TaskId>,
    /// How many at most, from 1 to 200, which is also what is meant when it is missing.
    limit: Option<u32>,
}

/// So many reproductions are listed at most.
const LISTED: u32 = 200;

/// Starts the motion of a plan. A start that is repeated never moves the arm twice.
#[utoipa::path(post, path = "/reproductions", tag = "reproductions", request_body = NewReproduction,
    params(("Idempotency-Key" = Option<String>, Header, description = "Names this start")),
    responses(
        (status = 202, body = Reproduction, headers(("Location" = String, description = "The reproduction"))),
        (status = 404, body = Problem, content_type = "application/problem+json"),
        (status = 409, description = "The arm is busy, not ready or not at the start, or the plan is not known or another robot's", body = Problem, content_type = "application/problem+json"),
        (status = 503, description = "The controller does not answer", body = Problem, content_type = "application/problem+json"),
    )
)]
pub async fn start(
    State(state): State<AppState>,
    Actor(actor): Actor,
    OnPhone(phone): OnPhone,
    headers: HeaderMap,
    Json(new): Json<NewReproduction>,
) -> Result<Response, ApiError> {
    let arm = state.arms.named(new.robot.as_deref())?;
    arm.claim(phone.as_ref())?;
    if !new.hold && !arm.continuous_run {
        return Err(ReproducingError::HoldRequired.into());
    }
    let request = StartRequest {
        plan: new.plan,
        id: new.id,
        key: idempotency_key(&headers)?,
        hold: new.hold,
    };
    let reproduction = arm.reproducer.start(request).await?;
    state
        .audit(&actor, "started a motion", reproduction.id)
        .await;
    let location = format!("/api/v1/reproductions/{}", reproduction.id);
    let location = HeaderValue::from_str(&location).map_err(|error| ApiError::internal(&error))?;
    let headers = [(header::LOCATION, location)];
    Ok((StatusCode::ACCEPTED, headers, Json(reproduction)).into_response())
}

/// The latest reproductions, newest first.
#[utoipa::path(get, path = "/reproductions", tag = "reproductions", params(Filter), responses(
    (status = 200, body = [Reproduction]),
))]
pub async fn list(
    State(state): State<AppState>,
    Query(filter): Query<Filter>,
) -> Result<Json<Vec<Reproduction>>, ApiError> {
    let limit = filter.limit.unwrap_or(LISTED).clamp(1, LISTED);
    Ok(Json(state.store.reproductions(filter.task, limit).await?))
}

/// One reproduction.
#[utoipa::path(get, path = "/reproductions/{id}", tag = "reproductions", params(("id" = ReproductionId, Path)), responses(
    (status = 200, body = Reproduction),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn show(
    State(state): State<AppState>,
    Path(id): Path<ReproductionId>,
) -> Result<Json<Reproduction>, ApiError> {
    Ok(Json(state.store.reproduction(id).await?))
}

/// Stops a motion; the arm comes to rest on its path. One that has ended stays as it is.
#[utoipa::path(post, path = "/reproductions/{id}/stop", tag = "reproductions", params(("id" = ReproductionId, Path)), responses(
    (status = 200, body = Reproduction),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn stop(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(id): Path<ReproductionId>,
) -> Result<Json<Reproduction>, ApiError> {
    let running = state.store.reproduction(id).await?;
    let arm = state.arms.that_made(running.robot.as_deref());
    let reproduction = arm.reproducer.stop(id).await?;
    state.audit(&actor, "stopped a motion", id).await;
    Ok(Json(reproduction))
}

/// What was commanded and what was measured, thinned out for a plot.
#[utoipa::path(get, path = "/reproductions/{id}/trajectory", tag = "reproductions", params(("id" = ReproductionId, Path), MaxPoints), responses(
    (status = 200, body = RunTrajectory),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn trajectory(
    State(state): State<AppState>,
    Path(id): Path<ReproductionId>,
    Query(max): Query<MaxPoints>,
) -> Result<Json<RunTrajectory>, ApiError> {
    state.store.reproduction(id).await?;
    let count = state.store.flight_cycles(id).await?;
    let mut wanted = picks(count, max.points(400)?).peekable();
    let (mut picked, mut passed) = (Vec::new(), 0);
    let mut pages = state.store.flight(id, Stretch::ALL);
    while let Some(cycles) = pages.next().await? {
        while let Some(at) = wanted.next_if(|at| *at < passed + cycles.len()) {
            picked.push(cycles[at - passed]);
        }
        passed += cycles.len();
    }
    let signals = RunSignalMark::all(state.store.run_signals(id).await?);
    Ok(Json(run_trajectory_of(&picked).with_signals(signals)))
}

fn idempotency_key(headers: &HeaderMap) -> Result<Option<String>, ApiError> {
    let Some(key) = headers.get("idempotency-key") else {
        return Ok(None);
    };
    match key.to_str().map(str::trim) {
        Ok(key) if (1..=200).contains(&key.len()) => Ok(Some(key.to_owned())),
        _ => Err(ApiError::unprocessable(
            "bad_idempotency_key",
            "Idempotency-Key",
            "The key must be 1 to 200 plain characters.",
        )),
    }
}
