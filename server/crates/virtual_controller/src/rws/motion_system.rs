//! `/rw/motionsystem/mechunits/ROB_1`: where the arm is, and lead-through.

use std::collections::HashMap;

use axum::extract::{Query, State};
use axum::http::StatusCode;
use axum::response::Response;
use motion::JointAngles;
use motion::kinematics::tool0;

use super::App;
use super::negotiation::{Fields, Format};
use super::reply::{self, Item, Problem};
use crate::controller::LeadThrough;

/// What the controller says where there is no external axis.
const NO_AXIS: &str = "9E+09";
const EXTERNAL_AXES: [&str; 6] = ["eax_a", "eax_b", "eax_c", "eax_d", "eax_e", "eax_f"];

pub async fn unit(State(app): State<App>, format: Format) -> Response {
    let active = app.controller().lead_through() == LeadThrough::Active;
    let item = Item::new("ms-mechunit", "ROB_1")
        .with("mode", "Activated")
        .with("axes", 6)
        .with("tool-name", "tool0")
        .with("wobj-name", "wobj0")
        .with("payload-name", "load0")
        .with("status", if active { "LeadThrough" } else { "" });
    reply::single(format, &item)
}

pub async fn joint_target(State(app): State<App>, format: Format) -> Response {
    let measured = app.controller().measured();
    const AXES: [&str; 6] = ["rax_1", "rax_2", "rax_3", "rax_4", "rax_5", "rax_6"];
    let mut item = Item::new("ms-jointtarget", "jointtarget");
    for (name, angle) in AXES.into_iter().zip(measured.0) {
        item = item.with(name, single_precision(angle));
    }
    reply::single(format, &with_external_axes(item))
}

pub async fn rob_target(
    State(app): State<App>,
    format: Format,
    Query(query): Query<HashMap<String, String>>,
) -> Result<Response, Problem> {
    let is = |key: &str, known: &[&str]| {
        query
            .get(key)
            .is_none_or(|value| known.iter().any(|known| value.eq_ignore_ascii_case(known)))
    };
    if !is("tool", &["tool0"]) || !is("wobj", &["wobj0"]) {
        return Err(Problem::missing(
            "this controller knows tool0 and wobj0 alone",
        ));
    }
    // The base is the world here, and wobj0 is the world.
    if !is("coordinate", &["Base", "World", "Wobj"]) {
        return Err(Problem::bad_request("invalid coordinate"));
    }
    let measured = app.controller().measured();
    let item = pose_fields(Item::new("ms-robtargets", "robtarget"), &measured);
    Ok(reply::single(format, &with_external_axes(item)))
}

pub async fn cartesian(State(app): State<App>, format: Format) -> Response {
    let measured = app.controller().measured();
    let item = pose_fields(Item::new("ms-mechunit-cartesian", "cartesian"), &measured);
    reply::single(format, &item)
}

pub async fn lead_through(State(app): State<App>, format: Format) -> Response {
    let active = app.controller().lead_through().is_soft();
    let item = Item::new("ms-leadthrough", "lead-through")
        .with("status", if active { "Active" } else { "Inactive" });
    reply::single(format, &item)
}

pub async fn set_lead_through(
    State(app): State<App>,
    fields: Fields,
) -> Result<StatusCode, Problem> {
    let active = match fields.require("status")? {
        "active" => true,
        "inactive" => false,
        other => return Err(Problem::bad_request(format!("invalid status {other}"))),
    };
    app.controller().set_lead_through(active)?;
    Ok(StatusCode::NO_CONTENT)
}

/// Position, orientation (w first) and configuration of tool0.
fn pose_fields(item: Item, joints: &JointAngles) -> Item {
    let pose = tool0(joints);
    let [x, y, z] = pose.position.0.map(single_precision);
    let q = pose.orientation;
    let quarter = |joint: usize| (joints.0[joint] / 90.0).floor() as i32;
    item.with("x", x)
        .with("y", y)
        .with("z", z)
        .with("q1", single_precision(q.w))
        .with("q2", single_precision(q.x))
        .with("q3", single_precision(q.y))
        .with("q4", single_precision(q.z))
        .with("cf1", quarter(0))
        .with("cf4", quarter(3))
        .with("cf6", quarter(5))
        .with("cfx", u8::from(joints.0[4] < 0.0))
}

fn with_external_axes(item: Item) -> Item {
    EXTERNAL_AXES
        .into_iter()
        .fold(item, |item, name| item.with(name, NO_AXIS))
}

/// The controller works in single precision, and its answers show it.
fn single_precision(value: f64) -> f32 {
    value as f32
}
