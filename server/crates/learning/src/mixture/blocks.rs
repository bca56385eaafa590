//! The layout in which samples are worked on: blocks of [`LANES`] samples, one
//! dimension after the other, so that each arithmetic step takes a whole block.
//!
//! Each block also knows its moments and a ball that holds it. Where neighbours in
//! the order given are alike (samples in order of time), most blocks belong to one
//! cluster or component as a whole, and their moments stand for them.

use super::Rows;
use crate::vector::{self, Aligned, Kernel, LANES, lanes};

/// Samples, relative to their common mean.
#[derive(Clone, Debug)]
pub struct Blocks<const D: usize> {
    centre: [f64; D],
    samples: Vec<Block<D>>,
    moments: Vec<Moments<D>>,
    groups: Vec<Group<D>>,
    len: usize,
}

/// Sums of share times (1, x, x xᵀ). Rows are padded to whole vectors; of the
/// second moments only the lower triangle is meant.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Moments<const D: usize> {
    pub second: [[f64; LANES]; D],
    pub first: [f64; LANES],
    pub zeroth: f64,
}

/// One block: for each dimension the values of its samples.
pub type Block<const D: usize> = Aligned<[[f64; LANES]; D]>;

/// Balls around [`LANES`] successive blocks: means and radii.
#[derive(Clone, Copy, Debug)]
pub struct Group<const D: usize> {
    pub mean: [[f64; LANES]; D],
    pub radius: [f64; LANES],
}

impl<const D: usize> Moments<D> {
    pub const ZERO: Self = Moments {
        zeroth: 0.0,
        first: [0.0; LANES],
        second: [[0.0; LANES]; D],
    };

    /// Adds one sample.
    #[inline(always)]
    pub fn add_sample(&mut self, x: &[f64; D]) {
        let mut padded = [0.0; LANES];
        padded[..D].copy_from_slice(x);
        self.zeroth += 1.0;
        for lane in 0..LANES {
            self.first[lane] += padded[lane];
        }
        for (row, a) in self.second.iter_mut().zip(x) {
            for lane in 0..LANES {
                row[lane] += a * padded[lane];
            }
        }
    }

    /// Takes the samples of `other` away.
    #[inline(always)]
    pub fn subtract(&mut self, other: &Moments<D>) {
        self.zeroth -= other.zeroth;
        for lane in 0..LANES {
            self.first[lane] -= other.first[lane];
        }
        for (row, from) in self.second.iter_mut().zip(&other.second) {
            for lane in 0..LANES {
                row[lane] -= from[lane];
            }
        }
    }

    /// Adds the samples of `other`.
    #[inline(always)]
    pub fn add(&mut self, other: &Moments<D>) {
        self.zeroth += other.zeroth;
        for lane in 0..LANES {
            self.first[lane] += other.first[lane];
        }
        for (row, from) in self.second.iter_mut().zip(&other.second) {
            for lane in 0..LANES {
                row[lane] += from[lane];
            }
        }
    }
}

impl<const D: usize> Blocks<D> {
    /// Collects the rows numbered by `chosen`. The last block is filled up with
    /// copies of its first sample; [`Blocks::filled`] says how many lanes count.
    pub fn gather(rows: Rows, chosen: &[usize]) -> Blocks<D> {
        vector::dispatch(Gather::<D> { rows, chosen })
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Mean of all samples, to which the blocks are relative.
    pub fn centre(&self) -> &[f64; D] {
        &self.centre
    }

    /// The blocks.
    pub fn samples(&self) -> &[Block<D>] {
        &self.samples
    }

    /// Moments of each block.
    pub fn moments(&self) -> &[Moments<D>] {
        &self.moments
    }

    /// Balls around the blocks, [`LANES`] together.
    pub fn groups(&self) -> &[Group<D>] {
        &self.groups
    }

    /// Lanes of block `index` that hold samples.
    #[inline(always)]
    pub fn filled(&self, index: usize) -> usize {
        LANES.min(self.len - index * LANES)
    }

    /// Sample `i`, relative to the centre.
    pub fn sample(&self, i: usize) -> [f64; D] {
        let block = &self.samples[i / LANES].0;
        std::array::from_fn(|d| block[d][i % LANES])
    }
}

struct Gather<'a, const D: usize> {
    rows: Rows<'a>,
    chosen: &'a [usize],
}

impl<const D: usize> Kernel for Gather<'_, D> {
    type Output = Blocks<D>;

    #[inline(always)]
    fn run<const FUSED: bool>(self) -> Blocks<D> {
        let Gather { rows, chosen } = self;
        let mut centre = [0.0; D];
        for &number in chosen {
            for (sum, x) in centre.iter_mut().zip(rows.row(number)) {
                *sum += x;
            }
        }
        for sum in &mut centre {
            *sum /= chosen.len().max(1) as f64;
        }
        let count = chosen.len().div_ceil(LANES);
        let mut blocks = Blocks {
            centre,
            samples: Vec::with_capacity(count),
            moments: Vec::with_capacity(count),
            groups: Vec::with_capacity(count.div_ceil(LANES)),
            len: chosen.len(),
        };
        for numbers in chosen.chunks(LANES) {
            let mut block = [[0.0; LANES]; D];
            let mut sums = Moments::ZERO;
            for lane in 0..LANES {
                let row = rows.row(numbers[if lane < numbers.len() { lane } else { 0 }]);
                let x: [f64; D] = lanes(|d| row[d] - centre[d]);
                for (dimension, value) in block.iter_mut().zip(x) {
                    dimension[lane] = value;
                }
                if lane < numbers.len() {
                    sums.add_sample(&x);
                }
            }
            blocks.samples.push(Aligned(block));
            blocks.moments.push(sums);
        }
        let parts = blocks
            .samples
            .chunks(LANES)
            .zip(blocks.moments.chunks(LANES));
        for (samples, sums) in parts {
            blocks.groups.push(Group::around(samples, sums));
        }
        blocks
    }
}

impl<const D: usize> Group<D> {
    /// Lanes without a block repeat the first one.
    #[inline(always)]
    fn around(blocks: &[Block<D>], sums: &[Moments<D>]) -> Group<D> {
        let mut group = Group {
            mean: [[0.0; LANES]; D],
            radius: [0.0; LANES],
        };
        for lane in 0..LANES {
            let at = if lane < blocks.len() { lane } else { 0 };
            let (block, sum) = (&blocks[at], &sums[at]);
            let mut squares = [0.0; LANES];
            for d in 0..D {
                let mean = sum.first[d] / sum.zeroth;
                group.mean[d][lane] = mean;
                for (square, x) in squares.iter_mut().zip(&block.0[d]) {
                    *square += (x - mean) * (x - mean);
                }
            }
            group.radius[lane] = squares.iter().fold(0.0f64, |a, &b| a.max(b)).sqrt();
        }
        group
    }
}
