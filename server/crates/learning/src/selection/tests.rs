//! The test statistic against SciPy, the distance against closed forms, the walk
//! against the paper's algorithm.

use super::*;
use crate::mixture::Mixture;

/// Values of SciPy 1.17.1, ttest_ind(equal_var=False, alternative="greater").
#[test]
fn welch_agrees_with_scipy() {
    let (a, b) = ([1.2, 2.3, 1.9, 2.8, 3.1], [0.9, 1.1, 1.4, 0.7, 1.3, 1.0]);
    assert!((welch::p_greater(&a, &b) - 0.010_367_993_931_531_838).abs() < 1e-12);
    assert!((welch::p_greater(&b, &a) - 0.989_632_006_068_468_1).abs() < 1e-12);
    let (c, d) = ([0.5, 0.52, 0.48], [0.51, 0.47, 0.55, 0.49]);
    assert!((welch::p_greater(&c, &d) - 0.590_856_428_081_233_4).abs() < 1e-12);
}

#[test]
fn welch_without_variance_compares_the_means() {
    assert_eq!(welch::p_greater(&[2.0, 2.0], &[1.0, 1.0]), 0.0);
    assert_eq!(welch::p_greater(&[1.0, 1.0], &[1.0, 1.0]), 1.0);
    assert_eq!(welch::p_greater(&[1.0], &[0.0, 0.1]), 1.0);
}

fn normal(mean: f64, deviation: f64) -> Mixture {
    Mixture {
        weights: vec![1.0],
        means: vec![vec![mean]],
        covariances: vec![vec![vec![deviation * deviation]]],
    }
}

#[test]
fn equal_mixtures_have_no_distance_and_strangers_the_largest() {
    let mut rng = Stream::derive(1, &[]);
    let same = js::distance(&normal(1.0, 2.0), &normal(1.0, 2.0), &mut rng).unwrap();
    assert_eq!(same, 0.0);
    let far = js::distance(&normal(0.0, 1.0), &normal(1000.0, 1.0), &mut rng).unwrap();
    assert!((far - std::f64::consts::LN_2.sqrt()).abs() < 1e-9);
}

/// The divergence of two normal distributions by quadrature of its definition.
#[test]
fn the_distance_of_two_normals_is_that_of_numerical_integration() {
    for (m, s) in [(0.5, 1.0), (2.0, 1.0), (0.0, 3.0), (1.0, 0.2)] {
        let density = |x: f64, mean: f64, deviation: f64| {
            let z = (x - mean) / deviation;
            (-0.5 * z * z).exp() / (deviation * (2.0 * std::f64::consts::PI).sqrt())
        };
        let step = 1e-3;
        let divergence: f64 = (-40_000..40_000)
            .map(|i| {
                let x = f64::from(i) * step;
                let (p, q) = (density(x, 0.0, 1.0), density(x, m, s));
                let mean = 0.5 * (p + q);
                let term = |a: f64| if a > 1e-300 { a * (a / mean).ln() } else { 0.0 };
                0.5 * (term(p) + term(q)) * step
            })
            .sum();
        let mut rng = Stream::derive(2, &[]);
        let found = js::distance(&normal(0.0, 1.0), &normal(m, s), &mut rng).unwrap();
        // Four standard errors.
        assert!(
            (found / divergence.sqrt() - 1.0).abs() < 4.0 * js::ACCURACY,
            "{m} {s}: {found} {divergence}"
        );
    }
}

fn values(k: usize, mean: f64, spread: f64) -> Stability {
    let values = (0..50)
        .map(|i| mean + spread * (f64::from(i) - 24.5) / 24.5)
        .collect();
    Stability::of(k, values)
}

#[test]
fn the_walk_stays_at_a_minimum_that_is_clearly_best() {
    let candidates = [
        values(2, 0.3, 0.1),
        values(3, 0.1, 0.1),
        values(4, 0.4, 0.01),
    ];
    assert_eq!(choose(&candidates), 3);
}

#[test]
fn among_equals_the_walk_moves_to_less_scatter() {
    let candidates = [
        values(2, 0.100, 0.1),
        values(3, 0.101, 0.02),
        values(4, 0.5, 0.001),
    ];
    assert_eq!(choose(&candidates), 3);
    let steadier_first = [values(2, 0.100, 0.02), values(3, 0.101, 0.1)];
    assert_eq!(choose(&steadier_first), 2);
}

#[test]
fn the_first_of_equal_minima_is_where_the_walk_begins() {
    let candidates = [values(5, 0.2, 0.05), values(6, 0.2, 0.05)];
    assert_eq!(choose(&candidates), 5);
}

#[test]
fn splits_do_not_depend_on_the_number_of_threads() {
    let mut rng = Stream::derive(6, &[]);
    let data: Vec<f64> = (0..400)
        .flat_map(|i| {
            [
                f64::from(i) * 0.01,
                (f64::from(i) * 0.03).sin() + 0.1 * rng.normal(),
            ]
        })
        .collect();
    let params = SelectionParams {
        k_min: 2,
        k_max: 3,
        splits: 4,
    };
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| stabilities(Rows::new(2, &data), &params, 5, &|| Ok(())).unwrap())
    };
    let one = run(1);
    assert_eq!(one, run(3));
    assert_eq!(one.len(), 2);
    assert!(one.iter().all(|s| s.values.len() == 4));
}
