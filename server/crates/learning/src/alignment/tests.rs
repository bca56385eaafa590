//! DTW against brute force, and what alignment must do for its users.

use proptest::prelude::*;

use super::*;

/// Cheapest of all warpings, by trying every one.
fn brute_force(a: &[f64], b: &[f64], i: usize, j: usize) -> f64 {
    let here = (a[i] - b[j]) * (a[i] - b[j]);
    let rest = match (i, j) {
        (0, 0) => return here,
        (0, _) => brute_force(a, b, 0, j - 1),
        (_, 0) => brute_force(a, b, i - 1, 0),
        _ => brute_force(a, b, i - 1, j - 1)
            .min(brute_force(a, b, i - 1, j))
            .min(brute_force(a, b, i, j - 1)),
    };
    here + rest
}

fn path(values: &[f64]) -> Path {
    Path::from_rows(1, values.iter().map(|v| [*v]))
}

fn cost(a: &[f64], b: &[f64], warping: &[(usize, usize)]) -> f64 {
    warping.iter().map(|&(i, j)| (a[i] - b[j]).powi(2)).sum()
}

fn series() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-10.0..10.0f64, 1..7)
}

proptest! {
    #[test]
    fn the_distance_is_that_of_brute_force(a in series(), b in series()) {
        let expected = brute_force(&a, &b, a.len() - 1, b.len() - 1);
        let found = dtw::squared_distance(&path(&a), &path(&b));
        prop_assert!((found - expected).abs() <= 1e-9 * (1.0 + expected));
    }

    #[test]
    fn the_path_is_admissible_and_has_the_cost_of_brute_force(a in series(), b in series()) {
        let warping = dtw::warp(&path(&a), &path(&b), 0);
        prop_assert_eq!(warping[0], (0, 0));
        prop_assert_eq!(*warping.last().unwrap(), (a.len() - 1, b.len() - 1));
        for step in warping.windows(2) {
            let (di, dj) = (step[1].0 - step[0].0, step[1].1 - step[0].1);
            prop_assert!(matches!((di, dj), (1, 0) | (0, 1) | (1, 1)));
        }
        let expected = brute_force(&a, &b, a.len() - 1, b.len() - 1);
        prop_assert!((cost(&a, &b, &warping) - expected).abs() <= 1e-9 * (1.0 + expected));
    }

    #[test]
    fn relaxed_ends_are_the_best_of_all_cut_ends(a in series(), b in series()) {
        let psi = 2;
        let warping = dtw::warp(&path(&a), &path(&b), psi);
        let mut best = f64::INFINITY;
        // Either series may lose up to psi samples at either end, not both at the same end.
        let cuts = |n: usize| (0..=psi.min(n - 1)).collect::<Vec<_>>();
        for &i0 in &cuts(a.len()) { for &j0 in &cuts(b.len()) {
            for &i1 in &cuts(a.len()) { for &j1 in &cuts(b.len()) {
                if (i0 > 0 && j0 > 0) || (i1 > 0 && j1 > 0) { continue; }
                if i0 + i1 >= a.len() || j0 + j1 >= b.len() { continue; }
                let (x, y) = (&a[i0..a.len() - i1], &b[j0..b.len() - j1]);
                best = best.min(brute_force(x, y, x.len() - 1, y.len() - 1));
            }}
        }}
        prop_assert!((cost(&a, &b, &warping) - best).abs() <= 1e-9 * (1.0 + best));
    }

    #[test]
    fn the_distance_is_symmetric_and_zero_to_itself(a in series(), b in series()) {
        let (p, q) = (path(&a), path(&b));
        prop_assert_eq!(dtw::squared_distance(&p, &p), 0.0);
        let difference = dtw::squared_distance(&p, &q) - dtw::squared_distance(&q, &p);
        prop_assert!(difference.abs() < 1e-9);
    }
}

/// One joint that goes 0 -> 40 -> 10 deg, the clock bent by `warp`.
fn take(name: &str, samples: u32, warp: impl Fn(f64) -> f64) -> Demonstration {
    let times: Vec<f64> = (0..samples).map(|i| 0.02 * f64::from(i)).collect();
    let duration = times[times.len() - 1];
    let angles = times
        .iter()
        .map(|t| vec![shape(warp(t / duration))])
        .collect();
    Demonstration::new(name.into(), times, angles, None).unwrap()
}

fn shape(u: f64) -> f64 {
    if u < 0.5 {
        80.0 * u
    } else {
        40.0 - 60.0 * (u - 0.5)
    }
}

#[test]
fn takes_at_a_different_pace_fall_on_each_other() {
    let takes = [
        take("even", 200, |u| u),
        take("hasty", 150, |u| u.powf(1.4)),
        take("slow", 260, |u| u.powf(0.7)),
    ];
    let aligned = align(&takes, 100.0, &mut |_, _| Ok(())).unwrap();
    assert!((0..3).all(|i| aligned.joints_deg[i].len() == aligned.t_s.len()));
    let worst = (0..aligned.t_s.len())
        .flat_map(|t| (0..3).map(move |i| (t, i)))
        .map(|(t, i)| {
            let reference = &aligned.joints_deg[aligned.reference];
            (aligned.joints_deg[i].row(t)[0] - reference.row(t)[0]).abs()
        })
        .fold(0.0, f64::max);
    // A sample of the slowest take advances by at most 1 deg.
    assert!(worst < 1.0, "{worst}");
}

#[test]
fn the_common_clock_runs_at_the_rate_from_zero_to_the_end_of_the_reference() {
    let takes = [take("a", 200, |u| u), take("b", 201, |u| u)];
    let aligned = align(&takes, 100.0, &mut |_, _| Ok(())).unwrap();
    let duration = takes[aligned.reference].duration_s();
    assert_eq!(aligned.t_s[0], 0.0);
    assert_eq!(*aligned.t_s.last().unwrap(), duration);
    assert_eq!(aligned.t_s.len(), (duration * 100.0).round() as usize + 1);
}

#[test]
fn the_most_typical_take_is_the_reference() {
    let shifted = |by: f64| {
        let base = take("x", 150, |u| u);
        let angles = base
            .joints_deg()
            .rows()
            .map(|row| vec![row[0] + by])
            .collect();
        Demonstration::new(format!("{by}"), base.times_s().to_vec(), angles, None).unwrap()
    };
    let takes = [shifted(0.0), shifted(1.0), shifted(0.6)];
    let aligned = align(&takes, 100.0, &mut |_, _| Ok(())).unwrap();
    assert_eq!(takes[aligned.reference].name(), "0.6");
}

#[test]
fn two_different_motions_are_refused_by_name() {
    let other = {
        let base = take("other", 150, |u| u);
        let angles = base
            .joints_deg()
            .rows()
            .map(|row| vec![-row[0] - 30.0])
            .collect();
        Demonstration::new("other".into(), base.times_s().to_vec(), angles, None).unwrap()
    };
    let takes = [take("a", 150, |u| u), take("b", 160, |u| u), other];
    let error = align(&takes, 100.0, &mut |_, _| Ok(())).unwrap_err();
    let Error::DifferentMotions { groups } = error else {
        panic!("{error}");
    };
    assert_eq!(
        groups,
        [vec!["a".to_string(), "b".into()], vec!["other".into()]]
    );
}

#[test]
fn alignment_can_be_cancelled() {
    let takes = [take("a", 150, |u| u), take("b", 160, |u| u)];
    let result = align(&takes, 100.0, &mut |_, _| Err(Error::Cancelled));
    assert_eq!(result.unwrap_err(), Error::Cancelled);
}

#[test]
fn ten_minutes_of_one_motion_are_one_motion() {
    // From pose to pose in 1.5 s each, every take at a pace of its own.
    let mut rng = crate::rng::Stream::derive(1, &[]);
    let mut draw = |reach: f64| reach * (2.0 * rng.uniform() - 1.0);
    let poses: Vec<Vec<f64>> = (0..=400)
        .map(|_| {
            let [swing, reach, wrist, turn] = [60.0, 25.0, 40.0, 90.0].map(&mut draw);
            vec![swing, 10.0 + reach, 10.0 - reach, wrist, 40.0, turn]
        })
        .collect();
    let takes: Vec<Demonstration> = (0..3)
        .map(|number| {
            let mut begins = vec![0.0];
            for at in 0..400 {
                begins.push(begins[at] + 1.5 + draw(0.5));
            }
            let poses = Path::from_rows(6, &poses);
            let times = even_times(begins[400], 20.0);
            let joints = interpolate(&begins, &poses, &times);
            let rows = joints.rows().map(<[f64]>::to_vec).collect();
            Demonstration::new(format!("take {number}"), times, rows, None).unwrap()
        })
        .collect();
    groups::check_same_motion(&takes).unwrap();
}
