//! `/rw/mastership/edit`: who may change the program.

use axum::Extension;
use axum::extract::State;
use axum::http::StatusCode;
use axum::response::Response;

use super::App;
use super::negotiation::{Fields, Format};
use super::reply::{self, HELD_BY_ANOTHER, Item, NO_MASTERSHIP, Problem};
use super::sessions::SessionId;

pub async fn state(
    State(app): State<App>,
    Extension(session): Extension<SessionId>,
    format: Format,
) -> Response {
    let sessions = app.sessions();
    let held = if sessions.has_master() {
        "remote"
    } else {
        "nomaster"
    };
    let by_me = if sessions.is_master(&session) {
        "TRUE"
    } else {
        "FALSE"
    };
    let item = Item::new("msh-resource", "edit")
        .with("mastership", held)
        .with("mastershipheldbyme", by_me);
    reply::single(format, &item)
}

pub async fn request(
    State(app): State<App>,
    Extension(session): Extension<SessionId>,
    _: Fields,
) -> Result<StatusCode, Problem> {
    take(&app, &session)?;
    Ok(StatusCode::NO_CONTENT)
}

pub async fn release(
    State(app): State<App>,
    Extension(session): Extension<SessionId>,
    _: Fields,
) -> Result<StatusCode, Problem> {
    if app.sessions().release(&session) {
        Ok(StatusCode::NO_CONTENT)
    } else {
        Err(not_held())
    }
}

/// Lets a change through that needs mastership: held by the session, or taken for the change
/// alone when the request says `mastership=implicit`.
pub fn check(app: &App, session: &SessionId, mastership: Option<&str>) -> Result<(), Problem> {
    if app.sessions().is_master(session) {
        return Ok(());
    }
    if mastership != Some("implicit") {
        return Err(not_held());
    }
    take(app, session)?;
    app.sessions().release(session);
    Ok(())
}

fn take(app: &App, session: &SessionId) -> Result<(), Problem> {
    if app.sessions().take_mastership(session) {
        Ok(())
    } else {
        Err(Problem::new(
            StatusCode::FORBIDDEN,
            HELD_BY_ANOTHER,
            "mastership is held by someone else",
        ))
    }
}

fn not_held() -> Problem {
    Problem::new(
        StatusCode::FORBIDDEN,
        NO_MASTERSHIP,
        "the client does not have required mastership",
    )
}
