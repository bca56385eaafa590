//! `/rw/iosystem/signals`.

use axum::extract::{Path, State};
use axum::http::StatusCode;
use axum::response::Response;

use super::App;
use super::negotiation::{Fields, Format};
use super::reply::{self, Item, Problem};
use crate::signals::Signal;

pub async fn signals(State(app): State<App>, format: Format) -> Response {
    let items: Vec<Item> = app
        .controller()
        .signals()
        .all()
        .iter()
        .map(|signal| item("ios-signal-li", signal))
        .collect();
    reply::list(format, &items)
}

pub async fn signal(
    State(app): State<App>,
    format: Format,
    Path(path): Path<String>,
) -> Result<Response, Problem> {
    let controller = app.controller();
    let signal = controller
        .signals()
        .find(&path)
        .ok_or_else(|| Problem::missing("no such signal"))?;
    Ok(reply::single(format, &item("ios-signal", signal)))
}

pub async fn set_signal(
    State(app): State<App>,
    Path(path): Path<String>,
    fields: Fields,
) -> Result<StatusCode, Problem> {
    let Some(path) = path.strip_suffix("/set-value") else {
        return Err(Problem::of_status(StatusCode::METHOD_NOT_ALLOWED));
    };
    let on = match fields.require("lvalue")? {
        "0" => false,
        "1" => true,
        other => return Err(Problem::bad_request(format!("invalid lvalue {other}"))),
    };
    app.controller().set_signal(path, on)?;
    Ok(StatusCode::NO_CONTENT)
}

fn item(kind: &'static str, signal: &Signal) -> Item {
    Item::new(kind, signal.path())
        .with("name", signal.name)
        .with("type", signal.kind.word())
        .with("category", "")
        .with("lvalue", u8::from(signal.on))
        .with("lstate", "not simulated")
}
