//! Plans: a motion is computed, checked and shown before the arm may make it.

use axum::extract::State;
use motion::JointAngles;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::error::{ApiError, Problem};
use super::extract::Json;
use super::signals::SignalMark;
use super::state::AppState;
use super::trajectories::plan_columns;
use crate::arms::Arm;
use crate::ids::{ModelId, PositionId};
use crate::planning::{PlanRequest, Target, Warning, signal_remarks};
use crate::plans::KnownPlan;
use crate::positions::{PositionError, pose_of, present_pose};
use crate::store::Store;
use crate::training;

/// How many points of a plan are sent for its plot.
const POINTS: usize = 400;

/// A motion to be planned.
#[derive(Debug, Deserialize, ToSchema)]
pub struct NewPlan {
    /// By which model.
    model_id: ModelId,
    /// For which robot; the first one when it is missing.
    robot: Option<String>,
    /// Where it begins; as taught when it is missing.
    #[serde(default)]
    start: Place,
    /// Where it ends; as taught when it is missing.
    #[serde(default)]
    goal: Place,
    /// Its speed, from 0.05 to 1, as a share of the taught one.
    #[serde(default = "full_speed")]
    speed: f64,
}

/// A pose of the arm.
#[derive(Clone, Copy, Debug, Default, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case", untagged)]
pub enum Place {
    /// One that the server knows.
    Named(NamedPlace),
    /// One that somebody saved.
    Saved(SavedPlace),
    /// Any other.
    Joints(JointPlace),
    /// As taught.
    #[serde(skip)]
    #[default]
    Missing,
}

/// A pose that the server knows.
#[derive(Clone, Copy, Debug, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum NamedPlace {
    /// As it was shown.
    AsTaught,
    /// Where the arm stands now.
    Present,
}

/// A saved position of the robot that the motion is for.
#[derive(Clone, Copy, Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct SavedPlace {
    /// Its identifier.
    position: PositionId,
}

/// Any pose.
#[derive(Clone, Copy, Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct JointPlace {
    /// Joint angles in degrees.
    joints_deg: [f64; 6],
}

/// A motion that the gate approved.
#[derive(Debug, Serialize, ToSchema)]
pub struct Plan {
    /// Names exactly this motion (SHA-256); a reproduction is started with it.
    plan: String,
    /// The robot whose pose and limits it was made for; no other one may run it.
    robot: String,
    /// By which model.
    model_id: ModelId,
    /// Where it begins, in degrees per joint.
    start_deg: [f64; 6],
    /// Where it ends, in degrees per joint.
    goal_deg: [f64; 6],
    /// How long it takes with the approach, in seconds.
    duration_s: f64,
    /// How long the arm takes to come to the start, in seconds.
    approach_s: f64,
    /// By what factor it was made slower so that it keeps the arm's limits; 1 when it was not.
    slowed_by: f64,
    /// What a person should know before starting it.
    warnings: Vec<String>,
    /// The same warnings in the same order for programs.
    warning_details: Vec<WarningDetail>,
    /// The result of the check in a sentence.
    verdict: String,
    /// Times in seconds.
    t_s: Vec<f64>,
    /// For each joint, its angle at these times in degrees.
    joints_deg: Vec<Vec<f64>>,
    /// For x, y and z, the tool's position at these times in millimetres.
    tcp_mm: Vec<Vec<f64>>,
    /// The signals that are set on the way.
    signals: Vec<SignalMark>,
    /// The largest values on the way.
    peak: Peak,
}

/// A warning for programs.
#[derive(Debug, Default, Serialize, ToSchema)]
pub struct WarningDetail {
    /// Names this kind of warning for ever; "far_from_taught" when the start or goal lies outside
    /// what was taught.
    code: &'static str,
    /// "start" or "goal", where it is about one of them.
    #[serde(skip_serializing_if = "Option::is_none")]
    field: Option<&'static str>,
    /// The joint that it is about, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    joint: Option<usize>,
    /// How far this joint is from what was taught, in degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    off_deg: Option<f64>,
}

/// The largest values on the way.
#[derive(Debug, Serialize, ToSchema)]
pub struct Peak {
    /// For each joint, its speed in degrees per second.
    joint_speed_deg_s: [f64; 6],
    /// The tool's speed in millimetres per second.
    tcp_speed_mm_s: f64,
}

/// Plans a motion and has it checked.
#[utoipa::path(post, path = "/plans", tag = "reproductions", request_body = NewPlan, responses(
    (status = 200, body = Plan),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "The motion is not allowed, with where and why", body = Problem, content_type = "application/problem+json"),
    (status = 422, body = Problem, content_type = "application/problem+json"),
))]
pub async fn create(
    State(state): State<AppState>,
    Json(new): Json<NewPlan>,
) -> Result<Json<Plan>, ApiError> {
    let arm = state.arms.named(new.robot.as_deref())?;
    let request = PlanRequest {
        start: target(&state.store, new.start, arm).await?,
        goal: target(&state.store, new.goal, arm).await?,
        speed: new.speed,
    };
    let task_id = state.store.model(new.model_id).await?.task_id;
    let model = training::load(&state.store, new.model_id).await?;
    let present = present_pose(arm);
    let (robot, limits) = (arm.id.clone(), arm.limits.clone());
    let mut planned = tokio::task::spawn_blocking(move || {
        KnownPlan::make(
            &robot,
            &limits,
            task_id,
            new.model_id,
            model,
            &request,
            present,
        )
    })
    .await
    .map_err(|error| ApiError::internal(&error))??;
    let remarks = signal_remarks(&planned.plan, &arm.robot.view().borrow().signals);
    planned.warnings.extend(remarks);
    let known = state.plans.remember(planned);
    Ok(Json(answer(&known)))
}

fn full_speed() -> f64 {
    1.0
}

fn verdict(known: &KnownPlan) -> String {
    let limits = "The whole motion keeps to the arm's limits.";
    if known.slowed_by > 1.001 {
        let factor = known.slowed_by;
        return format!("{limits} For that it is {factor:.1} times slower than asked for.");
    }
    limits.into()
}

async fn target(store: &Store, place: Place, arm: &Arm) -> Result<Target, PositionError> {
    Ok(match place {
        Place::Missing | Place::Named(NamedPlace::AsTaught) => Target::AsTaught,
        Place::Named(NamedPlace::Present) => Target::Present,
        Place::Saved(SavedPlace { position }) => {
            Target::Joints(pose_of(store, position, arm).await?)
        }
        Place::Joints(JointPlace { joints_deg }) => Target::Joints(JointAngles(joints_deg)),
    })
}

pub(super) fn answer(known: &KnownPlan) -> Plan {
    let (t_s, joints_deg, tcp_mm) = plan_columns(&known.plan, POINTS);
    Plan {
        plan: known.plan.hash().to_owned(),
        robot: known.robot.clone(),
        model_id: known.model_id,
        start_deg: known.start.0,
        goal_deg: known.goal.0,
        duration_s: known.plan.duration_s(),
        approach_s: known.plan.approach_s(),
        slowed_by: known.slowed_by,
        warnings: known.warnings.iter().map(Warning::to_string).collect(),
        warning_details: known.warnings.iter().map(WarningDetail::of).collect(),
        verdict: verdict(known),
        t_s,
        joints_deg,
        tcp_mm,
        signals: known.plan.signals().iter().map(SignalMark::of).collect(),
        peak: Peak {
            joint_speed_deg_s: known.inspection.peak_joint_speed_deg_s,
            tcp_speed_mm_s: known.inspection.peak_tcp_speed_mm_s,
        },
    }
}

impl WarningDetail {
    fn of(warning: &Warning) -> Self {
        let code = warning.code();
        match *warning {
            Warning::FarFromTaught {
                which,
                joint,
                off_deg,
            } => Self {
                code,
                field: Some(which),
                joint: Some(joint),
                off_deg: Some(off_deg),
            },
            Warning::WholeTurn { joint } => Self {
                code,
                joint: Some(joint),
                ..Self::default()
            },
            Warning::TurnsFurther { joint, further_deg } => Self {
                code,
                joint: Some(joint),
                off_deg: Some(further_deg),
                ..Self::default()
            },
            _ => Self {
                code,
                ..Self::default()
            },
        }
    }
}
