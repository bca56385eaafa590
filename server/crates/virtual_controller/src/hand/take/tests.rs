//! Tests of what a person watching the hand would notice.

use super::*;
use motion::limits::RobotLimits;

const SCRIPTS: [Script; 3] = [Script::F1, Script::F2, Script::F3];
const STEP_S: f64 = 0.004;

fn samples(take: &Take) -> Vec<JointAngles> {
    (0..=(take.duration_s() / STEP_S) as usize)
        .map(|step| take.at(step as f64 * STEP_S))
        .collect()
}

fn tool_speeds_mm_s(samples: &[JointAngles]) -> Vec<f64> {
    samples
        .windows(2)
        .map(|pair| tool0(&pair[0]).position.distance(&tool0(&pair[1]).position) / STEP_S)
        .collect()
}

fn takes() -> impl Iterator<Item = (Script, Take)> {
    SCRIPTS
        .into_iter()
        .flat_map(|script| (0..40).map(move |seed| (script, Take::new(script, seed))))
}

#[test]
fn the_same_seed_shows_the_same_and_another_one_differs() {
    for script in SCRIPTS {
        let first = samples(&Take::new(script, 7));
        assert_eq!(first, samples(&Take::new(script, 7)));
        let other = samples(&Take::new(script, 8));
        let apart = first
            .iter()
            .zip(&other)
            .map(|(a, b)| a.max_abs_difference(b))
            .fold(0.0, f64::max);
        assert!(
            apart > 1.0,
            "{script:?}: two takes differ by {apart} deg only"
        );
        let start_apart = first[0].max_abs_difference(&other[0]);
        assert!((0.001..4.0).contains(&start_apart), "{start_apart} deg");
    }
}

#[test]
fn every_take_stays_in_range_and_away_from_the_singular_wrist() {
    let limits = RobotLimits::gofa5();
    for (script, take) in takes() {
        for at in samples(&take) {
            assert_eq!(limits.joint_out_of_range(&at), None);
            let wrist = at.0[4];
            assert!(
                (-75.0..-20.0).contains(&wrist),
                "{script:?}: joint 5 at {wrist}"
            );
        }
    }
}

#[test]
fn every_take_has_a_persons_speed_and_length() {
    for (script, take) in takes() {
        assert!(
            (12.0..22.0).contains(&take.duration_s()),
            "{script:?} takes {} s",
            take.duration_s()
        );
        let speeds = tool_speeds_mm_s(&samples(&take));
        let fastest = speeds.iter().copied().fold(0.0, f64::max);
        assert!(
            (140.0..260.0).contains(&fastest),
            "{script:?}: {fastest} mm/s"
        );
    }
}

#[test]
fn the_hand_stands_only_at_both_ends_and_where_it_grasps_and_places() {
    for (script, take) in takes() {
        let speeds = tool_speeds_mm_s(&samples(&take));
        assert!(speeds[..100].iter().all(|speed| *speed == 0.0));
        assert!(
            speeds[speeds.len() - 100..]
                .iter()
                .all(|speed| *speed == 0.0)
        );
        let mut rests = 0;
        let mut resting = false;
        for speed in speeds {
            // Between "standing" and "moving" lies a gap, so that one slow moment counts once.
            if speed == 0.0 && !resting {
                rests += 1;
                resting = true;
            } else if speed > 10.0 {
                resting = false;
            }
        }
        assert_eq!(rests, 4, "{script:?}");
    }
}

#[test]
fn the_third_script_turns_the_piece_by_a_quarter() {
    let turn: Vec<f64> = samples(&Take::new(Script::F3, 1))
        .iter()
        .map(|at| at.0[5])
        .collect();
    let highest = turn.iter().copied().fold(f64::MIN, f64::max);
    assert!(
        (highest - turn[0] - 90.0).abs() < 8.0,
        "turned by {highest}"
    );
}

#[test]
fn the_gripper_is_worked_while_the_hand_stands_at_its_place() {
    for (script, take) in takes() {
        let closes: Vec<bool> = take.grips().iter().map(|(_, close)| *close).collect();
        match script {
            Script::F1 => assert_eq!(closes, [true, false]),
            Script::F2 | Script::F3 => assert!(closes.is_empty()),
        }
        for (at_s, _) in take.grips() {
            let moved = take.at(at_s + 0.1).max_abs_difference(&take.at(*at_s));
            assert!(moved < 1e-9, "the hand moves {moved} deg while it grips");
        }
    }
}
