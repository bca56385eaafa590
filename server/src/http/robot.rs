//! The robots: how they are, stopping them, acknowledging a fault, making an arm soft.

use axum::extract::State;
use axum::http::StatusCode;
use robot::{HandScript, RobotView, RunProgress};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::auth::Actor;
use super::control::{OnPhone, moment};
use super::error::{ApiError, Problem};
use super::extract::{Json, Path};
use super::signals::SignalAnswer;
use super::state::AppState;
use crate::arms::Arm;
use crate::control::ControlView;
use crate::recording::HandShowing;

/// A robot as it is now.
#[derive(Debug, Serialize, ToSchema)]
pub struct RobotAnswer {
    /// What requests call it.
    id: String,
    /// What people call it.
    name: String,
    /// "virtual", "gofa" or "none".
    #[schema(value_type = String)]
    kind: robot::RobotKind,
    /// "disconnected", "idle", "guiding", "reproducing", "stopping" or "faulted".
    #[schema(value_type = String)]
    state: robot::RobotState,
    /// Joint angles in degrees, when they are known.
    joints_deg: Option<[f64; 6]>,
    /// Position of the tool flange's centre in millimetres.
    tcp_mm: Option<[f64; 3]>,
    /// How old the joint angles are, in milliseconds.
    age_ms: u64,
    /// Whether the motors are on.
    motors_on: Option<bool>,
    /// The controller's operating mode.
    operating_mode: Option<String>,
    /// Whether the arm is soft.
    lead_through: Option<bool>,
    /// The EGM link.
    egm: EgmAnswer,
    /// What the virtual hand does: "idle", "returning", "showing" or "leading".
    #[schema(value_type = Option<String>)]
    hand: Option<robot::HandActivity>,
    /// Why the arm stands still until somebody acknowledges it.
    fault: Option<FaultAnswer>,
    /// How far the running motion is.
    run: Option<RunAnswer>,
    /// The signals that may be worked.
    signals: Vec<SignalAnswer>,
    /// The phone that may make the arm move; nothing when any may.
    control: Option<ControlView>,
    /// Whether the arm may move without anybody holding a button.
    continuous_run: bool,
}

/// The EGM link.
#[derive(Debug, Serialize, ToSchema)]
pub struct EgmAnswer {
    /// Whether messages come in.
    connected: bool,
    /// How many came in.
    cycles: u64,
    /// How many were lost.
    lost: u64,
    /// How many came late.
    late: u64,
    /// Whether the control loop has real-time priority.
    real_time: bool,
}

/// A fault that waits to be acknowledged.
#[derive(Debug, Serialize, ToSchema)]
pub struct FaultAnswer {
    /// For programs.
    code: String,
    /// What went wrong.
    message: String,
    /// What to do.
    advice: String,
}

/// How far a motion is.
#[derive(Debug, Serialize, ToSchema)]
pub struct RunAnswer {
    /// "approach", "motion", "paused", "settling" or "stopping".
    #[schema(value_type = String)]
    phase: robot::RunPhase,
    /// Where in the plan it is, in seconds.
    t_s: f64,
    /// How long the plan takes, in seconds.
    duration_s: f64,
    /// The speed asked for, as a share of the plan's.
    speed: f64,
    /// Whether somebody asked for a pause.
    paused: bool,
    /// Whether somebody holds the button; nothing when the arm moves by itself.
    held: Option<bool>,
}

impl RobotAnswer {
    /// The robot at this moment.
    pub fn now(arm: &Arm) -> Self {
        Self::of(arm, &arm.robot.view().borrow())
    }

    /// The robot as this view of it shows.
    pub fn of(arm: &Arm, view: &RobotView) -> Self {
        let run = |run: RunProgress| RunAnswer {
            phase: run.phase,
            t_s: run.t_s,
            duration_s: run.duration_s,
            speed: run.speed,
            paused: run.paused,
            held: run.held,
        };
        Self {
            id: arm.id.clone(),
            name: arm.name.clone(),
            kind: view.kind,
            state: view.state,
            joints_deg: view.joints_deg,
            tcp_mm: view.tcp_mm,
            age_ms: view.age_ms,
            motors_on: view.motors_on,
            operating_mode: view.operating_mode.clone(),
            lead_through: view.lead_through,
            egm: EgmAnswer {
                connected: view.egm.connected,
                cycles: view.egm.cycles,
                lost: view.egm.lost,
                late: view.egm.late,
                real_time: view.egm.real_time,
            },
            hand: view.hand,
            fault: view.fault.as_ref().map(|fault| FaultAnswer {
                code: fault.code.to_owned(),
                message: fault.message.clone(),
                advice: fault.advice.clone(),
            }),
            run: view.run.map(run),
            signals: view.signals.iter().map(SignalAnswer::of).collect(),
            control: arm.control.view(moment(view)),
            continuous_run: arm.continuous_run,
        }
    }
}

/// Whether the arm shall be soft.
#[derive(Debug, Deserialize, ToSchema)]
pub struct LeadThrough {
    /// True: soft.
    active: bool,
}

/// What the virtual hand shall do.
#[derive(Debug, Deserialize, ToSchema)]
pub struct HandWish {
    /// Only "return": bring the arm to where a showing begins.
    action: HandAction,
    /// Of which script: "f1", "f2" or "f3".
    #[schema(value_type = String)]
    script: HandScript,
    /// The seed of the hand's variation.
    #[serde(default)]
    seed: u64,
}

/// What the virtual hand can be told without a recording.
#[derive(Clone, Copy, Debug, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum HandAction {
    /// Bring the arm to where a showing begins.
    Return,
}

/// Every robot as it is now, in the order of the configuration.
#[utoipa::path(get, path = "/robots", tag = "robots", responses((status = 200, body = [RobotAnswer])))]
pub async fn list(State(state): State<AppState>) -> Json<Vec<RobotAnswer>> {
    Json(state.arms.all().iter().map(RobotAnswer::now).collect())
}

/// Stops every robot. This is not a safety function.
#[utoipa::path(post, path = "/robots/stop", tag = "robots", responses((status = 204, description = "All arms come to rest")))]
pub async fn stop_all(State(state): State<AppState>, Actor(actor): Actor) -> StatusCode {
    for arm in state.arms.all() {
        arm.robot.stop();
    }
    state.audit(&actor, "stopped every arm", "robots").await;
    StatusCode::NO_CONTENT
}

/// A robot as it is now.
#[utoipa::path(get, path = "/robots/{robot}", tag = "robots", params(("robot" = String, Path)), responses(
    (status = 200, body = RobotAnswer),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn show(
    State(state): State<AppState>,
    Path(robot): Path<String>,
) -> Result<Json<RobotAnswer>, ApiError> {
    Ok(Json(RobotAnswer::now(state.arms.named(Some(&robot))?)))
}

/// Stops whatever the arm does. This is not a safety function.
#[utoipa::path(post, path = "/robots/{robot}/stop", tag = "robots", params(("robot" = String, Path)), responses(
    (status = 204, description = "The arm comes to rest"),
    (status = 404, body = Problem, content_type = "application/problem+json"),
))]
pub async fn stop(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(robot): Path<String>,
) -> Result<StatusCode, ApiError> {
    let arm = state.arms.named(Some(&robot))?;
    arm.robot.stop();
    state.audit(&actor, "stopped the arm", &arm.id).await;
    Ok(StatusCode::NO_CONTENT)
}

/// Acknowledges a fault, so that the arm may be used again.
#[utoipa::path(post, path = "/robots/{robot}/reset", tag = "robots", params(("robot" = String, Path)), responses(
    (status = 200, body = RobotAnswer),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 409, body = Problem, content_type = "application/problem+json"),
))]
pub async fn reset(
    State(state): State<AppState>,
    Actor(actor): Actor,
    OnPhone(phone): OnPhone,
    Path(robot): Path<String>,
) -> Result<Json<RobotAnswer>, ApiError> {
    let arm = state.arms.named(Some(&robot))?;
    arm.claim(phone.as_ref())?;
    arm.robot.reset().await?;
    state.audit(&actor, "acknowledged a fault", &arm.id).await;
    Ok(Json(RobotAnswer::now(arm)))
}

/// Makes the arm soft, to bring it somewhere by hand, or stiff again.
#[utoipa::path(post, path = "/robots/{robot}/lead-through", tag = "robots", params(("robot" = String, Path)), request_body = LeadThrough, responses(
    (status = 200, body = RobotAnswer),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 409, body = Problem, content_type = "application/problem+json"),
))]
pub async fn lead_through(
    State(state): State<AppState>,
    Actor(actor): Actor,
    OnPhone(phone): OnPhone,
    Path(robot): Path<String>,
    Json(LeadThrough { active }): Json<LeadThrough>,
) -> Result<Json<RobotAnswer>, ApiError> {
    let arm = state.arms.named(Some(&robot))?;
    // Making it stiff again takes nothing away from anybody.
    if active {
        arm.claim(phone.as_ref())?;
    }
    arm.recorder.set_free(active).await?;
    let action = if active {
        "made the arm soft"
    } else {
        "made the arm stiff"
    };
    state.audit(&actor, action, &arm.id).await;
    Ok(Json(RobotAnswer::now(arm)))
}

/// Has the virtual hand bring the virtual arm to where a showing begins.
#[utoipa::path(post, path = "/robots/{robot}/virtual-hand", tag = "robots", params(("robot" = String, Path)), request_body = HandWish, responses(
    (status = 202, description = "The hand moves the arm"),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "The arm is not soft, or not virtual", body = Problem, content_type = "application/problem+json"),
))]
pub async fn virtual_hand(
    State(state): State<AppState>,
    OnPhone(phone): OnPhone,
    Path(robot): Path<String>,
    Json(wish): Json<HandWish>,
) -> Result<StatusCode, ApiError> {
    let arm = state.arms.named(Some(&robot))?;
    arm.claim(phone.as_ref())?;
    let HandWish {
        action: HandAction::Return,
        script,
        seed,
    } = wish;
    arm.recorder
        .hand_returns(HandShowing { script, seed })
        .await?;
    Ok(StatusCode::ACCEPTED)
}
