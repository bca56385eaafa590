//! The one place where errors become HTTP answers: RFC 9457 problem documents.

mod teaching;
mod workers;

use std::borrow::Cow;

use axum::Json;
use axum::extract::rejection::BytesRejection;
use axum::extract::ws::rejection::WebSocketUpgradeRejection;
use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::Serialize;
use serde_json::{Value, json};

use crate::agreement::AgreementError;
use crate::arms::UnknownRobot;
use crate::control::ControlError;
use crate::dragging::DragError;
use crate::flight::ExportError;
use crate::planning::PlanError;
use crate::reproducing::ReproducingError;
use crate::store;
use crate::training::TrainingError;
use crate::uploads::UploadError;
use crate::words::sentence;

/// A refusal on its way to the client.
#[derive(Debug)]
pub struct ApiError {
    status: StatusCode,
    code: Cow<'static, str>,
    detail: String,
    place: Option<Box<Value>>,
    advice: Option<Cow<'static, str>>,
    retry_after_s: Option<u64>,
    /// For the log only.
    cause: Option<Box<str>>,
}

/// What a client gets with every error (RFC 9457).
#[derive(Debug, Serialize, utoipa::ToSchema)]
pub struct Problem {
    /// Names this kind of problem for ever.
    #[serde(rename = "type")]
    kind: String,
    /// The kind of problem in words; always the same for one status.
    title: &'static str,
    /// The HTTP status.
    status: u16,
    /// Names this kind of problem for programs.
    code: Cow<'static, str>,
    /// What was wrong this time.
    detail: String,
    /// Where it was wrong: a field, row, joint or time.
    #[serde(rename = "where", skip_serializing_if = "Option::is_none")]
    place: Option<Box<Value>>,
    /// What to do.
    #[serde(skip_serializing_if = "Option::is_none")]
    advice: Option<Cow<'static, str>>,
    /// Finds the cause in the server's log.
    #[serde(skip_serializing_if = "Option::is_none")]
    trace_id: Option<String>,
}

impl ApiError {
    /// A refusal with a status and a code.
    pub fn new(
        status: StatusCode,
        code: impl Into<Cow<'static, str>>,
        detail: impl Into<String>,
    ) -> Self {
        Self {
            status,
            code: code.into(),
            detail: detail.into(),
            place: None,
            advice: None,
            retry_after_s: None,
            cause: None,
        }
    }

    /// Something in the request is out of range or can't be used.
    pub fn unprocessable(code: &'static str, field: &str, detail: impl Into<String>) -> Self {
        Self::new(StatusCode::UNPROCESSABLE_ENTITY, code, detail).at(json!({ "field": field }))
    }

    /// No such thing.
    pub fn not_found(what: &str) -> Self {
        Self::new(
            StatusCode::NOT_FOUND,
            "not_found",
            format!("There is no such {what}."),
        )
    }

    /// The thing is there, but not in a state that allows this.
    pub fn conflict(code: impl Into<Cow<'static, str>>, detail: impl Into<String>) -> Self {
        Self::new(StatusCode::CONFLICT, code, detail)
    }

    /// A bug or a broken disk: the client gets a number, the log gets the cause.
    pub fn internal(cause: &dyn std::fmt::Display) -> Self {
        let mut error = Self::new(
            StatusCode::INTERNAL_SERVER_ERROR,
            "internal_error",
            "Something went wrong inside the server.",
        )
        .advise("Nothing that was stored is lost. Try again; if it happens again, tell whoever looks after the server.");
        error.cause = Some(cause.to_string().into());
        error
    }

    /// Adds where it was wrong.
    pub fn at(mut self, place: Value) -> Self {
        self.place = Some(Box::new(place));
        self
    }

    /// Adds what to do.
    pub fn advise(mut self, advice: impl Into<Cow<'static, str>>) -> Self {
        self.advice = Some(advice.into());
        self
    }

    /// What is said of it outside HTTP: code, detail and advice.
    pub fn words(self) -> (Cow<'static, str>, String, Cow<'static, str>) {
        (self.code, self.detail, self.advice.unwrap_or_default())
    }

    /// Adds when to try again.
    pub fn retry_after(mut self, seconds: u64) -> Self {
        self.retry_after_s = Some(seconds);
        self
    }
}

fn title(status: StatusCode) -> &'static str {
    match status {
        StatusCode::BAD_REQUEST => "The request could not be read",
        StatusCode::UNAUTHORIZED => "This device is not paired",
        StatusCode::FORBIDDEN => "This request is not allowed",
        StatusCode::NOT_FOUND => "Not found",
        StatusCode::METHOD_NOT_ALLOWED => "This can't be done here",
        StatusCode::CONFLICT => "Not possible now",
        StatusCode::PAYLOAD_TOO_LARGE => "Too large",
        StatusCode::UNSUPPORTED_MEDIA_TYPE => "The kind of content is not known",
        StatusCode::UNPROCESSABLE_ENTITY => "This can't be used",
        StatusCode::TOO_MANY_REQUESTS => "Too many attempts",
        StatusCode::SERVICE_UNAVAILABLE => "The robot can't be reached",
        _ => "Something went wrong",
    }
}

impl IntoResponse for ApiError {
    fn into_response(self) -> Response {
        let trace_id = self.cause.map(|cause| {
            let trace_id = uuid::Uuid::now_v7().to_string();
            tracing::error!(trace_id, %cause, "a request failed");
            trace_id
        });
        let problem = Problem {
            kind: format!("urn:team:problem:{}", self.code),
            title: title(self.status),
            status: self.status.as_u16(),
            code: self.code,
            detail: self.detail,
            place: self.place,
            advice: self.advice,
            trace_id,
        };
        let mut response = (self.status, Json(problem)).into_response();
        let headers = response.headers_mut();
        let json = HeaderValue::from_static("application/problem+json");
        headers.insert(header::CONTENT_TYPE, json);
        if let Some(seconds) = self.retry_after_s {
            headers.insert(header::RETRY_AFTER, seconds.into());
        }
        response
    }
}

impl From<store::Error> for ApiError {
    fn from(error: store::Error) -> Self {
        use store::Error;
        match &error {
            Error::NotFound { what } => Self::not_found(what),
            Error::WrongState { .. } => Self::conflict("wrong_state", sentence(&error)),
            Error::IdTaken { .. } => {
                Self::conflict("id_taken", sentence(&error)).advise("Send a new identifier.")
            }
            Error::NameTaken { .. } => Self::conflict("name_taken", sentence(&error))
                .at(json!({ "field": "name" }))
                .advise("Choose another name."),
            Error::Damaged { .. } | Error::Database(_) | Error::Migration(_) => {
                Self::internal(&error)
            }
        }
    }
}

impl From<learning::Error> for ApiError {
    fn from(error: learning::Error) -> Self {
        let place = serde_json::to_value(error.where_()).ok();
        let place = place.filter(|p| p.as_object().is_some_and(|fields| !fields.is_empty()));
        Self {
            place: place.map(Box::new),
            ..Self::new(
                StatusCode::UNPROCESSABLE_ENTITY,
                error.code(),
                sentence(&error),
            )
        }
        .advise(error.advice())
    }
}

impl From<robot::RobotError> for ApiError {
    fn from(error: robot::RobotError) -> Self {
        let status = match error {
            robot::RobotError::Disconnected | robot::RobotError::ShuttingDown => {
                StatusCode::SERVICE_UNAVAILABLE
            }
            robot::RobotError::Controller(ref refusal) if refusal.is_unreachable() => {
                StatusCode::SERVICE_UNAVAILABLE
            }
            robot::RobotError::SignalUnknown { .. } => StatusCode::NOT_FOUND,
            robot::RobotError::BadSpeed { .. } => StatusCode::UNPROCESSABLE_ENTITY,
            // The controller answers and says no.
            _ => StatusCode::CONFLICT,
        };
        let refused = Self::new(status, error.code(), sentence(&error)).advise(error.advice());
        match status {
            StatusCode::SERVICE_UNAVAILABLE => refused.retry_after(2),
            _ => refused,
        }
    }
}

impl From<UnknownRobot> for ApiError {
    fn from(error: UnknownRobot) -> Self {
        Self::new(StatusCode::NOT_FOUND, "robot_unknown", sentence(&error))
            .at(json!({ "field": "robot" }))
            .advise("Choose one of these robots.")
    }
}

impl From<ControlError> for ApiError {
    fn from(error: ControlError) -> Self {
        let status = match error {
            ControlError::NoPhone => StatusCode::UNPROCESSABLE_ENTITY,
            ControlError::Controlled { .. } | ControlError::NotYours => StatusCode::CONFLICT,
        };
        Self::new(status, error.code(), sentence(&error)).advise(error.advice())
    }
}

impl From<DragError> for ApiError {
    fn from(error: DragError) -> Self {
        let (code, advice) = match error {
            DragError::Robot(error) => return error.into(),
            DragError::Control(error) => return error.into(),
            DragError::RealArm => ("drag_real_arm", "Guide the arm by hand."),
            DragError::HandBusy => (
                "drag_hand_busy",
                "Wait until it has finished, or press Stop.",
            ),
            DragError::Taken => ("drag_taken", "Wait until they let go."),
        };
        Self::conflict(code, sentence(&error)).advise(advice)
    }
}

impl From<ReproducingError> for ApiError {
    fn from(error: ReproducingError) -> Self {
        match error {
            ReproducingError::Robot(error) => error.into(),
            ReproducingError::Store(error) => error.into(),
            ReproducingError::NoWay(error) => error.into(),
            ReproducingError::Crashed(error) => Self::internal(&error),
            ReproducingError::PlanUnknown => {
                Self::conflict("plan_unknown", sentence(&error)).advise("Preview the motion again.")
            }
            ReproducingError::OtherRobot { .. } => Self::conflict("other_robot", sentence(&error))
                .advise("Preview the motion for the robot that shall make it."),
            ReproducingError::HoldRequired => Self::conflict("hold_required", sentence(&error))
                .advise("Start it from a phone, and hold the button while the arm moves."),
            ReproducingError::NotRunning => Self::conflict("wrong_state", sentence(&error)),
            ReproducingError::KeyReused => Self::unprocessable(
                "idempotency_key_reused",
                "Idempotency-Key",
                sentence(&error),
            )
            .advise("Send a new key for a new motion."),
        }
    }
}

impl From<TrainingError> for ApiError {
    fn from(error: TrainingError) -> Self {
        let words = sentence(&error);
        match error {
            TrainingError::Store(error) => error.into(),
            TrainingError::NothingKept => {
                Self::unprocessable("no_demonstrations", "demonstrations", words)
                    .advise("Record the motion and keep at least one take; three are better.")
            }
            TrainingError::NotOfThisTask { id } => {
                Self::unprocessable("demonstration_unknown", "demonstrations", words)
                    .at(json!({ "demonstration": id }))
            }
            TrainingError::StillOpen { take } => Self::conflict("wrong_state", words)
                .at(json!({ "take": take }))
                .advise("Stop the recording first."),
            TrainingError::Unusable { id, take, error } => {
                let mut place = serde_json::to_value(error.where_()).unwrap_or_default();
                place["demonstration"] = json!(id);
                place["take"] = json!(take);
                Self::new(StatusCode::UNPROCESSABLE_ENTITY, error.code(), words)
                    .at(place)
                    .advise(error.advice())
            }
            TrainingError::Together(error) => error.into(),
            TrainingError::UnknownMethod(_) => {
                Self::unprocessable("method_unknown", "method", words)
                    .advise("Leave it out, or write \"faithful\" or \"paper\".")
            }
            TrainingError::NotReady(_) => Self::conflict("wrong_state", words)
                .advise("Wait until the training has ended, or train again."),
            TrainingError::Damaged(_) | TrainingError::Broke(_) => Self::internal(&words),
        }
    }
}

impl From<AgreementError> for ApiError {
    fn from(error: AgreementError) -> Self {
        match error {
            AgreementError::Store(error) => error.into(),
            AgreementError::Broke(error) => Self::internal(&error),
        }
    }
}

impl From<ExportError> for ApiError {
    fn from(error: ExportError) -> Self {
        match error {
            ExportError::Store(error) => error.into(),
            ExportError::Mcap(_) | ExportError::Broke(_) => Self::internal(&error),
        }
    }
}

impl From<UploadError> for ApiError {
    fn from(error: UploadError) -> Self {
        match error {
            UploadError::NotText => {
                Self::unprocessable("demonstration_unreadable", "body", sentence(&error))
                    .advise("Choose a recording: a CSV or JSON file.")
            }
            UploadError::OtherArm { .. } => {
                Self::unprocessable("demonstration_joint_count", "joints_deg", sentence(&error))
                    .advise("Choose a recording of this arm.")
            }
            UploadError::Learning(error) => error.into(),
            UploadError::Store(error) => error.into(),
            UploadError::Broke(error) => Self::internal(&error),
        }
    }
}

impl From<WebSocketUpgradeRejection> for ApiError {
    fn from(rejection: WebSocketUpgradeRejection) -> Self {
        Self::new(
            rejection.status(),
            "websocket_expected",
            rejection.body_text(),
        )
    }
}

impl From<BytesRejection> for ApiError {
    fn from(rejection: BytesRejection) -> Self {
        let status = rejection.status();
        match status {
            StatusCode::PAYLOAD_TOO_LARGE => {
                Self::new(status, "too_large", "The file is larger than 16 MB.")
                    .advise("Record the motion in shorter parts.")
            }
            _ => Self::new(status, "bad_body", rejection.body_text()),
        }
    }
}

impl From<PlanError> for ApiError {
    fn from(error: PlanError) -> Self {
        let status = match &error {
            PlanError::BadSpeed(_) => StatusCode::UNPROCESSABLE_ENTITY,
            _ => StatusCode::CONFLICT,
        };
        Self {
            place: error.place().map(Box::new),
            ..Self::new(status, error.code(), sentence(&error))
        }
        .advise(error.advice())
    }
}
