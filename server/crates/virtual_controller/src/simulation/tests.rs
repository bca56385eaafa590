//! A simulated controller and its server: the same arm as on sockets, faults included.

use std::f64::consts::TAU;

use egm::{Correction, MAX_CORRECTION_BYTES, SequenceNumber, encode_correction, read_feedback};
use motion::{JOINTS, JointVelocities};

use super::*;
use crate::faults::script::{Direction, Fault, ScriptedFault};

const CYCLE_US: u64 = 4_032;

fn started(script: FaultScript) -> SimulatedController {
    let config = Config::new(SocketAddr::from((Ipv4Addr::LOCALHOST, 6510)));
    let mut simulation = SimulatedController::new(config).unwrap();
    simulation.play(script).unwrap();
    simulation.start_program().unwrap();
    simulation
}

fn from_to(fault: Fault, direction: Direction, from_s: f64, for_s: f64) -> FaultScript {
    FaultScript {
        seed: 1,
        faults: vec![ScriptedFault {
            direction,
            from_s,
            for_s: Some(for_s),
            ..fault.into()
        }],
    }
}

/// An answer with this position of joint 1; the others stay at home.
fn answer(number: u32, home: JointAngles, joint_1_deg: f64, speed_deg_s: f64) -> Vec<u8> {
    let (mut joints, mut velocities) = (home, JointVelocities([0.0; JOINTS]));
    joints.0[0] = joint_1_deg;
    velocities.0[0] = speed_deg_s;
    let correction = Correction {
        sequence: SequenceNumber(number),
        sent_at: egm::ControllerTime(number),
        joints,
        velocities,
    };
    let mut buffer = [0; MAX_CORRECTION_BYTES];
    let length = encode_correction(&correction, &mut buffer).unwrap();
    buffer[..length].to_vec()
}

/// Messages of `cycles` cycles in which the server holds the arm at home.
fn held(simulation: &mut SimulatedController, cycles: usize) -> Vec<Datagram> {
    let home = simulation.controller().config().home;
    let mut messages = Vec::new();
    for number in 0..cycles as u32 {
        simulation.cycle(|message| {
            messages.push(message.clone());
            Some(answer(number, home, home.0[0], 0.0))
        });
    }
    messages
}

fn numbers(messages: &[Datagram]) -> Vec<u32> {
    messages
        .iter()
        .filter_map(|message| Some(read_feedback(&message.bytes).ok()?.sequence?.0))
        .collect()
}

/// Drives joint 1 through a sine for 6 s and returns how much later the arm goes through it, s.
fn sine_lag_s(with_speed: bool) -> f64 {
    let (hz, amplitude_deg) = (0.5, 5.0);
    let mut simulation = started(FaultScript::default());
    let home = simulation.controller().config().home;
    let mut began_us = None;
    let mut number = 0;
    let (mut sine, mut cosine) = (0.0, 0.0);
    for _ in 0..1500 {
        simulation.cycle(|message| {
            let began_us = *began_us.get_or_insert(message.at_us);
            let t_s = (message.at_us - began_us) as f64 * 1e-6;
            let phase = TAU * hz * t_s;
            // The phase of whole periods, after the beginning has died away.
            if (2.0..6.0).contains(&t_s) {
                let measured = read_feedback(&message.bytes).unwrap().feedback.unwrap();
                sine += (measured.0[0] - home.0[0]) * phase.sin();
                cosine += (measured.0[0] - home.0[0]) * phase.cos();
            }
            let speed = if with_speed {
                amplitude_deg * TAU * hz * phase.cos()
            } else {
                0.0
            };
            number += 1;
            let angle = home.0[0] + amplitude_deg * phase.sin();
            Some(answer(number, home, angle, speed))
        });
    }
    (-cosine).atan2(sine) / (TAU * hz)
}

#[test]
fn a_sine_lags_as_the_control_law_says_and_hardly_at_all_with_the_speed() {
    // A first-order lag with k = 5 1/s turns the phase by atan(2 pi f / k); the filter and the
    // servos add less than 20 ms.
    let expected_s = (TAU * 0.5 / 5.0).atan() / (TAU * 0.5);
    let lag_s = sine_lag_s(false);
    assert!((expected_s..expected_s + 0.020).contains(&lag_s), "{lag_s}");
    let lag_s = sine_lag_s(true);
    assert!((0.0..0.020).contains(&lag_s), "{lag_s}");
}

#[test]
fn without_faults_each_cycle_has_its_message() {
    let mut simulation = started(FaultScript::default());
    let messages = held(&mut simulation, 300);
    assert!(messages.len() > 250);
    let expected: Vec<u32> = (0..messages.len() as u32).collect();
    assert_eq!(numbers(&messages), expected);
    for pair in messages.windows(2) {
        assert_eq!(pair[1].at_us - pair[0].at_us, CYCLE_US);
        assert_eq!(pair[0].controller, pair[1].controller);
    }
}

#[test]
fn answers_are_taken_one_per_cycle_in_their_order() {
    let mut simulation = started(FaultScript::default());
    let home = simulation.controller().config().home;
    let last = held(&mut simulation, 100).pop().unwrap();
    let now_us = simulation.next_cycle_us();
    // Three answers at once: the last of them counts three cycles later.
    let answers = [1.0, 2.0, 3.0].map(|angle| Datagram {
        at_us: now_us,
        bytes: answer(1, home, home.0[0] + angle, 0.0),
        ..last.clone()
    });
    let mut targets = Vec::new();
    let mut incoming = answers.to_vec();
    for _ in 0..5 {
        let sent = simulation.step(simulation.next_cycle_us(), incoming.drain(..));
        targets.push(read_feedback(&sent[0].bytes).unwrap().move_index.unwrap());
    }
    let steps: Vec<u32> = targets.iter().map(|target| target - targets[0]).collect();
    assert_eq!(steps, [0, 1, 2, 3, 3]);
}

#[test]
fn a_counter_that_begins_anew_comes_from_another_port_and_the_arm_goes_on() {
    let script = from_to(Fault::CounterReset, Direction::Both, 0.2, 0.0);
    let mut simulation = started(script);
    let messages = held(&mut simulation, 200);
    let numbers = numbers(&messages);
    let reset = numbers.iter().rposition(|number| *number == 0).unwrap();
    assert_eq!(messages[reset].at_us - messages[0].at_us, 50 * CYCLE_US);
    assert_ne!(messages[reset].controller, messages[reset - 1].controller);
    assert_eq!(numbers[reset..reset + 3], [0, 1, 2]);
    let last = read_feedback(&messages.last().unwrap().bytes).unwrap();
    assert_eq!(last.mci_state, Some(egm::messages::MciState::Running));
}

#[test]
fn an_answer_to_a_closed_socket_is_gone() {
    let script = from_to(Fault::SourceChange, Direction::Both, 0.2, 0.0);
    let mut simulation = started(script);
    let home = simulation.controller().config().home;
    let first = held(&mut simulation, 60).remove(0);
    held(&mut simulation, 60);
    let far = Datagram {
        at_us: simulation.next_cycle_us(),
        bytes: answer(1, home, home.0[0] + 5.0, 0.0),
        ..first
    };
    simulation.step(simulation.next_cycle_us(), [far]);
    for _ in 0..20 {
        simulation.step(simulation.next_cycle_us(), []);
    }
    assert_eq!(simulation.measured(), home);
}

#[test]
fn lost_answers_are_an_error_after_the_timeout() {
    let script = from_to(Fault::Loss, Direction::ToRobot, 0.1, 5.0);
    let mut simulation = started(script);
    held(&mut simulation, 600);
    let codes = |simulation: &SimulatedController| -> Vec<u32> {
        let events = simulation.controller().events().newest_first(4);
        events.map(|event| event.code).collect()
    };
    assert_eq!(codes(&simulation), [41_822]);
}

#[test]
fn a_guard_that_opens_by_script_stops_the_arm_and_closes_again() {
    let script = from_to(Fault::GuardStop, Direction::Both, 0.1, 0.5);
    let mut simulation = started(script);
    held(&mut simulation, 60);
    let state = simulation.controller().state();
    assert_eq!(state, crate::controller::ControllerState::GuardStop);
    held(&mut simulation, 200);
    let state = simulation.controller().state();
    assert_eq!(state, crate::controller::ControllerState::MotorsOff);
}

#[test]
fn a_restarted_controller_forgets_its_session_and_counts_anew() {
    let script = from_to(Fault::ControllerRestart, Direction::Both, 0.1, 0.0);
    let mut simulation = started(script);
    let before = held(&mut simulation, 100);
    assert!(before.len() < 40, "it is silent after the restart");
    simulation.start_program().unwrap();
    let after = held(&mut simulation, 100);
    assert_eq!(numbers(&after)[0], 0);
    assert_ne!(after[0].controller, before[0].controller);
    let first = read_feedback(&after[0].bytes).unwrap();
    assert!(first.sent_at.unwrap().0 < 1000);
}

#[test]
fn a_late_cycle_does_not_make_the_next_ones_late() {
    let script = FaultScript {
        seed: 3,
        faults: vec![Fault::Jitter { spread_s: 0.003 }.into()],
    };
    let messages = held(&mut started(script), 1000);
    let late = |message: &Datagram| (message.at_us - messages[0].at_us) % CYCLE_US;
    assert!(messages.iter().all(|message| late(message) <= 3_000));
    assert!(messages.iter().any(|message| late(message) > 2_000));
}

#[test]
fn the_same_random_script_makes_the_same_run() {
    for seed in 0..40 {
        let run = || held(&mut started(FaultScript::random(seed, 2.0)), 500);
        assert_eq!(run(), run(), "seed {seed}");
    }
}

#[test]
fn whatever_happens_on_the_line_the_arm_stays_in_its_range() {
    let limits = motion::limits::RobotLimits::gofa5();
    for seed in 0..300 {
        let mut simulation = started(FaultScript::random(seed, 1.5));
        let home = simulation.controller().config().home;
        for number in 0..400 {
            let angle = home.0[0] + 0.1 * f64::from(number);
            simulation.cycle(|_| Some(answer(number, home, angle, 20.0)));
            let measured = simulation.measured();
            assert!(measured.is_finite(), "seed {seed}");
            let outside = limits.joint_out_of_range(&measured);
            assert_eq!(outside, None, "seed {seed}: {measured:?}");
        }
    }
}
