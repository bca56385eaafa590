//! What is left of a recording, and what is proposed to be cut.

use proptest::prelude::*;

use super::*;

const GRIPPER: &str = "GripperClose";

fn signal(at_us: u64, on: bool) -> SignalEvent {
    SignalEvent {
        at_us,
        name: GRIPPER.into(),
        on,
    }
}

/// Still for `before_s`, two seconds of motion, still for `after_s`; 100 samples a second.
fn still_move_still(before_s: f64, after_s: f64) -> Recording {
    let total = ((before_s + 2.0 + after_s) * 100.0).round() as u64;
    let samples = (0..=total).map(|i| {
        let share = ((i as f64 / 100.0 - before_s) / 2.0).clamp(0.0, 1.0);
        Sample {
            at_us: 10_000 * i,
            joints_deg: [40.0 * share, 10.0, 20.0, 0.0, -45.0, 0.0],
            tcp_mm: None,
        }
    });
    Recording {
        samples: samples.collect(),
        ..Recording::default()
    }
}

fn trim(from_s: f64, to_s: f64) -> Trim {
    Trim { from_s, to_s }
}

#[test]
fn a_cut_begins_at_zero_and_takes_signals_gaps_and_pauses_along() {
    let whole = Recording {
        signals: vec![
            signal(0, false),
            signal(500_000, true),
            signal(2_000_000, false),
            signal(3_500_000, true),
        ],
        gaps: vec![
            Gap {
                at_us: 900_000,
                length_us: 200_000,
            },
            Gap {
                at_us: 2_900_000,
                length_us: 300_000,
            },
            Gap {
                at_us: 3_500_000,
                length_us: 100_000,
            },
        ],
        pauses: vec![
            Pause {
                at_us: 1_500_000,
                length_us: Some(7),
            },
            Pause {
                at_us: 4_000_000,
                length_us: None,
            },
        ],
        ..still_move_still(1.0, 1.0)
    };
    let left = whole.cut(trim(1.0, 3.0));
    assert_eq!(left.samples.len(), 201);
    assert_eq!(
        (left.samples[0].at_us, left.samples[200].at_us),
        (0, 2_000_000)
    );
    assert!((left.samples[100].joints_deg[0] - 20.0).abs() < 1e-9);
    // It was closed before the cut: it stands closed at the beginning.
    assert_eq!(left.signals, [signal(0, true), signal(1_000_000, false)]);
    assert_eq!(
        left.gaps,
        [
            Gap {
                at_us: 0,
                length_us: 100_000
            },
            Gap {
                at_us: 1_900_000,
                length_us: 100_000
            },
        ]
    );
    assert_eq!(
        left.pauses,
        [Pause {
            at_us: 500_000,
            length_us: Some(7)
        }]
    );
}

#[test]
fn a_signal_after_the_last_sample_goes_only_when_the_end_is_cut() {
    let whole = Recording {
        signals: vec![signal(0, false), signal(4_050_000, true)],
        ..still_move_still(1.0, 1.0)
    };
    let begin_cut = whole.clone().cut(trim(0.5, 4.0));
    assert_eq!(
        begin_cut.signals,
        [signal(0, false), signal(3_550_000, true)]
    );
    assert_eq!(whole.cut(trim(0.0, 3.9)).signals, [signal(0, false)]);
}

#[test]
fn standing_still_at_both_ends_is_proposed_to_be_cut_with_a_margin() {
    let proposed = proposal(&still_move_still(2.0, 1.5)).unwrap();
    assert!((proposed.from_s - 1.7).abs() < 0.11, "{proposed:?}");
    assert!((proposed.to_s - 4.3).abs() < 0.11, "{proposed:?}");
    let one_end = proposal(&still_move_still(0.2, 1.5)).unwrap();
    assert_eq!(one_end.from_s, 0.0);
}

#[test]
fn nothing_is_proposed_where_little_is_to_gain_or_the_gripper_works() {
    assert_eq!(proposal(&still_move_still(0.4, 0.4)), None);
    assert_eq!(proposal(&Recording::default()), None);
    let grips = Recording {
        signals: vec![
            signal(0, false),
            signal(200_000, true),
            signal(5_400_000, false),
        ],
        ..still_move_still(2.0, 1.5)
    };
    assert_eq!(proposal(&grips), None);
}

proptest! {
    #[test]
    fn what_is_left_are_the_recorded_samples_themselves(from in 0.0..3.0_f64, length in 0.0..2.0_f64) {
        let whole = still_move_still(1.0, 1.0);
        let left = whole.clone().cut(trim(from, from + length));
        if let Some(first) = left.samples.first() {
            prop_assert_eq!(first.at_us, 0);
            let begin = whole.samples.iter().position(|s| s.at_us as f64 / 1e6 >= from - 1e-9).unwrap();
            for (cut, recorded) in left.samples.iter().zip(&whole.samples[begin..]) {
                prop_assert_eq!(cut.joints_deg, recorded.joints_deg);
                prop_assert_eq!(cut.at_us, recorded.at_us - whole.samples[begin].at_us);
            }
        }
    }
}
