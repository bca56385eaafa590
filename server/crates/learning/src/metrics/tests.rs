//! The figures on curves whose figures are known.

use super::*;
use crate::Demonstration;

fn wave(n: usize) -> Path {
    Path::from_rows(
        2,
        (0..n).map(|i| {
            let t = i as f64 * 0.05;
            [10.0 * t.sin() + t, 5.0 * (0.7 * t).cos()]
        }),
    )
}

#[test]
fn e_j_is_the_mean_absolute_difference() {
    assert_eq!(e_j_deg(&[1.0, 2.0, 3.0], &[2.0, 0.0, 3.0]), 1.0);
}

#[test]
fn objectives_of_a_constant_offset() {
    let a = wave(100);
    let b = Path::from_rows(2, a.rows().map(|row| [row[0] + 3.0, row[1] + 4.0]));
    // |offset| = 5 everywhere: sqrt(T) * 5 + 5, and 5 + 5 with the root mean square.
    assert!((objective(&a, &b) - (10.0 * 5.0 + 5.0)).abs() < 1e-9);
    assert!((objective_rms(&a, &b) - 10.0).abs() < 1e-9);
}

#[test]
fn gmcc_is_one_for_a_linear_image_and_with_centring_for_a_shifted_one() {
    let a = wave(200);
    let image = Path::from_rows(
        2,
        a.rows()
            .map(|r| [2.0 * r[0] - r[1], 0.5 * r[0] + 3.0 * r[1]]),
    );
    assert!((gmcc(&a, &image) - 1.0).abs() < 1e-9);
    let shifted = Path::from_rows(2, image.rows().map(|r| [r[0] + 100.0, r[1] - 40.0]));
    assert!((gmcc_both(&a, &shifted).centred - 1.0).abs() < 1e-9);
}

/// In one dimension the centred coefficient is the absolute correlation.
#[test]
fn in_one_dimension_gmcc_is_the_correlation() {
    let x = [1.0, 2.0, 3.0, 4.0, 6.0];
    let y = [2.0, 1.0, 4.0, 3.0, 7.0];
    // Sums about the means 3.2 and 3.4: 15.6, 14.8 and 21.2.
    let expected = 15.6 / (14.8f64 * 21.2).sqrt();
    let path = |v: [f64; 5]| Path::from_rows(1, v.map(|a| [a]));
    assert!((gmcc_both(&path(x), &path(y)).centred - expected).abs() < 1e-12);
}

#[test]
fn the_shorter_curve_waits_at_its_end() {
    let a = wave(100);
    let longer = Path::from_rows(2, a.rows().chain(std::iter::repeat_n(a.last(), 20)));
    assert!((gmcc(&a, &longer) - 1.0).abs() < 1e-9);
}

/// Joint 1 turns by 40 deg; joint 2 leans by `lean_deg`, which widens the circle.
fn swing(lean_deg: f64) -> Demonstration {
    let times: Vec<f64> = (0..201).map(|i| 0.02 * f64::from(i)).collect();
    let joints = times
        .iter()
        .map(|t| vec![10.0 * t, lean_deg, 0.0, 0.0, -40.0, 0.0])
        .collect();
    Demonstration::new(format!("{lean_deg}"), times, joints, None).unwrap()
}

#[test]
fn a_reproduction_of_the_only_demonstration_misses_nothing() {
    let demonstration = swing(0.0);
    let fidelity = fidelity(
        std::slice::from_ref(&demonstration),
        demonstration.joints_deg(),
        0.02,
    )
    .unwrap();
    assert_eq!(fidelity.missed_max_mm, 0.0);
    assert_eq!(fidelity.off_path_max_mm, 0.0);
    assert_eq!(fidelity.mutual_mean_mm, None);
    assert_eq!((fidelity.start_mm[0], fidelity.end_mm[0]), (0.0, 0.0));
    assert!((fidelity.duration_s - 4.0).abs() < 1e-9);
    assert!((fidelity.reproduction.peak_speed_deg_s - 10.0).abs() < 1e-6);
}

/// A turn of joint 1 moves the tool on a circle: the distances are chords.
#[test]
fn a_reproduction_that_stops_early_misses_the_end_by_the_chord() {
    let demonstration = swing(0.0);
    let half = Path::from_rows(6, demonstration.joints_deg().rows().take(101));
    let fidelity = fidelity(std::slice::from_ref(&demonstration), &half, 0.02).unwrap();
    let end = demonstration.tool_path_mm().unwrap()[200];
    let chord = 2.0 * end[0].hypot(end[1]) * 10f64.to_radians().sin();
    assert!((fidelity.missed_max_mm - chord).abs() < 1e-6);
    assert!((fidelity.end_mm[0] - chord).abs() < 1e-6);
    assert!(fidelity.off_path_max_mm < 1e-9);
}

#[test]
fn between_two_demonstrations_the_figures_are_relative_to_their_distance() {
    let takes = [swing(0.0), swing(2.0)];
    let middle = Path::from_rows(
        6,
        takes[0].joints_deg().rows().map(|r| {
            let mut row = r.to_vec();
            row[1] += 1.0;
            row
        }),
    );
    let fidelity = fidelity(&takes, &middle, 0.02).unwrap();
    let ratio = fidelity.missed_over_mutual.unwrap();
    // Half way between two curves that run side by side.
    assert!((ratio - 0.5).abs() < 0.01, "{ratio}");
}

#[test]
fn other_joint_counts_have_no_tool_path() {
    let times: Vec<f64> = (0..100).map(|i| 0.02 * f64::from(i)).collect();
    let joints = times.iter().map(|t| vec![10.0 * t, 0.0]).collect();
    let demonstration = Demonstration::new("two".into(), times, joints, None).unwrap();
    assert!(
        fidelity(
            std::slice::from_ref(&demonstration),
            demonstration.joints_deg(),
            0.02
        )
        .is_none()
    );
}
