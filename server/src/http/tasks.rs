//! Tasks.

use axum::extract::State;
use axum::http::StatusCode;
use serde::Deserialize;
use utoipa::ToSchema;

use super::auth::Actor;
use super::error::{ApiError, Problem};
use super::extract::{Json, Path};
use super::state::AppState;
use crate::ids::TaskId;
use crate::store::Task;

/// A task to be made.
#[derive(Debug, Deserialize, ToSchema)]
pub struct NewTask {
    /// Its identifier; the server makes one when it is missing. The same again is the same task.
    id: Option<TaskId>,
    /// What people call it.
    name: String,
}

/// What may be changed.
#[derive(Debug, Deserialize, ToSchema)]
pub struct TaskChange {
    /// What people call it.
    name: String,
}

/// All tasks, oldest first.
#[utoipa::path(get, path = "/tasks", tag = "tasks", responses((status = 200, body = [Task])))]
pub async fn list(State(state): State<AppState>) -> Result<Json<Vec<Task>>, ApiError> {
    Ok(Json(state.store.tasks().await?))
}

/// Makes a task.
#[utoipa::path(post, path = "/tasks", tag = "tasks", request_body = NewTask, responses(
    (status = 201, body = Task),
    (status = 200, description = "It was there already", body = Task),
    (status = 422, description = "The name can't be used", body = Problem, content_type = "application/problem+json"),
))]
pub async fn create(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Json(new): Json<NewTask>,
) -> Result<(StatusCode, Json<Task>), ApiError> {
    let name = checked_name(&new.name)?;
    let id = new.id.unwrap_or_else(TaskId::new);
    let (task, made) = state.store.create_task(id, name, state.clock.now()).await?;
    if !made {
        return Ok((StatusCode::OK, Json(task)));
    }
    state.audit(&actor, "made a task", task.id).await;
    Ok((StatusCode::CREATED, Json(task)))
}

/// One task.
#[utoipa::path(get, path = "/tasks/{task}", tag = "tasks", params(("task" = TaskId, Path)), responses(
    (status = 200, body = Task),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn show(
    State(state): State<AppState>,
    Path(task): Path<TaskId>,
) -> Result<Json<Task>, ApiError> {
    Ok(Json(state.store.task(task).await?))
}

/// Gives a task another name.
#[utoipa::path(patch, path = "/tasks/{task}", tag = "tasks", params(("task" = TaskId, Path)), request_body = TaskChange, responses(
    (status = 200, body = Task),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 422, body = Problem, content_type = "application/problem+json"),
))]
pub async fn rename(
    State(state): State<AppState>,
    Path(task): Path<TaskId>,
    Json(change): Json<TaskChange>,
) -> Result<Json<Task>, ApiError> {
    let name = checked_name(&change.name)?;
    Ok(Json(state.store.rename_task(task, name).await?))
}

/// Puts a task out of sight. What belongs to it stays in the database.
#[utoipa::path(delete, path = "/tasks/{task}", tag = "tasks", params(("task" = TaskId, Path)), responses(
    (status = 204, description = "Done"),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn delete(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(task): Path<TaskId>,
) -> Result<StatusCode, ApiError> {
    state.store.delete_task(task, state.clock.now()).await?;
    state.audit(&actor, "deleted a task", task).await;
    Ok(StatusCode::NO_CONTENT)
}

/// Brings a task back that was deleted, with everything that belongs to it.
#[utoipa::path(post, path = "/tasks/{task}/restore", tag = "tasks", params(("task" = TaskId, Path)), responses(
    (status = 200, body = Task),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn restore(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(task): Path<TaskId>,
) -> Result<Json<Task>, ApiError> {
    let restored = state.store.restore_task(task).await?;
    state.audit(&actor, "brought a task back", task).await;
    Ok(Json(restored))
}

fn checked_name(name: &str) -> Result<&str, ApiError> {
    let name = name.trim();
    let problem = match name.chars().count() {
        0 => "The task needs a name.",
        1..=120 if name.chars().any(char::is_control) => {
            "The name holds characters that can't be shown."
        }
        1..=120 => return Ok(name),
        _ => "The name is longer than 120 characters.",
    };
    Err(ApiError::unprocessable("bad_name", "name", problem).advise("Type a short name."))
}
