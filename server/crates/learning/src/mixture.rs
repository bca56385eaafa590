//! Gaussian mixtures over (time, joints), fitted by expectation maximisation.
//!
//! Full covariances; components start from the clusters of k-means; EM stops when
//! the mean log likelihood of a sample changes by less than 1e-3 or after 100
//! iterations; 1e-6 is added to the diagonal of every covariance. These are the
//! settings of the paper's published program, where its text is silent.

mod blocks;
mod em;
mod expectation;
mod gaussian;
mod kmeans;
mod shared;

use serde::{Deserialize, Serialize};

pub(crate) use gaussian::{Gaussian, prepare};

use blocks::Blocks;

use crate::{Error, rng::Stream};

/// A mixture of k Gaussians in D dimensions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mixture {
    /// Share of each component; they sum to 1.
    pub weights: Vec<f64>,
    /// Mean of each component, D values.
    pub means: Vec<Vec<f64>>,
    /// Covariance of each component, D rows of D values.
    pub covariances: Vec<Vec<Vec<f64>>>,
}

/// How a fit went.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// The mixture.
    pub mixture: Mixture,
    /// Mean log likelihood of a sample before each M step, in order.
    pub log_likelihoods: Vec<f64>,
    /// Whether EM converged before its last iteration.
    pub converged: bool,
}

/// Rows of equal width, the data of a fit.
#[derive(Clone, Copy, Debug)]
pub struct Rows<'a> {
    width: usize,
    values: &'a [f64],
}

impl<'a> Rows<'a> {
    /// `values` holds rows of `width` values, row after row; `width` is 1 to 8.
    ///
    /// # Panics
    /// When `values` is no whole number of rows.
    pub fn new(width: usize, values: &'a [f64]) -> Rows<'a> {
        assert!((1..=8).contains(&width) && values.len().is_multiple_of(width));
        Rows { width, values }
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.values.len() / self.width
    }

    /// True without rows.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// Values in a row.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Row `i`.
    pub fn row(&self, i: usize) -> &'a [f64] {
        &self.values[i * self.width..(i + 1) * self.width]
    }

    /// The numbers of all rows in the order of dimension 0, the time.
    pub fn by_time(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.len()).collect();
        order.sort_by(|&a, &b| self.row(a)[0].total_cmp(&self.row(b)[0]));
        order
    }
}

/// Calls a function that is generic over the dimension with the constant that
/// equals `$width`.
macro_rules! with_dimension {
    ($width:expr, $function:ident ($($argument:expr),*)) => {
        match $width {
            1 => $function::<1>($($argument),*),
            2 => $function::<2>($($argument),*),
            3 => $function::<3>($($argument),*),
            4 => $function::<4>($($argument),*),
            5 => $function::<5>($($argument),*),
            6 => $function::<6>($($argument),*),
            7 => $function::<7>($($argument),*),
            8 => $function::<8>($($argument),*),
            other => unreachable!("a dimension of {other}: widths are checked to be 1 to 8"),
        }
    };
}
pub(crate) use with_dimension;

/// Fits a mixture of `k` components to the rows numbered by `chosen`, beginning
/// with k-means. It is fastest when neighbours in `chosen` are alike, as rows in
/// the order of their times are.
pub fn fit(rows: Rows, chosen: &[usize], k: usize, rng: &mut Stream) -> Result<Fit, Error> {
    with_dimension!(rows.width(), fit_in(rows, chosen, k, rng))
}

/// Fits a mixture of `k` components to all rows, beginning with `k` stretches of
/// equal length along dimension 0, the time: nothing is drawn at random, and the
/// components follow the motion.
pub fn fit_along_time(rows: Rows, k: usize) -> Result<Fit, Error> {
    with_dimension!(rows.width(), fit_along_time_in(rows, k))
}

fn fit_along_time_in<const D: usize>(rows: Rows, k: usize) -> Result<Fit, Error> {
    enough(rows.len(), k)?;
    let order = rows.by_time();
    let labels: Vec<u16> = (0..order.len())
        .map(|i| (i * k / order.len()) as u16)
        .collect();
    em::maximise(&Blocks::<D>::gather(rows, &order), &labels, k)
}

fn enough(samples: usize, k: usize) -> Result<(), Error> {
    if k == 0 || samples < k || k > usize::from(u16::MAX) {
        return Err(Error::MixtureFailed {
            reason: format!("{samples} samples for {k} components"),
        });
    }
    Ok(())
}

fn fit_in<const D: usize>(
    rows: Rows,
    chosen: &[usize],
    k: usize,
    rng: &mut Stream,
) -> Result<Fit, Error> {
    enough(chosen.len(), k)?;
    let data = Blocks::<D>::gather(rows, chosen);
    let labels = kmeans::cluster(&data, k, rng);
    em::maximise(&data, &labels, k)
}

#[cfg(test)]
mod tests;
