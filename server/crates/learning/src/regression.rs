//! Gaussian mixture regression (GMR): the joints given the time.

use motion::minimum_jerk;
use serde::{Deserialize, Serialize};

use crate::{mixture::Mixture, path::Path, timeline::even_times};

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

/// How a motion is read off its mixture; with the mixture it gives the regression
/// again, so that a model file need not hold the curve.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Course {
    /// Duration of the aligned demonstrations, seconds.
    pub motion_s: f64,
    /// Rate of the regression, Hz.
    pub rate_hz: f64,
    /// How the ends are treated; as the mixture has them when missing.
    pub ends: Option<Ends>,
}

impl Course {
    /// The regression at equally spaced times from 0 to the end.
    pub fn regress(&self, mixture: &Mixture) -> Regression {
        match &self.ends {
            Some(ends) => regress_to_ends(mixture, ends, self.motion_s, self.rate_hz),
            None => regress(mixture, &even_times(self.motion_s, self.rate_hz)),
        }
    }

    /// How far the learned motion is when the demonstrations' common clock shows `t_s`,
    /// as a share of its duration, 0 to 1.
    pub(crate) fn phase_at(&self, t_s: f64) -> f64 {
        let Some(ends) = &self.ends else {
            return (t_s / self.motion_s).clamp(0.0, 1.0);
        };
        // The eased clock never goes back, so halving finds the moment.
        let whole_s = self.motion_s + ends.ease_s;
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if ends.demonstrated_time_s(middle * whole_s, self.motion_s) < t_s {
                low = middle;
            } else {
                high = middle;
            }
        }
        high
    }

    pub(crate) fn check(&self, joints: usize) -> Result<(), String> {
        let positive = |value: f64| value.is_finite() && value > 0.0;
        if !positive(self.motion_s) || !positive(self.rate_hz) || self.motion_s * self.rate_hz > 1e6
        {
            return Err("the duration or the rate is out of range".into());
        }
        let fits = |ends: &Ends| {
            ends.start_deg.len() == joints
                && ends.end_deg.len() == joints
                && positive(ends.fade_s)
                && positive(ends.ease_s)
                && ends.ease_s <= self.motion_s
        };
        if self.ends.as_ref().is_some_and(|ends| !fits(ends)) {
            return Err("the ends do not fit the motion".into());
        }
        Ok(())
    }
}

/// How the ends of a motion are treated: it begins and ends at rest, in the poses
/// where the demonstrations began and ended.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ends {
    /// The start, degrees.
    pub start_deg: Vec<f64>,
    /// The end, degrees.
    pub end_deg: Vec<f64>,
    /// Time over which the regression is led to its ends, seconds.
    pub fade_s: f64,
    /// Time over which the motion gathers speed and loses it again, seconds.
    pub ease_s: f64,
}

impl Ends {
    /// Where the clock of the demonstrations stands at `t_s` of the eased motion,
    /// which lasts `motion_s` on that clock and `ease_s` longer on its own. The path
    /// is the same; only the pace at its ends differs.
    fn demonstrated_time_s(&self, t_s: f64, motion_s: f64) -> f64 {
        let gathered = |t: f64| {
            let u = (t / self.ease_s).clamp(0.0, 1.0);
            // Integral of the pace 3u² - 2u³, which rises from 0 to 1 smoothly.
            self.ease_s * u * u * u * (1.0 - 0.5 * u) + (t - self.ease_s).max(0.0)
        };
        let whole = motion_s + self.ease_s;
        if t_s <= 0.5 * whole {
            gathered(t_s)
        } else {
            motion_s - gathered(whole - t_s)
        }
    }
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

/// Regression with its ends treated. The path is that of the mixture, its pace at
/// the ends eased:
/// what it lacks to the ends fades out smoothly (with minimum jerk).
fn regress_to_ends(mixture: &Mixture, ends: &Ends, motion_s: f64, rate_hz: f64) -> Regression {
    let t_s = even_times(motion_s + ends.ease_s, rate_hz);
    let demonstrated: Vec<f64> = t_s
        .iter()
        .map(|&t| ends.demonstrated_time_s(t, motion_s))
        .collect();
    let curve = regress(mixture, &demonstrated);
    let lack = |end: &[f64], row: &[f64]| -> Vec<f64> {
        end.iter().zip(row).map(|(p, q)| p - q).collect()
    };
    let at_start = lack(&ends.start_deg, curve.mean_deg.row(0));
    let at_end = lack(&ends.end_deg, curve.mean_deg.last());
    let share = |distance_s: f64| minimum_jerk::share(1.0 - distance_s / ends.fade_s);
    let mut mean_deg = Path::with_capacity(curve.mean_deg.width(), t_s.len());
    for (&s, row) in demonstrated.iter().zip(curve.mean_deg.rows()) {
        let (start, end) = (share(s), share(motion_s - s));
        let row: Vec<f64> = row
            .iter()
            .zip(at_start.iter().zip(&at_end))
            .map(|(q, (a, b))| q + start * a + end * b)
            .collect();
        mean_deg.push(&row);
    }
    Regression {
        t_s,
        mean_deg,
        covariance_deg2: curve.covariance_deg2,
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
