//! The program `team` from its command line to its exit code. It is in the library so that the
//! whole-system tests can start the same program.

use std::io::Write;
use std::process::ExitCode;

use clap::Parser;
use tracing_subscriber::EnvFilter;

use crate::config::{Command, CommandLine, Config};
use crate::{App, announcement, asked_by_the_system, cli};

/// Parses the command line, runs, and says what went wrong.
pub fn run() -> ExitCode {
    let line = CommandLine::parse();
    let result = match line.command {
        Some(Command::Train(arguments)) => cli::train::run(&arguments).map_err(Into::into),
        Some(Command::Evaluate(arguments)) => cli::evaluate::run(&arguments).map_err(Into::into),
        Some(Command::Doctor(arguments)) => cli::doctor::run(&arguments).map_err(Into::into),
        Some(Command::Reproduce(arguments)) => cli::reproduce::run(&arguments).map_err(Into::into),
        Some(Command::VirtualRobot(arguments)) => {
            begin_log();
            cli::virtual_robot::run(&arguments).map_err(Into::into)
        }
        Some(Command::Serve(config)) => serve(config),
        None => serve(line.config),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // The words of the causes are in it already.
            eprintln!("team: {error}");
            ExitCode::FAILURE
        }
    }
}

fn begin_log() {
    let filter = EnvFilter::try_from_env("TEAM_LOG").unwrap_or_else(|_| EnvFilter::new("info"));
    tracing_subscriber::fmt()
        .with_writer(std::io::stderr)
        .with_env_filter(filter)
        .init();
}

fn serve(config: Config) -> anyhow::Result<()> {
    begin_log();
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .worker_threads(2)
        .enable_all()
        .build()?;
    runtime.block_on(async {
        let app = App::start(config).await?;
        let mut out = std::io::stdout();
        out.write_all(announcement(&app).as_bytes())?;
        out.flush()?;
        asked_by_the_system().await?;
        tracing::info!("stopping");
        app.shutdown().await;
        Ok(())
    })
}
