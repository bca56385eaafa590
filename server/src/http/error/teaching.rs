//! The refusals around teaching: recording, cutting takes, pictures.

use axum::http::StatusCode;
use serde_json::json;

use super::ApiError;
use crate::pictures::PictureError;
use crate::recording::RecordingError;
use crate::trimming::TrimError;
use crate::words::sentence;

impl From<RecordingError> for ApiError {
    fn from(error: RecordingError) -> Self {
        match error {
            RecordingError::Robot(error) => error.into(),
            RecordingError::Store(error) => error.into(),
            RecordingError::Busy => {
                Self::conflict("robot_busy", sentence(&error)).advise("Stop that recording first.")
            }
            RecordingError::NoVirtualHand => {
                Self::conflict("no_virtual_hand", sentence(&error)).advise("Guide the arm by hand.")
            }
            RecordingError::NotOpen => Self::conflict("wrong_state", sentence(&error)),
            RecordingError::HandGoesOn => Self::conflict("hand_goes_on", sentence(&error))
                .advise("Let it finish, or stop the recording."),
            RecordingError::NothingYet => Self::conflict("nothing_recorded", sentence(&error))
                .advise("Wait until the time runs, then pause."),
            RecordingError::Elsewhere { joint, off_deg } => {
                Self::conflict("not_where_paused", sentence(&error))
                    .at(json!({ "joint": joint, "off_deg": off_deg }))
                    .advise("Bring the arm back to where you paused, then go on.")
            }
            RecordingError::Closing => Self::new(
                StatusCode::SERVICE_UNAVAILABLE,
                "shutting_down",
                sentence(&error),
            )
            .retry_after(5),
        }
    }
}

impl From<TrimError> for ApiError {
    fn from(error: TrimError) -> Self {
        match error {
            TrimError::Store(error) => error.into(),
            TrimError::Learning(error) => error.into(),
            TrimError::Broke(error) => Self::internal(&error),
            TrimError::Outside { .. } => {
                Self::unprocessable("trim_outside", "from_s", sentence(&error))
                    .advise("Choose a stretch inside the take.")
            }
            TrimError::TooLittle { .. } => {
                Self::unprocessable("trim_too_short", "to_s", sentence(&error))
                    .advise("Cut less away.")
            }
        }
    }
}

impl From<PictureError> for ApiError {
    fn from(error: PictureError) -> Self {
        match error {
            PictureError::Store(error) => error.into(),
            PictureError::Unknown => {
                Self::unprocessable("picture_unreadable", "body", sentence(&error))
                    .advise("Choose a photo.")
            }
            PictureError::TooLarge => {
                Self::new(StatusCode::PAYLOAD_TOO_LARGE, "too_large", sentence(&error))
                    .advise("Choose a smaller picture.")
            }
        }
    }
}
