//! What the controller says about itself over the web services.

use jiff::civil::DateTime;
use jiff::tz::TimeZone;
use rws::{Client, ControllerState, Execution, OperatingMode, RwsError};

use super::report::{Report, Step};
use super::{Args, MODULES, TASK};
use crate::clock::{Clock, SystemClock};

/// ABB's number of the option, and its name.
const EGM_OPTION: [&str; 2] = ["3124-1", "Externally Guided Motion"];
/// Clocks are set by people to the second, and both answers take their time.
const CLOCKS_AGREE_S: f64 = 5.0;
const QUARTER_HOUR_S: f64 = 900.0;
const WIDEST_ZONE_S: f64 = 14.0 * 3600.0;

/// Looks at everything; none of it depends on the others.
pub async fn look(client: &Client, arguments: &Args, report: &mut Report) {
    robotware(client, report).await;
    options(client, report).await;
    rights(client, report).await;
    mode(client, report).await;
    motors(client, report).await;
    program(client, report).await;
    position(client, report).await;
    let ready = report.all_ok(&[Step::Mode, Step::Motors]);
    lead_through(client, arguments.move_arm.then_some(ready), report).await;
    signals(client, &arguments.signals, report).await;
    clock(client, report).await;
}

async fn robotware(client: &Client, report: &mut Report) {
    match client.system().await {
        Ok(system) if system.robotware.starts_with("7.") => report.ok(
            Step::RobotWare,
            format!("\"{}\" has RobotWare {}", system.name, system.robotware),
        ),
        Ok(system) => report.failed(
            Step::RobotWare,
            format!("\"{}\" has RobotWare {}", system.name, system.robotware),
            "TEAM is made for RobotWare 7 on OmniCore controllers.",
        ),
        Err(error) => report.refused(Step::RobotWare, &error),
    }
}

async fn options(client: &Client, report: &mut Report) {
    match client.options().await {
        Ok(options) => {
            let found = options
                .iter()
                .find(|option| EGM_OPTION.iter().any(|name| option.contains(name)));
            match found {
                Some(option) => report.ok(Step::Options, option),
                None => report.failed(
                    Step::Options,
                    format!("none of the {} options is it", options.len()),
                    "Order and install option 3124-1 Externally Guided Motion. Without it TEAM can record and train, but not reproduce.",
                ),
            }
        }
        Err(RwsError::Missing { .. }) => report.skipped(
            Step::Options,
            "the controller does not list its options; look for 3124-1 on the FlexPendant",
        ),
        Err(error) => report.refused(Step::Options, &error),
    }
}

/// Mastership changes nothing by itself, and is given back at once.
async fn rights(client: &Client, report: &mut Report) {
    let taken = client.request_edit_mastership().await;
    let outcome = match taken {
        Ok(()) => client.release_edit_mastership().await,
        Err(error) => Err(error),
    };
    match outcome {
        Ok(()) => report.ok(Step::Rights, "edit mastership was given, and returned"),
        Err(error) => report.refused(Step::Rights, &error),
    }
}

async fn mode(client: &Client, report: &mut Report) {
    match client.operating_mode().await {
        Ok(OperatingMode::Auto) => report.ok(Step::Mode, "automatic"),
        Ok(other) => report.failed(
            Step::Mode,
            other.to_string(),
            "Switch it to automatic on the FlexPendant and confirm there.",
        ),
        Err(error) => report.refused(Step::Mode, &error),
    }
}

async fn motors(client: &Client, report: &mut Report) {
    let stop = "Release the stop, close the guard, and acknowledge it on the FlexPendant.";
    match client.controller_state().await {
        Ok(ControllerState::MotorsOn) => report.ok(Step::Motors, "motors on"),
        Ok(ControllerState::MotorsOff) => {
            report.ok(
                Step::Motors,
                "motors off; TEAM switches them on when it needs them",
            );
        }
        Ok(ControllerState::GuardStop) => report.failed(Step::Motors, "a guard stop", stop),
        Ok(ControllerState::EmergencyStop) => {
            report.failed(Step::Motors, "the emergency stop is pressed", stop);
        }
        Ok(ControllerState::EmergencyStopReset) => {
            report.failed(
                Step::Motors,
                "the emergency stop waits to be acknowledged",
                stop,
            );
        }
        Ok(other) => report.failed(
            Step::Motors,
            format!("{other:?}"),
            "Wait until the controller has started; if it stays, read its log on the FlexPendant.",
        ),
        Err(error) => report.refused(Step::Motors, &error),
    }
}

async fn program(client: &Client, report: &mut Report) {
    const LOAD: &str =
        "Load the modules of deploy/gofa into task T_ROB1 and set the program pointer to main.";
    let tasks = match client.tasks().await {
        Ok(tasks) => tasks,
        Err(error) => return report.refused(Step::Program, &error),
    };
    let Some(task) = tasks.iter().find(|task| task.name == TASK) else {
        return report.failed(Step::Program, format!("there is no task {TASK}"), LOAD);
    };
    if !task.active {
        return report.failed(
            Step::Program,
            format!("task {TASK} is switched off"),
            "Switch it on in the quick settings of the FlexPendant.",
        );
    }
    let modules = match client.modules(TASK).await {
        Ok(modules) => modules,
        Err(error) => return report.refused(Step::Program, &error),
    };
    let missing: Vec<&str> = MODULES
        .into_iter()
        .filter(|name| {
            let is_it = |module: &rws::Module| module.name.eq_ignore_ascii_case(name);
            !modules.iter().any(is_it)
        })
        .collect();
    if missing.is_empty() {
        report.ok(Step::Program, format!("{} in {TASK}", MODULES.join(", ")));
    } else {
        let saw = format!("{} is not loaded in {TASK}", missing.join(", "));
        report.failed(Step::Program, saw, LOAD);
    }
}

async fn position(client: &Client, report: &mut Report) {
    match client.joint_target_deg().await {
        Ok(joints_deg) => {
            let joints = joints_deg.map(|angle| format!("{angle:.1}°"));
            report.ok(Step::Position, joints.join(", "));
        }
        Err(error) => report.refused(Step::Position, &error),
    }
}

/// `toggle` is whether the arm is ready to be made soft, if that is wanted.
async fn lead_through(client: &Client, toggle: Option<bool>, report: &mut Report) {
    let active = match client.lead_through().await {
        Ok(active) => active,
        Err(error) => return report.refused(Step::LeadThrough, &error),
    };
    let Some(ready) = toggle else {
        let now = if active { "active" } else { "inactive" };
        return report.ok(
            Step::LeadThrough,
            format!("{now}; with --move-arm it is tried whether it can be switched"),
        );
    };
    if !ready {
        return report.skipped(
            Step::LeadThrough,
            "the arm is not made soft outside of automatic mode or while a stop is active",
        );
    }
    if active || !matches!(client.execution().await, Ok(Execution::Stopped)) {
        return report.skipped(
            Step::LeadThrough,
            "somebody guides the arm, or the robot program runs",
        );
    }
    let soft = async {
        client.set_motors(true).await?;
        client.set_lead_through(true).await
    };
    let softened = soft.await;
    // Whatever happened, the arm is stiff and its brakes hold it afterwards.
    let stiff = client.set_lead_through(false).await;
    let off = client.set_motors(false).await;
    match softened.and(stiff).and(off) {
        Ok(()) => report.ok(Step::LeadThrough, "the arm went soft and stiff again"),
        Err(error) => report.refused(Step::LeadThrough, &error),
    }
}

async fn signals(client: &Client, names: &[String], report: &mut Report) {
    let mut seen = Vec::new();
    for name in names {
        match client.signal(name).await {
            Ok(signal) => seen.push(format!("{name} ({}) is {}", signal.kind, signal.value)),
            Err(RwsError::Missing { .. }) => {
                return report.failed(
                    Step::Signals,
                    format!("there is no signal {name}"),
                    "Load deploy/gofa/TEAM_eio.cfg or make the signal with access level All, then restart the controller.",
                );
            }
            Err(error) => return report.refused(Step::Signals, &error),
        }
    }
    report.ok(Step::Signals, seen.join(", "));
}

async fn clock(client: &Client, report: &mut Report) {
    let text = match client.clock().await {
        Ok(text) => text,
        Err(RwsError::Missing { .. }) => {
            return report.skipped(Step::Clock, "the controller does not tell the time");
        }
        Err(error) => return report.refused(Step::Clock, &error),
    };
    let ours_s = SystemClock.now().0 as f64 / 1000.0;
    let Some(ahead_s) = seconds_since_1970(&text).map(|theirs_s| theirs_s - ours_s) else {
        return report.skipped(Step::Clock, format!("\"{text}\" is no time"));
    };
    // The controller shows the time of its zone, and zones differ by quarters of an hour.
    let zone_s = (ahead_s / QUARTER_HOUR_S).round() * QUARTER_HOUR_S;
    // Without the sum, a little behind would be written as "-0".
    let apart_s = (ahead_s - zone_s).round() + 0.0;
    let saw =
        format!("the controller shows {text}, {apart_s:+.0} s from ours beside whole time zones");
    if apart_s.abs() <= CLOCKS_AGREE_S && zone_s.abs() <= WIDEST_ZONE_S {
        report.ok(Step::Clock, saw);
    } else {
        report.failed(
            Step::Clock,
            saw,
            "Set the controller's clock, best by a time server. Recordings are right all the same, but its log cannot be compared with TEAM's.",
        );
    }
}

fn seconds_since_1970(text: &str) -> Option<f64> {
    let time = DateTime::strptime("%Y-%m-%d T %H:%M:%S", text).ok()?;
    let timestamp = TimeZone::UTC.to_timestamp(time).ok()?;
    Some(timestamp.as_second() as f64)
}
