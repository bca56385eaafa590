//! Gaussian process over the unit square: constant times Matérn 5/2 with one
//! length scale for each direction, plus white noise, on standardised values.

use nalgebra::{DMatrix, DVector};

use super::simplex;
use crate::rng::Stream;

/// Numerical floor on the diagonal.
const JITTER: f64 = 1e-10;
/// Random starts of the search for hyperparameters, beside the default and the
/// previous optimum.
const RESTARTS: usize = 2;

/// Natural logarithms of amplitude, two length scales and noise variance.
#[derive(Clone, Debug, PartialEq)]
pub struct Hyperparameters([f64; 4]);

/// Bounds of amplitude, length scales and noise (not logarithms).
const BOUNDS: [(f64, f64); 4] = [(0.01, 1000.0), (0.01, 100.0), (0.01, 100.0), (1e-5, 1e5)];

/// A process conditioned on observations.
pub struct GaussianProcess {
    hyperparameters: Hyperparameters,
    inputs: Vec<[f64; 2]>,
    mean: f64,
    deviation: f64,
    /// K⁻¹ of the standardised values.
    dual: DVector<f64>,
    /// Lower Cholesky factor of K.
    factor: DMatrix<f64>,
}

impl GaussianProcess {
    /// Conditions on `values` at `inputs`; hyperparameters maximise the marginal
    /// likelihood. None when no covariance can be factorised.
    pub fn fit(
        inputs: &[[f64; 2]],
        values: &[f64],
        previous: Option<&Hyperparameters>,
        rng: &mut Stream,
    ) -> Option<GaussianProcess> {
        let n = values.len() as f64;
        let mean = values.iter().sum::<f64>() / n;
        let variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n;
        let deviation = if variance > 0.0 { variance.sqrt() } else { 1.0 };
        let standard =
            DVector::from_iterator(values.len(), values.iter().map(|v| (v - mean) / deviation));
        let mut starts = vec![[0.0; 4]];
        starts.extend(previous.map(|p| p.0));
        for _ in 0..RESTARTS {
            starts
                .push(BOUNDS.map(|(low, high)| low.ln() + rng.uniform() * (high.ln() - low.ln())));
        }
        let cost = |log: &[f64; 4]| negative_log_likelihood(log, inputs, &standard);
        let bounds = BOUNDS.map(|(low, high)| (low.ln(), high.ln()));
        let best = starts
            .iter()
            .map(|start| simplex::minimise(&cost, *start, &bounds))
            .min_by(|a, b| a.1.total_cmp(&b.1))?;
        let factor = covariance(&best.0, inputs).cholesky()?;
        Some(GaussianProcess {
            hyperparameters: Hyperparameters(best.0),
            inputs: inputs.to_vec(),
            mean,
            deviation,
            dual: factor.solve(&standard),
            factor: factor.l(),
        })
    }

    pub fn hyperparameters(&self) -> &Hyperparameters {
        &self.hyperparameters
    }

    /// Mean and deviation of the noiseless objective at `input`.
    pub fn predict(&self, input: [f64; 2]) -> (f64, f64) {
        let log = &self.hyperparameters.0;
        let cross = DVector::from_iterator(
            self.inputs.len(),
            self.inputs.iter().map(|x| matern(log, x, &input)),
        );
        let mean = cross.dot(&self.dual);
        let explained = self
            .factor
            .solve_lower_triangular(&cross)
            .map_or(0.0, |v| v.norm_squared());
        let variance = (log[0].exp() - explained).max(0.0);
        (
            self.mean + self.deviation * mean,
            self.deviation * variance.sqrt(),
        )
    }
}

fn negative_log_likelihood(log: &[f64; 4], inputs: &[[f64; 2]], values: &DVector<f64>) -> f64 {
    let Some(factor) = covariance(log, inputs).cholesky() else {
        return f64::INFINITY;
    };
    let fit = values.dot(&factor.solve(values));
    let log_determinant: f64 = factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum();
    0.5 * fit + log_determinant
}

fn covariance(log: &[f64; 4], inputs: &[[f64; 2]]) -> DMatrix<f64> {
    let noise = log[3].exp() + JITTER;
    DMatrix::from_fn(inputs.len(), inputs.len(), |i, j| {
        matern(log, &inputs[i], &inputs[j]) + if i == j { noise } else { 0.0 }
    })
}

fn matern(log: &[f64; 4], a: &[f64; 2], b: &[f64; 2]) -> f64 {
    let first = (a[0] - b[0]) / log[1].exp();
    let second = (a[1] - b[1]) / log[2].exp();
    let r = (5.0 * (first * first + second * second)).sqrt();
    log[0].exp() * (1.0 + r + r * r / 3.0) * (-r).exp()
}
