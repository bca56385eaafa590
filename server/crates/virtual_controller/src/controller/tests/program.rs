//! How runs of the program begin and end.

use super::*;

#[test]
fn a_run_ends_by_itself_when_the_arm_has_been_where_it_should_for_the_time_given() {
    let egm = EgmSettings {
        cond_time_s: 0.5,
        ..EgmSettings::default()
    };
    let mut bench = Bench::running(egm);
    bench.message(Bench::holding_cycle, |feedback| {
        feedback.mci_convergence_met == Some(true)
    });
    bench.message(Bench::holding_cycle, |feedback| {
        feedback.mci_state == Some(MciState::Stopped)
    });
    bench.until_silent();
    assert_eq!(bench.controller.program(), Program::Stopped);
    assert!(!bench.has_event(41_822));
}

#[test]
fn a_program_that_runs_forever_opens_its_next_session() {
    let egm = EgmSettings {
        cond_time_s: 0.5,
        ..EgmSettings::default()
    };
    let mut bench = Bench::new(egm);
    bench.controller.set_motors(true).unwrap();
    bench
        .controller
        .start_program(Some(RunMode::Forever))
        .unwrap();
    bench.message(Bench::holding_cycle, |feedback| {
        feedback.mci_state == Some(MciState::Stopped)
    });
    let again = bench.message(Bench::holding_cycle, |feedback| {
        feedback.mci_state == Some(MciState::Running)
    });
    assert_eq!(again.sequence, Some(SequenceNumber(0)));
}

#[test]
fn ramp_down_brings_the_arm_back_to_where_the_run_began() {
    let egm = EgmSettings {
        cond_time_s: 0.2,
        stop_mode: StopMode::RampDown,
        ..EgmSettings::default()
    };
    let mut bench = Bench::running(egm);
    let goal = beside_home(&bench, 4.0);
    bench.message(
        |bench| bench.cycle(|_| Some(goal)),
        |feedback| feedback.mci_state == Some(MciState::Stopped),
    );
    bench.until_silent();
    let home = bench.controller.config().home;
    assert!(bench.controller.measured().max_abs_difference(&home) <= 0.5);
}

#[test]
fn the_stop_input_ends_the_run_without_an_error() {
    let mut bench = Bench::running(EgmSettings::default());
    bench.message(Bench::holding_cycle, |_| true);
    bench.controller.set_signal("EgmStop", true).unwrap();
    let feedback = bench.holding_cycle().unwrap();
    assert_eq!(feedback.mci_state, Some(MciState::Stopped));
    assert_eq!(feedback.rapid_exec_state, Some(RapidExecState::Running));
    bench.until_silent();
    assert_eq!(bench.controller.program(), Program::Stopped);
    assert_eq!(bench.controller.state(), ControllerState::MotorsOn);
}

#[test]
fn a_closed_port_stops_the_program() {
    let mut bench = Bench::running(EgmSettings::default());
    bench.message(Bench::silent_cycle, |_| true);
    let open = bench.controller.begin_cycle(WallTime::default()).unwrap();
    bench.controller.message_refused(open.session, 598);
    assert!(bench.has_event(41_830));
    assert_eq!(bench.controller.program(), Program::Stopped);
    assert!(bench.silent_cycle().is_none());
}

#[test]
fn a_start_that_is_taken_back_runs_for_a_moment_only() {
    let mut bench = Bench::new(EgmSettings::default());
    bench.controller.set_motors(true).unwrap();
    bench.controller.faults_mut().start_reverts = true;
    bench.controller.start_program(None).unwrap();
    assert!(bench.controller.program().is_running());
    for _ in 0..100 {
        assert!(bench.silent_cycle().is_none());
    }
    assert!(!bench.controller.program().is_running());
}

#[test]
fn after_a_restart_the_program_state_can_be_unknown_until_the_first_stop() {
    let mut bench = Bench::running(EgmSettings {
        rapid_undefined_at_first: true,
        ..EgmSettings::default()
    });
    let first = bench.message(Bench::holding_cycle, |_| true);
    assert_eq!(first.rapid_exec_state, Some(RapidExecState::Undefined));
    bench.controller.stop_program();
    bench.until_silent();
    bench.controller.start_program(None).unwrap();
    let next = bench.message(Bench::holding_cycle, |_| true);
    assert_eq!(next.rapid_exec_state, Some(RapidExecState::Running));
}
