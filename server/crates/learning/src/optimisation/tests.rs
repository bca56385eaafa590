//! The optimiser on functions whose minimum is known.

use super::*;

fn search() -> SearchBox {
    SearchBox {
        low: [5, 50],
        high: [30, 200],
        step: [1, 1],
        max_calls: 100,
    }
}

fn run(seed: u64, f: impl Fn(f64, f64) -> f64) -> Optimum {
    minimise(&search(), seed, &mut |[a, b]| {
        Ok(f(f64::from(a), f64::from(b)))
    })
    .unwrap()
}

#[test]
fn it_finds_the_bottom_of_a_bowl() {
    for seed in 0..8 {
        let optimum = run(seed, |a, b| {
            10.0 + (a - 17.0).powi(2) / 10.0 + ((b - 120.0) / 30.0).powi(2)
        });
        assert_eq!(optimum.best.point, [17, 120], "seed {seed}");
        assert!(
            optimum.evaluations.len() < 80,
            "{}",
            optimum.evaluations.len()
        );
    }
}

#[test]
fn it_finds_a_minimum_on_the_edge() {
    for seed in 0..8 {
        let optimum = run(seed, |a, b| 50.0 - a + (200.0 - b) * 0.1);
        assert_eq!(optimum.best.point, [30, 200], "seed {seed}");
    }
}

#[test]
fn it_never_leaves_the_box_and_reports_what_it_saw() {
    let optimum = run(3, |a, b| (0.3 * a).sin() * 5.0 + (0.05 * b).cos());
    for evaluation in &optimum.evaluations {
        let [a, b] = evaluation.point;
        assert!((5..=30).contains(&a) && (50..=200).contains(&b));
        assert!(evaluation.value >= optimum.best.value);
    }
}

#[test]
fn the_same_seed_asks_the_same_questions() {
    let f = |a: f64, b: f64| (a - 9.0).abs() + (b - 90.0).abs() * 0.02;
    assert_eq!(run(5, f), run(5, f));
    assert_ne!(run(5, f).evaluations, run(6, f).evaluations);
}

#[test]
fn an_objective_that_fails_ends_the_search() {
    let result = minimise(&search(), 1, &mut |_| Err(Error::Cancelled));
    assert_eq!(result.unwrap_err(), Error::Cancelled);
}

/// E[max(t - f, 0)] by quadrature of its definition.
#[test]
fn expected_improvement_is_its_integral() {
    for (target, mean, deviation) in [(1.0, 0.5, 0.3), (0.0, 1.0, 2.0), (-1.0, 4.0, 1.5)] {
        let step = 1e-4;
        let integral: f64 = (-100_000..100_000)
            .map(|i| {
                let z = f64::from(i) * step;
                let density = (-0.5 * z * z).exp() / (2.0 * std::f64::consts::PI).sqrt();
                (target - mean - deviation * z).max(0.0) * density * step
            })
            .sum();
        let found = acquisition::expected_improvement(target, mean, deviation);
        assert!((found - integral).abs() < 1e-7, "{found} {integral}");
    }
    assert_eq!(acquisition::expected_improvement(3.0, 1.0, 0.0), 2.0);
}

/// 25 values of a smooth function on a grid: between them the process must know it
/// far better than its spread (2.6), and doubt what lies outside.
#[test]
fn the_process_knows_a_smooth_function_between_its_points_and_doubts_what_is_outside() {
    let f = |[x, y]: [f64; 2]| (3.0 * x).sin() + 2.0 * (y - 0.4) * (y - 0.4) + x * y;
    let inputs: Vec<[f64; 2]> = (0..25)
        .map(|i| [f64::from(i % 5) / 4.0, f64::from(i / 5) / 4.0])
        .collect();
    let values: Vec<f64> = inputs.iter().map(|x| f(*x)).collect();
    let mut rng = Stream::derive(1, &[]);
    let process = GaussianProcess::fit(&inputs, &values, None, &mut rng).unwrap();
    for input in [[0.1, 0.1], [0.4, 0.6], [0.85, 0.3], [0.6, 0.9]] {
        let (mean, deviation) = process.predict(input);
        assert!(
            (mean - f(input)).abs() < 0.03,
            "{input:?}: {mean} {}",
            f(input)
        );
        assert!(deviation < 0.1, "{input:?}: {deviation}");
    }
    let (_, inside) = process.predict([0.4, 0.6]);
    let (_, outside) = process.predict([2.5, 2.5]);
    assert!(outside > 10.0 * inside, "{inside} {outside}");
}
