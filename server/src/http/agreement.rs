//! How well a task's takes agree.

use axum::extract::State;

use super::error::{ApiError, Problem};
use super::extract::{Json, Path};
use super::state::AppState;
use crate::agreement::{self, TaskAgreement};
use crate::ids::TaskId;

/// How well the takes agree, which one does not and where, and whether to record another. Counted
/// are the takes that were kept and those that wait for a decision.
#[utoipa::path(get, path = "/tasks/{task}/agreement", tag = "demonstrations", params(("task" = TaskId, Path)), responses(
    (status = 200, body = TaskAgreement),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn show(
    State(state): State<AppState>,
    Path(task): Path<TaskId>,
) -> Result<Json<TaskAgreement>, ApiError> {
    let agreement = agreement::of_task(&state.store, &state.agreements, task).await?;
    Ok(Json(agreement))
}
