//! From what the control thread saw to what a person is told about the end of a run.

use crate::control_loop::LoopEnd;
use crate::error::Fault;
use crate::player::PlayerEnd;
use crate::procedures;
use crate::run::RunEnd;
use egm::session::{Beginning, Hold};
use rws::ControllerState;

/// The end of a run. `controller` is the controller's own state right after it, if it answered.
pub(crate) fn run_end(end: LoopEnd, controller: Option<&ControllerState>) -> RunEnd {
    let fault = match end {
        LoopEnd::Player(PlayerEnd::Completed) => return RunEnd::Completed,
        LoopEnd::Player(PlayerEnd::Stopped) => return RunEnd::Stopped,
        LoopEnd::Player(PlayerEnd::NotFollowing { joint, error_deg }) => Fault::new(
            "tracking_error",
            format!(
                "joint {} did not follow: it is {error_deg:.1}° from where it should be",
                joint + 1
            ),
            "Check that nothing is in the arm's way and that the tool's load is set.",
        ),
        LoopEnd::Player(PlayerEnd::NotSettled { joint, error_deg }) => Fault::new(
            "not_settled",
            format!(
                "joint {} did not arrive: it stands {error_deg:.2}° from the end of the motion",
                joint + 1
            ),
            "Check that nothing is in the arm's way and that the tool's load is set.",
        ),
        LoopEnd::NotAtStart { distance_deg } => Fault::new(
            "arm_moved",
            format!("the arm stands {distance_deg:.1}° away from where the motion begins"),
            "Preview the motion again from where the arm stands now.",
        ),
        LoopEnd::Silence | LoopEnd::SessionBegan(Beginning::Silence) => lost(),
        LoopEnd::SessionBegan(_) => Fault::new(
            "egm_restarted",
            "the robot began a new control session in the middle of the motion",
            "Check the robot program on the FlexPendant, and that only one robot sends to this server.",
        ),
        LoopEnd::NotApplied {
            mci_error,
            motors_on,
        } => controller_stopped(controller, mci_error, motors_on),
        LoopEnd::Held(hold) => held(hold),
        LoopEnd::Panicked => Fault::new(
            "egm_refused",
            "the control loop failed and held the arm",
            "Try again. If it happens again, report it with the server's log.",
        ),
        LoopEnd::Disarmed => Fault::new(
            "egm_disarmed",
            "the motion was broken off by the server",
            "Try again.",
        ),
    };
    RunEnd::Failed(fault)
}

fn held(hold: Hold) -> Fault {
    let cable = "Check the network cable between the server and the controller.";
    match hold {
        Hold::Gap => Fault::new(
            "egm_gap",
            "several control messages of the robot were lost in the middle of the motion",
            cable,
        ),
        Hold::OutOfOrder => Fault::new(
            "egm_out_of_order",
            "the robot's control messages arrived in the wrong order",
            "Connect the server to the controller by a cable of its own.",
        ),
        Hold::Moved => Fault::new(
            "egm_moved",
            "the robot's control messages came from another address in the middle of the motion",
            "Check the network between the server and the controller, and that nothing restarts the robot program.",
        ),
        Hold::Stranger => Fault::new(
            "egm_stranger",
            "a second robot sends control messages to the same port",
            "Give each robot an EGM port of its own and check the controllers' settings.",
        ),
        Hold::Implausible => Fault::new(
            "pose_implausible",
            "the robot reported a pose that the arm cannot have reached",
            "Do not move the arm. Check the messages on the FlexPendant.",
        ),
        Hold::Incomplete => Fault::new(
            "egm_incomplete",
            "the robot's control messages lack the arm's pose or its states",
            "Check the messages on the FlexPendant.",
        ),
        Hold::NotArmed | Hold::NoSetpoint | Hold::NotApplied | Hold::NotFinite | Hold::Jump => {
            Fault::new(
                "egm_refused",
                "the control loop held the arm because a setpoint was not plausible",
                "Try again. If it happens again, report it with the server's log.",
            )
        }
    }
}

/// No messages any more.
pub(crate) fn lost() -> Fault {
    Fault::new(
        "egm_lost",
        "the robot's control messages stopped in the middle of the motion",
        "Check the network cable between the server and the controller.",
    )
}

/// The program runs, but the controller never asked for references.
pub(crate) fn no_session() -> Fault {
    Fault::new(
        "egm_no_session",
        "the robot program runs, but no control messages arrive",
        "Check that the robot program starts EGM and that the controller sends to this server's address and EGM port.",
    )
}

/// The controller does not let the arm move; `None` when it does.
pub(crate) fn stopped_by(controller: &ControllerState) -> Option<Fault> {
    let code = match controller {
        ControllerState::MotorsOn | ControllerState::Other(_) => return None,
        ControllerState::MotorsOff => {
            return Some(Fault::new(
                "motors_off",
                "the motors were switched off in the middle of the motion",
                "Find out who switched them off and why, then start again.",
            ));
        }
        ControllerState::GuardStop => "guard_stop",
        ControllerState::EmergencyStop | ControllerState::EmergencyStopReset => "emergency_stop",
        ControllerState::Init | ControllerState::SystemFailure => "controller_failure",
    };
    let reason = procedures::not_ready(controller).unwrap_or("the controller stopped the arm");
    Some(Fault::new(
        code,
        format!("the motion was broken off: {reason}"),
        "Make sure that nobody is in danger, release the stop and acknowledge it on the controller.",
    ))
}

fn controller_stopped(
    controller: Option<&ControllerState>,
    mci_error: bool,
    motors_on: bool,
) -> Fault {
    match controller.and_then(stopped_by) {
        // With an error of EGM the controller switches the motors off; the error is the cause.
        Some(fault) if !(mci_error && fault.code == "motors_off") => fault,
        _ if mci_error => Fault::new(
            "egm_error",
            "the controller reported an error of its external guidance",
            "Read the message on the FlexPendant, acknowledge it and start again.",
        ),
        _ if !motors_on => Fault::new(
            "motors_off",
            "the motors were switched off in the middle of the motion",
            "Find out who switched them off and why, then start again.",
        ),
        _ => Fault::new(
            "program_stopped",
            "the robot program stopped in the middle of the motion",
            "Check the robot program on the FlexPendant.",
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn code(end: LoopEnd, controller: Option<ControllerState>) -> &'static str {
        match run_end(end, controller.as_ref()) {
            RunEnd::Failed(fault) => fault.code,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn the_controllers_own_reason_is_named_before_its_consequence() {
        let not_applied = |mci_error, motors_on| LoopEnd::NotApplied {
            mci_error,
            motors_on,
        };
        let guard = Some(ControllerState::GuardStop);
        assert_eq!(code(not_applied(true, false), guard), "guard_stop");
        let off = Some(ControllerState::MotorsOff);
        assert_eq!(code(not_applied(true, false), off.clone()), "egm_error");
        assert_eq!(code(not_applied(false, false), off), "motors_off");
        assert_eq!(code(not_applied(false, true), None), "program_stopped");
    }

    #[test]
    fn silence_is_named_the_same_however_it_is_noticed() {
        let began = LoopEnd::SessionBegan(Beginning::Silence);
        assert_eq!(code(began, None), code(LoopEnd::Silence, None));
    }
}
