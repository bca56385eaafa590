//! `/virtual/hand`: the one resource that is not ABB's. It answers in plain JSON.

use axum::Json;
use axum::extract::{Request, State};
use axum::http::StatusCode;
use motion::JointAngles;
use motion::limits::RobotLimits;
use serde_json::{Value, json};

use super::App;
use super::negotiation::Fields;
use super::reply::Problem;
use crate::controller::Refusal;
use crate::hand::Action;

pub async fn doing(State(app): State<App>) -> Json<Value> {
    let doing = app.controller().hand();
    Json(json!({"state": doing.state, "t_s": doing.t_s}))
}

/// `action=return|show&script=f1|f2|f3&seed=N`, `action=lead&joints=a,b,c,d,e,f` in degrees, or
/// `action=let_go`; 409 unless lead-through is active.
pub async fn act(State(app): State<App>, request: Request) -> Result<StatusCode, Problem> {
    let fields = Fields::read(request, &app).await?;
    let refused = |refusal: Refusal| Problem::new(StatusCode::CONFLICT, 409, refusal.to_string());
    let action = match fields.require("action")? {
        "return" => Action::Return,
        "show" => Action::Show,
        "lead" => {
            let to = joints(fields.require("joints")?)?;
            app.controller().lead_hand(to).map_err(refused)?;
            return Ok(StatusCode::NO_CONTENT);
        }
        "let_go" => {
            app.controller().end_lead();
            return Ok(StatusCode::NO_CONTENT);
        }
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
        .map_err(refused)?;
    Ok(StatusCode::NO_CONTENT)
}

/// Six angles in the arm's ranges.
fn joints(text: &str) -> Result<JointAngles, Problem> {
    let angles: Result<Vec<f64>, _> = text.split(',').map(str::parse).collect();
    let six = angles.ok().and_then(|angles| angles.try_into().ok());
    six.map(JointAngles)
        .filter(|joints| RobotLimits::gofa5().joint_out_of_range(joints).is_none())
        .ok_or_else(|| Problem::bad_request(format!("invalid joints {text}")))
}
