//! What the controller is, and the end of a session.

use axum::Extension;
use axum::extract::State;
use axum::http::StatusCode;
use axum::response::Response;

use super::App;
use super::negotiation::Format;
use super::reply::{self, Item};
use super::sessions::SessionId;
use crate::clock::WallTime;

pub async fn root(format: Format) -> Response {
    let services = ["rw", "ctrl", "subscription", "logout"];
    reply::list(format, &services.map(|name| Item::new("service-li", name)))
}

pub async fn system(State(app): State<App>, format: Format) -> Response {
    let name = app.controller().config().name.clone();
    let item = Item::new("sys-system", "system")
        .with("major", 7)
        .with("minor", 20)
        .with("build", 0)
        .with("name", name)
        .with("rwversion", "7.20.0+0")
        .with("rwversionname", "7.20.0 virtual")
        .with("sysid", "{00000000-0000-0000-0000-000000000000}");
    reply::single(format, &item)
}

pub async fn identity(State(app): State<App>, format: Format) -> Response {
    let name = app.controller().config().name.clone();
    let item = Item::new("ctrl-identity-info", "identity")
        .with("ctrl-name", name)
        .with("ctrl-id", "virtual")
        .with("ctrl-type", "Virtual Controller")
        .with("ctrl-level", "Virtual");
    reply::single(format, &item)
}

pub async fn options(format: Format) -> Response {
    let names = ["RobotControl Base", "3124-1 Externally Guided Motion"];
    let items = names.map(|name| Item::new("sys-option-li", name).with("option", name));
    reply::list(format, &items)
}

pub async fn clock(format: Format) -> Response {
    let item = Item::new("ctrl-clock-info", "clock").with("datetime", WallTime::now());
    reply::single(format, &item)
}

pub async fn logout(
    State(app): State<App>,
    Extension(session): Extension<SessionId>,
) -> StatusCode {
    app.sessions().close(&session);
    app.subscriptions().end_of_session(&session);
    StatusCode::NO_CONTENT
}
