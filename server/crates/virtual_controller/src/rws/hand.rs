//! `/virtual/hand`: the one resource that is not ABB's. It answers in plain JSON.

use axum::Json;
use axum::extract::{Request, State};
use axum::http::StatusCode;
use serde_json::{Value, json};

use super::App;
use super::negotiation::Fields;
use super::reply::Problem;
use crate::hand::Action;

pub async fn doing(State(app): State<App>) -> Json<Value> {
    let doing = app.controller().hand();
    Json(json!({"state": doing.state, "t_s": doing.t_s}))
}

/// `action=return|show&script=f1|f2|f3&seed=N`; 409 unless lead-through is active.
pub async fn act(State(app): State<App>, request: Request) -> Result<StatusCode, Problem> {
    let fields = Fields::read(request, &app).await?;
    let action = match fields.require("action")? {
        "return" => Action::Return,
        "show" => Action::Show,
        other => return Err(Problem::bad_request(format!("invalid action {other}"))),
    };
    let script = fields.require("script")?;
    let script = script
        .parse()
        .map_err(|()| Problem::bad_request(format!("invalid script {script}")))?;
    let seed = fields.require("seed")?;
    let seed = seed
        .parse()
        .map_err(|_| Problem::bad_request(format!("invalid seed {seed}")))?;
    app.controller()
        .move_hand(action, script, seed)
        .map_err(|refusal| Problem::new(StatusCode::CONFLICT, 409, refusal.to_string()))?;
    Ok(StatusCode::NO_CONTENT)
}
