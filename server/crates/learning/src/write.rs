//! Writing a demonstration in the project's own JSON form.

use serde::Serialize;

use crate::{Demonstration, SignalEvent, read};

#[derive(Serialize)]
struct Own<'a> {
    format: &'static str,
    version: u32,
    name: &'a str,
    units: Units,
    t_s: &'a [f64],
    joints_deg: Vec<&'a [f64]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tcp_mm: Option<&'a [[f64; 3]]>,
    #[serde(skip_serializing_if = "<[SignalEvent]>::is_empty")]
    signals: &'a [SignalEvent],
}

#[derive(Serialize)]
struct Units {
    t_s: &'static str,
    joints_deg: &'static str,
    tcp_mm: &'static str,
}

/// The demonstration as JSON text that [`read::from_json_str`] reads back exactly.
pub fn to_json(demonstration: &Demonstration) -> String {
    let own = Own {
        format: read::FORMAT,
        version: 1,
        name: demonstration.name(),
        units: Units {
            t_s: "seconds",
            joints_deg: "degrees, one row a sample",
            tcp_mm: "millimetres, tool0 in the base frame",
        },
        t_s: demonstration.times_s(),
        joints_deg: demonstration.joints_deg().rows().collect(),
        tcp_mm: demonstration.recorded_tcp_mm(),
        signals: demonstration.signals(),
    };
    // Finite numbers and strings always serialise.
    serde_json::to_string(&own).unwrap_or_default()
}
