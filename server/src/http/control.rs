//! Control of a robot: which phone a request comes from, and asking for and giving the robot.

use std::time::Instant;

use axum::extract::{FromRequestParts, State};
use axum::http::request::Parts;
use robot::{RobotState, RobotView};
use serde::Deserialize;
use utoipa::ToSchema;

use super::auth::Actor;
use super::error::{ApiError, Problem};
use super::extract::{Json, Path};
use super::robot::RobotAnswer;
use super::state::AppState;
use crate::arms::Arm;
use crate::control::{ControlError, Moment, Phone};

const ID: &str = "x-team-phone";
const NAME: &str = "x-team-phone-name";
/// Longest identifier and name of a phone, in bytes.
const LONGEST: usize = 80;

/// The phone that a request comes from; a line system names none.
#[derive(Debug)]
pub struct OnPhone(pub Option<Phone>);

impl<S: Send + Sync> FromRequestParts<S> for OnPhone {
    type Rejection = ApiError;

    async fn from_request_parts(parts: &mut Parts, _state: &S) -> Result<Self, ApiError> {
        let text = |name| {
            parts
                .headers
                .get(name)
                .and_then(|value| value.to_str().ok())
        };
        let name = text(NAME).map(decoded).unwrap_or_default();
        Ok(Self(text(ID).and_then(|id| phone(id, &name))))
    }
}

/// A phone with this identifier and name; nothing when the identifier is none.
pub fn phone(id: &str, name: &str) -> Option<Phone> {
    let sound = (1..=LONGEST).contains(&id.len()) && id.bytes().all(|b| b.is_ascii_graphic());
    let name = name.trim();
    let named = !name.is_empty() && name.len() <= LONGEST;
    sound.then(|| Phone {
        id: id.to_owned(),
        name: if named { name } else { "Another phone" }.to_owned(),
    })
}

/// A header's value holds plain characters only, so the name comes percent-encoded.
fn decoded(text: &str) -> String {
    percent_encoding::percent_decode_str(text)
        .decode_utf8_lossy()
        .into_owned()
}

/// This moment at this robot.
pub fn moment(view: &RobotView) -> Moment {
    Moment {
        now: Instant::now(),
        in_use: matches!(
            view.state,
            RobotState::Guiding | RobotState::Reproducing | RobotState::Stopping
        ),
    }
}

impl Arm {
    /// Something is about to make the arm move.
    ///
    /// # Errors
    /// When another phone controls the robot.
    pub fn claim(&self, phone: Option<&Phone>) -> Result<(), ControlError> {
        let moment = moment(&self.robot.view().borrow());
        self.control.claim(phone, moment)
    }
}

/// What a phone wants with the control of a robot.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct ControlWish {
    /// What it wants.
    action: ControlAction,
}

/// What can be done about the control of a robot.
#[derive(Clone, Copy, Debug, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum ControlAction {
    /// To have it; the holder is asked when there is one.
    Ask,
    /// To hand it to the phone that asks.
    Give,
    /// To go on having it although another phone asks.
    Keep,
    /// To have it no more.
    Release,
}

/// Asks for the control of a robot, gives it away, or keeps it. The phone is the one that the
/// headers `X-Team-Phone` and `X-Team-Phone-Name` name.
#[utoipa::path(post, path = "/robots/{robot}/control", tag = "robots", params(("robot" = String, Path)), request_body = ControlWish, responses(
    (status = 200, body = RobotAnswer),
    (status = 404, body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "The phone does not control the robot", body = Problem, content_type = "application/problem+json"),
    (status = 422, description = "The request names no phone", body = Problem, content_type = "application/problem+json"),
))]
pub async fn change(
    State(state): State<AppState>,
    Actor(actor): Actor,
    OnPhone(phone): OnPhone,
    Path(robot): Path<String>,
    Json(ControlWish { action }): Json<ControlWish>,
) -> Result<Json<RobotAnswer>, ApiError> {
    let arm = state.arms.named(Some(&robot))?;
    let phone = phone.ok_or(ControlError::NoPhone)?;
    let moment = moment(&arm.robot.view().borrow());
    match action {
        ControlAction::Ask => arm.control.ask(&phone, moment),
        ControlAction::Give => arm.control.answer(&phone, true, moment)?,
        ControlAction::Keep => arm.control.answer(&phone, false, moment)?,
        ControlAction::Release => arm.control.release(&phone, moment)?,
    }
    let what = match action {
        ControlAction::Ask => "asked for control",
        ControlAction::Give => "gave control away",
        ControlAction::Keep => "kept control",
        ControlAction::Release => "released control",
    };
    state.audit(&actor, what, &arm.id).await;
    Ok(Json(RobotAnswer::now(arm)))
}
