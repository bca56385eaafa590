//! The Jensen-Shannon distance between two mixtures, by Monte Carlo.

use crate::{
    Error,
    exp::exp_lanes,
    mixture::{Gaussian, Mixture, prepare, with_dimension},
    rng::Stream,
    vector::{self, Kernel, LANES, lanes},
};

/// Samples are drawn until the standard error of the distance is at most this share
/// of it, ...
pub const ACCURACY: f64 = 0.02;
/// ... [`BATCH`] from each mixture at a time, but never more than this from each.
const MOST_SAMPLES: usize = 100_000;
const BATCH: usize = 256;

/// Square root of the Jensen-Shannon divergence in nats: 0 for equal mixtures,
/// sqrt(ln 2) = 0.8326 for mixtures without common ground.
///
/// With m = (p + q) / 2 and u = p / (p + q), the divergence is
///
/// ```text
/// 1/2 E_p[ln p - ln m] + 1/2 E_q[ln q - ln m] = E_m[u ln 2u + (1 - u) ln 2(1 - u)]
/// ```
///
/// since p = 2 u m and q = 2 (1 - u) m. The form on the right is estimated: its
/// term is never negative and vanishes with the square of u - 1/2, so that similar
/// mixtures need no more samples than different ones. The form on the left, with
/// the published 100,000 samples from each, knows a distance of 0.06 to 2 to 3 % (see
/// `docs/performance.md`).
pub fn distance(p: &Mixture, q: &Mixture, rng: &mut Stream) -> Result<f64, Error> {
    let dimension = p.means[0].len();
    with_dimension!(dimension, distance_in(p, q, rng))
}

fn distance_in<const D: usize>(p: &Mixture, q: &Mixture, rng: &mut Stream) -> Result<f64, Error> {
    let pair = [
        Prepared {
            weights: &p.weights,
            components: prepare::<D>(p)?,
        },
        Prepared {
            weights: &q.weights,
            components: prepare::<D>(q)?,
        },
    ];
    Ok(vector::dispatch(Divergence { pair: &pair, rng }).sqrt())
}

/// A mixture prepared for evaluation and sampling.
struct Prepared<'a, const D: usize> {
    weights: &'a [f64],
    components: Vec<Gaussian<D>>,
}

impl<const D: usize> Prepared<'_, D> {
    /// How many of `count` samples fall to each component: its share, rounded up or
    /// down so that it is right on average over `offset` in [0, 1) (systematic
    /// sampling).
    fn shares_of(&self, count: usize, offset: f64) -> impl Iterator<Item = usize> {
        let total: f64 = self.weights.iter().sum();
        let mut cumulated = 0.0;
        let mut before = 0;
        self.weights.iter().map(move |weight| {
            cumulated += weight / total * count as f64;
            let now = ((cumulated + offset) as usize).min(count);
            let share = now - before;
            before = now;
            share
        })
    }
}

struct Divergence<'a, 'b, const D: usize> {
    pair: &'a [Prepared<'b, D>; 2],
    rng: &'a mut Stream,
}

impl<const D: usize> Kernel for Divergence<'_, '_, D> {
    type Output = f64;

    #[inline(always)]
    fn run<const FUSED: bool>(self) -> f64 {
        let mut logs = [const { Vec::new() }; 2];
        let (mut sum, mut squares, mut count) = (0.0, 0.0, 0.0);
        let mut drawn = 0;
        loop {
            for from in self.pair {
                let offset = self.rng.uniform();
                for (c, share) in from.shares_of(BATCH, offset).enumerate() {
                    for begun in (0..share).step_by(LANES) {
                        let samples = from.components[c].draw::<FUSED>(self.rng);
                        let shares = shares::<FUSED, D>(self.pair, &samples, &mut logs);
                        for &(u, rest) in &shares[..LANES.min(share - begun)] {
                            let term = entropy_term(u) + entropy_term(rest);
                            sum += term;
                            squares += term * term;
                            count += 1.0;
                        }
                    }
                }
            }
            drawn += BATCH;
            let mean = sum / count;
            let error = ((squares / count - mean * mean).max(0.0) / count).sqrt();
            // d = sqrt(divergence): its relative error is half that of the divergence.
            if drawn >= MOST_SAMPLES || error <= 2.0 * ACCURACY * mean {
                return mean.max(0.0);
            }
        }
    }
}

/// u ln 2u, which vanishes with u.
#[inline(always)]
fn entropy_term(u: f64) -> f64 {
    if u > 0.0 { u * (2.0 * u).ln() } else { 0.0 }
}

/// (p / (p + q), q / (p + q)) at each sample.
#[inline(always)]
fn shares<const FUSED: bool, const D: usize>(
    pair: &[Prepared<D>; 2],
    samples: &[[f64; LANES]; D],
    logs: &mut [Vec<[f64; LANES]>; 2],
) -> [(f64, f64); LANES] {
    let mut max = [f64::NEG_INFINITY; LANES];
    for (mixture, logs) in pair.iter().zip(logs.iter_mut()) {
        logs.clear();
        for component in &mixture.components {
            let log = component.log_weighted::<FUSED>(samples);
            for lane in 0..LANES {
                max[lane] = if log[lane] > max[lane] {
                    log[lane]
                } else {
                    max[lane]
                };
            }
            logs.push(log);
        }
    }
    let mut densities = [[0.0; LANES]; 2];
    for (density, logs) in densities.iter_mut().zip(logs) {
        for log in logs.iter() {
            let powers: [f64; LANES] =
                exp_lanes::<FUSED, LANES>(lanes(|lane| log[lane] - max[lane]));
            for lane in 0..LANES {
                density[lane] += powers[lane];
            }
        }
    }
    let [p, q] = densities;
    lanes(|lane| {
        let total = p[lane] + q[lane];
        (p[lane] / total, q[lane] / total)
    })
}
