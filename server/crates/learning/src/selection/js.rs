//! The Jensen-Shannon distance between two mixtures, by Monte Carlo.

use crate::{
    Error,
    mixture::{LANES, LogDensity, Mixture, with_dimension},
    rng::Stream,
};

/// Samples that the paper's protocol draws from each mixture.
pub const SAMPLES: usize = 100_000;

/// Square root of the Jensen-Shannon divergence in nats: 0 for equal mixtures,
/// sqrt(ln 2) = 0.8326 for mixtures without common ground.
///
/// The divergence is the mean over both mixtures of mean(ln p - ln m), with
/// m = (p + q) / 2; the sum is rounded to six decimals and a negative estimate
/// (sampling noise of equal mixtures) counts as 0.
/// `samples` are drawn from each.
pub fn distance(p: &Mixture, q: &Mixture, samples: usize, rng: &mut Stream) -> Result<f64, Error> {
    let dimension = p.means[0].len();
    with_dimension!(dimension, distance_in(p, q, samples, rng))
}

fn distance_in<const D: usize>(
    p: &Mixture,
    q: &Mixture,
    samples: usize,
    rng: &mut Stream,
) -> Result<f64, Error> {
    let p = LogDensity::<D>::new(p)?;
    let q = LogDensity::<D>::new(q)?;
    let sum =
        divergence_from_mean(&p, &q, samples, rng) + divergence_from_mean(&q, &p, samples, rng);
    let rounded = (sum * 1e6).round() / 1e6;
    Ok((0.5 * rounded.max(0.0)).sqrt())
}

/// Mean of ln p - ln m over samples of p.
fn divergence_from_mean<const D: usize>(
    p: &LogDensity<D>,
    q: &LogDensity<D>,
    count: usize,
    rng: &mut Stream,
) -> f64 {
    let mut sum = 0.0;
    p.sample(count, rng, |samples, filled| {
        let (log_p, log_q) = (p.at(samples), q.at(samples));
        for lane in 0..filled.min(LANES) {
            // ln p - ln m = ln 2 - ln(1 + q/p).
            sum += std::f64::consts::LN_2 - (log_q[lane] - log_p[lane]).exp().ln_1p();
        }
    });
    sum / count as f64
}
