//! What counts as a change, which stories are the same, and that an event lands where it
//! was made, whatever the pace.

use proptest::prelude::*;

use super::*;
use crate::{
    alignment::{align_with_clocks, barycentre::align_to_mean},
    timeline::interpolate,
};

fn event(name: &str, at_s: f64, on: bool) -> SignalEvent {
    SignalEvent {
        name: name.into(),
        at_s,
        on,
    }
}

/// One joint that goes 0 -> 40 -> 10 deg; the place at the share u of its way.
fn shape(u: f64) -> f64 {
    if u < 0.5 {
        80.0 * u
    } else {
        40.0 - 60.0 * (u - 0.5)
    }
}

/// The motion at a pace of its own: the share of the way done at the share s of the time
/// is s^bend, so that the place u is passed at the share u^(1/bend) of the time.
#[derive(Debug)]
struct Pace {
    duration_s: f64,
    bend: f64,
}

impl Pace {
    fn time_of(&self, u: f64) -> f64 {
        self.duration_s * u.powf(1.0 / self.bend)
    }

    fn take(&self, places: &[f64]) -> Demonstration {
        let count = (self.duration_s * 50.0).round() as usize;
        let times: Vec<f64> = (0..=count)
            .map(|i| self.duration_s * i as f64 / count as f64)
            .collect();
        let joints = times
            .iter()
            .map(|t| vec![shape((t / self.duration_s).powf(self.bend))])
            .collect();
        let events = places
            .iter()
            .enumerate()
            .map(|(i, u)| event("Gripper", self.time_of(*u), i % 2 == 0))
            .collect();
        let name = format!("bend {}", self.bend);
        let take = Demonstration::new(name, times, joints, None).unwrap();
        take.with_signals(events).unwrap()
    }
}

fn paces() -> impl Strategy<Value = Vec<Pace>> {
    let pace =
        (3.0..8.0_f64, 0.7..1.4_f64).prop_map(|(duration_s, bend)| Pace { duration_s, bend });
    proptest::collection::vec(pace, 1..5)
}

/// Where the event of each demonstration lies on the common time.
fn common(takes: &[Demonstration], t_s: &[f64], clocks_s: &[Vec<f64>], step: usize) -> Vec<f64> {
    takes
        .iter()
        .zip(clocks_s)
        .map(|(take, clock)| common_time_s(t_s, clock, take.signal_changes()[step].at_s))
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn an_event_lands_where_it_was_made_at_whatever_pace(
        paces in paces(), u in 0.05..0.95_f64,
    ) {
        let takes: Vec<Demonstration> = paces.iter().map(|pace| pace.take(&[u])).collect();
        let by_mean = align_to_mean(&takes, 100.0, &mut |_, _| Ok(())).unwrap();
        let by_reference = align_with_clocks(&takes, 100.0, &mut |_, _| Ok(())).unwrap();
        for (aligned, clocks_s) in [
            (&by_mean.aligned, &by_mean.recorded_s()),
            (&by_reference.0, &by_reference.1),
        ] {
            for (i, at_s) in common(&takes, &aligned.t_s, clocks_s, 0).into_iter().enumerate() {
                for joints in &aligned.joints_deg {
                    let found = interpolate(&aligned.t_s, joints, &[at_s]).row(0)[0];
                    // A sample advances by at most 80 deg · 1.4 / (3 s · 50 Hz) = 0.75 deg, and a
                    // match is good to about two of the coarsest samples.
                    prop_assert!((found - shape(u)).abs() < 2.0, "take {}: {} for {}", i, found, shape(u));
                }
            }
        }
    }

    #[test]
    fn later_events_land_later(paces in paces(), u in 0.05..0.9_f64, further in 0.0..0.1_f64) {
        let takes: Vec<Demonstration> =
            paces.iter().map(|pace| pace.take(&[u, u + further])).collect();
        let found = align_to_mean(&takes, 100.0, &mut |_, _| Ok(())).unwrap();
        let course = Course { motion_s: found.aligned.duration_s(), rate_hz: 100.0, ends: None };
        let story = learned(&takes, &found.aligned.t_s, &found.recorded_s(), &course);
        prop_assert!(story.is_sorted_by(|a, b| a.phase <= b.phase));
        prop_assert!(check_model(&story).is_ok());
    }

    #[test]
    fn the_common_time_never_goes_back(
        steps in proptest::collection::vec(0.0..1.0_f64, 2..30),
        stands in proptest::collection::vec(any::<bool>(), 30),
        mut asked in proptest::collection::vec(-1.0..30.0_f64, 2..20),
    ) {
        let clock: Vec<f64> = steps
            .iter()
            .zip(&stands)
            .scan(0.0, |sum, (step, stands)| {
                *sum += if *stands { 0.0 } else { *step };
                Some(*sum)
            })
            .collect();
        let t_s: Vec<f64> = (0..clock.len()).map(|i| i as f64).collect();
        asked.sort_by(f64::total_cmp);
        let common: Vec<f64> = asked.iter().map(|own| common_time_s(&t_s, &clock, *own)).collect();
        prop_assert!(common.is_sorted());
        prop_assert!(common.iter().all(|t| (0.0..=t_s[t_s.len() - 1]).contains(t)));
    }
}

#[test]
fn a_clock_that_stands_still_gives_the_middle_of_its_rest() {
    let (t_s, clock) = ([0.0, 1.0, 2.0, 3.0, 4.0], [0.0, 1.0, 1.0, 1.0, 2.0]);
    let at = |own| common_time_s(&t_s, &clock, own);
    assert_eq!([at(0.5), at(1.0), at(1.5), at(9.0)], [0.5, 2.0, 3.5, 4.0]);
}

#[test]
fn an_event_before_the_arm_moves_keeps_the_wait_behind_it() {
    // Still for 2 s, then 4 s of motion; the gripper closes after half a second.
    let times: Vec<f64> = (0..=300).map(|i| 0.02 * f64::from(i)).collect();
    let rows = times
        .iter()
        .map(|t| vec![10.0 * (t - 2.0).max(0.0)])
        .collect();
    let still = Demonstration::new("take".into(), times, rows, None).unwrap();
    let worked = still
        .clone()
        .with_signals(vec![event("Gripper", 0.5, true)])
        .unwrap();
    let starts = |take: &Demonstration| {
        let takes = [take.clone()];
        align_to_mean(&takes, 100.0, &mut |_, _| Ok(()))
            .unwrap()
            .origins_s[0]
    };
    assert!((starts(&still) - 1.72).abs() < 0.03, "{}", starts(&still));
    assert!((starts(&worked) - 0.2).abs() < 0.03, "{}", starts(&worked));
}

#[test]
fn how_a_signal_stood_at_the_beginning_is_no_change() {
    let events = [
        event("Gripper", 0.0, false),
        event("Gripper", 1.0, false),
        event("Gripper", 2.0, true),
        event("Vacuum", 2.5, false),
        event("Gripper", 3.0, true),
        event("Gripper", 4.0, false),
    ];
    let told: Vec<(f64, bool)> = changes(&events, 0.0)
        .iter()
        .map(|e| (e.at_s, e.on))
        .collect();
    assert_eq!(told, [(2.0, true), (2.5, false), (4.0, false)]);
}

#[test]
fn the_take_that_tells_another_story_is_named_with_what_it_does() {
    let pace = Pace {
        duration_s: 4.0,
        bend: 1.0,
    };
    let named = |name: &str, places: &[f64]| {
        let plain = pace.take(&[]);
        let joints = plain.joints_deg().rows().map(<[f64]>::to_vec).collect();
        let take = Demonstration::new(name.into(), plain.times_s().to_vec(), joints, None).unwrap();
        take.with_signals(pace.take(places).signals().to_vec())
            .unwrap()
    };
    let [one, two, three] = [
        named("take 1", &[0.3]),
        named("take 2", &[0.3, 0.7]),
        named("take 3", &[0.4, 0.6]),
    ];
    assert_eq!(check_same(&[two.clone(), three.clone()]), Ok(()));
    let error = check_same(&[one, two, three]).unwrap_err();
    assert_eq!(error.code(), "signals_differ");
    assert_eq!(
        error.to_string(),
        "take 1 works the signals differently (Gripper switched on) from take 2 (Gripper switched on, then Gripper switched off)"
    );
    let silent = check_same(&[named("take 1", &[]), named("take 2", &[0.5])]).unwrap_err();
    assert!(silent.to_string().contains("no signal is worked"));
}

#[test]
fn an_eased_motion_reaches_its_places_later_than_it_was_shown() {
    let ends = crate::regression::Ends {
        start_deg: vec![0.0],
        end_deg: vec![1.0],
        fade_s: 1.0,
        ease_s: 1.0,
    };
    let course = Course {
        motion_s: 9.0,
        rate_hz: 100.0,
        ends: Some(ends),
    };
    // Each end takes half the easing longer: the middle stays the middle of 10 s, and all
    // that is not eased lies half a second later.
    for (shown_s, at_s) in [(4.5, 5.0), (2.0, 2.5), (7.0, 7.5), (0.0, 0.0)] {
        assert!(
            (10.0 * course.phase_at(shown_s) - at_s).abs() < 1e-9,
            "{shown_s}"
        );
    }
    let plain = Course {
        ends: None,
        ..course
    };
    assert!((plain.phase_at(4.5) - 0.5).abs() < 1e-12);
}

#[test]
fn events_that_cannot_be_are_refused_with_their_place() {
    let pace = Pace {
        duration_s: 4.0,
        bend: 1.0,
    };
    for (bad, row) in [
        (vec![event("Gripper", 1.0, true), event("", 2.0, true)], 2),
        (vec![event("Gripper", f64::NAN, true)], 1),
        (vec![event("Gripper", 4.1, true)], 1),
        (vec![event("Gripper", -0.1, true)], 1),
    ] {
        let error = pace.take(&[]).with_signals(bad).unwrap_err();
        assert_eq!(error.where_().row, Some(row), "{error}");
        assert_eq!(error.code(), "demonstration_signal_bad");
    }
}
