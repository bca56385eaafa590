//! `team doctor`: looks at every link between this computer and a controller, one after the other,
//! and says of each what it saw and what to do.
//!
//! It moves nothing. With `--move-arm` it makes the arm soft for a moment and lets the robot
//! program run while the arm is told to stand still; the arm is within reach of a mistake then.

mod controller;
mod guidance;
mod reach;
mod report;
#[cfg(test)]
mod tests;

use std::io::Write;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::time::Duration;

use rws::Client;

use super::CliError;
use crate::cell::{self, RobotSettings};
use report::{Report, Step};

/// The task that moves the arm.
pub const TASK: &str = "T_ROB1";
/// TEAM's robot modules that have to be loaded, as they are in `deploy/gofa`. `TEAM_main` is not
/// among them, because a cell may call them from a main program of its own.
pub const MODULES: [&str; 1] = ["TEAM_egm"];
/// The signals that TEAM's robot modules use.
pub const SIGNALS: [&str; 2] = ["GripperClose", "EgmStop"];
/// Longest wait for one answer of the web services.
const ANSWER_WITHIN: Duration = Duration::from_secs(5);

/// Arguments of `team doctor`.
#[derive(Clone, Debug, clap::Args)]
pub struct Args {
    /// Address of the controller's web services, such as https://192.168.125.1.
    #[arg(long, value_name = "URL", required_unless_present = "config")]
    pub rws: Option<String>,
    /// The cell's configuration file; takes the place of the address, the account, the certificate
    /// and --egm.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["rws", "user", "password_file", "certificate", "egm"])]
    pub config: Option<PathBuf>,
    /// Which robot of the file; needed when it has several.
    #[arg(long, value_name = "ID", requires = "config")]
    pub robot: Option<String>,
    /// The controller's account for TEAM.
    #[arg(long, default_value = "Default User")]
    pub user: String,
    /// File with its password in the first line; without it the factory's password is tried.
    #[arg(long, value_name = "FILE")]
    pub password_file: Option<PathBuf>,
    /// SHA-256 fingerprint of the controller's certificate; the only one that is accepted.
    #[arg(long, value_name = "SHA256")]
    pub certificate: Option<String>,
    /// Where the controller sends its EGM messages: this computer's address on the robot's network
    /// and the port. Without it EGM is not looked at.
    #[arg(long, value_name = "ADDR:PORT")]
    pub egm: Option<SocketAddr>,
    /// How long to wait for the first EGM message, seconds.
    #[arg(long, default_value_t = 5.0, value_name = "S", value_parser = seconds)]
    pub egm_wait: f64,
    /// A signal that must be there; may be given several times.
    #[arg(long = "signal", value_name = "NAME", default_values = SIGNALS)]
    pub signals: Vec<String>,
    /// Make the arm soft for a moment, and let the robot program run while the arm stands still.
    /// Nobody may be in the arm's reach.
    #[arg(long)]
    pub move_arm: bool,
    /// Print one JSON object with everything that was seen.
    #[arg(long)]
    pub json: bool,
}

fn seconds(text: &str) -> Result<f64, String> {
    text.parse()
        .ok()
        .filter(|seconds| (0.1..=600.0).contains(seconds))
        .ok_or_else(|| "give a number of seconds from 0.1 to 600".to_owned())
}

/// What is looked at, and how.
#[derive(Clone)]
struct Target {
    rws: String,
    user: String,
    password: String,
    certificate: Option<String>,
    egm: Option<SocketAddr>,
    egm_wait: f64,
    signals: Vec<String>,
    move_arm: bool,
}

/// Examines, prints what was seen, and fails when something is not as it should be.
pub fn run(arguments: &Args) -> Result<(), CliError> {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build()
        .map_err(|error| CliError::Usage(format!("the system refused: {error}")))?;
    let target = target(arguments)?;
    let report = runtime.block_on(async {
        tokio::select! {
            report = examine(&target) => Ok(report),
            _ = tokio::signal::ctrl_c() => {
                if target.move_arm {
                    reach::make_safe(&target).await;
                }
                Err(CliError::Usage("interrupted".to_owned()))
            }
        }
    })?;
    let text = if arguments.json {
        report.json()
    } else {
        report.text()
    };
    // Somebody who closed the pipe does not want to read more.
    std::io::stdout().write_all(text.as_bytes()).ok();
    match report.failures() {
        0 => Ok(()),
        failed => Err(CliError::Unwell {
            failed,
            all: report.findings().len(),
        }),
    }
}

fn password(arguments: &Args) -> Result<Option<String>, CliError> {
    match &arguments.password_file {
        None => Ok(None),
        Some(file) => {
            let text = std::fs::read_to_string(file).map_err(CliError::file(file))?;
            Ok(Some(text.lines().next().unwrap_or_default().to_owned()))
        }
    }
}

fn target(arguments: &Args) -> Result<Target, CliError> {
    let factory = rws::Config::new("");
    let mut target = Target {
        rws: arguments.rws.clone().unwrap_or_default(),
        user: arguments.user.clone(),
        password: factory.password,
        certificate: arguments.certificate.clone(),
        egm: arguments.egm,
        egm_wait: arguments.egm_wait,
        signals: arguments.signals.clone(),
        move_arm: arguments.move_arm,
    };
    if let Some(file) = &arguments.config {
        let robots = cell::read(file).map_err(|error| CliError::Usage(error.to_string()))?;
        let robot = chosen(&robots, arguments.robot.as_deref())?.robot_config();
        let virtual_one = "a virtual robot has no controller to look at; choose a real one";
        target.rws = robot
            .rws_url
            .ok_or_else(|| CliError::Usage(virtual_one.to_owned()))?;
        target.user = robot.rws_user;
        target.password = robot.rws_password;
        target.certificate = robot.rws_certificate_sha256;
        target.egm = Some(robot.egm_listen);
    } else {
        target.password = password(arguments)?.unwrap_or(target.password);
    }
    Ok(target)
}

fn chosen<'a>(
    robots: &'a [RobotSettings],
    id: Option<&str>,
) -> Result<&'a RobotSettings, CliError> {
    let found = match (robots, id) {
        ([only], None) => Some(only),
        (_, None) => None,
        (_, Some(id)) => robots.iter().find(|robot| robot.id == id),
    };
    found.ok_or_else(|| {
        let ids: Vec<&str> = robots.iter().map(|robot| robot.id.as_str()).collect();
        CliError::Usage(format!("choose one with --robot: {}", ids.join(", ")))
    })
}

async fn examine(target: &Target) -> Report {
    let mut report = Report::default();
    if let Err(why) = every_link(target, &mut report).await {
        report.skip_the_rest(&why);
    }
    report
}

/// Looks at one link after the other; an error says why the remaining ones mean nothing.
async fn every_link(target: &Target, report: &mut Report) -> Result<(), String> {
    reach::address(target, report).await?;
    reach::certificate(target, report).await?;
    let client = reach::log_in(target, report).await?;
    controller::look(&client, target, report).await;
    match target.egm {
        Some(listen) => guidance::look(&client, listen, target, report).await,
        None => {
            for step in [Step::EgmPort, Step::EgmMessages, Step::EgmAnswers] {
                report.skipped(step, "no address was given with --egm");
            }
        }
    }
    // The controller frees the session by itself later.
    client.logout().await.ok();
    Ok(())
}

fn client(target: &Target) -> Result<Client, rws::RwsError> {
    Client::new(rws::Config {
        user: target.user.clone(),
        password: target.password.clone(),
        certificate_sha256: target.certificate.clone(),
        timeout: ANSWER_WITHIN,
        ..rws::Config::new(&target.rws)
    })
}
