//! Whatever goes wrong on the line: the arm is brought to rest at once, what it is told stays
//! continuous and within the limits, and a person is told why.

use super::*;
use crate::ending;
use crate::links::{SupervisorLinks, links};
use crate::run::RunEnd;
use crate::testing::{HOME, minimum_jerk_plan};
use egm::messages::{MciState, MotorState, RapidExecState};
use motion::JOINTS;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use std::sync::Arc;
use virtual_controller::{Config, Datagram, FaultScript, SimulatedController};

const CYCLE_S: f64 = 0.004_032;
/// Answers until the arm must be on its way to rest.
const WITHIN: u32 = 3;
/// Rounding, and a plan between two of its samples.
const MARGIN: f64 = 1.06;

/// What is wrong with a datagram, judged by its bytes alone.
#[derive(Default)]
struct Observer {
    last: Option<Seen>,
    /// The newest odd one, with the one before it and whether it was sound.
    oddest: Option<(Option<Seen>, Seen, bool)>,
}

/// Where from, with which number, and when, µs.
type Seen = (SocketAddr, i64, u64);

impl Observer {
    /// Whether the arm has to be stopped because of this datagram.
    fn is_odd(&mut self, datagram: &Datagram) -> bool {
        let Ok(robot) = read_feedback(&datagram.bytes) else {
            return true;
        };
        let sound = robot.feedback.is_some_and(|joints| joints.is_finite())
            && robot.motor_state == Some(MotorState::MotorsOn)
            && robot.mci_state == Some(MciState::Running)
            && robot
                .rapid_exec_state
                .is_some_and(|state| state != RapidExecState::Stopped);
        let Some(number) = robot.sequence.map(|number| i64::from(number.0)) else {
            return true;
        };
        let now = (datagram.controller, number, datagram.at_us);
        let goes_on = match self.last {
            None => true,
            Some((controller, last, at_us)) => {
                let steps = number - last;
                // About half a cycle later it may be either a copy or a cycle of its own.
                let copy = steps == 0 && datagram.at_us < at_us + 2_600;
                controller == datagram.controller
                    && (copy || (1..=1 + i64::from(LOST_TOLERATED)).contains(&steps))
                    && datagram.at_us < at_us + 100_000
            }
        };
        let before = self.last.replace(now);
        if !(sound && goes_on) {
            self.oddest = Some((before, now, sound));
        }
        !(sound && goes_on)
    }
}

/// A control loop on the line with a controller whose line has faults.
struct Line {
    control: ControlLoop,
    supervisor: SupervisorLinks,
    observer: Observer,
    /// Answers since the first odd datagram of the run.
    odd_for: Option<u32>,
    told: Option<Told>,
    armed: bool,
}

/// What the arm was told last, and how fast that was.
#[derive(Clone, Copy)]
struct Told {
    joints: JointAngles,
    speed: [f64; JOINTS],
    step_s: f64,
}

impl Line {
    fn new() -> Self {
        let (thread, supervisor) = links();
        Self {
            control: ControlLoop::new(thread, &limits(), Duration::from_millis(100)),
            supervisor,
            observer: Observer::default(),
            odd_for: None,
            told: None,
            armed: false,
        }
    }

    fn serve(&mut self, datagram: &Datagram) -> Option<Vec<u8>> {
        let odd = self.observer.is_odd(datagram);
        if !self
            .control
            .receive(&datagram.bytes, datagram.at_us, datagram.controller)
        {
            return None;
        }
        let visited = self.control.session.is_visited();
        let latest = self.control.latest.expect("a message was taken in");
        let begins = visited || latest.began.is_some();
        let applies = latest.began.is_none() && latest.may_be_commanded;
        let elapsed_s = self.control.session.pending_us() as f64 * 1e-6;
        let mut reply = [0; egm::MAX_CORRECTION_BYTES];
        let length = self.control.answer(&mut reply).expect("an answer");
        let sensor = egm::codec::decode_sensor(&reply[..length]).unwrap();
        let joints = sensor.planned.unwrap().joints.unwrap().joints;
        let joints = JointAngles(joints.try_into().unwrap());
        assert!(joints.is_finite());
        if begins {
            // A beginning, or a stranger: it is told where it stands.
            let robot = read_feedback(&datagram.bytes).unwrap();
            assert_eq!(Some(joints), robot.feedback);
        }
        if !applies {
            self.told = None;
        } else if !visited {
            self.check_continuity(joints, elapsed_s);
        }
        if self.armed {
            self.check_reaction(odd, visited);
        }
        Some(reply[..length].to_vec())
    }

    fn check_continuity(&mut self, joints: JointAngles, elapsed_s: f64) {
        let Some(before) = self.told else {
            self.told = Some(Told {
                joints,
                speed: [0.0; JOINTS],
                step_s: CYCLE_S,
            });
            return;
        };
        if elapsed_s == 0.0 {
            assert_eq!(joints, before.joints, "no time, no way");
            return;
        }
        let mut now = Told {
            joints,
            step_s: elapsed_s,
            ..before
        };
        for joint in 0..JOINTS {
            let speed = (joints.0[joint] - before.joints.0[joint]) / elapsed_s;
            assert!(speed.abs() <= limits().joint_speed_deg_s[joint] * MARGIN);
            let time_s = 0.5 * (elapsed_s + before.step_s);
            let acceleration = (speed - before.speed[joint]).abs() / time_s;
            let limit = limits().joint_acceleration_deg_s2[joint];
            assert!(
                acceleration <= limit * MARGIN,
                "joint {}: {acceleration:.0} deg/s2 after {elapsed_s} s, {:?}",
                joint + 1,
                self.control.state.run
            );
            now.speed[joint] = speed;
        }
        self.told = Some(now);
    }

    fn check_reaction(&mut self, odd: bool, visited: bool) {
        let run = self.run();
        if odd && self.odd_for.is_none() && run.end.is_none() {
            self.odd_for = Some(0);
        }
        if let Some(answers) = &mut self.odd_for {
            *answers += 1;
            // A stranger is held where it stands.
            let stops = run.phase == RunPhase::Stopping || run.end.is_some() || visited;
            let seen = self.observer.oddest;
            assert!(stops || *answers < WITHIN, "it goes on: {run:?}, {seen:?}");
        }
    }

    fn run(&mut self) -> RunState {
        self.control.publish();
        self.supervisor.state.read().run.unwrap()
    }

    fn arm(&mut self, travel_deg: [f64; 6], duration_s: f64) {
        let command = Command::Arm {
            run: 1,
            stops: self.supervisor.flags.stops(),
            plan: Arc::new(minimum_jerk_plan(travel_deg, duration_s)),
            held: false,
        };
        self.supervisor.commands.push(command).unwrap();
        self.armed = true;
    }
}

fn limits() -> RobotLimits {
    RobotLimits::gofa5()
}

/// Cycles until the line is quiet, then a run under the script, then until it has ended.
fn run_under(script: FaultScript, travel_deg: [f64; 6], duration_s: f64) -> LoopEnd {
    let config = Config {
        home: HOME,
        ..Config::new(SocketAddr::from(([127, 0, 0, 1], 6510)))
    };
    let mut simulation = SimulatedController::new(config).unwrap();
    simulation.start_program().unwrap();
    let mut line = Line::new();
    for _ in 0..100 {
        simulation.cycle(|datagram| line.serve(datagram));
    }
    line.arm(travel_deg, duration_s);
    simulation.play(script).unwrap();
    let cycles = ((duration_s + 12.0) / CYCLE_S) as usize;
    for _ in 0..cycles {
        // Everything that arrives before this is served.
        let now_us = simulation.next_cycle_us();
        simulation.cycle(|datagram| line.serve(datagram));
        if now_us > line.control.latest_us + 100_000 {
            line.control.silence(now_us);
        }
    }
    line.control.publish();
    let run = line.supervisor.state.read().run;
    // A line on which nothing arrives from the first cycle on never sees the run armed.
    run.map_or(LoopEnd::Silence, |run| {
        run.end.expect("the run must come to an end")
    })
}

#[test]
fn without_faults_the_run_is_completed() {
    let end = run_under(
        FaultScript::default(),
        [20.0, -8.0, 5.0, 0.0, 10.0, -30.0],
        2.0,
    );
    assert_eq!(end, LoopEnd::Player(PlayerEnd::Completed));
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 1_000,
        // The same thousand each time; PROPTEST_RNG_SEED tries others.
        rng_seed: RngSeed::Fixed(2),
        ..ProptestConfig::default()
    })]
    #[test]
    fn every_fault_ends_in_a_ramped_stop_or_a_hold(
        seed in any::<u64>(),
        travel_deg in proptest::array::uniform6(-25.0..25.0_f64),
        duration_s in 1.6..3.0_f64,
    ) {
        let script = FaultScript::random(seed, duration_s);
        let end = run_under(script, travel_deg, duration_s);
        match ending::run_end(end, None) {
            RunEnd::Completed => {}
            RunEnd::Failed(fault) => {
                prop_assert!(!fault.message.is_empty() && !fault.advice.is_empty());
            }
            RunEnd::Stopped => prop_assert!(false, "nobody stopped it"),
        }
    }
}

#[test]
fn an_arm_that_is_led_astray_by_a_damaged_answer_is_led_to_rest_too() {
    let travel_deg = [0.0, 0.0, 0.0, 0.0, 0.0, -6.955_496_456_415_824];
    let duration_s = 2.395_030_545_558_235;
    run_under(
        FaultScript::random(5_064_538_541_975_703_746, duration_s),
        travel_deg,
        duration_s,
    );
}
