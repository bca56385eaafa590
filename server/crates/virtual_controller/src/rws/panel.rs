//! `/rw/panel`: motors, mode switch, speed ratio.

use axum::extract::State;
use axum::http::StatusCode;
use axum::response::Response;

use super::App;
use super::negotiation::{Fields, Format};
use super::reply::{self, Item, Problem};
use crate::controller::OperatingMode;

pub async fn state(State(app): State<App>, format: Format) -> Response {
    let state = app.controller().state().word();
    let item = Item::new("pnl-ctrlstate", "ctrl-state").with("ctrlstate", state);
    reply::single(format, &item)
}

pub async fn set_state(State(app): State<App>, fields: Fields) -> Result<StatusCode, Problem> {
    let on = match fields.require("ctrl-state")? {
        "motoron" => true,
        "motoroff" => false,
        other => return Err(Problem::bad_request(format!("invalid ctrl-state {other}"))),
    };
    app.controller().set_motors(on)?;
    Ok(StatusCode::NO_CONTENT)
}

pub async fn mode(State(app): State<App>, format: Format) -> Response {
    let mode = app.controller().mode().word();
    reply::single(
        format,
        &Item::new("pnl-opmode", "opmode").with("opmode", mode),
    )
}

pub async fn set_mode(State(app): State<App>, fields: Fields) -> Result<StatusCode, Problem> {
    let mode = match fields.require("opmode")? {
        "auto" => OperatingMode::Automatic,
        "manr" => OperatingMode::ManualReduced,
        "manf" => OperatingMode::ManualFull,
        other => return Err(Problem::bad_request(format!("invalid opmode {other}"))),
    };
    app.controller().set_mode(mode);
    Ok(StatusCode::NO_CONTENT)
}

pub async fn speed_ratio(State(app): State<App>, format: Format) -> Response {
    let percent = app.controller().speed_ratio();
    let item = Item::new("pnl-speedratio", "speedratio").with("speedratio", percent);
    reply::single(format, &item)
}

pub async fn set_speed_ratio(
    State(app): State<App>,
    fields: Fields,
) -> Result<StatusCode, Problem> {
    let text = fields.require("speed-ratio")?;
    match text.parse() {
        Ok(percent @ 0..=100) => app.controller().set_speed_ratio(percent),
        _ => return Err(Problem::bad_request(format!("invalid speed-ratio {text}"))),
    }
    Ok(StatusCode::NO_CONTENT)
}

pub async fn collision_detection(format: Format) -> Response {
    let item = Item::new("pnl-coldetstate", "coldetstate").with("coldetstate", "INIT");
    reply::single(format, &item)
}
