//! Refusals about what workers tell the server: saved positions and the questionnaire.

use serde_json::json;

use super::ApiError;
use crate::positions::PositionError;
use crate::questionnaire::QuestionnaireError;
use crate::words::sentence;

impl From<PositionError> for ApiError {
    fn from(error: PositionError) -> Self {
        let words = sentence(&error);
        match error {
            PositionError::Store(error) => error.into(),
            PositionError::Deleted { .. } => Self::conflict("position_deleted", words)
                .advise("Choose another position, or save this one again."),
            PositionError::OtherRobot { robot, .. } => {
                Self::conflict("position_of_other_robot", words)
                    .at(json!({ "robot": robot }))
                    .advise("Choose a position of the robot that shall move.")
            }
            PositionError::OutsideRange {
                joint,
                value_deg,
                min_deg,
                max_deg,
            } => Self::unprocessable("outside_joint_range", "joints_deg", words)
                .at(json!({
                    "field": "joints_deg", "joint": joint, "value_deg": value_deg,
                    "min_deg": min_deg, "max_deg": max_deg,
                }))
                .advise("Choose angles within the arm's range."),
            PositionError::PresentUnknown => Self::conflict("present_pose_unknown", words)
                .advise("Wait until the arm is connected, or give the joint angles yourself."),
        }
    }
}

impl From<QuestionnaireError> for ApiError {
    fn from(error: QuestionnaireError) -> Self {
        let words = sentence(&error);
        match error {
            QuestionnaireError::Store(error) => error.into(),
            QuestionnaireError::BadAnswer { statement, .. } => {
                Self::unprocessable("bad_answer", "answers", words)
                    .at(json!({ "field": "answers", "statement": statement }))
                    .advise("Choose a number from 1 to 5 for each statement.")
            }
            QuestionnaireError::OtherTask => {
                Self::unprocessable("other_task", "reproduction_id", words)
                    .advise("Name the task of this motion.")
            }
            QuestionnaireError::TooSoon => {
                Self::conflict("already_answered", words).advise("Answer again in your next shift.")
            }
        }
    }
}
