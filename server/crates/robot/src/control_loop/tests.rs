//! Datagrams in, datagrams out: what the controller is told in each situation.

use super::*;
use crate::links::{SupervisorLinks, links};
use crate::testing::{HOME, line_plan};
use egm::codec;
use egm::messages::{
    EgmFeedBack, EgmHeader, EgmJoints, EgmMciState, EgmMotorState, EgmRapidCtrlExecState, EgmRobot,
    MciState, MessageType, MotorState, RapidExecState,
};
use motion::plan::Plan;
use std::sync::Arc;

mod held;

const CYCLE_US: u64 = 4_000;

/// A controller with an arm that follows every reference at once.
struct Bench {
    control: ControlLoop,
    supervisor: SupervisorLinks,
    sequence: u32,
    now_us: u64,
    arm: JointAngles,
    mci: MciState,
}

impl Bench {
    fn new() -> Self {
        let (thread, supervisor) = links();
        Self {
            control: ControlLoop::new(thread, &RobotLimits::gofa5(), Duration::from_millis(100)),
            supervisor,
            sequence: 0,
            now_us: 1_000_000,
            arm: HOME,
            mci: MciState::Running,
        }
    }

    fn message(&self) -> Vec<u8> {
        let robot = EgmRobot {
            header: Some(EgmHeader {
                seqno: Some(self.sequence),
                tm: Some((self.now_us / 1000) as u32),
                mtype: Some(MessageType::Data as i32),
            }),
            feed_back: Some(EgmFeedBack {
                joints: Some(EgmJoints {
                    joints: self.arm.0.to_vec(),
                }),
                ..EgmFeedBack::default()
            }),
            motor_state: Some(EgmMotorState {
                state: MotorState::MotorsOn as i32,
            }),
            mci_state: Some(EgmMciState {
                state: self.mci as i32,
            }),
            rapid_exec_state: Some(EgmRapidCtrlExecState {
                state: RapidExecState::Running as i32,
            }),
            ..EgmRobot::default()
        };
        let mut datagram = Vec::new();
        codec::encode_robot(&robot, &mut datagram).unwrap();
        datagram
    }

    fn source() -> SocketAddr {
        SocketAddr::from(([127, 0, 0, 1], 6599))
    }

    /// One cycle; the arm goes to the answer.
    fn cycle(&mut self) -> JointAngles {
        let message = self.message();
        self.sequence += 1;
        assert!(self.control.receive(&message, self.now_us, Self::source()));
        let reference = self.answer().expect("a robot's message must be answered");
        self.now_us += CYCLE_US;
        if self.mci == MciState::Running {
            self.arm = reference;
        }
        reference
    }

    fn answer(&mut self) -> Option<JointAngles> {
        let mut reply = [0; egm::MAX_CORRECTION_BYTES];
        let length = self.control.answer(&mut reply)?;
        let sensor = codec::decode_sensor(&reply[..length]).unwrap();
        let joints = sensor.planned.unwrap().joints.unwrap().joints;
        Some(JointAngles(joints.try_into().unwrap()))
    }

    fn arm_plan(&mut self, plan: Plan) -> Arc<Plan> {
        let plan = Arc::new(plan);
        let command = Command::Arm {
            run: 7,
            stops: self.supervisor.flags.stops(),
            plan: Arc::clone(&plan),
            held: false,
        };
        self.supervisor.commands.push(command).unwrap();
        plan
    }

    fn run_state(&mut self) -> RunState {
        self.control.publish();
        self.supervisor.state.read().run.unwrap()
    }

    /// Cycles until the run has ended.
    fn until_end(&mut self) -> LoopEnd {
        for _ in 0..5_000 {
            self.cycle();
            if let Some(end) = self.run_state().end {
                return end;
            }
        }
        panic!("the run must end");
    }
}

#[test]
fn without_a_run_the_arm_is_held_where_it_is() {
    let mut bench = Bench::new();
    for _ in 0..100 {
        assert_eq!(bench.cycle(), HOME);
    }
}

#[test]
fn a_run_follows_the_plan_and_is_recorded_cycle_by_cycle() {
    let mut bench = Bench::new();
    bench.cycle();
    let plan = bench.arm_plan(line_plan());
    assert_eq!(bench.until_end(), LoopEnd::Player(PlayerEnd::Completed));
    assert_eq!(bench.arm, plan.last());
    let mut records = 0;
    while let Ok(record) = bench.supervisor.records.pop() {
        let planned = plan.at(record.plan_t_s).joints;
        assert!(record.commanded.max_abs_difference(&planned) < 1e-9);
        assert!(!record.held && !record.limited);
        records += 1;
    }
    assert!(records >= 500, "{records}");
    // The plan came back to be freed elsewhere, and the arm stays at the end.
    assert!(Arc::ptr_eq(&bench.supervisor.retired.pop().unwrap(), &plan));
    assert_eq!(bench.cycle(), plan.last());
}

#[test]
fn a_stop_ends_the_run_within_its_time_and_the_next_run_is_not_affected() {
    let mut bench = Bench::new();
    bench.cycle();
    bench.arm_plan(line_plan());
    for _ in 0..250 {
        bench.cycle();
    }
    bench.supervisor.flags.stop();
    let stopped_at_us = bench.now_us;
    assert_eq!(bench.until_end(), LoopEnd::Player(PlayerEnd::Stopped));
    assert!(bench.now_us - stopped_at_us <= 310_000);
    let rest = bench.cycle();
    assert_eq!(bench.cycle(), rest);

    bench.arm = HOME;
    bench.sequence = 0;
    bench.cycle();
    bench.arm_plan(line_plan());
    assert_eq!(bench.until_end(), LoopEnd::Player(PlayerEnd::Completed));
}

#[test]
fn the_first_answer_after_a_stop_is_slower_already() {
    let way_after = |stop: bool| {
        let mut bench = Bench::new();
        bench.cycle();
        bench.arm_plan(line_plan());
        for _ in 0..250 {
            bench.cycle();
        }
        let before = bench.arm;
        if stop {
            bench.supervisor.flags.stop();
        }
        bench.cycle().max_abs_difference(&before)
    };
    assert!(way_after(true) < way_after(false));
}

#[test]
fn silence_ends_the_run_and_what_comes_later_does_not_move_the_arm() {
    let mut bench = Bench::new();
    bench.cycle();
    bench.arm_plan(line_plan());
    for _ in 0..250 {
        bench.cycle();
    }
    bench.now_us += 150_000;
    bench.control.silence(bench.now_us);
    assert_eq!(bench.run_state().end, Some(LoopEnd::Silence));
    let rest = bench.arm;
    for _ in 0..100 {
        assert_eq!(bench.cycle(), rest);
    }
}

#[test]
fn a_controller_that_stops_applying_references_ends_the_run() {
    let mut bench = Bench::new();
    bench.cycle();
    bench.arm_plan(line_plan());
    for _ in 0..250 {
        bench.cycle();
    }
    bench.mci = MciState::Error;
    let end = bench.until_end();
    assert_eq!(
        end,
        LoopEnd::NotApplied {
            mci_error: true,
            motors_on: true
        }
    );
    // It may be moved by hand now; when guidance comes back, the reference is there.
    bench.arm.0[1] += 12.0;
    assert_eq!(bench.cycle(), bench.arm);
    bench.mci = MciState::Running;
    assert_eq!(bench.cycle(), bench.arm);
}

#[test]
fn an_arm_elsewhere_is_not_moved_to_the_start() {
    let mut bench = Bench::new();
    bench.arm.0[3] += 3.0;
    bench.cycle();
    bench.arm_plan(line_plan());
    let before = bench.arm;
    let LoopEnd::NotAtStart { distance_deg } = bench.until_end() else {
        panic!("it must be refused");
    };
    assert!((distance_deg - 3.0).abs() < 1e-9);
    assert_eq!(bench.cycle(), before);
}

#[test]
fn an_arm_that_is_held_up_is_not_pushed_on() {
    let mut bench = Bench::new();
    bench.cycle();
    bench.arm_plan(crate::testing::minimum_jerk_plan(
        [20.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        3.0,
    ));
    let mut previous = HOME;
    for _ in 0..2_000 {
        let reference = bench.cycle();
        // The reference gives way without a jump.
        assert!(reference.max_abs_difference(&previous) <= 125.0 * 1.05 * 0.004 + 1e-9);
        previous = reference;
        bench.arm = HOME;
    }
    let end = bench.run_state().end;
    assert!(matches!(
        end,
        Some(LoopEnd::Player(PlayerEnd::NotFollowing { joint: 0, .. }))
    ));
    assert!(previous.max_abs_difference(&HOME) < 1e-6);
}

#[test]
fn rubbish_is_counted_and_not_answered() {
    let mut bench = Bench::new();
    assert!(!bench.control.receive(b"\xff\xff\xff", 0, Bench::source()));
    bench.cycle();
    let stranger = SocketAddr::from(([127, 0, 0, 1], 9));
    assert!(!bench.control.receive(b"hello", bench.now_us, stranger));
    bench.control.publish();
    assert_eq!(bench.supervisor.state.read().unreadable, 2);
    assert_eq!(bench.cycle(), HOME);
}

#[test]
fn after_a_failure_of_its_own_it_holds_the_measured_pose() {
    let mut bench = Bench::new();
    bench.cycle();
    bench.arm_plan(line_plan());
    for _ in 0..250 {
        bench.cycle();
    }
    bench.control.recover();
    assert_eq!(bench.run_state().end, Some(LoopEnd::Panicked));
    let rest = bench.arm;
    for _ in 0..10 {
        assert_eq!(bench.cycle(), rest);
    }
}
