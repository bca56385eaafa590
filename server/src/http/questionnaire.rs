//! The questionnaire: whether to put it to a person now, their reply, and the means of all replies.

use axum::extract::State;
use axum::http::StatusCode;
use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};

use super::error::{ApiError, Problem};
use super::extract::{Json, Query};
use super::state::AppState;
use crate::clock::WallTime;
use crate::ids::{PersonId, ReplyId, ReproductionId, TaskId};
use crate::questionnaire;
use crate::store::questionnaire::{Period, QuestionnaireResult, Reply};

/// Who is to be asked, and after what.
#[derive(Debug, Deserialize, IntoParams)]
pub struct Asked {
    /// The random identifier that the phone made for whoever uses it.
    person: PersonId,
    /// The motion that was just made; only one that ended within the last hour is asked about.
    reproduction: Option<ReproductionId>,
}

/// Whether to ask.
#[derive(Debug, Serialize, ToSchema)]
pub struct QuestionnaireDue {
    /// Ask now.
    due: bool,
    /// This person replied or declined in this shift, and is left alone until then.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    not_before: Option<WallTime>,
}

/// A reply to the five statements.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct NewReply {
    /// Its identifier; the server makes one when it is missing. The same again is the same reply.
    id: Option<ReplyId>,
    /// The random identifier that the phone made for whoever uses it.
    person: PersonId,
    /// The task that it is about.
    task_id: TaskId,
    /// The motion after which it is given.
    reproduction_id: Option<ReproductionId>,
    /// From 1 (not at all) to 5 (completely), for: the right motion was learned, it felt safe, the
    /// goal was reached accurately, teaching was simple, teaching was enjoyable. Missing when the
    /// person does not want to answer in this shift.
    answers: Option<[u8; 5]>,
}

/// Over which time the replies are taken together.
#[derive(Debug, Deserialize, IntoParams)]
pub struct Grouping {
    /// "all" when it is missing.
    #[param(inline)]
    by: Option<Period>,
}

/// Whether to put the questionnaire to this person now: at most once in a shift of eight hours.
#[utoipa::path(get, path = "/questionnaire/due", tag = "questionnaire", params(Asked), responses(
    (status = 200, body = QuestionnaireDue),
    (status = 404, description = "No such motion", body = Problem, content_type = "application/problem+json"),
))]
pub async fn due(
    State(state): State<AppState>,
    Query(asked): Query<Asked>,
) -> Result<Json<QuestionnaireDue>, ApiError> {
    let now = state.clock.now();
    let due = questionnaire::due(&state.store, asked.person, asked.reproduction, now).await?;
    Ok(Json(QuestionnaireDue {
        due: due.now,
        not_before: due.not_before,
    }))
}

/// Takes the answers of a person, or that they don't want to answer in this shift.
#[utoipa::path(post, path = "/questionnaire", tag = "questionnaire", request_body = NewReply, responses(
    (status = 201, body = Reply),
    (status = 200, description = "It was there already", body = Reply),
    (status = 404, description = "No such task or motion", body = Problem, content_type = "application/problem+json"),
    (status = 409, description = "This person replied in this shift", body = Problem, content_type = "application/problem+json"),
    (status = 422, description = "The answers are none", body = Problem, content_type = "application/problem+json"),
))]
pub async fn reply(
    State(state): State<AppState>,
    Json(new): Json<NewReply>,
) -> Result<(StatusCode, Json<Reply>), ApiError> {
    let reply = Reply {
        id: new.id.unwrap_or_else(ReplyId::new),
        task_id: new.task_id,
        reproduction_id: new.reproduction_id,
        at: state.clock.now(),
        answers: new.answers,
    };
    let (reply, made) = questionnaire::take(&state.store, new.person, &reply).await?;
    let status = if made {
        StatusCode::CREATED
    } else {
        StatusCode::OK
    };
    Ok((status, Json(reply)))
}

/// The means of the replies for each task, over all of the time or for each week or month (UTC).
#[utoipa::path(get, path = "/questionnaire/results", tag = "questionnaire", params(Grouping), responses(
    (status = 200, body = [QuestionnaireResult]),
    (status = 400, description = "No such period", body = Problem, content_type = "application/problem+json"),
))]
pub async fn results(
    State(state): State<AppState>,
    Query(grouping): Query<Grouping>,
) -> Result<Json<Vec<QuestionnaireResult>>, ApiError> {
    let by = grouping.by.unwrap_or(Period::All);
    Ok(Json(state.store.questionnaire_results(by).await?))
}
