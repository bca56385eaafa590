//! Blocks that several components share, and the arithmetic of sharing them.

use std::ops::Range;

use super::{Blocks, blocks::Moments};
use crate::{
    exp::exp_lanes,
    vector::{self, Aligned, LANES, for_each_dimension, lanes, multiply_add},
};

/// Lists of blocks, and what is known of each of them. The vectors are kept from
/// step to step.
pub struct Shared {
    /// Blocks listed for each component, `capacity` places each.
    pub blocks: Vec<u32>,
    counts: Vec<usize>,
    capacity: usize,
    /// For each block: least log density of its strongest component, its log
    /// densities, and the largest ones of all components.
    pub floor: Vec<f64>,
    pub own: Vec<Aligned<[f64; LANES]>>,
    pub max: Vec<Aligned<[f64; LANES]>>,
    /// Sum over the components, later its inverse.
    sum: Vec<Aligned<[f64; LANES]>>,
    /// (component, places in `pair_blocks`): blocks in which a component has a share
    /// beside the strongest one.
    pub pairs: Vec<(usize, Range<usize>)>,
    pub pair_blocks: Vec<u32>,
    /// Log densities at the places of `pair_blocks`, later exponentials.
    pub logs: Vec<Aligned<[f64; LANES]>>,
}

impl Shared {
    pub fn new(blocks: usize, k: usize) -> Shared {
        Shared {
            blocks: vec![0; blocks * k],
            counts: vec![0; k],
            capacity: blocks,
            floor: vec![0.0; blocks],
            own: vec![Aligned::default(); blocks],
            max: vec![Aligned::default(); blocks],
            sum: vec![Aligned::default(); blocks],
            pairs: Vec::with_capacity(k),
            pair_blocks: Vec::new(),
            logs: Vec::new(),
        }
    }

    pub fn clear(&mut self) {
        self.counts.fill(0);
    }

    /// Lists `block` for the component `strongest`.
    #[inline(always)]
    pub fn list(&mut self, strongest: usize, block: usize) {
        self.blocks[strongest * self.capacity + self.counts[strongest]] = block as u32;
        self.counts[strongest] += 1;
    }

    /// Places of the blocks listed for `strongest`.
    #[inline(always)]
    pub fn listed(&self, strongest: usize) -> Range<usize> {
        let first = strongest * self.capacity;
        first..first + self.counts[strongest]
    }

    #[inline(always)]
    pub fn begin_pairs(&mut self) {
        self.pairs.clear();
    }

    /// Lists those of the blocks `listed` that `matters` (block, floor) for `c`.
    #[inline(always)]
    pub fn list_pair(
        &mut self,
        c: usize,
        listed: Range<usize>,
        matters: impl Fn(usize, f64) -> bool,
    ) -> Range<usize> {
        let first = self.pairs.last().map_or(0, |(_, places)| places.end);
        let most = first + listed.len();
        if self.pair_blocks.len() < most {
            self.pair_blocks.resize(most, 0);
            self.logs.resize(most, Aligned::default());
        }
        let mut end = first;
        for &block in &self.blocks[listed] {
            self.pair_blocks[end] = block;
            end += usize::from(matters(block as usize, self.floor[block as usize]));
        }
        if end > first {
            self.pairs.push((c, first..end));
        }
        first..end
    }

    /// Turns the sum of a block into its inverse, 0 where no sample is; gives the sum
    /// of the `filled` samples' log likelihoods.
    #[inline(always)]
    pub fn normalise(&mut self, block: usize, filled: usize) -> f64 {
        let (mut max, mut sum) = (self.max[block].0, self.sum[block].0);
        let mut inverse: [f64; LANES] = lanes(|lane| 1.0 / sum[lane]);
        if filled < LANES {
            inverse[filled..].fill(0.0);
            sum[filled..].fill(1.0);
            max[filled..].fill(0.0);
        }
        self.sum[block].0 = inverse;
        // The sums are between 1 and k: one logarithm serves for their product.
        vector::reduce(max, |a, b| a + b) + vector::reduce(sum, |a, b| a * b).ln()
    }
}

/// Exponentials of all log densities, less the largest, and their sums.
#[inline(always)]
pub fn exponentials<const FUSED: bool>(shared: &mut Shared, listed: Range<usize>) {
    for at in listed {
        let block = shared.blocks[at] as usize;
        let (own, max) = (&shared.own[block].0, &shared.max[block].0);
        shared.sum[block].0 = exp_lanes::<FUSED, LANES>(lanes(|lane| own[lane] - max[lane]));
    }
    let end = shared.pairs.last().map_or(0, |(_, places)| places.end);
    for at in 0..end {
        let block = shared.pair_blocks[at] as usize;
        let (log, max) = (&shared.logs[at].0, &shared.max[block].0);
        let power = exp_lanes::<FUSED, LANES>(lanes(|lane| log[lane] - max[lane]));
        shared.logs[at].0 = power;
        for lane in 0..LANES {
            shared.sum[block].0[lane] += power[lane];
        }
    }
}

/// Blocks that are added together, so that running sums are read and written less.
const TOGETHER: usize = 4;

/// Moments of the share that the component of `pair` takes of its blocks.
#[inline(always)]
pub fn take_shares<const FUSED: bool, const D: usize>(
    shared: &Shared,
    pair: usize,
    data: &Blocks<D>,
) -> Moments<D> {
    let places = shared.pairs[pair].1.clone();
    let mut sums = LaneMoments::ZERO;
    let mut at = places.start;
    while at < places.end {
        let mut shares = [[0.0; LANES]; TOGETHER];
        let mut samples = [&data.samples()[0].0; TOGETHER];
        for i in 0..TOGETHER.min(places.end - at) {
            let block = shared.pair_blocks[at + i] as usize;
            let (power, inverse) = (&shared.logs[at + i].0, &shared.sum[block].0);
            shares[i] = lanes(|lane| power[lane] * inverse[lane]);
            samples[i] = &data.samples()[block].0;
        }
        sums.add::<FUSED>(&shares, &samples);
        at += TOGETHER;
    }
    sums.summed()
}

/// Running sums, one for each lane; of the second moments only the lower triangle.
#[repr(C, align(64))]
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
        // Two rows at a time, so that each sample is read once for both.
        for_each_dimension!(D, pair => {
            let i = 2 * pair;
            if i + 1 < D {
                self.add_rows::<FUSED, 2>(i, shares, samples);
            } else if i < D {
                self.add_rows::<FUSED, 1>(i, shares, samples);
            }
        });
    }

    /// Adds to `ROWS` rows from row `i` on. Of these the longest one decides how far all
    /// go; what lies above the diagonal is not read.
    #[inline(always)]
    fn add_rows<const FUSED: bool, const ROWS: usize>(
        &mut self,
        i: usize,
        shares: &[[f64; LANES]; TOGETHER],
        samples: &[&[[f64; LANES]; D]; TOGETHER],
    ) {
        let mut weighted = [[[0.0; LANES]; TOGETHER]; ROWS];
        for row in 0..ROWS {
            for b in 0..TOGETHER {
                for lane in 0..LANES {
                    weighted[row][b][lane] = shares[b][lane] * samples[b][i + row][lane];
                    self.first[i + row][lane] += weighted[row][b][lane];
                }
            }
        }
        for j in 0..i + ROWS {
            let mut sums: [[f64; LANES]; ROWS] = [[0.0; LANES]; ROWS];
            for row in 0..ROWS {
                sums[row] = self.second[i + row][j];
            }
            for b in 0..TOGETHER {
                for row in 0..ROWS {
                    for lane in 0..LANES {
                        sums[row][lane] = multiply_add::<FUSED>(
                            weighted[row][b][lane],
                            samples[b][j][lane],
                            sums[row][lane],
                        );
                    }
                }
            }
            for row in 0..ROWS {
                self.second[i + row][j] = sums[row];
            }
        }
    }

    #[inline(always)]
    fn summed(&self) -> Moments<D> {
        let mut moments = Moments::ZERO;
        moments.zeroth = vector::reduce(self.zeroth, |a, b| a + b);
        for i in 0..D {
            moments.first[i] = vector::reduce(self.first[i], |a, b| a + b);
            for j in 0..=i {
                moments.second[i][j] = vector::reduce(self.second[i][j], |a, b| a + b);
            }
        }
        moments
    }
}
