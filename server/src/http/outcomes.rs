//! What a person says of a motion: that it worked or did not.

use axum::extract::State;
use serde::Deserialize;
use utoipa::ToSchema;

use super::auth::Actor;
use super::error::{ApiError, Problem};
use super::extract::{Json, Path};
use super::state::AppState;
use crate::ids::ReproductionId;
use crate::store::outcomes::Outcome;
use crate::store::reproductions::Reproduction;

/// What a person says of a motion.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct NewOutcome {
    /// Whether the work was done.
    worked: bool,
    /// What there is to say about it, in at most 400 characters.
    note: Option<String>,
}

/// Says whether a motion that has ended did its work. It may be said anew at any time.
#[utoipa::path(put, path = "/reproductions/{id}/outcome", tag = "reproductions", request_body = NewOutcome,
    params(("id" = ReproductionId, Path)),
    responses(
        (status = 200, body = Reproduction),
        (status = 404, body = Problem, content_type = "application/problem+json"),
        (status = 409, description = "The motion is not over", body = Problem, content_type = "application/problem+json"),
        (status = 422, description = "The note is too long", body = Problem, content_type = "application/problem+json"),
    )
)]
pub async fn set(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(id): Path<ReproductionId>,
    Json(new): Json<NewOutcome>,
) -> Result<Json<Reproduction>, ApiError> {
    let outcome = Outcome {
        worked: new.worked,
        note: checked_note(new.note.as_deref())?,
        at: state.clock.now(),
    };
    let reproduction = state.store.set_outcome(id, Some(&outcome)).await?;
    state.events.tell(&reproduction);
    let action = if new.worked {
        "said that a motion worked"
    } else {
        "said that a motion did not work"
    };
    state.audit(&actor, action, id).await;
    Ok(Json(reproduction))
}

/// Takes back what was said of a motion.
#[utoipa::path(delete, path = "/reproductions/{id}/outcome", tag = "reproductions",
    params(("id" = ReproductionId, Path)),
    responses(
        (status = 200, body = Reproduction),
        (status = 404, body = Problem, content_type = "application/problem+json"),
        (status = 409, description = "The motion is not over", body = Problem, content_type = "application/problem+json"),
    )
)]
pub async fn forget(
    State(state): State<AppState>,
    Actor(actor): Actor,
    Path(id): Path<ReproductionId>,
) -> Result<Json<Reproduction>, ApiError> {
    let reproduction = state.store.set_outcome(id, None).await?;
    state.events.tell(&reproduction);
    state
        .audit(&actor, "took back what was said of a motion", id)
        .await;
    Ok(Json(reproduction))
}

/// The note as it is kept; an empty one is none.
fn checked_note(note: Option<&str>) -> Result<Option<String>, ApiError> {
    let note = note.unwrap_or_default().trim();
    match note.chars().count() {
        0 => Ok(None),
        1..=400 => Ok(Some(note.to_owned())),
        _ => Err(ApiError::unprocessable(
            "bad_note",
            "note",
            "The note is longer than 400 characters.",
        )
        .advise("Write a shorter note.")),
    }
}
