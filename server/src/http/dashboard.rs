//! The dashboard: everything that an operator follows, in one answer that may be asked for every
//! other second.

use axum::extract::State;
use serde::Serialize;
use utoipa::ToSchema;

use super::error::ApiError;
use super::extract::Json;
use super::robot::RobotAnswer;
use super::state::AppState;
use crate::clock::WallTime;
use crate::store::dashboard::{RunSummary, TaskSummary};
use crate::store::jobs::{Job, JobState};

/// So many of the latest motions are told.
const RUNS: u32 = 30;

/// How everything is now.
#[derive(Debug, Serialize, ToSchema)]
pub struct Dashboard {
    /// When this was put together.
    #[schema(value_type = String, format = DateTime)]
    at: WallTime,
    /// Every robot.
    robots: Vec<RobotAnswer>,
    /// Background work that runs or waits.
    jobs: Vec<Job>,
    /// The latest 30 motions, newest first. Ways back are not among them.
    runs: Vec<RunSummary>,
    /// Every task with its counts. Ways back do not count.
    tasks: Vec<TaskSummary>,
}

/// How everything is now: robots, running work, the latest motions and the counts of each task.
#[utoipa::path(get, path = "/dashboard", tag = "dashboard", responses((status = 200, body = Dashboard)))]
pub async fn show(State(state): State<AppState>) -> Result<Json<Dashboard>, ApiError> {
    let mut jobs = state.store.jobs(Some(JobState::Running)).await?;
    jobs.extend(state.store.jobs(Some(JobState::Queued)).await?);
    Ok(Json(Dashboard {
        at: state.clock.now(),
        robots: state.arms.all().iter().map(RobotAnswer::now).collect(),
        jobs,
        runs: state.store.latest_runs(RUNS).await?,
        tasks: state.store.task_summaries().await?,
    }))
}
