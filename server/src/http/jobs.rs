//! Background work.

use axum::extract::State;
use serde::Deserialize;
use utoipa::IntoParams;

use super::auth::Actor;
use super::error::{ApiError, Problem};
use super::extract::{Json, Path, Query};
use super::state::AppState;
use crate::ids::JobId;
use crate::store::jobs::{Job, JobState};

/// Which jobs.
#[derive(Debug, Deserialize, IntoParams)]
pub struct Filter {
    /// Only jobs in this state.
    #[param(inline)]
    state: Option<JobState>,
}

/// The latest 500 jobs, newest first.
#[utoipa::path(get, path = "/jobs", tag = "jobs", params(Filter), responses(
    (status = 200, body = [Job]),
    (status = 400, description = "No such state", body = Problem, content_type = "application/problem+json"),
))]
pub async fn list(
    State(state): State<AppState>,
    Query(filter): Query<Filter>,
) -> Result<Json<Vec<Job>>, ApiError> {
    Ok(Json(state.store.jobs(filter.state).await?))
}

/// One job.
#[utoipa::path(get, path = "/jobs/{id}", tag = "jobs", params(("id" = JobId, Path)), responses(
    (status = 200, body = Job),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn show(
    State(state): State<AppState>,
    Path(id): Path<JobId>,
) -> Result<Json<Job>, ApiError> {
    Ok(Json(state.store.job(id).await?))
}

/// Calls a job off. One that has ended stays as it is.
#[utoipa::path(post, path = "/jobs/{id}/cancel", tag = "jobs", params(("id" = JobId, Path)), responses(
    (status = 200, body = Job),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn cancel(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(id): Path<JobId>,
) -> Result<Json<Job>, ApiError> {
    let job = state.queue.cancel(id).await?;
    state.audit(&actor, "called off a job", id).await;
    Ok(Json(job))
}
