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
    #[arg(long, value_name = "URL")]
    pub rws: String,
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

/// Examines, prints what was seen, and fails when something is not as it should be.
pub fn run(arguments: &Args) -> Result<(), CliError> {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build()
        .map_err(|error| CliError::Usage(format!("the system refused: {error}")))?;
    let password = password(arguments)?;
    let report = runtime.block_on(async {
        tokio::select! {
            report = examine(arguments, &password) => Ok(report),
            _ = tokio::signal::ctrl_c() => {
                if arguments.move_arm {
                    reach::make_safe(arguments, &password).await;
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

fn password(arguments: &Args) -> Result<String, CliError> {
    match &arguments.password_file {
        None => Ok(rws::Config::new("").password),
        Some(file) => {
            let text = std::fs::read_to_string(file).map_err(CliError::file(file))?;
            Ok(text.lines().next().unwrap_or_default().to_owned())
        }
    }
}

async fn examine(arguments: &Args, password: &str) -> Report {
    let mut report = Report::default();
    if let Err(why) = every_link(arguments, password, &mut report).await {
        report.skip_the_rest(&why);
    }
    report
}

/// Looks at one link after the other; an error says why the remaining ones mean nothing.
async fn every_link(arguments: &Args, password: &str, report: &mut Report) -> Result<(), String> {
    reach::address(arguments, report).await?;
    reach::certificate(arguments, report).await?;
    let client = reach::log_in(arguments, password, report).await?;
    controller::look(&client, arguments, report).await;
    match arguments.egm {
        Some(listen) => guidance::look(&client, listen, arguments, report).await,
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

fn client(arguments: &Args, password: &str) -> Result<Client, rws::RwsError> {
    Client::new(rws::Config {
        user: arguments.user.clone(),
        password: password.to_owned(),
        certificate_sha256: arguments.certificate.clone(),
        timeout: ANSWER_WITHIN,
        ..rws::Config::new(&arguments.rws)
    })
}
