//! Signals: working one from the phone, and how they are written in answers.

use axum::extract::State;
use robot::SignalView;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::auth::Actor;
use super::control::OnPhone;
use super::error::{ApiError, Problem};
use super::extract::{Json, Path};
use super::robot::RobotAnswer;
use super::state::AppState;
use crate::store::signals::{RunSignal, SignalEvent};

/// A signal that may be worked, as it stands.
#[derive(Debug, Serialize, ToSchema)]
pub struct SignalAnswer {
    /// The controller's name of it.
    name: String,
    /// What people call it.
    label: String,
    /// What setting it does, as a verb: "close".
    on: String,
    /// What resetting it does: "open".
    off: String,
    /// Whether it is set; nothing while that is not known.
    is_on: Option<bool>,
}

/// A signal on a time line.
#[derive(Debug, Serialize, ToSchema)]
pub struct SignalMark {
    /// The controller's name of it.
    name: String,
    /// When, in seconds; 0 in a demonstration says how it stood at the beginning.
    at_s: f64,
    /// Its value from then on.
    on: bool,
}

/// A signal that a motion has set.
#[derive(Debug, Serialize, ToSchema)]
pub struct RunSignalMark {
    /// The controller's name of it.
    name: String,
    /// When the controller had it, in seconds since the arm was started.
    at_s: f64,
    /// Its value from then on.
    on: bool,
    /// How long after its time of the plan that was, in seconds.
    late_s: f64,
}

/// How a signal shall stand.
#[derive(Debug, Deserialize, ToSchema)]
pub struct SignalWish {
    /// Its value.
    on: bool,
}

impl SignalAnswer {
    /// What the view says.
    pub fn of(view: &SignalView) -> Self {
        let signal = view.signal.clone();
        Self {
            name: signal.name,
            label: signal.label,
            on: signal.on,
            off: signal.off,
            is_on: view.is_on,
        }
    }
}

impl SignalMark {
    /// One of a plan.
    pub fn of(signal: &motion::plan::PlanSignal) -> Self {
        Self {
            name: signal.name.clone(),
            at_s: signal.at_s,
            on: signal.on,
        }
    }

    /// Those of a demonstration.
    pub fn all(signals: Vec<SignalEvent>) -> Vec<Self> {
        let mark = |signal: SignalEvent| Self {
            name: signal.name,
            at_s: signal.at_us as f64 / 1e6,
            on: signal.on,
        };
        signals.into_iter().map(mark).collect()
    }
}

impl RunSignalMark {
    /// Those of a reproduction.
    pub fn all(signals: Vec<RunSignal>) -> Vec<Self> {
        let mark = |signal: RunSignal| Self {
            name: signal.name,
            at_s: signal.at_us as f64 / 1e6,
            on: signal.on,
            late_s: signal.late_s,
        };
        signals.into_iter().map(mark).collect()
    }
}

/// Sets a signal. While a demonstration is recorded, it becomes part of it.
#[utoipa::path(post, path = "/robots/{robot}/signals/{name}", tag = "robots", params(("robot" = String, Path), ("name" = String, Path)), request_body = SignalWish, responses(
    (status = 200, description = "The controller has it", body = RobotAnswer),
    (status = 404, description = "No such signal is configured", body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "A motion is running, or the signal did not change", body = Problem, content_type = "application/problem+json"),
))]
pub async fn set(
    State(state): State<AppState>,
    Actor(actor): Actor,
    OnPhone(phone): OnPhone,
    Path((robot, name)): Path<(String, String)>,
    Json(SignalWish { on }): Json<SignalWish>,
) -> Result<Json<RobotAnswer>, ApiError> {
    let arm = state.arms.named(Some(&robot))?;
    arm.claim(phone.as_ref())?;
    arm.robot.set_signal(&name, on).await?;
    let action = if on { "set a signal" } else { "reset a signal" };
    state.audit(&actor, action, &name).await;
    Ok(Json(RobotAnswer::now(arm)))
}
