//! Gaussian mixture regression (GMR): the joints given the time.

use serde::{Deserialize, Serialize};

use crate::{mixture::Mixture, path::Path};

/// Conditional mean and covariance of the joints over time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Regression {
    /// Times, seconds.
    pub t_s: Vec<f64>,
    /// Mean of the joints at each time, degrees.
    pub mean_deg: Path,
    /// Covariance of the joints at each time, row after row, degrees².
    pub covariance_deg2: Path,
}

impl Regression {
    /// Standard deviation of each joint at each time, degrees.
    pub fn std_deg(&self) -> Path {
        let d = self.mean_deg.width();
        let mut path = Path::with_capacity(d, self.t_s.len());
        for covariance in self.covariance_deg2.rows() {
            let row: Vec<f64> = (0..d)
                .map(|j| covariance[j * d + j].max(0.0).sqrt())
                .collect();
            path.push(&row);
        }
        path
    }
}

/// Regresses the joints (dimensions 1..) on the time (dimension 0) at `t_s`.
///
/// q(t) = sum_i h_i(t) (mu_q + S_qt / S_tt (t - mu_t)), with h_i(t) the share of
/// component i at t; the covariance adds the components' own and the spread of
/// their means (law of total variance).
pub fn regress(mixture: &Mixture, t_s: &[f64]) -> Regression {
    let d = mixture.means[0].len() - 1;
    let mut mean_deg = Path::with_capacity(d, t_s.len());
    let mut covariance_deg2 = Path::with_capacity(d * d, t_s.len());
    for &t in t_s {
        let (mean, covariance) = condition(mixture, t, d);
        mean_deg.push(&mean);
        covariance_deg2.push(&covariance);
    }
    Regression {
        t_s: t_s.to_vec(),
        mean_deg,
        covariance_deg2,
    }
}

fn condition(mixture: &Mixture, t: f64, d: usize) -> (Vec<f64>, Vec<f64>) {
    let shares = shares(mixture, t);
    let mut mean = vec![0.0; d];
    let mut second = vec![0.0; d * d];
    for (c, &share) in shares.iter().enumerate() {
        let (centre, covariance) = (&mixture.means[c], &mixture.covariances[c]);
        let slope: Vec<f64> = (0..d)
            .map(|i| covariance[i + 1][0] / covariance[0][0])
            .collect();
        let local: Vec<f64> = (0..d)
            .map(|i| centre[i + 1] + slope[i] * (t - centre[0]))
            .collect();
        for i in 0..d {
            mean[i] += share * local[i];
            for j in 0..d {
                let conditional = covariance[i + 1][j + 1] - slope[i] * covariance[0][j + 1];
                second[i * d + j] += share * (conditional + local[i] * local[j]);
            }
        }
    }
    for i in 0..d {
        for j in 0..d {
            second[i * d + j] -= mean[i] * mean[j];
        }
    }
    (mean, second)
}

/// Share of each component at time `t`; computed from logarithms so that times far
/// from every component still have one.
fn shares(mixture: &Mixture, t: f64) -> Vec<f64> {
    let logs: Vec<f64> = (0..mixture.weights.len())
        .map(|c| {
            let variance = mixture.covariances[c][0][0];
            let offset = t - mixture.means[c][0];
            mixture.weights[c].ln() - 0.5 * (variance.ln() + offset * offset / variance)
        })
        .collect();
    let max = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let powers: Vec<f64> = logs.iter().map(|log| (log - max).exp()).collect();
    let sum: f64 = powers.iter().sum();
    powers.iter().map(|p| p / sum).collect()
}

#[cfg(test)]
mod tests;
