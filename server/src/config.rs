//! The whole configuration as typed values, and the command line that fills them in.

use std::net::{Ipv4Addr, SocketAddr};
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::cli;

/// Which arm the server works with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum RobotChoice {
    /// The virtual GoFa that comes with the server.
    Virtual,
    /// No arm: for training from files and looking at results.
    None,
}

/// What the server needs to know to start.
#[derive(Clone, Debug, Args)]
pub struct Config {
    /// Address and port of the web pages. Anything but a loopback address asks every client for
    /// the pairing code. Port 0 takes any free port.
    #[arg(long, env = "TEAM_LISTEN", default_value_t = Config::DEFAULT_LISTEN)]
    pub listen: SocketAddr,
    /// Answer over HTTPS too, on the same port, with a certificate of this cell's own authority.
    /// Phones that have it can install the app and keep their screen on.
    #[arg(long, env = "TEAM_HTTPS")]
    pub https: bool,
    /// UDP port on which the arm's controller reaches the server (EGM). 0 takes any free port.
    #[arg(long, env = "TEAM_EGM_PORT", default_value_t = 6510)]
    pub egm_port: u16,
    /// Folder of the database. It is made if it is not there.
    #[arg(long, env = "TEAM_DATA", default_value = "./data")]
    pub data: PathBuf,
    /// The arm.
    #[arg(long, env = "TEAM_ROBOT", value_enum, default_value_t = RobotChoice::Virtual)]
    pub robot: RobotChoice,
    /// The configuration file of a cell with several robots or a real one (docs/cell.md).
    #[arg(long, env = "TEAM_CONFIG", value_name = "FILE", conflicts_with_all = ["robot", "egm_port"])]
    pub config: Option<PathBuf>,
}

impl Config {
    const DEFAULT_LISTEN: SocketAddr =
        SocketAddr::new(std::net::IpAddr::V4(Ipv4Addr::LOCALHOST), 8080);
}

/// The command line of `team`.
#[derive(Debug, Parser)]
#[command(name = "team", version, about = "Teach a robot arm to move, by hand")]
pub struct CommandLine {
    /// What to do; without it, the server starts.
    #[command(subcommand)]
    pub command: Option<Command>,
    /// For the server.
    #[command(flatten)]
    pub config: Config,
}

/// What `team` can do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Start the server (the same as no command).
    Serve(Config),
    /// Train a model from recorded files.
    Train(cli::train::Args),
    /// Compute the tables of the method's evaluation from recorded files.
    Evaluate(cli::evaluate::Args),
    /// Look at every link to a robot's controller, and say what to do about those that fail.
    Doctor(cli::doctor::Args),
    /// Reproduce a model into numbers.
    Reproduce(cli::reproduce::Args),
    /// Run the virtual robot by itself, for a server on another computer.
    VirtualRobot(cli::virtual_robot::Args),
}

#[cfg(test)]
mod tests {
    use super::*;

    fn served(arguments: &[&str]) -> Config {
        let line = CommandLine::try_parse_from(arguments).unwrap();
        match line.command {
            Some(Command::Serve(config)) => config,
            None => line.config,
            other => panic!("{other:?} is not a server"),
        }
    }

    #[test]
    fn without_arguments_the_virtual_arm_is_served_on_this_computer_only() {
        let config = served(&["team"]);
        assert_eq!(config.listen.to_string(), "127.0.0.1:8080");
        assert_eq!(
            (config.egm_port, config.robot),
            (6510, RobotChoice::Virtual)
        );
        assert_eq!(config.data, PathBuf::from("./data"));
    }

    #[test]
    fn flags_mean_the_same_with_and_without_the_word_serve() {
        let flags = [
            "--listen",
            "0.0.0.0:80",
            "--egm-port",
            "0",
            "--robot",
            "none",
        ];
        for words in [&["team"][..], &["team", "serve"][..]] {
            let config = served(&[words, &flags[..]].concat());
            assert_eq!(config.listen.to_string(), "0.0.0.0:80");
            assert_eq!((config.egm_port, config.robot), (0, RobotChoice::None));
        }
    }

    #[test]
    fn https_is_one_flag() {
        assert!(!served(&["team"]).https);
        assert!(served(&["team", "--https"]).https);
        assert!(served(&["team", "serve", "--listen", "0.0.0.0:80", "--https"]).https);
    }

    #[test]
    fn a_configuration_file_takes_the_place_of_the_single_robot() {
        let config = served(&["team", "serve", "--config", "cell.toml"]);
        assert_eq!(config.config, Some(PathBuf::from("cell.toml")));
        for other in [["--robot", "none"], ["--egm-port", "6511"]] {
            let line = [&["team", "--config", "cell.toml"][..], &other[..]].concat();
            assert!(CommandLine::try_parse_from(line).is_err());
        }
    }

    #[test]
    fn an_address_without_a_port_is_refused() {
        assert!(CommandLine::try_parse_from(["team", "--listen", "127.0.0.1"]).is_err());
    }
}
