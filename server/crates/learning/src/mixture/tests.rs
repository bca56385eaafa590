//! Mixtures against scikit-learn and against what EM guarantees.

use proptest::prelude::*;

use super::{gaussian::Component, *};
use crate::vector::LANES;

/// A mixture in three dimensions and the log densities that scikit-learn 1.9.1
/// (GaussianMixture.score_samples) gives for four points.
#[test]
fn log_densities_are_those_of_scikit_learn() {
    let mixture = Mixture {
        weights: vec![0.3, 0.7],
        means: vec![vec![0.0, 1.0, -2.0], vec![3.0, -1.0, 0.5]],
        covariances: vec![
            vec![
                vec![1.0, 0.3, 0.1],
                vec![0.3, 0.8, -0.2],
                vec![0.1, -0.2, 0.5],
            ],
            vec![
                vec![2.0, -0.4, 0.2],
                vec![-0.4, 1.5, 0.3],
                vec![0.2, 0.3, 0.9],
            ],
        ],
    };
    let points = [
        0.1, 0.9, -1.8, 2.5, 0.0, 0.0, 10.0, -10.0, 5.0, -40.0, 3.0, 2.0,
    ];
    let expected = [
        -3.391_656_943_548_471_6,
        -4.145_847_677_657_731,
        -55.884_050_847_596_62,
        -503.044_544_674_757,
    ];
    let components = prepare::<3>(&mixture).unwrap();
    let samples = std::array::from_fn(|d| std::array::from_fn(|lane| points[lane % 4 * 3 + d]));
    let [first, second] = [0, 1].map(|c| components[c].log_weighted::<true>(&samples));
    for (lane, expected) in expected.into_iter().enumerate() {
        let max = f64::max(first[lane], second[lane]);
        let found = max + ((first[lane] - max).exp() + (second[lane] - max).exp()).ln();
        assert!((found / expected - 1.0).abs() < 1e-13, "{found} {expected}");
    }
}

/// 25 points of a noisy arc, and what EM of scikit-learn 1.9.1 makes of them from
/// the halves t < 1.9 and t > 1.9 (tol 1e-3, reg_covar 1e-6).
#[test]
fn em_from_given_clusters_is_that_of_scikit_learn() {
    let heights = [
        -0.241, 1.262, 3.197, 4.92, 6.525, 7.435, 8.249, 8.959, 9.944, 10.465, 10.036, 9.287,
        8.805, 8.757, 7.292, 5.465, 4.548, 2.685, 1.222, -0.397, -2.12, -3.342, -5.032, -6.556,
        -7.445,
    ];
    let values: Vec<f64> = heights
        .iter()
        .enumerate()
        .flat_map(|(i, h)| [i as f64 / 6.0, *h])
        .collect();
    let labels: Vec<u16> = (0..25).map(|i| u16::from(i as f64 / 6.0 > 1.9)).collect();
    let all: Vec<usize> = (0..25).collect();
    let data = Blocks::<2>::gather(Rows::new(2, &values), &all);
    let fit = em::maximise(&data, &labels, 2).unwrap();
    assert!(fit.converged);
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-11 * b.abs().max(1.0), "{a} {b}");
    assert_eq!(fit.log_likelihoods.len(), 2);
    close(fit.log_likelihoods[0], -2.634_227_731_376_326);
    close(fit.log_likelihoods[1], -2.633_770_366_842_073_3);
    let mixture = fit.mixture;
    close(mixture.weights[0], 0.482_195_644_399_448_45);
    close(mixture.means[0][0], 0.921_600_617_625_843_6);
    close(mixture.means[0][1], 6.679_554_711_163_59);
    close(mixture.means[1][1], 1.035_039_211_146_663_5);
    close(mixture.covariances[0][0][1], 1.862_334_497_258_211);
    close(mixture.covariances[1][0][1], -3.394_353_633_721_934_7);
    close(mixture.covariances[1][1][1], 29.977_884_523_246_647);
}

fn arc(points: usize, noise: f64, seed: u64) -> Vec<f64> {
    let mut rng = Stream::derive(seed, &[]);
    (0..points)
        .flat_map(|i| {
            let t = 6.0 * i as f64 / points as f64;
            [
                t,
                30.0 * t.sin() + noise * rng.normal(),
                10.0 * t.cos() + noise * rng.normal(),
            ]
        })
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn em_never_lowers_the_likelihood(seed in 0u64..1000, k in 1usize..7, noise in 0.1..5.0f64) {
        let values = arc(300, noise, seed);
        let all: Vec<usize> = (0..300).collect();
        let fit = fit(Rows::new(3, &values), &all, k, &mut Stream::derive(seed, &[9])).unwrap();
        for pair in fit.log_likelihoods.windows(2) {
            // The regularisation of the covariances may cost a little.
            prop_assert!(pair[1] >= pair[0] - 1e-6, "{:?}", fit.log_likelihoods);
        }
        let total: f64 = fit.mixture.weights.iter().sum();
        prop_assert!((total - 1.0).abs() < 1e-12);
    }
}

#[test]
fn one_component_has_the_mean_and_covariance_of_the_data() {
    let values = arc(257, 1.0, 3);
    let rows = Rows::new(3, &values);
    let all: Vec<usize> = (0..rows.len()).collect();
    let fit = fit(rows, &all, 1, &mut Stream::derive(1, &[])).unwrap();
    let n = rows.len() as f64;
    let mean = |d: usize| (0..rows.len()).map(|i| rows.row(i)[d]).sum::<f64>() / n;
    for i in 0..3 {
        assert!((fit.mixture.means[0][i] - mean(i)).abs() < 1e-9);
        for j in 0..3 {
            let covariance = (0..rows.len())
                .map(|r| (rows.row(r)[i] - mean(i)) * (rows.row(r)[j] - mean(j)))
                .sum::<f64>()
                / n
                + if i == j { 1e-6 } else { 0.0 };
            assert!((fit.mixture.covariances[0][i][j] - covariance).abs() < 1e-9);
        }
    }
}

#[test]
fn well_separated_clusters_are_found() {
    let mut rng = Stream::derive(4, &[]);
    let centres = [[0.0, 0.0], [50.0, 0.0], [0.0, 50.0], [50.0, 50.0]];
    let values: Vec<f64> = (0..400)
        .flat_map(|i| centres[i % 4].map(|c| c + rng.normal()))
        .collect();
    let all: Vec<usize> = (0..400).collect();
    let mixture = fit(Rows::new(2, &values), &all, 4, &mut rng)
        .unwrap()
        .mixture;
    for centre in centres {
        let near = |mean: &Vec<f64>| (mean[0] - centre[0]).hypot(mean[1] - centre[1]) < 0.5;
        assert_eq!(
            mixture.means.iter().filter(|m| near(m)).count(),
            1,
            "{centre:?}"
        );
    }
}

#[test]
fn a_joint_that_never_moves_is_no_trouble() {
    let values: Vec<f64> = (0..200)
        .flat_map(|i| [f64::from(i), (f64::from(i) * 0.1).sin(), 7.0])
        .collect();
    let all: Vec<usize> = (0..200).collect();
    let mixture = fit(Rows::new(3, &values), &all, 3, &mut Stream::derive(1, &[]))
        .unwrap()
        .mixture;
    for mean in &mixture.means {
        assert!((mean[2] - 7.0).abs() < 1e-9);
    }
}

#[test]
fn samples_have_the_mixtures_mean_and_variance() {
    let mixture = Mixture {
        weights: vec![0.25, 0.75],
        means: vec![vec![-3.0, 1.0], vec![5.0, 2.0]],
        covariances: vec![
            vec![vec![1.0, 0.5], vec![0.5, 2.0]],
            vec![vec![0.5, -0.2], vec![-0.2, 0.3]],
        ],
    };
    let components = prepare::<2>(&mixture).unwrap();
    let (mut count, mut sum, mut squares) = (0usize, 0.0, 0.0);
    let mut rng = Stream::derive(8, &[]);
    for (component, blocks) in components.iter().zip([50_000 / LANES, 150_000 / LANES]) {
        for _ in 0..blocks {
            for x in component.draw::<true>(&mut rng)[0] {
                count += 1;
                sum += x;
                squares += x * x;
            }
        }
    }
    let mean = sum / count as f64;
    let variance = squares / count as f64 - mean * mean;
    // 0.25 * -3 + 0.75 * 5 = 3; within + between: 0.625 + 0.25 * 36 + 0.75 * 4.
    assert!((mean - 3.0).abs() < 5.0 * (12.625f64 / 200_000.0).sqrt());
    assert!((variance - 12.625).abs() < 0.15, "{variance}");
}

/// The E step as it is written down: every sample, every component.
fn plain_step(data: &Blocks<3>, components: &[Component<3>]) -> (f64, Vec<f64>, Vec<[f64; 3]>) {
    let k = components.len();
    let (mut total, mut mass, mut first) = (0.0, vec![0.0; k], vec![[0.0; 3]; k]);
    for i in 0..data.len() {
        let x = data.sample(i);
        let densities: Vec<f64> = components
            .iter()
            .map(|c| {
                let covariance = nalgebra::Matrix3::from_fn(|i, j| c.covariance[i][j]);
                let d = nalgebra::Vector3::from_fn(|i, _| x[i] - c.mean[i]);
                let square = d.dot(&(covariance.try_inverse().unwrap() * d));
                let scale = (2.0 * std::f64::consts::PI).powi(3) * covariance.determinant();
                c.weight.ln() - 0.5 * (scale.ln() + square)
            })
            .collect();
        let max = densities.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let sum: f64 = densities.iter().map(|log| (log - max).exp()).sum();
        total += max + sum.ln();
        for (c, log) in densities.iter().enumerate() {
            let share = (log - max).exp() / sum;
            mass[c] += share;
            for (f, x) in first[c].iter_mut().zip(x) {
                *f += share * x;
            }
        }
    }
    (total, mass, first)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Whatever the components do from step to step, small moves and jumps, looking
    /// only at what matters gives what looking at everything gives.
    #[test]
    fn the_e_step_is_the_plain_one(
        seed in 0u64..1000, samples in 20usize..400, k in 1usize..6, noise in 0.01..5.0f64,
    ) {
        let values = arc(samples, noise, seed);
        let rows = Rows::new(3, &values);
        let data = Blocks::<3>::gather(rows, &rows.by_time());
        let mut rng = Stream::derive(seed, &[17]);
        let mut components: Vec<Component<3>> = (0..k)
            .map(|_| Component {
                weight: 1.0 / k as f64,
                mean: data.sample(rng.below(samples)),
                covariance: [[1.0, 0.1, 0.0], [0.1, 20.0, 1.0], [0.0, 1.0, 5.0]],
            })
            .collect();
        let mut expectation = expectation::Expectation::new(&data, k);
        for step in [0.0, 1e-6, 1e-3, 0.1, 1.0, 10.0, 0.01] {
            for c in &mut components {
                for i in 0..3 {
                    c.mean[i] += step * rng.normal();
                    c.covariance[i][i] *= (0.3 * step.min(1.0) * rng.normal()).exp();
                }
                c.covariance[1][1] += 0.1;
                c.covariance[2][2] += 0.1;
            }
            let gaussians = components.iter().map(|c| Gaussian::new(c).unwrap()).collect();
            let (total, moments) = expectation.step(gaussians);
            let (plain, mass, first) = plain_step(&data, &components);
            // Each sample may lose shares of 1e-7 of each component.
            let lost = 1e-7 * k as f64 * samples as f64;
            prop_assert!((total - plain).abs() < lost + 1e-11 * plain.abs(), "{total} {plain}");
            for c in 0..k {
                prop_assert!((moments[c].zeroth - mass[c]).abs() < lost);
                for i in 0..3 {
                    prop_assert!((moments[c].first[i] - first[c][i]).abs() < 60.0 * lost);
                }
            }
        }
    }

    /// Every sample is labelled with its nearest centre, and every centre is the mean
    /// of its samples: what Lloyd's iterations end with (or their tolerance).
    #[test]
    fn k_means_ends_where_lloyds_iterations_end(
        seed in 0u64..1000, samples in 20usize..400, k in 1usize..9, noise in 0.01..5.0f64,
    ) {
        let values = arc(samples, noise, seed);
        let rows = Rows::new(3, &values);
        let data = Blocks::<3>::gather(rows, &rows.by_time());
        let labels = kmeans::cluster(&data, k, &mut Stream::derive(seed, &[5]));
        let mut centres = vec![[0.0; 3]; k];
        let mut counts = vec![0.0; k];
        for (i, &label) in labels.iter().enumerate() {
            counts[usize::from(label)] += 1.0;
            for (c, x) in centres[usize::from(label)].iter_mut().zip(data.sample(i)) {
                *c += x;
            }
        }
        prop_assert!(counts.iter().all(|&count| count > 0.0));
        for (centre, count) in centres.iter_mut().zip(&counts) {
            *centre = centre.map(|c| c / count);
        }
        let distance = |a: &[f64; 3], b: &[f64; 3]| -> f64 {
            a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
        };
        let spread = (0..samples).map(|i| distance(&data.sample(i), &[0.0; 3])).fold(0.0, f64::max);
        for (i, &label) in labels.iter().enumerate() {
            let own = distance(&data.sample(i), &centres[usize::from(label)]);
            let least = centres.iter().map(|c| distance(&data.sample(i), c)).fold(f64::INFINITY, f64::min);
            // The centres may still move by the tolerance of the iterations.
            prop_assert!(own <= least + 0.05 * spread, "{own} {least}");
        }
    }
}
