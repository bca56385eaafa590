//! Photos of tasks.

use axum::body::Bytes;
use axum::extract::State;
use axum::extract::rejection::BytesRejection;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};

use super::auth::Actor;
use super::error::{ApiError, Problem};
use super::extract::{Json, Path};
use super::state::AppState;
use crate::ids::TaskId;
use crate::pictures::{self, PictureError};
use crate::store::Task;

/// Gives a task a photo: a JPEG, PNG or WebP file of at most 100 kB.
#[utoipa::path(put, path = "/tasks/{task}/picture", tag = "tasks", params(("task" = TaskId, Path)), request_body(content = Vec<u8>, content_type = "application/octet-stream"), responses(
    (status = 200, body = Task),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 413, body = Problem, content_type = "application/problem+json"),
    (status = 422, description = "It is no such picture", body = Problem, content_type = "application/problem+json"),
))]
pub async fn set(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(task): Path<TaskId>,
    body: Result<Bytes, BytesRejection>,
) -> Result<Json<Task>, ApiError> {
    let body = match body {
        Err(rejection) if rejection.status() == StatusCode::PAYLOAD_TOO_LARGE => {
            return Err(PictureError::TooLarge.into());
        }
        body => body?,
    };
    let changed = pictures::store(&state.store, task, &body).await?;
    state.audit(&actor, "gave a task a picture", task).await;
    Ok(Json(changed))
}

/// A task's photo. What is under an address with the photo's name never changes.
#[utoipa::path(get, path = "/tasks/{task}/picture", tag = "tasks", params(("task" = TaskId, Path)), responses(
    (status = 200, body = Vec<u8>, content_type = "image/webp"),
    (status = 404, description = "It has none", body = Problem, content_type = "application/problem+json"),
))]
pub async fn show(
    State(state): State<AppState>,
    Path(task): Path<TaskId>,
) -> Result<Response, ApiError> {
    let picture = state.store.picture(task).await?;
    let headers = [
        (header::CONTENT_TYPE, picture.kind.as_str()),
        (header::CONTENT_DISPOSITION, "inline; filename=\"picture\""),
        (
            header::CACHE_CONTROL,
            "private, max-age=31536000, immutable",
        ),
    ];
    Ok((headers, picture.body).into_response())
}

/// Takes a task's photo away.
#[utoipa::path(delete, path = "/tasks/{task}/picture", tag = "tasks", params(("task" = TaskId, Path)), responses(
    (status = 200, body = Task),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn remove(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(task): Path<TaskId>,
) -> Result<Json<Task>, ApiError> {
    state.store.remove_picture(task).await?;
    state
        .audit(&actor, "took a task's picture away", task)
        .await;
    Ok(Json(state.store.task(task).await?))
}
