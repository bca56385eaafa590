//! Runs that move only while somebody holds the button.

use super::*;
use proptest::prelude::*;

/// As the robot's handle gives it.
const HOLD_US: u64 = crate::handle::HOLD.as_micros() as u64;
/// A standstill within half a second of the last word, of which the hold itself takes a part.
const REST_US: u64 = 500_000;
/// Slower than anybody can see, deg per cycle.
const STILL_DEG: f64 = 1e-4;

impl Bench {
    fn arm_held(&mut self, plan: Plan) -> Arc<Plan> {
        let plan = Arc::new(plan);
        let command = Command::Arm {
            run: 7,
            stops: self.supervisor.flags.stops(),
            plan: Arc::clone(&plan),
            held: true,
        };
        self.supervisor.commands.push(command).unwrap();
        plan
    }

    fn hold(&mut self) {
        self.supervisor.flags.hold_until(self.now_us + HOLD_US);
    }
}

#[test]
fn nothing_moves_before_the_button_is_held() {
    let mut bench = Bench::new();
    bench.cycle();
    bench.arm_held(line_plan());
    for _ in 0..500 {
        assert_eq!(bench.cycle(), HOME);
    }
    assert_eq!(bench.run_state().phase, RunPhase::Paused);
}

#[test]
fn held_all_the_way_it_arrives_on_the_planned_path() {
    let mut bench = Bench::new();
    bench.cycle();
    let plan = bench.arm_held(line_plan());
    while bench
        .supervisor
        .state
        .read()
        .run
        .and_then(|run| run.end)
        .is_none()
    {
        bench.hold();
        bench.cycle();
        bench.control.publish();
        assert!(bench.sequence < 5_000, "the run must end");
    }
    assert_eq!(bench.arm, plan.last());
    while let Ok(record) = bench.supervisor.records.pop() {
        let planned = plan.at(record.plan_t_s).joints;
        assert!(record.commanded.max_abs_difference(&planned) < 1e-9);
    }
}

#[test]
fn let_go_it_stands_within_half_a_second_and_goes_on_when_held_again() {
    let mut bench = Bench::new();
    bench.cycle();
    bench.arm_held(line_plan());
    for _ in 0..200 {
        bench.hold();
        bench.cycle();
    }
    // The network is cut: no further word comes.
    let last_word_us = bench.now_us - CYCLE_US;
    let mut before = bench.arm;
    loop {
        let now = bench.cycle();
        if now == before {
            break;
        }
        before = now;
        assert!(bench.now_us - last_word_us <= REST_US, "it must stand");
    }
    for _ in 0..500 {
        assert_eq!(bench.cycle(), before);
    }
    assert_eq!(bench.run_state().phase, RunPhase::Paused);
    for _ in 0..100 {
        bench.hold();
        bench.cycle();
    }
    assert_ne!(bench.arm, before);
    bench.supervisor.flags.let_go();
    bench.supervisor.flags.stop();
    assert_eq!(bench.until_end(), LoopEnd::Player(PlayerEnd::Stopped));
}

proptest! {
    /// However the words come and stay away, the arm keeps to its path, its limits, and the time
    /// after the last word.
    #[test]
    fn any_pattern_of_holding_is_safe(
        gaps in proptest::collection::vec(1_u64..200, 1..60),
        travel_deg in proptest::array::uniform6(-25.0..25.0_f64),
    ) {
        let limits = RobotLimits::gofa5();
        let mut bench = Bench::new();
        bench.cycle();
        let plan = bench.arm_held(crate::testing::minimum_jerk_plan(travel_deg, 2.0));
        let cycle_s = CYCLE_US as f64 * 1e-6;
        let (mut before, mut speed_before) = (bench.arm, [0.0; 6]);
        for gap in gaps {
            let word_us = bench.now_us;
            bench.hold();
            for _ in 0..gap {
                let now = bench.cycle();
                for joint in 0..6 {
                    let speed = (now.0[joint] - before.0[joint]) / cycle_s;
                    let acceleration = (speed - speed_before[joint]).abs() / cycle_s;
                    prop_assert!(speed.abs() <= limits.joint_speed_deg_s[joint] * 1.06);
                    prop_assert!(acceleration <= limits.joint_acceleration_deg_s2[joint] * 1.06);
                    speed_before[joint] = speed;
                }
                if bench.now_us - word_us > REST_US {
                    prop_assert!(now.max_abs_difference(&before) < STILL_DEG);
                }
                before = now;
            }
        }
        while let Ok(record) = bench.supervisor.records.pop() {
            let planned = plan.at(record.plan_t_s).joints;
            prop_assert!(record.commanded.max_abs_difference(&planned) < 1e-6);
        }
    }
}
