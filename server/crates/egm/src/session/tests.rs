//! What a person would notice of the session rules: when the arm may move, and from where.

use super::*;
use crate::messages::MessageType;
use crate::wire::ClockTime;

const CYCLE_US: u64 = 4_032;
const HOME: JointAngles = JointAngles([0.0, 10.0, 20.0, 0.0, -45.0, 5.0]);

fn controller() -> SocketAddr {
    SocketAddr::from(([127, 0, 0, 1], 6599))
}

pub(super) fn config() -> SessionConfig {
    SessionConfig {
        timeout_us: 100_000,
        late_after_us: 10_000,
        max_lost: 25,
        max_advance_us: 16_000,
        brake_us: 1_500_000,
        max_speed_deg_s: [125.0, 125.0, 140.0, 200.0, 200.0, 200.0],
    }
}

/// A message of a controller that applies references.
fn running(sequence: u32) -> RobotFeedback {
    let microseconds = u64::from(sequence) * CYCLE_US;
    RobotFeedback {
        sequence: Some(SequenceNumber(sequence)),
        sent_at: Some(ControllerTime((microseconds / 1000) as u32)),
        message_type: Some(MessageType::Data),
        feedback: Some(HOME),
        feedback_time: Some(ClockTime {
            seconds: microseconds / 1_000_000,
            microseconds: microseconds % 1_000_000,
        }),
        planned: Some(HOME),
        motor_state: Some(MotorState::MotorsOn),
        mci_state: Some(MciState::Running),
        rapid_exec_state: Some(RapidExecState::Running),
        ..RobotFeedback::default()
    }
}

/// A session that has had its first message, and the time of the next.
fn begun() -> (Session, u64) {
    let mut session = Session::new(config());
    session
        .receive(&running(0), 1_000_000, controller())
        .unwrap();
    session.answer(None, ControllerTime(0)).unwrap();
    (session, 1_000_000 + CYCLE_US)
}

fn near_home(offset_deg: f64) -> Setpoint {
    Setpoint::at_rest(JointAngles(HOME.0.map(|angle| angle + offset_deg)))
}

#[test]
fn the_first_reference_is_the_measured_pose_at_rest() {
    let mut session = Session::new(config());
    let received = session.receive(&running(0), 5, controller()).unwrap();
    assert_eq!(received.began, Some(Beginning::First));
    let answer = session
        .answer(Some(&near_home(0.1)), ControllerTime(9))
        .unwrap();
    assert_eq!(answer.correction.joints, HOME);
    assert_eq!(answer.correction.velocities, JointVelocities::ZERO);
    assert_eq!(answer.correction.sequence, SequenceNumber(0));
    assert_eq!(answer.held, Some(Hold::NotArmed));
}

#[test]
fn setpoints_pass_once_armed_and_stop_when_disarmed() {
    let (mut session, at_us) = begun();
    assert!(session.arm());
    session.receive(&running(1), at_us, controller()).unwrap();
    let answer = session
        .answer(Some(&near_home(0.1)), ControllerTime(0))
        .unwrap();
    assert_eq!(answer.held, None);
    assert_eq!(answer.correction.joints, near_home(0.1).joints);
    session.disarm();
    session
        .receive(&running(2), at_us + CYCLE_US, controller())
        .unwrap();
    let answer = session
        .answer(Some(&near_home(0.2)), ControllerTime(0))
        .unwrap();
    assert_eq!(answer.held, Some(Hold::NotArmed));
    assert_eq!(answer.correction.joints, near_home(0.1).joints);
}

fn stranger() -> SocketAddr {
    SocketAddr::from(([127, 0, 0, 1], 7000))
}

/// A session at message 5.
fn at_five(armed: bool) -> Session {
    let mut session = Session::new(config());
    session.receive(&running(5), 0, controller()).unwrap();
    assert!(!armed || session.arm());
    session
        .answer(Some(&near_home(0.0)), ControllerTime(0))
        .unwrap();
    session
}

#[test]
fn a_beginning_starts_from_the_measured_pose() {
    let cases = [
        (0, CYCLE_US, controller(), Beginning::Restarted, true),
        (6, 200_000, controller(), Beginning::Silence, true),
        (6, 200_000, stranger(), Beginning::SourceChanged, true),
        (4, CYCLE_US, controller(), Beginning::WentBack, false),
        (
            500,
            CYCLE_US,
            controller(),
            Beginning::SequenceJumped,
            false,
        ),
        (6, CYCLE_US, stranger(), Beginning::SourceChanged, false),
    ];
    for (sequence, wait_us, source, beginning, armed) in cases {
        let mut session = at_five(armed);
        let received = session
            .receive(&running(sequence), wait_us, source)
            .unwrap();
        assert_eq!(received.began, Some(beginning));
        assert!(!session.is_armed(), "{beginning:?}");
        let answer = session
            .answer(Some(&near_home(0.1)), ControllerTime(0))
            .unwrap();
        assert_eq!(answer.correction.joints, HOME, "{beginning:?}");
        assert!(answer.held.is_some());
    }
}

#[test]
fn what_is_odd_about_an_armed_session_lets_the_arm_come_to_rest_and_no_further() {
    let blind = RobotFeedback {
        feedback: None,
        ..running(6)
    };
    let stateless = RobotFeedback {
        mci_state: None,
        ..running(6)
    };
    let elsewhere = RobotFeedback {
        feedback: Some(near_home(40.0).joints),
        ..running(6)
    };
    let cases = [
        (running(4), Hold::OutOfOrder),
        (running(500), Hold::Gap),
        (blind, Hold::Incomplete),
        (stateless, Hold::Incomplete),
        (elsewhere, Hold::Implausible),
        (running(5), Hold::OutOfOrder),
    ];
    for (odd, hold) in cases {
        let mut session = at_five(true);
        let received = session.receive(&odd, CYCLE_US, controller()).unwrap();
        assert_eq!((received.began, received.hold), (None, Some(hold)));
        assert_eq!(received.measured, HOME, "{hold:?}");
        assert!(received.brakes && received.may_be_commanded, "{hold:?}");
        assert!(!session.is_armed());
        // A message that is older than the one before takes no time.
        let way_deg = if odd == running(4) { 0.0 } else { 0.01 };
        let braked = near_home(way_deg);
        let answer = session.answer(Some(&braked), ControllerTime(0)).unwrap();
        assert_eq!(
            (answer.correction.joints, answer.held),
            (braked.joints, None)
        );
        // The time to brake is over while the messages go on.
        let mut at_us = CYCLE_US;
        let mut sequence = 500;
        while at_us < 2 * config().brake_us {
            at_us += CYCLE_US;
            sequence += 1;
            session
                .receive(&running(sequence), at_us, controller())
                .unwrap();
            session.answer(None, ControllerTime(0)).unwrap();
        }
        let answer = session
            .answer(Some(&near_home(0.1)), ControllerTime(0))
            .unwrap();
        assert!(answer.held.is_some(), "{hold:?}");
    }
}

#[test]
fn another_robot_at_the_same_port_is_told_its_own_pose_and_stops_the_motion() {
    let mut session = at_five(true);
    let other = RobotFeedback {
        feedback: Some(near_home(30.0).joints),
        ..running(77)
    };
    for sequence in 0..2 {
        let received = session.receive(&other, CYCLE_US, stranger()).unwrap();
        assert_eq!(received.hold, Some(Hold::Stranger));
        assert!(session.is_visited());
        let answer = session
            .answer(Some(&near_home(0.1)), ControllerTime(0))
            .unwrap();
        assert_eq!(answer.correction.joints, near_home(30.0).joints);
        assert_eq!(answer.correction.velocities, JointVelocities::ZERO);
        assert_eq!(answer.correction.sequence, SequenceNumber(sequence));
        assert_eq!(answer.held, Some(Hold::Stranger));
    }
    assert!(!session.is_armed());
    // The arm that moves is still led to rest.
    let received = session
        .receive(&running(6), 2 * CYCLE_US, controller())
        .unwrap();
    assert_eq!((received.began, received.brakes), (None, true));
    assert!(!session.is_visited());
    let braked = near_home(0.01);
    let answer = session.answer(Some(&braked), ControllerTime(0)).unwrap();
    assert_eq!(answer.correction.joints, braked.joints);
}

#[test]
fn an_arm_whose_messages_go_on_from_another_port_is_led_to_rest() {
    let mut session = at_five(true);
    let received = session.receive(&running(6), CYCLE_US, stranger()).unwrap();
    assert_eq!((received.began, received.hold), (None, Some(Hold::Moved)));
    let braked = near_home(0.01);
    let answer = session.answer(Some(&braked), ControllerTime(0)).unwrap();
    assert_eq!(answer.correction.joints, braked.joints);
    let received = session
        .receive(&running(7), 2 * CYCLE_US, stranger())
        .unwrap();
    assert_eq!((received.hold, received.brakes), (None, true));
    assert!(!session.is_armed());
}

#[test]
fn time_that_does_not_fit_the_number_of_messages_is_not_believed() {
    let mut session = at_five(false);
    let mut jumped = running(6);
    jumped.feedback_time = Some(ClockTime {
        seconds: 0,
        microseconds: 5 * CYCLE_US + 36_000,
    });
    session.receive(&jumped, 40_000, controller()).unwrap();
    assert!((4_000..=4_100).contains(&session.pending_us()));
}

#[test]
fn a_lost_a_repeated_and_a_late_message_are_counted_and_do_no_harm() {
    let (mut session, at_us) = begun();
    assert!(session.arm());
    session.receive(&running(3), at_us, controller()).unwrap();
    session
        .receive(&running(3), at_us + 1, controller())
        .unwrap();
    session
        .receive(&running(4), at_us + 50_000, controller())
        .unwrap();
    let counters = session.counters();
    assert_eq!((counters.lost, counters.repeated, counters.late), (2, 1, 1));
    assert!(session.is_armed());
}

#[test]
fn the_counter_may_wrap_but_a_restart_is_still_seen() {
    let mut session = Session::new(config());
    session
        .receive(&running(u32::MAX), 0, controller())
        .unwrap();
    assert!(session.arm());
    let received = session
        .receive(&running(0), CYCLE_US, controller())
        .unwrap();
    assert_eq!(received.began, None);
    assert!(session.is_armed());
    let received = session
        .receive(&running(0), 2 * CYCLE_US, controller())
        .unwrap();
    assert_eq!(received.began, Some(Beginning::Restarted));
}

#[test]
fn commands_need_motors_program_and_guidance() {
    type Change = fn(&mut RobotFeedback);
    let cases: [(Change, bool); 6] = [
        (|_| (), true),
        (
            |robot| robot.rapid_exec_state = Some(RapidExecState::Undefined),
            true,
        ),
        (
            |robot| robot.rapid_exec_state = Some(RapidExecState::Stopped),
            false,
        ),
        (
            |robot| robot.motor_state = Some(MotorState::MotorsOff),
            false,
        ),
        (|robot| robot.mci_state = Some(MciState::Stopped), false),
        (|robot| robot.mci_state = Some(MciState::Error), false),
    ];
    for (change, allowed) in cases {
        let (mut session, at_us) = begun();
        assert!(session.arm());
        let mut robot = running(1);
        change(&mut robot);
        let received = session.receive(&robot, at_us, controller()).unwrap();
        assert_eq!(received.may_be_commanded, allowed, "{robot:?}");
        assert_eq!(session.is_armed(), allowed, "{robot:?}");
        assert_eq!(session.arm(), allowed, "{robot:?}");
    }
}

#[test]
fn while_nothing_is_applied_the_reference_follows_the_hand() {
    let (mut session, at_us) = begun();
    let mut streaming = running(1);
    streaming.mci_state = Some(MciState::Stopped);
    streaming.feedback = Some(near_home(30.0).joints);
    session.receive(&streaming, at_us, controller()).unwrap();
    let answer = session.answer(None, ControllerTime(0)).unwrap();
    assert_eq!(answer.correction.joints, near_home(30.0).joints);
    assert_eq!(answer.held, Some(Hold::NotApplied));
}

#[test]
fn a_setpoint_that_jumps_or_is_no_number_is_refused_and_disarms() {
    let nan = Setpoint::at_rest(JointAngles([f64::NAN; 6]));
    for (wish, hold) in [(near_home(5.0), Hold::Jump), (nan, Hold::NotFinite)] {
        let (mut session, at_us) = begun();
        assert!(session.arm());
        session.receive(&running(1), at_us, controller()).unwrap();
        let answer = session.answer(Some(&wish), ControllerTime(0)).unwrap();
        assert_eq!(answer.held, Some(hold));
        assert_eq!(answer.correction.joints, HOME);
        assert!(!session.is_armed());
    }
}

#[test]
fn a_message_without_a_pose_begins_nothing_and_does_not_let_go_of_the_arm() {
    let blind = RobotFeedback {
        feedback: None,
        ..running(1)
    };
    let (mut session, at_us) = begun();
    session.receive(&blind, at_us, controller()).unwrap();
    let answer = session
        .answer(Some(&near_home(0.1)), ControllerTime(0))
        .unwrap();
    assert_eq!(answer.held, Some(Hold::Incomplete));
    assert_eq!(answer.correction.joints, HOME);

    let mut session = Session::new(config());
    assert_eq!(session.receive(&blind, at_us, controller()), None);
    assert_eq!(session.answer(None, ControllerTime(0)), None);
}

#[test]
fn rubbish_from_elsewhere_does_not_disturb_the_session() {
    let (mut session, at_us) = begun();
    assert!(session.arm());
    assert_eq!(
        session.receive(&RobotFeedback::default(), at_us, stranger()),
        None
    );
    assert!(session.is_armed());
    let received = session.receive(&running(1), at_us, controller()).unwrap();
    assert_eq!(received.began, None);
}

#[test]
fn time_goes_by_the_controllers_clock_and_is_made_up_for_in_bounded_pieces() {
    let (mut session, at_us) = begun();
    // Both come a little late and together.
    session
        .receive(&running(1), at_us + 9_000, controller())
        .unwrap();
    assert_eq!(session.pending_us(), CYCLE_US);
    session
        .receive(&running(2), at_us + 9_001, controller())
        .unwrap();
    assert_eq!(session.pending_us(), 2 * CYCLE_US);
    session.answer(None, ControllerTime(0)).unwrap();
    assert_eq!(session.pending_us(), 0);
    // Twenty messages were lost: the time they would have taken is not made up for.
    session
        .receive(&running(23), at_us + 90_000, controller())
        .unwrap();
    assert_eq!(session.pending_us(), config().max_advance_us);
}

#[test]
fn a_controller_clock_that_races_does_not_speed_the_motion_up() {
    let (mut session, mut at_us) = begun();
    let mut total_us = 0;
    for sequence in 1..=1000_u32 {
        let mut racing = running(sequence);
        let microseconds = u64::from(sequence) * 3 * CYCLE_US;
        racing.feedback_time = Some(ClockTime {
            seconds: microseconds / 1_000_000,
            microseconds: microseconds % 1_000_000,
        });
        session.receive(&racing, at_us, controller()).unwrap();
        total_us += session.pending_us();
        session.answer(None, ControllerTime(0)).unwrap();
        at_us += CYCLE_US;
    }
    assert!(total_us <= 1000 * CYCLE_US + 50_000, "{total_us}");
}
