//! The control loop's reader and writer against the general codec, on messages of all kinds.

use egm::messages::*;
use egm::wire::ClockTime;
use egm::{
    ControllerTime, Correction, Error, MAX_CORRECTION_BYTES, RobotFeedback, SequenceNumber, codec,
    encode_correction, read_feedback,
};
use motion::{JointAngles, JointVelocities};
use proptest::collection::vec;
use proptest::option::of;
use proptest::prelude::*;
use prost::Message;

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        -400.0..400.0,
        any::<f64>().prop_filter("finite", |x| x.is_finite())
    ]
}

fn joint_list() -> impl Strategy<Value = EgmJoints> {
    prop_oneof![4 => vec(number(), 6), 1 => vec(number(), 0..9)]
        .prop_map(|joints| EgmJoints { joints })
}

fn header() -> impl Strategy<Value = EgmHeader> {
    (of(any::<u32>()), of(any::<u32>()), of(-1..7i32)).prop_map(|(seqno, tm, mtype)| EgmHeader {
        seqno,
        tm,
        mtype,
    })
}

fn feed_back() -> impl Strategy<Value = EgmFeedBack> {
    (of(joint_list()), of(joint_list()), of(any::<(u64, u64)>())).prop_map(
        |(joints, external_joints, time)| EgmFeedBack {
            joints,
            external_joints,
            time: time.map(|(sec, usec)| EgmClock { sec, usec }),
            ..EgmFeedBack::default()
        },
    )
}

fn force() -> impl Strategy<Value = EgmMeasuredForce> {
    (of(any::<bool>()), vec(number(), 0..7), vec(number(), 0..7)).prop_map(
        |(fc_active, force_rw6, force)| EgmMeasuredForce {
            fc_active,
            force_rw6,
            force,
        },
    )
}

fn robot() -> impl Strategy<Value = EgmRobot> {
    let states = (of(-1..5i32), of(-1..5i32), of(-1..5i32), of(any::<bool>()));
    let rest = (
        of(force()),
        of(number()),
        of(any::<u32>()),
        of(any::<bool>()),
    );
    (of(header()), of(feed_back()), of(feed_back()), states, rest).prop_map(
        |(header, feed_back, planned, states, rest)| EgmRobot {
            header,
            feed_back,
            planned: planned.map(|like| EgmPlanned {
                joints: like.joints,
                external_joints: like.external_joints,
                time: like.time,
                ..EgmPlanned::default()
            }),
            motor_state: states.0.map(|state| EgmMotorState { state }),
            mci_state: states.1.map(|state| EgmMciState { state }),
            rapid_exec_state: states.2.map(|state| EgmRapidCtrlExecState { state }),
            mci_convergence_met: states.3,
            measured_force: rest.0,
            utilization_rate: rest.1,
            move_index: rest.2,
            collision_info: rest.3.map(|triggered| EgmCollisionInfo {
                collision_triggered: Some(triggered),
                coll_det_quota: vec![0.5; 6],
            }),
            ..EgmRobot::default()
        },
    )
}

/// Six joints, nothing for another number of them, an error for a value that is no number.
fn angles(joints: Option<&EgmJoints>, field: &'static str) -> Result<Option<JointAngles>, Error> {
    let Some(list) = joints.and_then(|list| <[f64; 6]>::try_from(&list.joints[..]).ok()) else {
        return Ok(None);
    };
    if list.iter().all(|value| value.is_finite()) {
        Ok(Some(JointAngles(list)))
    } else {
        Err(Error::NotFinite { field })
    }
}

/// What the control loop should see of a message, taken from the general decoder's result.
fn expected(robot: &EgmRobot) -> Result<RobotFeedback, Error> {
    let header = robot.header.unwrap_or_default();
    let feed_back = robot.feed_back.clone().unwrap_or_default();
    let planned = robot.planned.clone().unwrap_or_default();
    Ok(RobotFeedback {
        sequence: header.seqno.map(SequenceNumber),
        sent_at: header.tm.map(ControllerTime),
        message_type: header
            .mtype
            .map(|kind| kind.try_into().unwrap_or(MessageType::Undefined)),
        feedback: angles(feed_back.joints.as_ref(), "feedBack.joints")?,
        feedback_time: feed_back.time.map(|time| ClockTime {
            seconds: time.sec,
            microseconds: time.usec,
        }),
        planned: angles(planned.joints.as_ref(), "planned.joints")?,
        motor_state: robot
            .motor_state
            .map(|m| m.state.try_into().unwrap_or(MotorState::Undefined)),
        mci_state: robot
            .mci_state
            .map(|m| m.state.try_into().unwrap_or(MciState::Undefined)),
        mci_convergence_met: robot.mci_convergence_met,
        rapid_exec_state: robot
            .rapid_exec_state
            .map(|m| m.state.try_into().unwrap_or(RapidExecState::Undefined)),
        utilization_rate: robot.utilization_rate.filter(|rate| rate.is_finite()),
        move_index: robot.move_index,
        collision_triggered: robot
            .collision_info
            .as_ref()
            .and_then(|info| info.collision_triggered),
    })
}

proptest! {
    #[test]
    fn both_readers_see_the_same(message in robot()) {
        let mut datagram = Vec::new();
        codec::encode_robot(&message, &mut datagram).unwrap();
        prop_assert_eq!(&codec::decode_robot(&datagram).unwrap(), &message);
        prop_assert_eq!(read_feedback(&datagram), expected(&message));
    }

    /// Protobuf says that two encodings one after the other are one message, merged.
    #[test]
    fn repeated_fields_are_merged_alike(first in robot(), second in robot()) {
        let mut datagram = first.encode_to_vec();
        datagram.extend(second.encode_to_vec());
        let merged = codec::decode_robot(&datagram).unwrap();
        prop_assert_eq!(read_feedback(&datagram), expected(&merged));
    }

    #[test]
    fn a_damaged_message_panics_no_reader_and_is_read_alike(
        message in robot(),
        damage in vec((any::<prop::sample::Index>(), any::<u8>()), 1..4),
        cut in any::<prop::sample::Index>(),
    ) {
        let mut datagram = message.encode_to_vec();
        if !datagram.is_empty() {
            for (index, value) in damage {
                let at = index.index(datagram.len());
                datagram[at] = value;
            }
            datagram.truncate(cut.index(datagram.len()) + 1);
        }
        let read = read_feedback(&datagram);
        if let Ok(decoded) = codec::decode_robot(&datagram) {
            prop_assert_eq!(read, expected(&decoded));
        }
    }

    #[test]
    fn arbitrary_bytes_panic_no_reader(bytes in vec(any::<u8>(), 0..200)) {
        let read = read_feedback(&bytes);
        if let Ok(decoded) = codec::decode_robot(&bytes) {
            prop_assert_eq!(read, expected(&decoded));
        }
        codec::decode_sensor(&bytes).ok();
    }

    #[test]
    fn the_writer_makes_the_same_bytes_as_the_general_encoder(
        seqno in any::<u32>(),
        tm in any::<u32>(),
        joints in prop::array::uniform6(number()),
        speeds in prop::array::uniform6(number()),
    ) {
        let correction = Correction {
            sequence: SequenceNumber(seqno),
            sent_at: ControllerTime(tm),
            joints: JointAngles(joints),
            velocities: JointVelocities(speeds),
        };
        let mut buffer = [0u8; MAX_CORRECTION_BYTES];
        let length = encode_correction(&correction, &mut buffer).unwrap();
        let list = |values: [f64; 6]| Some(EgmJoints { joints: values.to_vec() });
        let message = EgmSensor {
            header: Some(EgmHeader {
                seqno: Some(seqno),
                tm: Some(tm),
                mtype: Some(MessageType::Correction as i32),
            }),
            planned: Some(EgmPlanned { joints: list(joints), ..EgmPlanned::default() }),
            speed_ref: Some(EgmSpeedRef { joints: list(speeds), ..EgmSpeedRef::default() }),
            ..EgmSensor::default()
        };
        let mut general = Vec::new();
        codec::encode_sensor(&message, &mut general).unwrap();
        prop_assert_eq!(&buffer[..length], &general[..]);
        prop_assert_eq!(codec::decode_sensor(&buffer[..length]).unwrap(), message);
    }

    #[test]
    fn the_writer_refuses_what_is_no_number(
        joint in 0..6usize,
        bad in prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(f64::NEG_INFINITY)],
        in_speeds in any::<bool>(),
    ) {
        let mut joints = [0.0; 6];
        let mut speeds = [0.0; 6];
        let field = if in_speeds {
            speeds[joint] = bad;
            "speedRef.joints"
        } else {
            joints[joint] = bad;
            "planned.joints"
        };
        let correction = Correction {
            sequence: SequenceNumber(0),
            sent_at: ControllerTime(0),
            joints: JointAngles(joints),
            velocities: JointVelocities(speeds),
        };
        let mut buffer = [0u8; MAX_CORRECTION_BYTES];
        prop_assert_eq!(
            encode_correction(&correction, &mut buffer),
            Err(Error::NotFinite { field })
        );
    }
}

#[test]
fn a_buffer_that_is_too_small_is_an_error() {
    let correction = Correction {
        sequence: SequenceNumber(1),
        sent_at: ControllerTime(4),
        joints: JointAngles([0.0; 6]),
        velocities: JointVelocities([0.0; 6]),
    };
    let mut buffer = [0u8; MAX_CORRECTION_BYTES - 1];
    assert_eq!(
        encode_correction(&correction, &mut buffer),
        Err(Error::BufferTooSmall {
            needed: MAX_CORRECTION_BYTES,
            given: MAX_CORRECTION_BYTES - 1
        })
    );
}
