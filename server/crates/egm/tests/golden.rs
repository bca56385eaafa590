//! A datagram made by another implementation, and variations of it.

use egm::messages::*;
use egm::wire::ClockTime;
use egm::{ControllerTime, Error, SequenceNumber, codec, read_feedback};
use motion::JointAngles;
use prost::Message;

const ONE_TO_SIX: [f64; 6] = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];

fn golden() -> Vec<u8> {
    let text = include_str!("data/rw7_egm_robot.hex").trim();
    (0..text.len())
        .step_by(2)
        .map(|at| u8::from_str_radix(&text[at..at + 2], 16).expect("the file is hexadecimal"))
        .collect()
}

fn joints(values: &[f64]) -> Option<EgmJoints> {
    Some(EgmJoints {
        joints: values.to_vec(),
    })
}

fn golden_message() -> EgmRobot {
    let pose = EgmPose {
        pos: Some(EgmCartesian {
            x: 1.0,
            y: 2.0,
            z: 3.0,
        }),
        orient: Some(EgmQuaternion {
            u0: 1.0,
            u1: 0.0,
            u2: 0.0,
            u3: 0.0,
        }),
        euler: Some(EgmEuler {
            x: 1.0,
            y: 2.0,
            z: 3.0,
        }),
    };
    let time = EgmClock { sec: 1, usec: 2 };
    let time_stamp = EgmTimestamp {
        sec: Some(3),
        nsec: Some(4),
    };
    EgmRobot {
        header: Some(EgmHeader {
            seqno: Some(7),
            tm: Some(28),
            mtype: Some(MessageType::Data as i32),
        }),
        feed_back: Some(EgmFeedBack {
            joints: joints(&ONE_TO_SIX),
            cartesian: Some(pose),
            external_joints: joints(&[0.0; 6]),
            time: Some(time),
            time_stamp: Some(time_stamp),
        }),
        planned: Some(EgmPlanned {
            joints: joints(&ONE_TO_SIX),
            cartesian: Some(pose),
            external_joints: joints(&[0.0; 6]),
            time: Some(time),
            time_stamp: Some(time_stamp),
        }),
        motor_state: Some(EgmMotorState {
            state: MotorState::MotorsOn as i32,
        }),
        mci_state: Some(EgmMciState {
            state: MciState::Running as i32,
        }),
        mci_convergence_met: Some(false),
        test_signals: Some(EgmTestSignals {
            signals: vec![0.0; 6],
        }),
        rapid_exec_state: Some(EgmRapidCtrlExecState {
            state: RapidExecState::Running as i32,
        }),
        measured_force: Some(EgmMeasuredForce {
            fc_active: Some(true),
            force_rw6: vec![],
            force: ONE_TO_SIX.to_vec(),
        }),
        utilization_rate: Some(12.5),
        move_index: Some(3),
        collision_info: Some(EgmCollisionInfo {
            collision_triggered: Some(false),
            coll_det_quota: vec![0.1; 6],
        }),
        rapid_from_robot: Some(EgmRapidData {
            dig_val: Some(true),
            dnum: vec![1.5, 2.5],
        }),
        torque_ref: joints(&[0.0; 6]),
    }
}

#[test]
fn every_field_of_the_golden_datagram_is_read() {
    assert_eq!(codec::decode_robot(&golden()).unwrap(), golden_message());
}

#[test]
fn the_golden_message_encodes_to_the_golden_bytes() {
    let mut bytes = Vec::new();
    codec::encode_robot(&golden_message(), &mut bytes).unwrap();
    assert_eq!(bytes, golden());
}

#[test]
fn the_control_loops_reader_finds_its_fields_in_the_golden_datagram() {
    let feedback = read_feedback(&golden()).unwrap();
    assert_eq!(feedback.sequence, Some(SequenceNumber(7)));
    assert_eq!(feedback.sent_at, Some(ControllerTime(28)));
    assert_eq!(feedback.message_type, Some(MessageType::Data));
    assert_eq!(feedback.feedback, Some(JointAngles(ONE_TO_SIX)));
    assert_eq!(feedback.planned, Some(JointAngles(ONE_TO_SIX)));
    let time = ClockTime {
        seconds: 1,
        microseconds: 2,
    };
    assert_eq!(feedback.feedback_time, Some(time));
    assert_eq!(feedback.motor_state, Some(MotorState::MotorsOn));
    assert_eq!(feedback.mci_state, Some(MciState::Running));
    assert_eq!(feedback.mci_convergence_met, Some(false));
    assert_eq!(feedback.rapid_exec_state, Some(RapidExecState::Running));
    assert_eq!(feedback.utilization_rate, Some(12.5));
    assert_eq!(feedback.move_index, Some(3));
    assert_eq!(feedback.collision_triggered, Some(false));
}

#[test]
fn unknown_fields_do_no_harm() {
    let mut datagram = golden();
    // Field 2000 as a number, 2001 as text, 2002 as a double, 2003 as a group with one number.
    datagram.extend([0x80, 0x7d, 0x2a]);
    datagram.extend([0x8a, 0x7d, 3, b'a', b'b', b'c']);
    datagram.extend([0x91, 0x7d, 1, 2, 3, 4, 5, 6, 7, 8]);
    datagram.extend([0x9b, 0x7d, 0x08, 0x05, 0x9c, 0x7d]);
    assert_eq!(codec::decode_robot(&datagram).unwrap(), golden_message());
    assert_eq!(read_feedback(&datagram), read_feedback(&golden()));
}

#[test]
fn the_force_of_robotware_6_is_read_packed_and_unpacked() {
    let mut unpacked = Vec::new();
    let mut packed = vec![0x0a, 48];
    for value in ONE_TO_SIX {
        unpacked.push(0x09);
        unpacked.extend(value.to_le_bytes());
        packed.extend(value.to_le_bytes());
    }
    for force in [unpacked, packed] {
        let mut datagram = vec![0x4a, force.len() as u8];
        datagram.extend(force);
        let message = codec::decode_robot(&datagram).unwrap();
        let force = message.measured_force.unwrap();
        assert_eq!(force.values(), ONE_TO_SIX);
        assert_eq!(force.fc_active, None);
    }
}

#[test]
fn packed_joints_are_read_too() {
    let mut list = vec![0x0a, 48];
    for value in ONE_TO_SIX {
        list.extend(value.to_le_bytes());
    }
    let mut datagram = vec![0x12, 52, 0x0a, 50];
    datagram.extend(list);
    let feedback = read_feedback(&datagram).unwrap();
    assert_eq!(feedback.feedback, Some(JointAngles(ONE_TO_SIX)));
    let message = codec::decode_robot(&datagram).unwrap();
    assert_eq!(
        message.feed_back.unwrap().joints.unwrap().joints,
        ONE_TO_SIX
    );
}

#[test]
fn a_message_with_five_joints_has_no_angles() {
    let mut message = golden_message();
    message.feed_back.as_mut().unwrap().joints = joints(&ONE_TO_SIX[..5]);
    let feedback = read_feedback(&message.encode_to_vec()).unwrap();
    assert_eq!(feedback.feedback, None);
    assert_eq!(feedback.planned, Some(JointAngles(ONE_TO_SIX)));
}

#[test]
fn a_measured_angle_that_is_no_number_is_refused() {
    let mut message = golden_message();
    message.feed_back.as_mut().unwrap().joints = joints(&[0.0, 1.0, f64::NAN, 0.0, 0.0, 0.0]);
    assert_eq!(
        read_feedback(&message.encode_to_vec()),
        Err(Error::NotFinite {
            field: "feedBack.joints"
        })
    );
}

#[test]
fn a_cut_datagram_is_refused_by_both_readers_alike() {
    let whole = golden();
    for length in 0..whole.len() {
        let cut = &whole[..length];
        assert_eq!(
            read_feedback(cut).is_ok(),
            codec::decode_robot(cut).is_ok(),
            "after {length} bytes"
        );
    }
}

#[test]
fn an_outgoing_message_with_a_value_that_is_no_number_is_refused() {
    let mut bytes = vec![1, 2, 3];
    let mut robot = golden_message();
    robot.planned.as_mut().unwrap().joints = joints(&[f64::INFINITY; 6]);
    assert!(matches!(
        codec::encode_robot(&robot, &mut bytes),
        Err(Error::NotFinite {
            field: "planned.joints"
        })
    ));
    assert!(bytes.is_empty());
    let sensor = EgmSensor {
        speed_ref: Some(EgmSpeedRef {
            joints: joints(&[f64::NAN; 6]),
            ..EgmSpeedRef::default()
        }),
        ..EgmSensor::default()
    };
    assert!(matches!(
        codec::encode_sensor(&sensor, &mut bytes),
        Err(Error::NotFinite {
            field: "speedRef.joints"
        })
    ));
}
