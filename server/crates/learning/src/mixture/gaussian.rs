//! Gaussians prepared for evaluation, many samples at a time, and for sampling.

use super::{Mixture, blocks::Moments};
use crate::{
    Error,
    rng::Stream,
    vector::{LANES, for_each_dimension, lanes, multiply_add},
};

/// One component of a mixture.
#[derive(Clone, Copy, Debug)]
pub struct Component<const D: usize> {
    pub weight: f64,
    pub mean: [f64; D],
    pub covariance: [[f64; D]; D],
}

/// One Gaussian, prepared.
#[derive(Clone, Copy, Debug)]
pub struct Gaussian<const D: usize> {
    mean: [f64; D],
    /// Lower triangular L with covariance = L Lᵀ.
    factor: [[f64; D]; D],
    /// L⁻¹, lower triangular.
    whitening: [[f64; D]; D],
    /// L⁻¹ mean.
    whitened_mean: [f64; D],
    /// ln of (weight / sqrt((2 pi)^D det covariance)).
    log_scale: f64,
}

impl<const D: usize> Gaussian<D> {
    /// Prepares a component; fails when its covariance is not positive definite.
    pub fn new(component: &Component<D>) -> Result<Self, Error> {
        let failed = |reason: &str| Error::MixtureFailed {
            reason: reason.into(),
        };
        let factor = cholesky(&component.covariance)
            .ok_or_else(|| failed("a covariance is not positive definite"))?;
        let whitening = inverse_of_lower(&factor);
        let log_determinant: f64 = (0..D).map(|i| factor[i][i].ln()).sum();
        let log_scale = component.weight.ln()
            - 0.5 * D as f64 * (2.0 * std::f64::consts::PI).ln()
            - log_determinant;
        if log_scale.is_nan() {
            return Err(failed("a component has no weight"));
        }
        Ok(Gaussian {
            mean: component.mean,
            factor,
            whitening,
            whitened_mean: times(&whitening, &component.mean),
            log_scale,
        })
    }

    /// ln of the weighted density at the mean; the log density of a sample is this
    /// less half its squared whitened distance.
    #[inline(always)]
    pub fn log_scale(&self) -> f64 {
        self.log_scale
    }

    /// The same for two blocks at once, which reads the factors half as often.
    #[inline(always)]
    pub fn squared_distances_of_two<const FUSED: bool>(
        &self,
        samples: [&[[f64; LANES]; D]; 2],
    ) -> [[f64; LANES]; 2] {
        let mut squares = [[0.0; LANES]; 2];
        for_each_dimension!(D, i => {
            let mut y = [[-self.whitened_mean[i]; LANES]; 2];
            for j in 0..=i {
                let w = self.whitening[i][j];
                for (y, samples) in y.iter_mut().zip(samples) {
                    for lane in 0..LANES {
                        y[lane] = multiply_add::<FUSED>(w, samples[j][lane], y[lane]);
                    }
                }
            }
            for (square, y) in squares.iter_mut().zip(&y) {
                for lane in 0..LANES {
                    square[lane] = multiply_add::<FUSED>(y[lane], y[lane], square[lane]);
                }
            }
        });
        squares
    }

    /// Squared distance |L⁻¹ (x - mean)|² of each sample.
    #[inline(always)]
    pub fn squared_distances<const FUSED: bool>(
        &self,
        samples: &[[f64; LANES]; D],
    ) -> [f64; LANES] {
        let mut square = [0.0; LANES];
        for_each_dimension!(D, i => {
            let mut y = [-self.whitened_mean[i]; LANES];
            for j in 0..=i {
                let w = self.whitening[i][j];
                for lane in 0..LANES {
                    y[lane] = multiply_add::<FUSED>(w, samples[j][lane], y[lane]);
                }
            }
            for lane in 0..LANES {
                square[lane] = multiply_add::<FUSED>(y[lane], y[lane], square[lane]);
            }
        });
        square
    }

    /// ln(weight * density) of each sample.
    #[inline(always)]
    pub fn log_weighted<const FUSED: bool>(&self, samples: &[[f64; LANES]; D]) -> [f64; LANES] {
        let squares = self.squared_distances::<FUSED>(samples);
        lanes(|lane| self.log_scale - 0.5 * squares[lane])
    }

    /// Sum of ln(weight * density) over samples of which only the moments are known.
    pub fn total_log_weighted(&self, moments: &Moments<D>) -> f64 {
        if moments.zeroth == 0.0 {
            return 0.0;
        }
        // Sum of |W (x - m)|² = n |W (mean - m)|² + trace of W S Wᵀ, S the scatter.
        let n = moments.zeroth;
        let mean: [f64; D] = std::array::from_fn(|i| moments.first[i] / n);
        let offset: [f64; D] = std::array::from_fn(|i| mean[i] - self.mean[i]);
        let scatter =
            |i: usize, j: usize| moments.second[i.max(j)][i.min(j)] - n * mean[i] * mean[j];
        let mut squares = n * norm(&times(&self.whitening, &offset)).powi(2);
        for row in &self.whitening {
            for i in 0..D {
                for j in 0..D {
                    squares += row[i] * scatter(i, j) * row[j];
                }
            }
        }
        n * self.log_scale - 0.5 * squares
    }

    /// By how much whitened distances can differ from those of `earlier`: a distance
    /// d there is at least (d - shift) (1 - change) and at most (d + shift)
    /// (1 + change) here. Gives (shift, change).
    ///
    /// With A = W W'⁻¹ and s = W' (mean - mean'), primes for the earlier one,
    /// W (x - mean) = A (W' (x - mean') - s), and every singular value of A is
    /// within |A - I| (Frobenius) of 1.
    pub fn drift_from(&self, earlier: &Gaussian<D>) -> (f64, f64) {
        let moved: [f64; D] = std::array::from_fn(|i| self.mean[i] - earlier.mean[i]);
        let shift = norm(&times(&earlier.whitening, &moved));
        let mut square = 0.0;
        for i in 0..D {
            for j in 0..=i {
                let entry: f64 = (j..=i)
                    .map(|l| self.whitening[i][l] * earlier.factor[l][j])
                    .sum();
                square += (entry - f64::from(u8::from(i == j))).powi(2);
            }
        }
        (shift, square.sqrt())
    }

    /// One sample in each lane.
    #[inline(always)]
    pub fn draw<const FUSED: bool>(&self, rng: &mut Stream) -> [[f64; LANES]; D] {
        let mut normal = [[0.0; LANES]; D];
        for z in normal.as_flattened_mut() {
            *z = rng.normal();
        }
        let mut samples = [[0.0; LANES]; D];
        for (i, x) in samples.iter_mut().enumerate() {
            *x = [self.mean[i]; LANES];
            for (l, z) in self.factor[i][..=i].iter().zip(&normal) {
                for lane in 0..LANES {
                    x[lane] = multiply_add::<FUSED>(*l, z[lane], x[lane]);
                }
            }
        }
        samples
    }
}

/// All components of a mixture, prepared; D must be its dimension.
pub fn prepare<const D: usize>(mixture: &Mixture) -> Result<Vec<Gaussian<D>>, Error> {
    (0..mixture.weights.len())
        .map(|c| {
            Gaussian::new(&Component {
                weight: mixture.weights[c],
                mean: std::array::from_fn(|i| mixture.means[c][i]),
                covariance: std::array::from_fn(|i| {
                    std::array::from_fn(|j| mixture.covariances[c][i][j])
                }),
            })
        })
        .collect()
}

/// Lower triangular L with L Lᵀ = `matrix`, of which the lower triangle is read.
fn cholesky<const D: usize>(matrix: &[[f64; D]; D]) -> Option<[[f64; D]; D]> {
    let mut lower = [[0.0; D]; D];
    for i in 0..D {
        for j in 0..=i {
            let known: f64 = (0..j).map(|l| lower[i][l] * lower[j][l]).sum();
            let rest = matrix[i][j] - known;
            if i > j {
                lower[i][j] = rest / lower[j][j];
            } else if rest > 0.0 {
                lower[i][i] = rest.sqrt();
            } else {
                return None;
            }
        }
    }
    Some(lower)
}

fn inverse_of_lower<const D: usize>(lower: &[[f64; D]; D]) -> [[f64; D]; D] {
    let mut inverse = [[0.0; D]; D];
    for i in 0..D {
        inverse[i][i] = 1.0 / lower[i][i];
        for j in 0..i {
            let known: f64 = (j..i).map(|l| lower[i][l] * inverse[l][j]).sum();
            inverse[i][j] = -known / lower[i][i];
        }
    }
    inverse
}

fn times<const D: usize>(lower: &[[f64; D]; D], x: &[f64; D]) -> [f64; D] {
    std::array::from_fn(|i| (0..=i).map(|j| lower[i][j] * x[j]).sum())
}

fn norm<const D: usize>(x: &[f64; D]) -> f64 {
    x.iter().map(|v| v * v).sum::<f64>().sqrt()
}
