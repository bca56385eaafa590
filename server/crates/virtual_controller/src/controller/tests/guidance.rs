//! Lead-through, the hand, guards and modes.

use super::*;

#[test]
fn a_start_needs_automatic_mode_motors_and_a_stiff_arm() {
    let mut bench = Bench::new(EgmSettings::default());
    assert!(bench.controller.start_program(None).is_err());
    bench.controller.set_mode(OperatingMode::ManualReduced);
    assert!(bench.controller.set_motors(true).is_err());
    bench.controller.set_mode(OperatingMode::Automatic);
    bench.controller.set_motors(true).unwrap();
    bench.until_soft();
    assert!(bench.controller.start_program(None).is_err());
}

#[test]
fn a_position_stream_says_that_nothing_is_guided() {
    let mut bench = Bench::new(EgmSettings {
        stream_when_idle: true,
        ..EgmSettings::default()
    });
    bench.controller.set_motors(true).unwrap();
    bench.until_soft();
    let begin = bench.silent_cycle().unwrap();
    bench
        .controller
        .move_hand(Action::Show, Script::F1, 3)
        .unwrap();
    let moved = bench.message(Bench::silent_cycle, |feedback| {
        feedback.feedback != begin.feedback
    });
    assert_eq!(moved.mci_state, Some(MciState::Stopped));
    assert_eq!(moved.rapid_exec_state, Some(RapidExecState::Stopped));
}

#[test]
fn the_hand_moves_only_a_soft_arm_and_lets_go_when_it_gets_stiff() {
    let mut bench = Bench::new(EgmSettings::default());
    assert!(
        bench.controller.set_lead_through(true).is_err(),
        "motors are off"
    );
    bench.controller.set_motors(true).unwrap();
    assert!(
        bench
            .controller
            .move_hand(Action::Show, Script::F1, 1)
            .is_err()
    );
    bench.until_soft();
    bench
        .controller
        .move_hand(Action::Show, Script::F1, 1)
        .unwrap();
    for _ in 0..1000 {
        bench.silent_cycle();
    }
    assert_eq!(bench.controller.hand().state, "showing");
    let home = bench.controller.config().home;
    assert!(bench.controller.measured().max_abs_difference(&home) > 2.0);

    bench.controller.set_motors(false).unwrap();
    let left = bench.controller.measured();
    for _ in 0..100 {
        bench.silent_cycle();
    }
    assert_eq!(bench.controller.measured(), left);
    assert_eq!(bench.controller.hand().state, "idle");
    assert!(bench.controller.lead_through().is_off());
}

#[test]
fn the_hand_brings_the_arm_gently_to_where_its_show_begins() {
    let mut bench = Bench::new(EgmSettings::default());
    bench.controller.set_motors(true).unwrap();
    bench.until_soft();
    bench
        .controller
        .move_hand(Action::Return, Script::F3, 11)
        .unwrap();
    let mut before = bench.controller.measured();
    let mut cycles = 0;
    while bench.controller.hand().state == "returning" {
        bench.silent_cycle();
        let now = bench.controller.measured();
        let way_mm = motion::kinematics::tool0(&before)
            .position
            .distance(&motion::kinematics::tool0(&now).position);
        assert!(way_mm / 0.004_032 < 250.0);
        before = now;
        cycles += 1;
    }
    assert!(f64::from(cycles) * 0.004_032 <= 4.1);
    bench
        .controller
        .move_hand(Action::Show, Script::F3, 11)
        .unwrap();
    bench.silent_cycle();
    assert!(bench.controller.measured().max_abs_difference(&before) < 0.01);
}

#[test]
fn lead_through_that_is_taken_back_is_logged_as_a_safety_event() {
    let mut bench = Bench::new(EgmSettings::default());
    bench.controller.set_motors(true).unwrap();
    bench.controller.faults_mut().lead_through_reverts = true;
    bench.controller.set_lead_through(true).unwrap();
    for _ in 0..200 {
        bench.silent_cycle();
    }
    assert!(bench.controller.lead_through().is_off());
    let safety: Vec<u32> = bench
        .controller
        .events()
        .newest_first(9)
        .map(|event| event.code)
        .collect();
    assert_eq!(safety, [90_515]);
}

#[test]
fn an_open_guard_stops_the_arm_and_keeps_its_motors_off() {
    let mut bench = Bench::running(EgmSettings::default());
    let goal = beside_home(&bench, 20.0);
    bench.message(|bench| bench.cycle(|_| Some(goal)), |_| true);
    for _ in 0..40 {
        bench.cycle(|_| Some(goal));
    }
    bench.controller.set_guard_stop(true);
    let feedback = bench.cycle(|_| Some(goal)).unwrap();
    assert_eq!(feedback.motor_state, Some(MotorState::MotorsOff));
    bench.until_silent();
    assert!(bench.controller.measured().max_abs_difference(&goal) > 1.0);
    assert!(bench.controller.set_motors(true).is_err());
    bench.controller.set_guard_stop(false);
    assert!(bench.controller.set_motors(true).is_ok());
}

#[test]
fn a_led_arm_goes_where_it_is_led_within_its_limits_and_rests_when_nobody_leads() {
    let mut bench = Bench::new(EgmSettings {
        stream_when_idle: true,
        ..EgmSettings::default()
    });
    let to = beside_home(&bench, 6.0);
    bench.controller.set_motors(true).unwrap();
    assert!(bench.controller.lead_hand(to).is_err(), "the arm is stiff");
    bench.until_soft();

    let mut before = bench.controller.measured();
    for cycle in 0..500 {
        // Five cycles are 20 ms.
        if cycle % 5 == 0 {
            bench.controller.lead_hand(to).unwrap();
        }
        let told = bench.silent_cycle().unwrap();
        assert_eq!(
            told.feedback
                .map(|at| at.max_abs_difference(&before) < 1e-9),
            Some(true)
        );
        let now = bench.controller.measured();
        let way_mm = motion::kinematics::tool0(&before)
            .position
            .distance(&motion::kinematics::tool0(&now).position);
        assert!(way_mm / 0.004_032 <= 250.1);
        before = now;
    }
    assert_eq!(bench.controller.hand().state, "leading");
    assert!(before.max_abs_difference(&to) < 0.01, "{before:?}");

    let far = beside_home(&bench, 60.0);
    bench.controller.lead_hand(far).unwrap();
    let mut cycles = 0;
    while bench.controller.hand().state == "leading" {
        bench.silent_cycle();
        cycles += 1;
        assert!(cycles < PATIENCE, "nobody leads it any more");
    }
    assert!(bench.controller.measured().max_abs_difference(&far) > 20.0);
    let rests = bench.controller.measured();
    bench.silent_cycle();
    assert_eq!(bench.controller.measured(), rests);
}

#[test]
fn a_script_is_not_led_away_and_a_stiff_arm_is_led_nowhere() {
    let mut bench = Bench::new(EgmSettings::default());
    bench.controller.set_motors(true).unwrap();
    bench.until_soft();
    let to = beside_home(&bench, 6.0);
    bench
        .controller
        .move_hand(Action::Show, Script::F1, 1)
        .unwrap();
    assert!(bench.controller.lead_hand(to).is_err());
    bench.controller.end_lead();
    assert_eq!(bench.controller.hand().state, "showing");

    bench.controller.set_motors(false).unwrap();
    assert!(bench.controller.lead_hand(to).is_err());
    let left = bench.controller.measured();
    bench.silent_cycle();
    assert_eq!(bench.controller.measured(), left);
}
