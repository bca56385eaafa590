//! A flight record as comma-separated values: one row per cycle, units in the names of the columns.
//! The columns are described in `docs/flight.md`. What is not known is an empty field.

use std::fmt::Write;

use crate::store::cycles::{Cycle, CycleDetails};

/// The first line.
pub(super) fn header() -> String {
    let joints = |name: &str, unit: &str| -> String {
        (1..=6)
            .map(|joint| format!(",{name}_{joint}_{unit}"))
            .collect()
    };
    format!(
        "t_s,plan_t_s,phase{}{}{},lost,late,held,limited,motors_on,rapid_running,utilization_percent\n",
        joints("commanded", "deg"),
        joints("measured", "deg"),
        joints("commanded_speed", "deg_s"),
    )
}

/// Numbers are written so that they read back as the same numbers.
pub(super) fn rows(cycles: &[Cycle]) -> String {
    let mut text = String::with_capacity(cycles.len() * 360);
    for cycle in cycles {
        row(&mut text, cycle);
    }
    text
}

fn row(text: &mut String, cycle: &Cycle) {
    let (whole, rest) = (cycle.at_us / 1_000_000, cycle.at_us % 1_000_000);
    let details = cycle.details.as_ref();
    // Writing into a text never fails.
    let _ = write!(text, "{whole}.{rest:06},{},", cycle.plan_t_s);
    text.push_str(details.map_or("", |details| details.phase.as_str()));
    for angle in cycle.commanded_deg.iter().chain(&cycle.measured_deg) {
        let _ = write!(text, ",{angle}");
    }
    match details {
        Some(details) => known(text, details),
        None => text.push_str(&",".repeat(13)),
    }
    text.push('\n');
}

fn known(text: &mut String, details: &CycleDetails) {
    for speed in details.commanded_deg_s {
        let _ = write!(text, ",{speed}");
    }
    let _ = write!(text, ",{}", details.lost);
    let flags = [
        details.late,
        details.held,
        details.limited,
        details.motors_on,
        details.rapid_running,
    ];
    for flag in flags {
        text.push_str(if flag { ",1" } else { ",0" });
    }
    match details.utilization_percent {
        Some(percent) => {
            let _ = write!(text, ",{percent}");
        }
        None => text.push(','),
    }
}
