//! The layout in which samples are worked on: blocks of [`LANES`] rows, one
//! dimension after the other, so that each arithmetic step takes a whole block.

use super::Rows;

/// Rows in a block.
pub const LANES: usize = 8;

/// Samples in blocks. The last block is filled up with copies of its first row;
/// [`Blocks::filled`] says how many lanes of a block count.
#[derive(Clone, Debug)]
pub struct Blocks<const D: usize> {
    blocks: Vec<[[f64; LANES]; D]>,
    len: usize,
}

impl<const D: usize> Blocks<D> {
    /// Collects the rows numbered by `chosen`.
    pub fn gather(rows: Rows, chosen: &[usize]) -> Blocks<D> {
        let blocks = chosen
            .chunks(LANES)
            .map(|numbers| {
                let mut block = [[0.0; LANES]; D];
                for lane in 0..LANES {
                    let number = numbers.get(lane).unwrap_or(&numbers[0]);
                    for (dimension, value) in block.iter_mut().zip(rows.row(*number)) {
                        dimension[lane] = *value;
                    }
                }
                block
            })
            .collect();
        Blocks {
            blocks,
            len: chosen.len(),
        }
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.len
    }

    /// The blocks.
    pub fn iter(&self) -> impl Iterator<Item = &[[f64; LANES]; D]> {
        self.blocks.iter()
    }

    /// Lanes of block `index` that hold samples.
    pub fn filled(&self, index: usize) -> usize {
        LANES.min(self.len - index * LANES)
    }

    /// Sample `i`.
    pub fn sample(&self, i: usize) -> [f64; D] {
        let block = &self.blocks[i / LANES];
        std::array::from_fn(|d| block[d][i % LANES])
    }
}
