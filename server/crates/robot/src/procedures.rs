//! The sequences of web-service calls that make the arm soft, make it stiff, start and stop the
//! robot program. Each leaves the arm in a safe state when one of its steps fails.

use crate::error::RobotError;
use rws::{Client, ControllerState, Cycle, Execution, OperatingMode, RwsError};
use std::time::Duration;
use tokio::time::Instant;

const MOTORS_ON_WITHIN: Duration = Duration::from_secs(3);
const AT_REST_WITHIN: Duration = Duration::from_secs(3);
const POLL: Duration = Duration::from_millis(50);

/// Makes the arm soft: automatic mode, program stopped, motors on, lead-through active.
pub(crate) async fn enter_guidance(
    client: &Client,
    stopped: impl Fn() -> bool,
) -> Result<(), RobotError> {
    let soft = async {
        require_automatic(client).await?;
        stop_program(client).await?;
        switch_motors_on(client).await?;
        unless(&stopped)?;
        switch_lead_through_on(client, &stopped).await?;
        unless(&stopped)
    };
    match soft.await {
        Ok(()) => Ok(()),
        Err(error) => {
            // The first error is the one to report; the second would only say the same again.
            let _ = leave_guidance(client).await;
            Err(error)
        }
    }
}

/// Makes the arm stiff: lead-through inactive, motors off, so that the brakes hold it. The motors
/// are switched off also when lead-through will not end.
pub(crate) async fn leave_guidance(client: &Client) -> Result<(), RobotError> {
    let inactive = client.set_lead_through(false).await;
    let off = client.set_motors(false).await;
    inactive?;
    match off {
        // A stop that is active has switched them off already.
        Err(RwsError::Refused { .. }) => Ok(()),
        other => Ok(other?),
    }
}

/// Starts the robot program from its beginning; the arm does not move yet.
pub(crate) async fn begin_run(
    client: &Client,
    stopped: impl Fn() -> bool,
) -> Result<(), RobotError> {
    require_automatic(client).await?;
    if client.lead_through().await? {
        client.set_lead_through(false).await?;
    }
    stop_program(client).await?;
    unless(&stopped)?;
    client.request_edit_mastership().await?;
    // The program pointer must go back to main: a program that was stopped in the middle still
    // holds an EGM identity, and there are only four of them.
    let reset = client.reset_program_pointer().await;
    let released = client.release_edit_mastership().await;
    reset?;
    released?;
    unless(&stopped)?;
    switch_motors_on(client).await?;
    unless(&stopped)?;
    client.start_execution(Cycle::Once).await?;
    Ok(())
}

/// What was found after a run.
#[derive(Debug)]
pub(crate) struct Aftermath {
    /// The controller's state before the program was stopped, if it answered.
    pub controller: Option<ControllerState>,
    /// Whether the program stands now.
    pub stopped: Result<(), RobotError>,
}

/// Stops the robot program.
pub(crate) async fn end_run(client: &Client) -> Aftermath {
    Aftermath {
        controller: client.controller_state().await.ok(),
        stopped: stop_program(client).await,
    }
}

async fn stop_program(client: &Client) -> Result<(), RobotError> {
    if client.execution().await? == Execution::Running {
        client.stop_execution().await?;
    }
    Ok(())
}

/// For a moment after the program was stopped the arm still comes to rest, and the controller
/// refuses lead-through as long.
async fn switch_lead_through_on(
    client: &Client,
    stopped: &impl Fn() -> bool,
) -> Result<(), RobotError> {
    let deadline = Instant::now() + AT_REST_WITHIN;
    loop {
        match client.set_lead_through(true).await {
            Err(RwsError::Refused { .. }) if Instant::now() < deadline => {
                unless(stopped)?;
                tokio::time::sleep(POLL).await;
            }
            other => return Ok(other?),
        }
    }
}

async fn require_automatic(client: &Client) -> Result<(), RobotError> {
    match client.operating_mode().await? {
        OperatingMode::Auto => Ok(()),
        other => Err(RobotError::NotAutomatic {
            mode: other.to_string(),
        }),
    }
}

async fn switch_motors_on(client: &Client) -> Result<(), RobotError> {
    let deadline = Instant::now() + MOTORS_ON_WITHIN;
    let mut asked = false;
    loop {
        let state = client.controller_state().await?;
        if let Some(reason) = not_ready(&state) {
            return Err(RobotError::NotReady { reason });
        }
        if state == ControllerState::MotorsOn {
            return Ok(());
        }
        if !asked {
            client.set_motors(true).await?;
            asked = true;
        } else if Instant::now() >= deadline {
            return Err(RobotError::MotorsStayOff);
        } else {
            tokio::time::sleep(POLL).await;
        }
    }
}

/// Why the motors cannot be on in this state, if they cannot.
pub(crate) fn not_ready(state: &ControllerState) -> Option<&'static str> {
    match state {
        ControllerState::MotorsOn | ControllerState::MotorsOff | ControllerState::Other(_) => None,
        ControllerState::Init => Some("the controller is starting up"),
        ControllerState::GuardStop => Some("a guard stop is active"),
        ControllerState::EmergencyStop => Some("the emergency stop is pressed"),
        ControllerState::EmergencyStopReset => Some("the emergency stop is not acknowledged"),
        ControllerState::SystemFailure => Some("the controller reports a system failure"),
    }
}

fn unless(stopped: &impl Fn() -> bool) -> Result<(), RobotError> {
    if stopped() {
        Err(RobotError::Stopped)
    } else {
        Ok(())
    }
}
