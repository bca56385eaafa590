//! `/rw/rapid`: execution of the program.

use std::collections::HashMap;

use axum::Extension;
use axum::extract::{Path, Query, State};
use axum::http::StatusCode;
use axum::response::Response;

use super::negotiation::{Fields, Format};
use super::reply::{self, Item, Problem};
use super::sessions::SessionId;
use super::{App, mastership};
use crate::controller::RunMode;

pub async fn execution(State(app): State<App>, format: Format) -> Response {
    let controller = app.controller();
    let item = Item::new("rap-execution", "execution")
        .with(
            "ctrlexecstate",
            execution_word(controller.program().is_running()),
        )
        .with("cycle", cycle_word(controller.run_mode()));
    reply::single(format, &item)
}

/// The one task, and what is loaded in it: the cell's modules and one of the controller's own.
const TASK: &str = "T_ROB1";
const MODULES: [(&str, &str); 3] = [
    ("BASE", "SysMod"),
    ("TEAM_main", "ProgMod"),
    ("TEAM_egm", "ProgMod"),
];

pub async fn modules(format: Format, Path(task): Path<String>) -> Result<Response, Problem> {
    if task != TASK {
        return Err(Problem::missing("no such task"));
    }
    let items = MODULES.map(|(name, kind)| {
        Item::new("rap-module-info-li", format!("{TASK}/{name}"))
            .with("name", name)
            .with("type", kind)
    });
    Ok(reply::list(format, &items))
}

pub async fn tasks(State(app): State<App>, format: Format) -> Response {
    let running = app.controller().program().is_running();
    let item = Item::new("rap-task-li", TASK)
        .with("name", TASK)
        .with("type", "norm")
        .with("taskstate", "link")
        .with("excstate", if running { "star" } else { "stop" })
        .with("active", "On")
        .with("motiontask", "TRUE");
    reply::list(format, &[item])
}

pub async fn start(State(app): State<App>, fields: Fields) -> Result<StatusCode, Problem> {
    let mode = match fields.get("cycle") {
        Some("once") => Some(RunMode::Once),
        Some("forever") => Some(RunMode::Forever),
        Some("asis") | None => None,
        Some(other) => return Err(Problem::bad_request(format!("invalid cycle {other}"))),
    };
    app.controller().start_program(mode)?;
    Ok(StatusCode::NO_CONTENT)
}

pub async fn stop(State(app): State<App>, _: Fields) -> StatusCode {
    app.controller().stop_program();
    StatusCode::NO_CONTENT
}

pub async fn reset_program_pointer(
    State(app): State<App>,
    Extension(session): Extension<SessionId>,
    Query(query): Query<HashMap<String, String>>,
    _: Fields,
) -> Result<StatusCode, Problem> {
    mastership::check(&app, &session, query.get("mastership").map(String::as_str))?;
    app.controller().program_to_main()?;
    Ok(StatusCode::NO_CONTENT)
}

/// RAPID's execution state as the wire has it.
pub fn execution_word(running: bool) -> &'static str {
    if running { "running" } else { "stopped" }
}

/// The run mode as the wire has it.
pub fn cycle_word(mode: RunMode) -> &'static str {
    match mode {
        RunMode::Once => "once",
        RunMode::Forever => "forever",
    }
}
