//! Log densities of mixtures, many samples at a time, and sampling from them.

use nalgebra::DMatrix;

use super::{LANES, Mixture};
use crate::{Error, exp::exp_lanes, rng::Stream};

/// One Gaussian, prepared for evaluation and sampling.
#[derive(Clone, Debug)]
pub struct Gaussian<const D: usize> {
    mean: [f64; D],
    /// Lower triangular L with covariance = L Lᵀ.
    factor: [[f64; D]; D],
    /// L⁻¹, lower triangular.
    whitening: [[f64; D]; D],
    /// ln of (weight / sqrt((2 pi)^D det covariance)).
    log_scale: f64,
}

impl<const D: usize> Gaussian<D> {
    /// Prepares a component of `weight`; fails when the covariance is not positive definite.
    pub fn new(weight: f64, mean: &[f64], covariance: &[Vec<f64>]) -> Result<Self, Error> {
        let failed = |reason: &str| Error::MixtureFailed {
            reason: reason.into(),
        };
        let matrix = DMatrix::from_fn(D, D, |i, j| covariance[i][j]);
        let cholesky = matrix
            .cholesky()
            .ok_or_else(|| failed("a covariance is not positive definite"))?;
        let lower = cholesky.l();
        let inverse = lower
            .solve_lower_triangular(&DMatrix::identity(D, D))
            .ok_or_else(|| failed("a covariance is singular"))?;
        let square = |m: &DMatrix<f64>| {
            std::array::from_fn(|i| std::array::from_fn(|j| if j <= i { m[(i, j)] } else { 0.0 }))
        };
        let log_determinant: f64 = (0..D).map(|i| lower[(i, i)].ln()).sum();
        let log_scale =
            weight.ln() - 0.5 * D as f64 * (2.0 * std::f64::consts::PI).ln() - log_determinant;
        if log_scale.is_nan() {
            return Err(failed("a component has no weight"));
        }
        Ok(Gaussian {
            mean: std::array::from_fn(|i| mean[i]),
            factor: square(&lower),
            whitening: square(&inverse),
            log_scale,
        })
    }

    /// Differences of the samples from the mean.
    #[inline(always)]
    pub fn centre(&self, samples: &[[f64; LANES]; D]) -> [[f64; LANES]; D] {
        std::array::from_fn(|i| std::array::from_fn(|lane| samples[i][lane] - self.mean[i]))
    }

    /// ln(weight * density) of each centred sample.
    #[inline(always)]
    pub fn log_weighted(&self, centred: &[[f64; LANES]; D]) -> [f64; LANES] {
        let mut square = [0.0; LANES];
        for (i, row) in self.whitening.iter().enumerate() {
            let mut y = [0.0; LANES];
            for (w, c) in row[..=i].iter().zip(centred) {
                for lane in 0..LANES {
                    y[lane] += w * c[lane];
                }
            }
            for lane in 0..LANES {
                square[lane] += y[lane] * y[lane];
            }
        }
        square.map(|s| self.log_scale - 0.5 * s)
    }

    /// One sample in each lane.
    #[inline(always)]
    fn draw(&self, rng: &mut Stream) -> [[f64; LANES]; D] {
        let normal: [[f64; LANES]; D] =
            std::array::from_fn(|_| std::array::from_fn(|_| rng.normal()));
        std::array::from_fn(|i| {
            let mut x = [self.mean[i]; LANES];
            for (l, z) in self.factor[i][..=i].iter().zip(&normal) {
                for lane in 0..LANES {
                    x[lane] += l * z[lane];
                }
            }
            x
        })
    }
}

/// A mixture prepared for evaluation.
#[derive(Clone, Debug)]
pub struct LogDensity<const D: usize> {
    components: Vec<Gaussian<D>>,
    weights: Vec<f64>,
}

impl<const D: usize> LogDensity<D> {
    /// Prepares all components; D must be the mixture's dimension.
    pub fn new(mixture: &Mixture) -> Result<Self, Error> {
        let components = mixture
            .weights
            .iter()
            .zip(&mixture.means)
            .zip(&mixture.covariances)
            .map(|((&weight, mean), covariance)| Gaussian::new(weight, mean, covariance))
            .collect::<Result<_, _>>()?;
        Ok(LogDensity {
            components,
            weights: mixture.weights.clone(),
        })
    }

    /// ln of the mixture's density at each sample.
    #[inline(always)]
    pub fn at(&self, samples: &[[f64; LANES]; D]) -> [f64; LANES] {
        let mut logs = [[0.0; LANES]; 16];
        let mut chunks = [f64::NEG_INFINITY; LANES];
        for part in self.components.chunks(logs.len()) {
            for (log, gaussian) in logs.iter_mut().zip(part) {
                *log = gaussian.log_weighted(&gaussian.centre(samples));
            }
            let sums = log_sum_exp(&logs[..part.len()]);
            chunks = if chunks[0] == f64::NEG_INFINITY {
                sums
            } else {
                log_sum_exp(&[chunks, sums])
            };
        }
        chunks
    }

    /// How many of `count` samples fall to each component.
    pub fn shares_of(&self, count: usize, rng: &mut Stream) -> Vec<usize> {
        let mut shares = vec![0usize; self.components.len()];
        for _ in 0..count {
            let mut u = rng.uniform();
            let mut chosen = 0;
            while chosen + 1 < self.weights.len() && u >= self.weights[chosen] {
                u -= self.weights[chosen];
                chosen += 1;
            }
            shares[chosen] += 1;
        }
        shares
    }

    /// A block of samples of one component.
    #[inline(always)]
    pub fn draw(&self, component: usize, rng: &mut Stream) -> [[f64; LANES]; D] {
        self.components[component].draw(rng)
    }
}

/// ln of the sum of exponentials over the components, for each lane.
#[inline(always)]
pub fn log_sum_exp(logs: &[[f64; LANES]]) -> [f64; LANES] {
    let mut max = [f64::NEG_INFINITY; LANES];
    for log in logs {
        for lane in 0..LANES {
            max[lane] = if log[lane] > max[lane] {
                log[lane]
            } else {
                max[lane]
            };
        }
    }
    let mut sum = [0.0; LANES];
    for log in logs {
        let shifted: [f64; LANES] = std::array::from_fn(|lane| log[lane] - max[lane]);
        let powers = exp_lanes(shifted);
        for lane in 0..LANES {
            sum[lane] += powers[lane];
        }
    }
    std::array::from_fn(|lane| max[lane] + sum[lane].ln())
}
