//! Expectation maximisation for mixtures with full covariances.

use super::{Blocks, Fit, LANES, Mixture, gaussian::Gaussian};
use crate::{Error, exp::exp_lanes};

const MAX_ITERATIONS: usize = 100;
const TOLERANCE: f64 = 1e-3;
/// Added to the diagonal of each covariance, so that a joint that never moves
/// leaves it positive definite.
const REGULARISATION: f64 = 1e-6;
/// A block whose responsibilities are all below this adds nothing to sums of
/// doubles and is passed over.
const NEGLIGIBLE: f64 = 1e-30;

/// Fits from the clusters `labels` (one of 0..k for each sample).
pub fn maximise<const D: usize>(
    data: &Blocks<D>,
    labels: &[usize],
    k: usize,
) -> Result<Fit, Error> {
    let mut mixture = from_labels(data, labels, k);
    let mut log_likelihoods = Vec::new();
    let mut converged = false;
    for _ in 0..MAX_ITERATIONS {
        let (log_likelihood, moments) = expect(data, &mixture)?;
        let before = log_likelihoods.last().copied();
        log_likelihoods.push(log_likelihood);
        mixture = moments.maximise(data.len());
        if before.is_some_and(|b: f64| (log_likelihood - b).abs() < TOLERANCE) {
            converged = true;
            break;
        }
    }
    Ok(Fit {
        mixture,
        log_likelihoods,
        converged,
    })
}

/// Sums of responsibility times (1, d, d dᵀ), d = distance from `centres`.
struct Moments<const D: usize> {
    centres: Vec<[f64; D]>,
    zeroth: Vec<f64>,
    first: Vec<[f64; D]>,
    second: Vec<[[f64; D]; D]>,
}

impl<const D: usize> Moments<D> {
    fn maximise(&self, n: usize) -> Mixture {
        let mut mixture = Mixture {
            weights: Vec::new(),
            means: Vec::new(),
            covariances: Vec::new(),
        };
        for c in 0..self.zeroth.len() {
            // A component that lost all its samples must not divide by zero.
            let mass = self.zeroth[c] + 10.0 * f64::EPSILON;
            let shift = self.first[c].map(|s| s / mass);
            let covariance = (0..D)
                .map(|i| {
                    (0..D)
                        .map(|j| {
                            let (low, high) = (i.min(j), i.max(j));
                            let centred = self.second[c][high][low] / mass - shift[i] * shift[j];
                            centred + if i == j { REGULARISATION } else { 0.0 }
                        })
                        .collect()
                })
                .collect();
            mixture.weights.push(mass / n as f64);
            mixture
                .means
                .push((0..D).map(|i| self.centres[c][i] + shift[i]).collect());
            mixture.covariances.push(covariance);
        }
        let total: f64 = mixture.weights.iter().sum();
        for weight in &mut mixture.weights {
            *weight /= total;
        }
        mixture
    }
}

fn from_labels<const D: usize>(data: &Blocks<D>, labels: &[usize], k: usize) -> Mixture {
    let mut centres = vec![[0.0; D]; k];
    let mut counts = vec![0.0; k];
    for (i, &label) in labels.iter().enumerate() {
        counts[label] += 1.0;
        for (c, x) in centres[label].iter_mut().zip(data.sample(i)) {
            *c += x;
        }
    }
    for (centre, count) in centres.iter_mut().zip(&counts) {
        for c in centre.iter_mut() {
            *c /= f64::max(*count, 1.0);
        }
    }
    let mut second = vec![[[0.0; D]; D]; k];
    for (i, &label) in labels.iter().enumerate() {
        let x = data.sample(i);
        let d: [f64; D] = std::array::from_fn(|j| x[j] - centres[label][j]);
        for (row, a) in second[label].iter_mut().zip(d) {
            for (sum, b) in row.iter_mut().zip(d) {
                *sum += a * b;
            }
        }
    }
    Moments {
        centres,
        zeroth: counts,
        first: vec![[0.0; D]; k],
        second,
    }
    .maximise(data.len())
}

/// E step and the sums that the M step needs, in one pass over the data. The
/// moments are taken about the present means, which keeps them small.
fn expect<const D: usize>(data: &Blocks<D>, mixture: &Mixture) -> Result<(f64, Moments<D>), Error> {
    let k = mixture.weights.len();
    let gaussians = (0..k)
        .map(|c| {
            Gaussian::<D>::new(
                mixture.weights[c],
                &mixture.means[c],
                &mixture.covariances[c],
            )
        })
        .collect::<Result<Vec<_>, _>>()?;
    let mut sums = vec![LaneMoments::<D>::zero(); k];
    // The same arithmetic with the widest vectors the processor has; nothing is
    // contracted or reordered, so the result has the same bits on every processor.
    let total = pulp::Arch::new().dispatch(Accumulate {
        data,
        gaussians: &gaussians,
        sums: &mut sums,
    });
    let log_likelihood = total / data.len() as f64;
    if !log_likelihood.is_finite() {
        return Err(Error::MixtureFailed {
            reason: "the likelihood is not a number".into(),
        });
    }
    let centres = mixture
        .means
        .iter()
        .map(|mean| std::array::from_fn(|i| mean[i]))
        .collect();
    let moments = Moments {
        centres,
        zeroth: sums.iter().map(|s| s.zeroth.iter().sum()).collect(),
        first: sums
            .iter()
            .map(|s| s.first.map(|lanes| lanes.iter().sum()))
            .collect(),
        second: sums
            .iter()
            .map(|s| s.second.map(|row| row.map(|lanes| lanes.iter().sum())))
            .collect(),
    };
    Ok((log_likelihood, moments))
}

/// Adds all responsibilities to `sums`; gives the sum of the samples' log
/// likelihoods. An operation and not a closure, so that it is compiled for the
/// vectors it is dispatched to.
struct Accumulate<'a, const D: usize> {
    data: &'a Blocks<D>,
    gaussians: &'a [Gaussian<D>],
    sums: &'a mut [LaneMoments<D>],
}

impl<const D: usize> pulp::NullaryFnOnce for Accumulate<'_, D> {
    type Output = f64;

    #[inline(always)]
    fn call(self) -> f64 {
        accumulate(self.data, self.gaussians, self.sums)
    }
}

#[inline(always)]
fn accumulate<const D: usize>(
    data: &Blocks<D>,
    gaussians: &[Gaussian<D>],
    sums: &mut [LaneMoments<D>],
) -> f64 {
    let k = gaussians.len();
    let mut logs = vec![[0.0; LANES]; k];
    let mut centred = vec![[[0.0; LANES]; D]; k];
    let mut total = 0.0;
    for (index, block) in data.iter().enumerate() {
        let filled = data.filled(index);
        let mut max = [f64::NEG_INFINITY; LANES];
        for c in 0..k {
            centred[c] = gaussians[c].centre(block);
            logs[c] = gaussians[c].log_weighted(&centred[c]);
            for lane in 0..LANES {
                max[lane] = if logs[c][lane] > max[lane] {
                    logs[c][lane]
                } else {
                    max[lane]
                };
            }
        }
        let mut sum = [0.0; LANES];
        for log in logs.iter_mut() {
            *log = exp_lanes(std::array::from_fn(|lane| log[lane] - max[lane]));
            for lane in 0..LANES {
                sum[lane] += log[lane];
            }
        }
        for lane in 0..filled {
            total += max[lane] + sum[lane].ln();
        }
        let mut share: [f64; LANES] = sum.map(|s| 1.0 / s);
        share[filled..].fill(0.0);
        for c in 0..k {
            let responsibility: [f64; LANES] =
                std::array::from_fn(|lane| logs[c][lane] * share[lane]);
            if responsibility.iter().any(|&r| r > NEGLIGIBLE) {
                sums[c].add(&responsibility, &centred[c]);
            }
        }
    }
    total
}

/// Running sums, one for each lane; of the second moments only the lower triangle.
#[derive(Clone)]
struct LaneMoments<const D: usize> {
    zeroth: [f64; LANES],
    first: [[f64; LANES]; D],
    second: [[[f64; LANES]; D]; D],
}

impl<const D: usize> LaneMoments<D> {
    fn zero() -> Self {
        LaneMoments {
            zeroth: [0.0; LANES],
            first: [[0.0; LANES]; D],
            second: [[[0.0; LANES]; D]; D],
        }
    }

    #[inline(always)]
    fn add(&mut self, responsibility: &[f64; LANES], centred: &[[f64; LANES]; D]) {
        for lane in 0..LANES {
            self.zeroth[lane] += responsibility[lane];
        }
        for i in 0..D {
            let weighted: [f64; LANES] =
                std::array::from_fn(|lane| responsibility[lane] * centred[i][lane]);
            for lane in 0..LANES {
                self.first[i][lane] += weighted[lane];
            }
            for j in 0..=i {
                for lane in 0..LANES {
                    self.second[i][j][lane] += weighted[lane] * centred[j][lane];
                }
            }
        }
    }
}
