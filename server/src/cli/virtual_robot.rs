//! `team virtual-robot`: the virtual arm as a program of its own, for servers on other computers
//! and for EGM servers of others.
//!
//! The arm itself is the crate `virtual_controller`; what is here is its command line.

use std::net::{Ipv4Addr, SocketAddr, ToSocketAddrs};
use std::path::PathBuf;
use std::time::Duration;

use motion::{JOINTS, JointAngles};
use tokio::sync::broadcast::error::RecvError;
use virtual_controller::{
    Config, EgmSettings, FaultScript, MessageSet, StopMode, VirtualController,
};

use super::CliError;
use crate::asked_by_the_system;

/// Whether the program still runs is looked at with this period.
const LOOK_AGAIN: Duration = Duration::from_secs(1);

/// Arguments of `team virtual-robot`.
#[derive(Clone, Debug, clap::Args)]
pub struct Args {
    /// Where the EGM server listens, HOST:PORT. The robot sends there and takes the answers.
    #[arg(long, default_value = "127.0.0.1:6510", value_name = "HOST:PORT")]
    pub egm: String,
    /// Where Robot Web Services listen. Any address of this computer; port 0 takes any free port.
    #[arg(long, default_value_t = SocketAddr::new(Ipv4Addr::LOCALHOST.into(), 8081), value_name = "ADDRESS:PORT")]
    pub rws: SocketAddr,
    /// Serve them over HTTPS, with a certificate made at the start; its fingerprint is printed.
    #[arg(long)]
    pub https: bool,
    /// Faults by script, a JSON file.
    #[arg(long, value_name = "FILE")]
    pub faults: Option<PathBuf>,
    /// Switch the motors on and start the program without being asked, and again when it has
    /// ended: for EGM servers that know no Robot Web Services.
    #[arg(long)]
    pub run: bool,
    /// Whose messages the robot sends.
    #[arg(long, value_enum, default_value = "rw7")]
    pub messages: Messages,
    /// Joint angles at the start in degrees, q1,..,q6.
    #[arg(
        long,
        value_name = "ANGLES",
        value_delimiter = ',',
        num_args = 1,
        allow_hyphen_values = true
    )]
    pub home: Vec<f64>,
    /// The controller's period, ms.
    #[arg(long, value_name = "MS", default_value_t = 4.032)]
    pub cycle_ms: f64,
    /// Position gain k, 1/s.
    #[arg(long, value_name = "K", default_value_t = 5.0)]
    pub position_gain: f64,
    /// Largest joint speed that EGM may cause (MaxSpeedDeviation), deg/s.
    #[arg(long, value_name = "DEG_S", default_value_t = 1000.0)]
    pub max_speed_deg_s: f64,
    /// How long the arm must be where it should before the run ends by itself (CondTime), s.
    #[arg(long, value_name = "S", default_value_t = 600.0)]
    pub cond_time_s: f64,
    /// How long the robot waits for an answer (CommTimeout), s.
    #[arg(long, value_name = "S", default_value_t = 1.0)]
    pub comm_timeout_s: f64,
    /// Go back to where the run began when it ends, instead of holding.
    #[arg(long)]
    pub ramp_down: bool,
    /// Send the position also while no program guides the arm.
    #[arg(long)]
    pub stream: bool,
    /// Report the program's state as undefined at first, as a restarted controller can.
    #[arg(long)]
    pub undefined_at_first: bool,
}

/// Message generations on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Messages {
    /// RobotWare 7.
    Rw7,
    /// RobotWare 6.10 and later.
    Rw6,
    /// RobotWare 6 before 6.07.
    Rw6Early,
}

impl Args {
    fn config(&self) -> Result<Config, CliError> {
        let mut config = Config::new(resolve(&self.egm)?);
        config.rws_listen = self.rws;
        config.rws_https = self.https;
        if !self.home.is_empty() {
            let home = <[f64; JOINTS]>::try_from(&*self.home).map_err(|_| {
                CliError::Usage("--home needs six angles in degrees, q1,..,q6".into())
            })?;
            config.home = JointAngles(home);
        }
        config.egm = EgmSettings {
            cycle_s: self.cycle_ms * 1e-3,
            position_gain: self.position_gain,
            max_speed_deviation_deg_s: self.max_speed_deg_s,
            cond_time_s: self.cond_time_s,
            comm_timeout_s: self.comm_timeout_s,
            stop_mode: if self.ramp_down {
                StopMode::RampDown
            } else {
                StopMode::Hold
            },
            stream_when_idle: self.stream,
            messages: match self.messages {
                Messages::Rw7 => MessageSet::RobotWare7,
                Messages::Rw6 => MessageSet::RobotWare6,
                Messages::Rw6Early => MessageSet::EarlyRobotWare6,
            },
            rapid_undefined_at_first: self.undefined_at_first,
            ..EgmSettings::default()
        };
        Ok(config)
    }

    fn script(&self) -> Result<Option<FaultScript>, CliError> {
        let Some(path) = &self.faults else {
            return Ok(None);
        };
        let text = std::fs::read_to_string(path).map_err(CliError::file(path))?;
        let script = FaultScript::from_json(&text)
            .map_err(|error| CliError::Usage(format!("{}: {error}", path.display())))?;
        Ok(Some(script))
    }
}

fn resolve(address: &str) -> Result<SocketAddr, CliError> {
    let found = address.to_socket_addrs().map_err(|error| {
        CliError::Usage(format!(
            "--egm {address}: {error}; give the computer and the port, as in 192.168.125.10:6510"
        ))
    })?;
    // A name can stand for several addresses; EGM servers listen on the older kind.
    let mut found: Vec<SocketAddr> = found.collect();
    found.sort_by_key(SocketAddr::is_ipv6);
    let first = found.first().copied();
    first.ok_or_else(|| CliError::Usage(format!("--egm {address}: no such computer")))
}

/// Runs the robot until it is asked to end.
///
/// # Errors
/// When an option makes no sense, the script can't be read, or the robot can't start.
pub fn run(args: &Args) -> Result<(), CliError> {
    let (config, script) = (args.config()?, args.script()?);
    let egm = config.egm_remote;
    let system = |source| CliError::File {
        path: "the operating system refused".to_owned(),
        source,
    };
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build()
        .map_err(system)?;
    runtime.block_on(async {
        let robot = VirtualController::start(config).await?;
        if let Some(script) = script {
            robot.faults().play(script)?;
        }
        println!(
            "The virtual robot is ready: {}/ (EGM to {egm})",
            robot.rws_url()
        );
        if let Some(sha256) = robot.certificate_sha256() {
            println!("The SHA-256 fingerprint of its certificate is {sha256}");
        }
        tokio::select! {
            () = watch(&robot, args.run) => {}
            ended = asked_by_the_system() => ended.map_err(system)?,
        }
        robot.stop().await;
        Ok(())
    })
}

/// Prints what the robot logs, and starts its program again if that is wanted.
async fn watch(robot: &VirtualController, keep_running: bool) {
    let mut changes = robot.changes();
    let mut look = tokio::time::interval(LOOK_AGAIN);
    let mut printed = 0;
    loop {
        tokio::select! {
            _ = look.tick(), if keep_running => {
                // A guard that is open, say, is a reason not to; the next look asks again.
                if let Err(refusal) = robot.keep_running() {
                    tracing::debug!(%refusal, "the program does not run");
                }
            }
            change = changes.recv() => {
                if matches!(change, Err(RecvError::Closed)) {
                    return;
                }
                for event in robot.events_after(printed) {
                    println!("{} {}: {}", event.code, event.title, event.description);
                    printed = event.number;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::{Command, CommandLine};
    use clap::Parser;

    fn args(more: &[&str]) -> Args {
        let line = [&["team", "virtual-robot"], more].concat();
        match CommandLine::try_parse_from(line).unwrap().command {
            Some(Command::VirtualRobot(args)) => args,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn options_reach_the_controllers_settings() {
        let config = args(&[
            "--egm",
            "localhost:6511",
            "--rws",
            "0.0.0.0:0",
            "--messages",
            "rw6",
            "--home",
            "1,2,3,-4,-5,6",
            "--comm-timeout-s",
            "5",
            "--ramp-down",
        ])
        .config()
        .unwrap();
        assert_eq!(config.egm_remote.to_string(), "127.0.0.1:6511");
        assert_eq!(config.rws_listen.to_string(), "0.0.0.0:0");
        assert_eq!(config.home, JointAngles([1.0, 2.0, 3.0, -4.0, -5.0, 6.0]));
        assert_eq!(config.egm.messages, MessageSet::RobotWare6);
        assert_eq!(config.egm.stop_mode, StopMode::RampDown);
        assert_eq!(config.egm.comm_timeout_s, 5.0);
    }

    #[test]
    fn without_options_the_controller_is_the_one_of_the_server() {
        let config = args(&[]).config().unwrap();
        assert_eq!(config.egm, EgmSettings::default());
    }

    #[test]
    fn what_cannot_be_meant_is_refused_with_its_name() {
        for (more, word) in [
            (&["--egm", "127.0.0.1"][..], "--egm"),
            (&["--home", "1,2,3"], "--home"),
        ] {
            let error = args(more).config().unwrap_err().to_string();
            assert!(error.contains(word), "{error}");
        }
        let error = args(&["--faults", "nowhere.json"]).script().unwrap_err();
        assert!(error.to_string().contains("nowhere.json"));
    }
}
