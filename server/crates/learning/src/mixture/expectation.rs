//! The E step, without looking at what cannot matter.
//!
//! For every block of samples and every component, two bounds are kept: no sample
//! of the block is whitened to nearer than `near` or farther than `far` of the
//! component's mean. When the components move, the bounds give way by what
//! [`Gaussian::drift_from`] proves. A component whose best log density in a block
//! is more than [`NEGLIGIBLE`] below what another one surely has there takes a
//! share below 1e-10 of each sample and is passed over; where one component is left,
//! the block's moments are added as they are. Only the rest is evaluated, and
//! evaluating makes the bounds exact again. The mean log likelihood so differs from
//! that of the plain E step by less than k 1e-10.

use super::{Blocks, blocks::Moments, gaussian::Gaussian};
use crate::{
    exp::exp_lanes,
    vector::{self, Kernel, LANES, lanes, multiply_add},
};

/// exp(-23) = 1e-10, seven orders below what EM takes for converged.
const NEGLIGIBLE: f64 = 23.0;
/// What rounding may do to a bound, relative.
const ROUNDING: f64 = 1e-9;

/// Repeated E steps on the same data.
pub struct Expectation<'a, const D: usize> {
    data: &'a Blocks<D>,
    gaussians: Vec<Gaussian<D>>,
    /// For each group of blocks, for each component.
    bounds: Vec<Bounds>,
}

/// Bounds of whitened distances in each of [`LANES`] blocks.
#[derive(Clone, Copy)]
struct Bounds {
    near: [f64; LANES],
    far: [f64; LANES],
}

impl<'a, const D: usize> Expectation<'a, D> {
    /// Nothing is known yet of the `k` components.
    pub fn new(data: &'a Blocks<D>, k: usize) -> Self {
        let unknown = Bounds {
            near: [0.0; LANES],
            far: [f64::INFINITY; LANES],
        };
        Expectation {
            data,
            gaussians: Vec::new(),
            bounds: vec![unknown; data.groups().len() * k],
        }
    }

    /// Sum of the samples' log likelihoods under `gaussians`, and the moments of
    /// each component's share of the samples.
    pub fn step(&mut self, gaussians: Vec<Gaussian<D>>) -> (f64, Vec<Moments<D>>) {
        let drifts = gaussians
            .iter()
            .enumerate()
            .map(|(c, gaussian)| match self.gaussians.get(c) {
                Some(earlier) => Drift::between(earlier, gaussian),
                None => Drift::UNKNOWN,
            })
            .collect();
        self.gaussians = gaussians;
        vector::dispatch(Step {
            data: self.data,
            gaussians: &self.gaussians,
            drifts,
            bounds: &mut self.bounds,
        })
    }
}

/// What moving components does to bounds.
struct Drift {
    shift: f64,
    shrink: f64,
    grow: f64,
}

impl Drift {
    const UNKNOWN: Drift = Drift {
        shift: 0.0,
        shrink: 1.0,
        grow: 1.0,
    };

    fn between<const D: usize>(earlier: &Gaussian<D>, now: &Gaussian<D>) -> Drift {
        let (shift, change) = now.drift_from(earlier);
        Drift {
            shift: shift * (1.0 + ROUNDING),
            shrink: (1.0 - change - ROUNDING).max(0.0),
            grow: 1.0 + change + ROUNDING,
        }
    }
}

struct Step<'a, const D: usize> {
    data: &'a Blocks<D>,
    gaussians: &'a [Gaussian<D>],
    drifts: Vec<Drift>,
    bounds: &'a mut [Bounds],
}

impl<const D: usize> Kernel for Step<'_, D> {
    type Output = (f64, Vec<Moments<D>>);

    #[inline(always)]
    fn run<const FUSED: bool>(self) -> Self::Output {
        let k = self.gaussians.len();
        let mut whole = vec![Moments::ZERO; k];
        let mut shared = vec![Shared::EMPTY; k];
        let mut candidates = Vec::with_capacity(k);
        let mut logs = vec![[0.0; LANES]; k];
        let mut total = 0.0;
        let blocks = self.data.samples().len();
        for (group, bounds) in self.bounds.chunks_exact_mut(k).enumerate() {
            for (bound, drift) in bounds.iter_mut().zip(&self.drifts) {
                bound.move_by(drift);
            }
            let sure = surest(bounds, self.gaussians);
            let first = group * LANES;
            for lane in 0..LANES.min(blocks - first) {
                let block = &self.data.samples()[first + lane];
                let (floor, strongest) = (sure.floor[lane], sure.component[lane] as usize);
                let possible = |c: usize, bounds: &[Bounds], floor: f64| {
                    let near = bounds[c].near[lane];
                    self.gaussians[c].log_scale() - 0.5 * near * near > floor - NEGLIGIBLE
                };
                candidates.clear();
                candidates.extend((0..k).filter(|&c| possible(c, bounds, floor)));
                if candidates.len() > 1 {
                    // Knowing the strongest one exactly may rule out the others.
                    let log = evaluate::<FUSED, D>(self.gaussians, bounds, strongest, lane, block);
                    logs[strongest] = log;
                    let floor = vector::reduce(log, |a, b| if a < b { a } else { b });
                    candidates.retain(|&c| c == strongest || possible(c, bounds, floor));
                }
                match candidates[..] {
                    [only] => whole[only].add(&self.data.moments()[first + lane]),
                    _ => {
                        for &c in &candidates {
                            if c != strongest {
                                logs[c] =
                                    evaluate::<FUSED, D>(self.gaussians, bounds, c, lane, block);
                            }
                        }
                        let filled = self.data.filled(first + lane);
                        total += share::<FUSED>(filled, &candidates, &mut logs);
                        for &c in &candidates {
                            shared[c].take::<FUSED>(self.data, first + lane, &logs[c]);
                        }
                    }
                }
            }
        }
        let moments = (0..k)
            .map(|c| {
                total += self.gaussians[c].total_log_weighted(&whole[c]);
                shared[c].flush::<FUSED>(self.data);
                whole[c].add(&shared[c].sums.summed());
                whole[c]
            })
            .collect();
        (total, moments)
    }
}

impl Bounds {
    #[inline(always)]
    fn move_by(&mut self, drift: &Drift) {
        for lane in 0..LANES {
            let near = (self.near[lane] - drift.shift) * drift.shrink;
            self.near[lane] = if near > 0.0 { near } else { 0.0 };
            self.far[lane] = (self.far[lane] + drift.shift) * drift.grow;
        }
    }
}

/// What the log density in each block is at least, by which component.
struct Sure {
    floor: [f64; LANES],
    component: [f64; LANES],
}

#[inline(always)]
fn surest<const D: usize>(bounds: &[Bounds], gaussians: &[Gaussian<D>]) -> Sure {
    let mut sure = Sure {
        floor: [f64::NEG_INFINITY; LANES],
        component: [0.0; LANES],
    };
    for (c, (bound, gaussian)) in bounds.iter().zip(gaussians).enumerate() {
        for lane in 0..LANES {
            let least = gaussian.log_scale() - 0.5 * bound.far[lane] * bound.far[lane];
            let better = least > sure.floor[lane];
            sure.floor[lane] = if better { least } else { sure.floor[lane] };
            sure.component[lane] = if better {
                c as f64
            } else {
                sure.component[lane]
            };
        }
    }
    sure
}

/// Log densities of one component in one block; its bounds there become exact.
#[inline(always)]
fn evaluate<const FUSED: bool, const D: usize>(
    gaussians: &[Gaussian<D>],
    bounds: &mut [Bounds],
    c: usize,
    lane: usize,
    block: &[[f64; LANES]; D],
) -> [f64; LANES] {
    let squares = gaussians[c].squared_distances::<FUSED>(block);
    let least = vector::reduce(squares, |a, b| if a < b { a } else { b });
    let most = vector::reduce(squares, |a, b| if a > b { a } else { b });
    bounds[c].near[lane] = least.sqrt() * (1.0 - ROUNDING);
    bounds[c].far[lane] = most.sqrt() * (1.0 + ROUNDING);
    lanes(|lane| gaussians[c].log_scale() - 0.5 * squares[lane])
}

/// Turns the candidates' log densities into shares of a block's samples, of which
/// `filled` count; gives the sum of their log likelihoods.
#[inline(always)]
fn share<const FUSED: bool>(filled: usize, candidates: &[usize], logs: &mut [[f64; LANES]]) -> f64 {
    let mut max = [f64::NEG_INFINITY; LANES];
    for &c in candidates {
        for lane in 0..LANES {
            let log = logs[c][lane];
            max[lane] = if log > max[lane] { log } else { max[lane] };
        }
    }
    let mut sum = [0.0; LANES];
    for &c in candidates {
        logs[c] = exp_lanes::<FUSED, LANES>(lanes(|lane| logs[c][lane] - max[lane]));
        for lane in 0..LANES {
            sum[lane] += logs[c][lane];
        }
    }
    let mut inverse: [f64; LANES] = lanes(|lane| 1.0 / sum[lane]);
    if filled < LANES {
        inverse[filled..].fill(0.0);
        sum[filled..].fill(1.0);
        max[filled..].fill(0.0);
    }
    for &c in candidates {
        for lane in 0..LANES {
            logs[c][lane] *= inverse[lane];
        }
    }
    // The sums are between 1 and k: one logarithm serves for their product.
    vector::reduce(max, |a, b| a + b) + vector::reduce(sum, |a, b| a * b).ln()
}

/// Blocks that are added together, so that running sums are read and written less.
const TOGETHER: usize = 4;

/// What a component holds of blocks that it shares with others.
#[derive(Clone, Copy)]
struct Shared<const D: usize> {
    sums: LaneMoments<D>,
    waiting: usize,
    blocks: [usize; TOGETHER],
    shares: [[f64; LANES]; TOGETHER],
}

impl<const D: usize> Shared<D> {
    const EMPTY: Self = Shared {
        sums: LaneMoments::ZERO,
        waiting: 0,
        blocks: [0; TOGETHER],
        shares: [[0.0; LANES]; TOGETHER],
    };

    #[inline(always)]
    fn take<const FUSED: bool>(&mut self, data: &Blocks<D>, block: usize, shares: &[f64; LANES]) {
        self.blocks[self.waiting] = block;
        self.shares[self.waiting] = *shares;
        self.waiting += 1;
        if self.waiting == TOGETHER {
            self.flush::<FUSED>(data);
        }
    }

    /// Adds what waits; places that nothing waits in have no share.
    #[inline(always)]
    fn flush<const FUSED: bool>(&mut self, data: &Blocks<D>) {
        for empty in self.waiting..TOGETHER {
            self.blocks[empty] = self.blocks[0];
            self.shares[empty] = [0.0; LANES];
        }
        let samples = self.blocks.map(|block| &data.samples()[block]);
        self.sums.add::<FUSED>(&self.shares, &samples);
        self.waiting = 0;
    }
}

/// Running sums, one for each lane; of the second moments only the lower triangle.
#[derive(Clone, Copy)]
struct LaneMoments<const D: usize> {
    zeroth: [f64; LANES],
    first: [[f64; LANES]; D],
    second: [[[f64; LANES]; D]; D],
}

impl<const D: usize> LaneMoments<D> {
    const ZERO: Self = LaneMoments {
        zeroth: [0.0; LANES],
        first: [[0.0; LANES]; D],
        second: [[[0.0; LANES]; D]; D],
    };

    #[inline(always)]
    fn add<const FUSED: bool>(
        &mut self,
        shares: &[[f64; LANES]; TOGETHER],
        samples: &[&[[f64; LANES]; D]; TOGETHER],
    ) {
        for lane in 0..LANES {
            for share in shares {
                self.zeroth[lane] += share[lane];
            }
        }
        for i in 0..D {
            let mut weighted = [[0.0; LANES]; TOGETHER];
            for b in 0..TOGETHER {
                for lane in 0..LANES {
                    weighted[b][lane] = shares[b][lane] * samples[b][i][lane];
                    self.first[i][lane] += weighted[b][lane];
                }
            }
            for j in 0..=i {
                let mut sum = self.second[i][j];
                for b in 0..TOGETHER {
                    for lane in 0..LANES {
                        sum[lane] = multiply_add::<FUSED>(
                            weighted[b][lane],
                            samples[b][j][lane],
                            sum[lane],
                        );
                    }
                }
                self.second[i][j] = sum;
            }
        }
    }

    fn summed(&self) -> Moments<D> {
        let mut moments = Moments::ZERO;
        moments.zeroth = self.zeroth.iter().sum();
        for i in 0..D {
            moments.first[i] = self.first[i].iter().sum();
            for j in 0..=i {
                moments.second[i][j] = self.second[i][j].iter().sum();
            }
        }
        moments
    }
}
