//! Expectation maximisation for mixtures with full covariances.

use super::{
    Blocks, Fit, Mixture,
    blocks::Moments,
    expectation::Expectation,
    gaussian::{Component, Gaussian},
};
use crate::Error;

const MAX_ITERATIONS: usize = 100;
const TOLERANCE: f64 = 1e-3;
/// Added to the diagonal of each covariance, so that a joint that never moves
/// leaves it positive definite.
const REGULARISATION: f64 = 1e-6;
/// A component with less than this share of one sample has lost all.
const LOST: f64 = 1e-9;

/// Fits from the clusters `labels` (one of 0..k for each sample).
pub fn maximise<const D: usize>(data: &Blocks<D>, labels: &[u16], k: usize) -> Result<Fit, Error> {
    let mut components = components_of(&by_label(data, labels, k), data.len());
    let mut expectation = Expectation::new(data, k);
    let mut log_likelihoods = Vec::new();
    let mut converged = false;
    for _ in 0..MAX_ITERATIONS {
        let gaussians = components
            .iter()
            .map(Gaussian::new)
            .collect::<Result<Vec<_>, _>>()?;
        let (total, moments) = expectation.step(gaussians);
        let log_likelihood = total / data.len() as f64;
        if !log_likelihood.is_finite() {
            return Err(Error::MixtureFailed {
                reason: "the likelihood is not a number".into(),
            });
        }
        let before = log_likelihoods.last().copied();
        log_likelihoods.push(log_likelihood);
        components = components_of(&moments, data.len());
        if before.is_some_and(|b: f64| (log_likelihood - b).abs() < TOLERANCE) {
            converged = true;
            break;
        }
    }
    Ok(Fit {
        mixture: mixture_of(&components, data.centre()),
        log_likelihoods,
        converged,
    })
}

/// The M step: mean and covariance from the moments of each component.
fn components_of<const D: usize>(moments: &[Moments<D>], n: usize) -> Vec<Component<D>> {
    // A component that lost all its samples must not divide by zero, nor by what
    // rounding left of them.
    let moments: Vec<Moments<D>> = moments
        .iter()
        .map(|m| if m.zeroth > LOST { *m } else { Moments::ZERO })
        .collect();
    let mass = |m: &Moments<D>| m.zeroth + 10.0 * f64::EPSILON;
    let total: f64 = moments.iter().map(|m| mass(m) / n as f64).sum();
    moments
        .iter()
        .map(|m| {
            let mass = mass(m);
            let mean: [f64; D] = std::array::from_fn(|i| m.first[i] / mass);
            let covariance = std::array::from_fn(|i| {
                std::array::from_fn(|j| {
                    let centred = m.second[i.max(j)][i.min(j)] / mass - mean[i] * mean[j];
                    centred + if i == j { REGULARISATION } else { 0.0 }
                })
            });
            Component {
                weight: mass / n as f64 / total,
                mean,
                covariance,
            }
        })
        .collect()
}

fn by_label<const D: usize>(data: &Blocks<D>, labels: &[u16], k: usize) -> Vec<Moments<D>> {
    let mut sums = vec![Moments::ZERO; k];
    for (index, block) in data.moments().iter().enumerate() {
        let first = index * crate::vector::LANES;
        let labels = &labels[first..first + data.filled(index)];
        if labels.iter().all(|&label| label == labels[0]) {
            sums[usize::from(labels[0])].add(block);
        } else {
            for (lane, &label) in labels.iter().enumerate() {
                sums[usize::from(label)].add_sample(&data.sample(first + lane));
            }
        }
    }
    sums
}

fn mixture_of<const D: usize>(components: &[Component<D>], centre: &[f64; D]) -> Mixture {
    Mixture {
        weights: components.iter().map(|c| c.weight).collect(),
        means: components
            .iter()
            .map(|c| c.mean.iter().zip(centre).map(|(m, x)| m + x).collect())
            .collect(),
        covariances: components
            .iter()
            .map(|c| c.covariance.iter().map(|row| row.to_vec()).collect())
            .collect(),
    }
}
