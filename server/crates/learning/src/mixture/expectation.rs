//! The E step, without looking at what cannot matter.
//!
//! For every block of samples and every component, two bounds are kept: no sample
//! of the block is whitened to nearer than `near` or farther than `far` of the
//! component's mean. When the components move, the bounds give way by what
//! [`Gaussian::drift_from`] proves. A component whose best log density in a block
//! is more than [`NEGLIGIBLE`] below what another one surely has there takes a
//! share below 1e-7 of each sample and is passed over; where one component is left,
//! the block's moments are added as they are. Only the rest is evaluated, and
//! evaluating makes the bounds exact again. The mean log likelihood so differs from
//! that of the plain E step by less than k 1e-7.
//!
//! Blocks that are shared are worked on component by component, in long loops: the
//! block's moments go to its strongest component, and what the others take of them
//! is then moved.

use super::{
    Blocks,
    blocks::Moments,
    gaussian::Gaussian,
    shared::{Shared, exponentials, take_shares},
};
use crate::vector::{self, Aligned, Kernel, LANES, multiply_add};

/// exp(-16.2) = 1e-7, four orders below what EM takes for converged.
const NEGLIGIBLE: f64 = 16.2;
/// What rounding may do to a squared bound, relative.
const ROUNDING: f64 = 1e-9;
/// Distance at which bounds are kept tightest when components shift.
const TYPICAL: f64 = 8.0;

/// Repeated E steps on the same data.
pub struct Expectation<'a, const D: usize> {
    data: &'a Blocks<D>,
    gaussians: Vec<Gaussian<D>>,
    bounds: Bounds,
    shared: Shared,
}

/// Squared whitened distances of the blocks from each component: component after
/// component, [`Bounds::width`] blocks each.
struct Bounds {
    width: usize,
    near: Vec<Aligned<[f64; LANES]>>,
    far: Vec<Aligned<[f64; LANES]>>,
}

impl<'a, const D: usize> Expectation<'a, D> {
    /// Nothing is known yet of the `k` components.
    pub fn new(data: &'a Blocks<D>, k: usize) -> Self {
        let groups = data.groups().len();
        Expectation {
            data,
            gaussians: Vec::new(),
            bounds: Bounds {
                width: groups,
                near: vec![Aligned([0.0; LANES]); groups * k],
                far: vec![Aligned([f64::INFINITY; LANES]); groups * k],
            },
            shared: Shared::new(data.samples().len(), k),
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
        let first = self.gaussians.is_empty();
        self.gaussians = gaussians;
        vector::dispatch(Step {
            data: self.data,
            gaussians: &self.gaussians,
            drifts,
            first,
            bounds: &mut self.bounds,
            shared: &mut self.shared,
        })
    }
}

/// What moving components does to bounds: a squared distance of s becomes at least
/// s shrink - less and at most s grow + more.
struct Drift {
    shrink: f64,
    less: f64,
    grow: f64,
    more: f64,
}

impl Drift {
    const UNKNOWN: Drift = Drift {
        shrink: 1.0,
        less: 0.0,
        grow: 1.0,
        more: 0.0,
    };

    fn between<const D: usize>(earlier: &Gaussian<D>, now: &Gaussian<D>) -> Drift {
        let (shift, change) = now.drift_from(earlier);
        // (d - shift)² >= d² (1 - h) - shift² (1 / h - 1) for every h in (0, 1), and
        // (d + shift)² <= d² (1 + h) + shift² (1 + 1 / h); with h = shift / TYPICAL no
        // square roots are needed.
        let h = shift / TYPICAL;
        let (low, high) = ((1.0 - change).max(0.0).powi(2), (1.0 + change).powi(2));
        Drift {
            shrink: (low * (1.0 - h) - ROUNDING).max(0.0),
            less: low * shift * (TYPICAL - shift).max(0.0),
            grow: high * (1.0 + h) + ROUNDING,
            more: high * shift * (TYPICAL + shift),
        }
    }
}

struct Step<'a, const D: usize> {
    data: &'a Blocks<D>,
    gaussians: &'a [Gaussian<D>],
    drifts: Vec<Drift>,
    /// Whether the bounds are still unknown.
    first: bool,
    bounds: &'a mut Bounds,
    shared: &'a mut Shared,
}

impl<const D: usize> Kernel for Step<'_, D> {
    type Output = (f64, Vec<Moments<D>>);

    #[inline(always)]
    fn run<const FUSED: bool>(mut self) -> Self::Output {
        let k = self.gaussians.len();
        let mut moments = vec![Moments::ZERO; k];
        self.sort_blocks::<FUSED>(&mut moments);
        let mut total = 0.0;
        for (gaussian, moments) in self.gaussians.iter().zip(&moments) {
            total += gaussian.total_log_weighted(moments);
        }
        for strongest in 0..k {
            total += self.share_blocks::<FUSED>(strongest, &mut moments);
        }
        (total, moments)
    }
}

impl<const D: usize> Step<'_, D> {
    /// Moves the bounds; gives blocks that belong to one component as a whole to it,
    /// and lists the others by their strongest component.
    #[inline(always)]
    fn sort_blocks<const FUSED: bool>(&mut self, moments: &mut [Moments<D>]) {
        self.shared.clear();
        let blocks = self.data.moments();
        for (group, balls) in self.data.groups().iter().enumerate() {
            for (c, drift) in self.drifts.iter().enumerate() {
                self.bounds.move_by::<FUSED>(c, group, drift);
            }
            let (mut floor, mut strongest) = ([f64::NEG_INFINITY; LANES], [0.0; LANES]);
            for (c, gaussian) in self.gaussians.iter().enumerate() {
                // At first nothing is sure, and the middle of a block tells most.
                let squares = if self.first {
                    gaussian.squared_distances::<FUSED>(&balls.mean)
                } else {
                    self.bounds.far[c * self.bounds.width + group].0
                };
                for lane in 0..LANES {
                    let least = gaussian.log_scale() - 0.5 * squares[lane];
                    let better = least > floor[lane];
                    floor[lane] = if better { least } else { floor[lane] };
                    strongest[lane] = if better { c as f64 } else { strongest[lane] };
                }
            }
            let mut possible = [0.0; LANES];
            for (c, gaussian) in self.gaussians.iter().enumerate() {
                let near = &self.bounds.near[c * self.bounds.width + group].0;
                for lane in 0..LANES {
                    let most = gaussian.log_scale() - 0.5 * near[lane];
                    possible[lane] += f64::from(u8::from(most > floor[lane] - NEGLIGIBLE));
                }
            }
            let first = group * LANES;
            for lane in 0..LANES.min(blocks.len() - first) {
                let owner = strongest[lane] as usize;
                if possible[lane] == 1.0 && !self.first {
                    moments[owner].add(&blocks[first + lane]);
                } else {
                    self.shared.list(owner, first + lane);
                }
            }
        }
    }

    /// Shares the blocks listed for `strongest` among all components that matter
    /// there; gives the sum of their samples' log likelihoods.
    #[inline(always)]
    fn share_blocks<const FUSED: bool>(
        &mut self,
        strongest: usize,
        moments: &mut [Moments<D>],
    ) -> f64 {
        let listed = self.shared.listed(strongest);
        for at in listed.clone().step_by(2) {
            let blocks = [at, (at + 1).min(listed.end - 1)].map(|at| self.shared.blocks[at]);
            let logs = self.evaluate::<FUSED>(strongest, blocks);
            for (&block, log) in blocks.iter().zip(logs) {
                let block = block as usize;
                self.shared.floor[block] = vector::reduce(log, |a, b| if a < b { a } else { b });
                self.shared.max[block] = Aligned(log);
                self.shared.own[block] = Aligned(log);
            }
        }
        self.shared.begin_pairs();
        for c in 0..self.gaussians.len() {
            if c == strongest {
                continue;
            }
            let pair = self.list_pair(c, listed.clone());
            for at in pair.clone().step_by(2) {
                let places = [at, (at + 1).min(pair.end - 1)];
                let blocks = places.map(|at| self.shared.pair_blocks[at]);
                let logs = self.evaluate::<FUSED>(c, blocks);
                for i in 0..2 {
                    self.shared.logs[places[i]] = Aligned(logs[i]);
                    let max = &mut self.shared.max[blocks[i] as usize].0;
                    for lane in 0..LANES {
                        let log = logs[i][lane];
                        max[lane] = if log > max[lane] { log } else { max[lane] };
                    }
                }
            }
        }
        exponentials::<FUSED>(self.shared, listed.clone());
        let mut total = 0.0;
        for at in listed {
            let block = self.shared.blocks[at] as usize;
            total += self.shared.normalise(block, self.data.filled(block));
            moments[strongest].add(&self.data.moments()[block]);
        }
        for pair in 0..self.shared.pairs.len() {
            let taken = take_shares::<FUSED, D>(self.shared, pair, self.data);
            let c = self.shared.pairs[pair].0;
            moments[c].add(&taken);
            moments[strongest].subtract(&taken);
        }
        total
    }

    /// Lists those of the blocks `listed` where component `c` may matter.
    #[inline(always)]
    fn list_pair(&mut self, c: usize, listed: std::ops::Range<usize>) -> std::ops::Range<usize> {
        let (scale, near) = (
            self.gaussians[c].log_scale(),
            &self.bounds.near[c * self.bounds.width..][..self.bounds.width],
        );
        self.shared.list_pair(c, listed, |block, floor| {
            scale - 0.5 * near[block / LANES].0[block % LANES] > floor - NEGLIGIBLE
        })
    }

    /// Log densities of one component in two blocks (which may be the same); its
    /// bounds there become exact.
    #[inline(always)]
    fn evaluate<const FUSED: bool>(&mut self, c: usize, blocks: [u32; 2]) -> [[f64; LANES]; 2] {
        let gaussian = &self.gaussians[c];
        let samples = blocks.map(|block| &self.data.samples()[block as usize].0);
        let mut logs = gaussian.squared_distances_of_two::<FUSED>(samples);
        for i in 0..2 {
            let block = blocks[i] as usize;
            let at = c * self.bounds.width + block / LANES;
            self.bounds.near[at].0[block % LANES] =
                vector::reduce(logs[i], |a, b| if a < b { a } else { b });
            self.bounds.far[at].0[block % LANES] =
                vector::reduce(logs[i], |a, b| if a > b { a } else { b });
            for lane in 0..LANES {
                logs[i][lane] = gaussian.log_scale() - 0.5 * logs[i][lane];
            }
        }
        logs
    }
}

impl Bounds {
    #[inline(always)]
    fn move_by<const FUSED: bool>(&mut self, c: usize, group: usize, drift: &Drift) {
        let at = c * self.width + group;
        let (near, far) = (&mut self.near[at].0, &mut self.far[at].0);
        for lane in 0..LANES {
            let least = multiply_add::<FUSED>(near[lane], drift.shrink, -drift.less);
            near[lane] = if least > 0.0 { least } else { 0.0 };
            far[lane] = multiply_add::<FUSED>(far[lane], drift.grow, drift.more);
        }
    }
}
