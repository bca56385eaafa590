//! The Jensen-Shannon distance between two mixtures, by Monte Carlo.

use crate::{
    Error,
    exp::exp_lanes,
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
    let arch = pulp::Arch::new();
    let forth = arch.dispatch(FromMean {
        p: &p,
        q: &q,
        samples,
        rng,
    });
    let back = arch.dispatch(FromMean {
        p: &q,
        q: &p,
        samples,
        rng,
    });
    let sum = forth + back;
    let rounded = (sum * 1e6).round() / 1e6;
    Ok((0.5 * rounded.max(0.0)).sqrt())
}

/// Mean of ln p - ln m over samples of p. An operation and not a closure, so that
/// it is compiled for the vectors it is dispatched to.
struct FromMean<'a, const D: usize> {
    p: &'a LogDensity<D>,
    q: &'a LogDensity<D>,
    samples: usize,
    rng: &'a mut Stream,
}

impl<const D: usize> pulp::NullaryFnOnce for FromMean<'_, D> {
    type Output = f64;

    #[inline(always)]
    fn call(self) -> f64 {
        let mut sum = 0.0;
        for (component, share) in self
            .p
            .shares_of(self.samples, self.rng)
            .into_iter()
            .enumerate()
        {
            for begun in (0..share).step_by(LANES) {
                let samples = self.p.draw(component, self.rng);
                let (log_p, log_q) = (self.p.at(&samples), self.q.at(&samples));
                // exp_lanes ends at 709; a ratio of exp(700) already says everything.
                let ratio: [f64; LANES] = exp_lanes(std::array::from_fn(|lane| {
                    (log_q[lane] - log_p[lane]).min(700.0)
                }));
                for r in &ratio[..LANES.min(share - begun)] {
                    // ln p - ln m = ln 2 - ln(1 + q/p).
                    sum += std::f64::consts::LN_2 - r.ln_1p();
                }
            }
        }
        sum / self.samples as f64
    }
}
