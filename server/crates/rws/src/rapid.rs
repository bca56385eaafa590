//! Starting, stopping and watching the robot program.

use crate::hal::Entries;
use crate::{Client, RwsError};
use std::time::Duration;
use tokio::time::Instant;

const POLL: Duration = Duration::from_millis(50);
const SETTLE: Duration = Duration::from_millis(1500);
// A start that the controller takes back shows as running for a moment.
const SEEN_IN_A_ROW: u32 = 3;

/// Whether the robot program runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Execution {
    /// It runs.
    Running,
    /// It stands.
    Stopped,
}

impl Execution {
    pub(crate) fn from_wire(word: &str) -> Self {
        if word.eq_ignore_ascii_case("running") {
            Self::Running
        } else {
            Self::Stopped
        }
    }
}

/// How often the program is to be run through.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cycle {
    /// Once.
    Once,
    /// Until stopped.
    Forever,
}

impl Client {
    /// Reads whether the robot program runs.
    ///
    /// # Errors
    /// As for every call.
    pub async fn execution(&self) -> Result<Execution, RwsError> {
        let path = "/rw/rapid/execution";
        let text = self.get(path).await?;
        let word = Entries::parse(path, &text)?
            .with_field("ctrlexecstate")?
            .text("ctrlexecstate")?;
        Ok(Execution::from_wire(&word))
    }

    /// Starts the robot program and waits until it really runs.
    ///
    /// # Errors
    /// [`RwsError::ExecutionUnchanged`] when the controller said yes but the program did not
    /// start within 1.5 s; [`RwsError::Refused`] when it said no.
    pub async fn start_execution(&self, cycle: Cycle) -> Result<(), RwsError> {
        let cycle = match cycle {
            Cycle::Once => "once",
            Cycle::Forever => "forever",
        };
        let form = [
            ("regain", "continue"),
            ("execmode", "continue"),
            ("cycle", cycle),
            ("condition", "none"),
            ("stopatbp", "disabled"),
            ("alltaskbytsp", "false"),
        ];
        self.post("/rw/rapid/execution/start", &form).await?;
        // A success is returned even if the controller rejects the start at once.
        self.wait_for_execution(Execution::Running).await
    }

    /// Stops the robot program and waits until it stands.
    ///
    /// # Errors
    /// As for [`Client::start_execution`].
    pub async fn stop_execution(&self) -> Result<(), RwsError> {
        let form = [("stopmode", "stop"), ("usetsp", "normal")];
        self.post("/rw/rapid/execution/stop", &form).await?;
        self.wait_for_execution(Execution::Stopped).await
    }

    /// Moves the program pointer to main in all tasks. Needs edit mastership and a standing
    /// program.
    ///
    /// # Errors
    /// [`RwsError::Refused`] without mastership or while the program runs.
    pub async fn reset_program_pointer(&self) -> Result<(), RwsError> {
        self.post("/rw/rapid/execution/resetpp", &[])
            .await
            .map(|_| ())
    }

    async fn wait_for_execution(&self, wanted: Execution) -> Result<(), RwsError> {
        let deadline = Instant::now() + SETTLE;
        let mut in_a_row = 0;
        loop {
            in_a_row = if self.execution().await? == wanted {
                in_a_row + 1
            } else {
                0
            };
            // Standing needs no second look: nothing starts by itself.
            if in_a_row >= SEEN_IN_A_ROW || (in_a_row == 1 && wanted == Execution::Stopped) {
                return Ok(());
            }
            if Instant::now() >= deadline {
                let running = wanted == Execution::Running;
                return Err(RwsError::ExecutionUnchanged { running });
            }
            tokio::time::sleep(POLL).await;
        }
    }
}
