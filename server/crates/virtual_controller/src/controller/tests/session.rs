//! What one EGM session does, message by message.

use super::*;

#[test]
fn a_program_start_opens_a_session_at_zero_and_a_stop_ends_it_at_rest() {
    let mut bench = Bench::running(EgmSettings::default());
    let first = bench.message(Bench::silent_cycle, |_| true);
    assert_eq!(first.sequence, Some(SequenceNumber(0)));
    assert_eq!(first.message_type, Some(egm::messages::MessageType::Data));
    assert_eq!(first.feedback, Some(bench.controller.config().home));
    assert_eq!(first.motor_state, Some(MotorState::MotorsOn));
    assert_eq!(first.mci_state, Some(MciState::Running));
    assert_eq!(first.rapid_exec_state, Some(RapidExecState::Running));

    let goal = beside_home(&bench, 5.0);
    for count in 1..400 {
        let feedback = bench.cycle(|_| Some(goal)).unwrap();
        assert_eq!(feedback.sequence, Some(SequenceNumber(count)));
    }
    assert!(bench.controller.measured().max_abs_difference(&goal) < 0.01);

    let farther = beside_home(&bench, 10.0);
    for _ in 0..50 {
        bench.cycle(|_| Some(farther));
    }
    bench.controller.stop_program();
    let feedback = bench.cycle(|_| Some(farther)).unwrap();
    assert_eq!(feedback.rapid_exec_state, Some(RapidExecState::Stopped));
    assert_eq!(feedback.mci_state, Some(MciState::Stopped));
    bench.until_silent();
    let rest = bench.controller.measured();
    assert!(
        rest.max_abs_difference(&farther) > 0.5,
        "it did not follow on"
    );
    bench.silent_cycle();
    assert_eq!(bench.controller.measured(), rest);
}

#[test]
fn a_message_has_all_that_robotware_7_sends_and_about_its_size() {
    let mut bench = Bench::running(EgmSettings::default());
    let now = WallTime {
        seconds: 1_700_000_000,
        microseconds: 123_456,
    };
    let message = (0..PATIENCE)
        .find_map(|_| {
            let outgoing = bench.controller.begin_cycle(now);
            bench.controller.end_cycle(None);
            outgoing
        })
        .unwrap()
        .message;
    let mut datagram = Vec::new();
    codec::encode_robot(&message, &mut datagram).unwrap();
    // A real GoFa's message has 598 bytes; the lengths of its counters and lists vary.
    assert!(
        datagram.len().abs_diff(598) < 16,
        "{} bytes",
        datagram.len()
    );
    let feed_back = message.feed_back.unwrap();
    let pose = feed_back.cartesian.unwrap();
    let (position, orientation) = (pose.pos.unwrap(), pose.orient.unwrap());
    let tool = motion::kinematics::tool0(&bench.controller.config().home);
    assert_eq!([position.x, position.y, position.z], tool.position.0);
    let length = [
        orientation.u0,
        orientation.u1,
        orientation.u2,
        orientation.u3,
    ]
    .iter()
    .map(|part| part * part)
    .sum::<f64>();
    assert!((length - 1.0).abs() < 1e-9);
    assert_eq!(feed_back.time.unwrap().sec, now.seconds);
    assert_eq!(
        message.planned.unwrap().joints.unwrap().joints.len(),
        JOINTS
    );
    assert!(message.utilization_rate.is_some() && message.move_index.is_some());
}

#[test]
fn a_reference_outside_the_range_is_an_error_and_the_motors_go_off() {
    let mut bench = Bench::running(EgmSettings::default());
    bench.message(Bench::holding_cycle, |_| true);
    let mut outside = bench.controller.config().home;
    outside.0[1] = 181.0;
    bench.cycle(|_| Some(outside));
    let feedback = bench.silent_cycle().unwrap();
    assert_eq!(feedback.mci_state, Some(MciState::Error));
    assert_eq!(feedback.motor_state, Some(MotorState::MotorsOff));
    assert_eq!(feedback.rapid_exec_state, Some(RapidExecState::Stopped));
    assert_eq!(feedback.feedback, Some(bench.controller.config().home));
    assert!(bench.has_event(50_453));
    bench.until_silent();
    assert_eq!(bench.controller.state(), ControllerState::MotorsOff);
}

#[test]
fn silence_is_an_error_after_the_timeout_and_the_arm_keeps_its_motors() {
    let mut bench = Bench::running(EgmSettings::default());
    bench.message(Bench::holding_cycle, |_| true);
    let mut cycles = 0;
    bench.message(
        |bench| {
            cycles += 1;
            bench.silent_cycle()
        },
        |feedback| feedback.mci_state == Some(MciState::Error),
    );
    let seconds = f64::from(cycles) * 0.004_032;
    assert!((seconds - 1.0).abs() < 0.02, "after {seconds} s");
    assert!(bench.has_event(41_822));
    assert_eq!(bench.controller.state(), ControllerState::MotorsOn);
    assert_eq!(bench.controller.program(), Program::Stopped);
}

#[test]
fn the_last_reference_is_kept_until_a_new_one_comes() {
    let mut bench = Bench::running(EgmSettings::default());
    bench.message(Bench::holding_cycle, |_| true);
    let goal = beside_home(&bench, 3.0);
    bench.cycle(|_| Some(goal));
    for _ in 0..200 {
        bench.silent_cycle();
    }
    assert!(bench.controller.measured().max_abs_difference(&goal) < 0.1);
}

#[test]
fn datagrams_that_are_no_guidance_are_not_followed() {
    let mut bench = Bench::running(EgmSettings::default());
    let home = bench.controller.config().home;
    bench.message(Bench::holding_cycle, |_| true);
    for datagram in [&b"\xff\xff\xff"[..], &[], &[0x0a, 2, 0x18, 2]] {
        bench.controller.begin_cycle(WallTime::default());
        bench.controller.end_cycle(Some(datagram));
    }
    assert_eq!(bench.controller.measured(), home);
    assert_eq!(bench.controller.program(), Program::Guiding);
}

/// The first message of a controller that sends those of `set`.
fn first_message(set: MessageSet) -> egm::messages::EgmRobot {
    let mut bench = Bench::running(EgmSettings {
        messages: set,
        ..EgmSettings::default()
    });
    let outgoing = (0..PATIENCE).find_map(|_| {
        let outgoing = bench.controller.begin_cycle(WallTime::default());
        bench.controller.end_cycle(None);
        outgoing
    });
    outgoing.unwrap().message
}

#[test]
fn an_older_robotware_leaves_out_what_came_later_and_has_its_own_layout_of_the_force() {
    for (set, knows_time) in [
        (MessageSet::RobotWare6, true),
        (MessageSet::EarlyRobotWare6, false),
    ] {
        let message = first_message(set);
        let mut datagram = Vec::new();
        codec::encode_robot(&message, &mut datagram).unwrap();
        // The old force: field 9 with 54 bytes, of which the first is a double as field 1.
        assert!(datagram.windows(3).any(|bytes| bytes == [0x4a, 54, 0x09]));
        let feedback = read_feedback(&datagram).unwrap();
        assert_eq!(feedback.feedback_time.is_some(), knows_time);
        assert_eq!(feedback.utilization_rate.is_some(), knows_time);
        assert_eq!(feedback.move_index, None);
        assert_eq!(feedback.collision_triggered, None);
        assert!(feedback.feedback.is_some() && feedback.planned.is_some());
        assert!(message.rapid_from_robot.is_none() && message.torque_ref.is_none());
    }
}

#[test]
fn every_part_of_a_robotware_7_message_of_another_program_is_in_ours() {
    let text = include_str!("../../../../egm/tests/data/rw7_egm_robot.hex").trim();
    let other: Vec<u8> = (0..text.len())
        .step_by(2)
        .map(|at| u8::from_str_radix(&text[at..at + 2], 16).unwrap())
        .collect();
    let other = codec::decode_robot(&other).unwrap();
    let ours = first_message(MessageSet::RobotWare7);
    // What an arm without external axes and a controller without the time option leave out.
    let parts = |message: &egm::messages::EgmRobot| {
        let feed_back = message.feed_back.clone().unwrap();
        let planned = message.planned.clone().unwrap();
        let pose = feed_back.cartesian.unwrap();
        let force = message.measured_force.clone().unwrap();
        [
            message.header.unwrap().seqno.is_some(),
            message.header.unwrap().tm.is_some(),
            feed_back.joints.is_some() && planned.joints.is_some(),
            pose.pos.is_some() && pose.orient.is_some() && pose.euler.is_some(),
            planned.cartesian.is_some(),
            feed_back.time.is_some() && planned.time.is_some(),
            message.motor_state.is_some() && message.mci_state.is_some(),
            message.rapid_exec_state.is_some() && message.mci_convergence_met.is_some(),
            message.test_signals.is_some(),
            force.fc_active.is_some() && force.force.len() == 6,
            message.utilization_rate.is_some() && message.move_index.is_some(),
            message.collision_info.is_some(),
            message.rapid_from_robot.is_some(),
            message.torque_ref.is_some(),
        ]
    };
    assert_eq!(parts(&other), [true; 14]);
    assert_eq!(parts(&ours), [true; 14]);
}
