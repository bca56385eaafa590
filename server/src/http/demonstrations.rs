//! Demonstrations: recording, uploading, judging, and looking at them.

use axum::body::Bytes;
use axum::extract::State;
use axum::extract::rejection::BytesRejection;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use robot::HandScript;
use serde::Deserialize;
use utoipa::{IntoParams, ToSchema};

use super::auth::Actor;
use super::control::OnPhone;
use super::error::{ApiError, Problem};
use super::extract::{Json, Path, Query};
use super::state::AppState;
use super::trajectories::{MaxPoints, Trajectory, trajectory_of};
use crate::ids::{DemonstrationId, TaskId};
use crate::jobs::demonstration_with;
use crate::recording::{HandShowing, RecordingRequest};
use crate::store::demonstrations::{Decision, Demonstration};
use crate::store::trims::Trim;
use crate::trimming::recording;
use crate::uploads;

/// A recording to be begun.
#[derive(Debug, Deserialize, ToSchema)]
pub struct NewRecording {
    /// The demonstration's identifier; the server makes one when it is missing. The same again is
    /// the same demonstration.
    id: Option<DemonstrationId>,
    /// From which robot; the first one when it is missing.
    robot: Option<String>,
    /// Has the virtual arm's hand show one of its scripts: "f1", "f2" or "f3".
    #[schema(value_type = Option<String>)]
    virtual_hand: Option<HandScript>,
    /// The seed of the hand's variation; another one for each take makes takes that differ.
    #[serde(default)]
    seed: u64,
}

/// What an uploaded file is called.
#[derive(Debug, Deserialize, IntoParams)]
pub struct UploadName {
    /// The file's name; it helps a person to find the file again.
    name: Option<String>,
}

/// Whether everything is wanted that was recorded.
#[derive(Debug, Deserialize, IntoParams)]
pub struct Whole {
    /// Also what was cut away at the ends.
    #[serde(default)]
    raw: bool,
}

impl Whole {
    fn trim_of(&self, demonstration: &Demonstration) -> Option<Trim> {
        demonstration.trim.filter(|_| !self.raw)
    }
}

/// A task's demonstrations, by take.
#[utoipa::path(get, path = "/tasks/{task}/demonstrations", tag = "demonstrations", params(("task" = TaskId, Path)), responses(
    (status = 200, body = [Demonstration]),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn list(
    State(state): State<AppState>,
    Path(task): Path<TaskId>,
) -> Result<Json<Vec<Demonstration>>, ApiError> {
    state.store.task(task).await?;
    Ok(Json(state.store.demonstrations(task).await?))
}

/// Makes the arm soft and begins to record.
#[utoipa::path(post, path = "/tasks/{task}/demonstrations", tag = "demonstrations", params(("task" = TaskId, Path)), request_body = NewRecording, responses(
    (status = 201, body = Demonstration),
    (status = 200, description = "It was begun before", body = Demonstration),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "The arm is busy or not ready", body = Problem, content_type = "application/problem+json"),
))]
pub async fn record(
    State(state): State<AppState>,
    Actor(actor): Actor,
    OnPhone(phone): OnPhone,
    Path(task_id): Path<TaskId>,
    Json(new): Json<NewRecording>,
) -> Result<(StatusCode, Json<Demonstration>), ApiError> {
    let arm = state.arms.named(new.robot.as_deref())?;
    arm.claim(phone.as_ref())?;
    let request = RecordingRequest {
        id: new.id.unwrap_or_else(DemonstrationId::new),
        task_id,
        hand: new.virtual_hand.map(|script| HandShowing {
            script,
            seed: new.seed,
        }),
    };
    let (demonstration, made) = arm.recorder.start(request).await?;
    if !made {
        return Ok((StatusCode::OK, Json(demonstration)));
    }
    state
        .audit(&actor, "began a recording", demonstration.id)
        .await;
    Ok((StatusCode::CREATED, Json(demonstration)))
}

/// Stores a recorded file: comma-separated values or JSON.
#[utoipa::path(post, path = "/tasks/{task}/demonstrations/upload", tag = "demonstrations", params(("task" = TaskId, Path), UploadName), request_body(content = String, content_type = "text/plain"), responses(
    (status = 201, body = Demonstration),
    (status = 413, body = Problem, content_type = "application/problem+json"),
    (status = 422, description = "Nothing can be learnt from this file, with where and why", body = Problem, content_type = "application/problem+json"),
))]
pub async fn upload(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(task): Path<TaskId>,
    Query(UploadName { name }): Query<UploadName>,
    body: Result<Bytes, BytesRejection>,
) -> Result<(StatusCode, Json<Demonstration>), ApiError> {
    let body = body?;
    let name = name.unwrap_or_else(|| "upload".into());
    let demonstration = uploads::store(&state.store, task, &name, body, state.clock.now()).await?;
    state.events.tell(&demonstration);
    state
        .audit(&actor, "uploaded a demonstration", demonstration.id)
        .await;
    Ok((StatusCode::CREATED, Json(demonstration)))
}

/// One demonstration.
#[utoipa::path(get, path = "/demonstrations/{id}", tag = "demonstrations", params(("id" = DemonstrationId, Path)), responses(
    (status = 200, body = Demonstration),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn show(
    State(state): State<AppState>,
    Path(id): Path<DemonstrationId>,
) -> Result<Json<Demonstration>, ApiError> {
    Ok(Json(state.store.demonstration(id).await?))
}

/// What was recorded, thinned out for a plot.
#[utoipa::path(get, path = "/demonstrations/{id}/trajectory", tag = "demonstrations", params(("id" = DemonstrationId, Path), MaxPoints, Whole), responses(
    (status = 200, body = Trajectory),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn trajectory(
    State(state): State<AppState>,
    Path(id): Path<DemonstrationId>,
    Query(max): Query<MaxPoints>,
    Query(whole): Query<Whole>,
) -> Result<Json<Trajectory>, ApiError> {
    let demonstration = state.store.demonstration(id).await?;
    let recorded = recording(&state.store, id, whole.trim_of(&demonstration)).await?;
    Ok(Json(trajectory_of(recorded, max.points(300)?)))
}

/// What was recorded, at its full rate, as a file that can be uploaded again.
#[utoipa::path(get, path = "/demonstrations/{id}/download", tag = "demonstrations", params(("id" = DemonstrationId, Path), Whole), responses(
    (status = 200, body = String, content_type = "application/json"),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 422, description = "It is too short or has no motion", body = Problem, content_type = "application/problem+json"),
))]
pub async fn download(
    State(state): State<AppState>,
    Path(id): Path<DemonstrationId>,
    Query(whole): Query<Whole>,
) -> Result<Response, ApiError> {
    let demonstration = state.store.demonstration(id).await?;
    let recorded = recording(&state.store, id, whole.trim_of(&demonstration)).await?;
    let name = format!("take {}", demonstration.take);
    let text = tokio::task::spawn_blocking(move || {
        demonstration_with(&name, &recorded.samples, &recorded.signals)
            .map(|d| learning::write::to_json(&d))
    })
    .await
    .map_err(|error| ApiError::internal(&error))??;
    let file = format!("attachment; filename=\"take_{}.json\"", demonstration.take);
    let headers = [
        (header::CONTENT_TYPE, "application/json".to_owned()),
        (header::CONTENT_DISPOSITION, file),
    ];
    Ok((headers, text).into_response())
}

/// Ends a recording; the arm becomes stiff.
#[utoipa::path(post, path = "/demonstrations/{id}/stop", tag = "demonstrations", params(("id" = DemonstrationId, Path)), responses(
    (status = 200, body = Demonstration),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn stop(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(id): Path<DemonstrationId>,
) -> Result<Json<Demonstration>, ApiError> {
    let open = state.store.demonstration(id).await?;
    let arm = state.arms.that_made(open.robot.as_deref());
    let demonstration = arm.recorder.stop(id).await?;
    state.audit(&actor, "ended a recording", id).await;
    Ok(Json(demonstration))
}

/// Says that a model is to be trained from it. This also undoes discarding it.
#[utoipa::path(post, path = "/demonstrations/{id}/keep", tag = "demonstrations", params(("id" = DemonstrationId, Path)), responses(
    (status = 200, body = Demonstration),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 409, body = Problem, content_type = "application/problem+json"),
))]
pub async fn keep(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(id): Path<DemonstrationId>,
) -> Result<Json<Demonstration>, ApiError> {
    decide(&state, &actor, id, Decision::Keep).await
}

/// Says that no model is to be trained from it. The data stays.
#[utoipa::path(post, path = "/demonstrations/{id}/discard", tag = "demonstrations", params(("id" = DemonstrationId, Path)), responses(
    (status = 200, body = Demonstration),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 409, body = Problem, content_type = "application/problem+json"),
))]
pub async fn discard(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(id): Path<DemonstrationId>,
) -> Result<Json<Demonstration>, ApiError> {
    decide(&state, &actor, id, Decision::Discard).await
}

/// Takes such a decision back: the take waits for one again.
#[utoipa::path(post, path = "/demonstrations/{id}/undecide", tag = "demonstrations", params(("id" = DemonstrationId, Path)), responses(
    (status = 200, body = Demonstration),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 409, body = Problem, content_type = "application/problem+json"),
))]
pub async fn undecide(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(id): Path<DemonstrationId>,
) -> Result<Json<Demonstration>, ApiError> {
    decide(&state, &actor, id, Decision::Reconsider).await
}

async fn decide(
    state: &AppState,
    actor: &str,
    id: DemonstrationId,
    decision: Decision,
) -> Result<Json<Demonstration>, ApiError> {
    let demonstration = state.store.decide(id, decision).await?;
    state.events.tell(&demonstration);
    let action = match decision {
        Decision::Keep => "kept a demonstration",
        Decision::Discard => "discarded a demonstration",
        Decision::Reconsider => "took a decision about a demonstration back",
    };
    state.audit(actor, action, id).await;
    Ok(Json(demonstration))
}
