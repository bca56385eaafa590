//! Models: asking for one, and looking at what came of it.

use axum::extract::State;
use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::auth::Actor;
use super::error::{ApiError, Problem};
use super::extract::{Json, Path, Query};
use super::state::AppState;
use super::trajectories::{Curve, MaxPoints, curve_of};
use crate::ids::{DemonstrationId, ModelId, TaskId};
use crate::store::jobs::Job;
use crate::store::models::Model;
use crate::training::{self, Wish};

/// A training to be begun.
#[derive(Debug, Default, Deserialize, ToSchema)]
pub struct NewModel {
    /// What to train from; all demonstrations that were kept when it is missing.
    demonstrations: Option<Vec<DemonstrationId>>,
    /// How to train: "faithful" (when it is missing) or "paper".
    method: Option<String>,
    /// The seed of everything random; the same inputs and seed give the same model.
    seed: Option<u64>,
}

/// The job that trains, and the model that it makes.
#[derive(Debug, Serialize, ToSchema)]
pub struct Training {
    /// The job.
    job: Job,
    /// The model.
    model: Model,
}

/// Trains a model in the background. Asking for the same again is the same job.
#[utoipa::path(post, path = "/tasks/{task}/models", tag = "models", params(("task" = TaskId, Path)), request_body = NewModel, responses(
    (status = 202, body = Training, headers(("Location" = String, description = "The job"))),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 422, description = "The demonstrations can't be used, with which and why", body = Problem, content_type = "application/problem+json"),
))]
pub async fn train(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(task_id): Path<TaskId>,
    Json(new): Json<NewModel>,
) -> Result<Response, ApiError> {
    let wish = Wish {
        task_id,
        demonstrations: new.demonstrations,
        method: new.method,
        seed: new.seed,
    };
    let (job, model) = training::begin(&state.store, &state.queue, wish).await?;
    state.audit(&actor, "asked for a training", model.id).await;
    let location = format!("/api/v1/jobs/{}", job.id);
    let location = HeaderValue::from_str(&location).map_err(|error| ApiError::internal(&error))?;
    let answer = Json(Training { job, model });
    Ok((StatusCode::ACCEPTED, [(header::LOCATION, location)], answer).into_response())
}

/// A task's models, by version.
#[utoipa::path(get, path = "/tasks/{task}/models", tag = "models", params(("task" = TaskId, Path)), responses(
    (status = 200, body = [Model]),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn list(
    State(state): State<AppState>,
    Path(task): Path<TaskId>,
) -> Result<Json<Vec<Model>>, ApiError> {
    state.store.task(task).await?;
    Ok(Json(state.store.models(task).await?))
}

/// One model.
#[utoipa::path(get, path = "/models/{id}", tag = "models", params(("id" = ModelId, Path)), responses(
    (status = 200, body = Model),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn show(
    State(state): State<AppState>,
    Path(id): Path<ModelId>,
) -> Result<Json<Model>, ApiError> {
    Ok(Json(state.store.model(id).await?))
}

/// The model's file, as `team train` writes it.
#[utoipa::path(get, path = "/models/{id}/file", tag = "models", params(("id" = ModelId, Path)), responses(
    (status = 200, body = String, content_type = "application/json"),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn file(
    State(state): State<AppState>,
    Path(id): Path<ModelId>,
) -> Result<Response, ApiError> {
    let model = state.store.model(id).await?;
    let (body, sha256) = state.store.model_file(id).await?;
    let name = format!("attachment; filename=\"model_{}.json\"", model.version);
    let headers = [
        (header::CONTENT_TYPE, "application/json".to_owned()),
        (header::CONTENT_DISPOSITION, name),
        (header::ETAG, format!("\"{sha256}\"")),
    ];
    Ok((headers, body).into_response())
}

/// The learnt motion with its spread.
#[utoipa::path(get, path = "/models/{id}/curve", tag = "models", params(("id" = ModelId, Path), MaxPoints), responses(
    (status = 200, body = Curve),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn curve(
    State(state): State<AppState>,
    Path(id): Path<ModelId>,
    Query(max): Query<MaxPoints>,
) -> Result<Json<Curve>, ApiError> {
    let max_points = max.points(300)?;
    let model = training::load(&state.store, id).await?;
    let curve = tokio::task::spawn_blocking(move || curve_of(&model, max_points)).await;
    Ok(Json(curve.map_err(|error| ApiError::internal(&error))?))
}
