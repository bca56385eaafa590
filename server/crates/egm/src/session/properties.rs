//! Whatever comes down the line and whatever setpoints are wished for, no answer is NaN and no
//! answer jumps.

use super::tests::config;
use super::*;
use crate::messages::MessageType;
use proptest::prelude::*;

/// One step of an arbitrary history.
#[derive(Debug, Clone)]
struct Step {
    sequence_step: i64,
    wait_us: u64,
    port: u16,
    feedback: Option<[f64; 6]>,
    time_ms: u32,
    motors: Option<MotorState>,
    mci: Option<MciState>,
    rapid: Option<RapidExecState>,
    arm: bool,
    wish: Option<([f64; 6], [f64; 6])>,
    answered: bool,
}

fn angle() -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => -1.0..1.0_f64,
        2 => -180.0..180.0_f64,
        1 => Just(f64::NAN),
        1 => Just(f64::INFINITY),
    ]
}

fn step() -> impl Strategy<Value = Step> {
    let line = (
        prop_oneof![12 => Just(1_i64), 1 => -3..40_i64, 1 => any::<i64>()],
        prop_oneof![12 => 3_000..6_000_u64, 1 => 0..300_000_u64],
        prop_oneof![20 => Just(1_u16), 1 => Just(2_u16)],
        proptest::option::weighted(0.95, proptest::array::uniform6(-1.0..1.0_f64)),
        prop_oneof![12 => 4..5_u32, 1 => any::<u32>()],
    );
    let states = (
        prop_oneof![15 => Just(Some(MotorState::MotorsOn)), 1 => Just(Some(MotorState::MotorsOff)), 1 => Just(None)],
        prop_oneof![15 => Just(Some(MciState::Running)), 1 => Just(Some(MciState::Error)), 1 => Just(Some(MciState::Stopped))],
        prop_oneof![15 => Just(Some(RapidExecState::Running)), 1 => Just(Some(RapidExecState::Stopped))],
    );
    let ours = (
        any::<bool>(),
        proptest::option::weighted(
            0.9,
            (
                proptest::array::uniform6(angle()),
                proptest::array::uniform6(angle()),
            ),
        ),
        prop_oneof![9 => Just(true), 1 => Just(false)],
    );
    (line, states, ours).prop_map(|(line, states, ours)| Step {
        sequence_step: line.0,
        wait_us: line.1,
        port: line.2,
        feedback: line.3,
        time_ms: line.4,
        motors: states.0,
        mci: states.1,
        rapid: states.2,
        arm: ours.0,
        wish: ours.1,
        answered: ours.2,
    })
}

proptest! {
    #[test]
    fn references_are_finite_and_never_jump(
        first in any::<u32>(),
        steps in proptest::collection::vec(step(), 1..200),
    ) {
        let config = config();
        let mut session = Session::new(config.clone());
        let mut sequence = first;
        let mut sent_at = ControllerTime(0);
        let mut now_us = 0_u64;
        // The last answer that the controller may have applied, while it may still apply it.
        let mut previous: Option<JointAngles> = None;
        for step in steps {
            sequence = sequence.wrapping_add(step.sequence_step as u32);
            now_us += step.wait_us;
            sent_at = sent_at.plus_ms(step.time_ms);
            let robot = RobotFeedback {
                sequence: Some(SequenceNumber(sequence)),
                sent_at: Some(sent_at),
                message_type: Some(MessageType::Data),
                feedback: step.feedback.map(JointAngles),
                motor_state: step.motors,
                mci_state: step.mci,
                rapid_exec_state: step.rapid,
                ..RobotFeedback::default()
            };
            let source = SocketAddr::from(([127, 0, 0, 1], step.port));
            let received = session.receive(&robot, now_us, source);
            if received.is_none() {
                continue;
            }
            if session.is_visited() {
                // Someone else is told its own pose; the session's arm is not concerned.
                let answer = session.answer(None, ControllerTime(0)).expect("an answer");
                prop_assert_eq!(Some(answer.correction.joints.0), step.feedback);
                prop_assert_eq!(answer.correction.velocities, JointVelocities::ZERO);
                continue;
            }
            let steady = received.is_some_and(|received| {
                received.began.is_none() && received.may_be_commanded
            });
            if !steady {
                previous = None;
            }
            if step.arm {
                let _ = session.arm();
            }
            if !step.answered {
                continue;
            }
            let elapsed_s = session.pending_us() as f64 * 1e-6;
            prop_assert!(elapsed_s <= config.max_advance_us as f64 * 1e-6);
            let wish = step.wish.map(|(joints, velocities)| Setpoint {
                joints: JointAngles(joints),
                velocities: JointVelocities(velocities),
            });
            let answer = session.answer(wish.as_ref(), ControllerTime(0));
            let answer = answer.expect("a message of the session is always answered");
            let correction = answer.correction;
            prop_assert!(correction.joints.is_finite());
            prop_assert!(correction.velocities.is_finite());
            let speeds = correction.velocities.0.iter().zip(&config.max_speed_deg_s);
            for (speed, max) in speeds {
                prop_assert!(speed.abs() <= max * 1.05);
            }
            if let Some(previous) = previous {
                for joint in 0..6 {
                    let moved = (correction.joints.0[joint] - previous.0[joint]).abs();
                    let allowed =
                        config.largest_step_deg(config.max_speed_deg_s[joint], elapsed_s);
                    prop_assert!(moved <= allowed, "joint {joint} moved {moved}");
                }
            } else if received.is_some_and(|received| received.hold.is_none() && !received.brakes)
                && !session.is_armed()
            {
                // A beginning, or nothing is applied: the reference is where the arm is.
                let measured = received.map(|received| received.measured);
                prop_assert!(answer.held.is_some());
                if received.is_some_and(|received| !received.may_be_commanded || received.began.is_some()) {
                    prop_assert_eq!(Some(correction.joints), measured);
                }
            }
            previous = Some(correction.joints).filter(|_| session_applies(received));
        }
    }
}

fn session_applies(received: Option<Received>) -> bool {
    received.is_some_and(|received| received.may_be_commanded)
}
