//! The number of components k* of the mixture.
//!
//! For every k of a range, the samples are split at random into halves, a mixture
//! is fitted to each, and the Jensen-Shannon distance between the two is taken; a
//! walk of one-tailed Welch tests picks the k that is stable (section "Gaussian
//! Mixture Model and Gaussian Mixture Regression" of the paper).

pub mod js;
mod left_out;
pub mod welch;

pub use left_out::{LeftOut, Tried, by_missed, leave_one_out};

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::{
    Error,
    mixture::{self, Rows},
    rng::Stream,
    statistics::{mean, population_std},
};

/// Level of the tests.
const ALPHA: f64 = 0.05;
/// Labels of the random streams, so that purposes never share numbers.
const STREAM_SPLIT: u64 = 1;

/// What to try.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectionParams {
    /// Smallest number of components.
    pub k_min: usize,
    /// Largest number of components.
    pub k_max: usize,
    /// Random halves for each k.
    pub splits: usize,
}

/// Distances between the halves for one k.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stability {
    /// Number of components.
    pub k: usize,
    /// Mean of the distances.
    pub mean: f64,
    /// Population standard deviation of the distances.
    pub std: f64,
    /// The distance of each split.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub values: Vec<f64>,
}

impl Stability {
    /// Mean and deviation of `values`, which must not be empty.
    pub fn of(k: usize, values: Vec<f64>) -> Stability {
        Stability {
            k,
            mean: mean(&values),
            std: population_std(&values),
            values,
        }
    }
}

/// Distances between random halves of `rows` for every k, in ascending order of k.
///
/// The splits run in parallel in the caller's thread pool; the result does not
/// depend on the number of threads. `step` is called after every split.
pub fn stabilities(
    rows: Rows,
    params: &SelectionParams,
    seed: u64,
    step: &(dyn Fn() -> Result<(), Error> + Sync),
) -> Result<Vec<Stability>, Error> {
    let tasks: Vec<(usize, usize)> = (params.k_min..=params.k_max)
        .flat_map(|k| (0..params.splits).map(move |split| (k, split)))
        .collect();
    let by_time = rows.by_time();
    let distances = tasks
        .par_iter()
        .map(|&(k, split)| {
            let mut rng = Stream::derive(seed, &[STREAM_SPLIT, k as u64, split as u64]);
            let distance = split_distance(rows, &by_time, k, &mut rng)?;
            step()?;
            Ok(distance)
        })
        .collect::<Result<Vec<f64>, Error>>()?;
    Ok(distances
        .chunks(params.splits)
        .zip(params.k_min..)
        .map(|(values, k)| Stability::of(k, values.to_vec()))
        .collect())
}

/// Fits both halves of one random split and compares them. `by_time` lists the rows
/// in the order of their times.
fn split_distance(rows: Rows, by_time: &[usize], k: usize, rng: &mut Stream) -> Result<f64, Error> {
    let mut order: Vec<usize> = (0..rows.len()).collect();
    rng.shuffle(&mut order);
    let mut tested = vec![0; rows.len()];
    for &i in &order[..rows.len().div_ceil(2)] {
        tested[i] = 1;
    }
    // Either half in the order of time, in which fitting is fastest. No branch: which
    // half a row falls to is a coin toss.
    let mut halves = [vec![0; rows.len()], vec![0; rows.len()]];
    let mut counts = [0, 0];
    for &i in by_time {
        for (half, count) in halves.iter_mut().zip(counts) {
            half[count] = i;
        }
        counts[tested[i]] += 1;
    }
    let [train, test] = halves;
    let first = mixture::fit(rows, &train[..counts[0]], k, rng)?;
    let second = mixture::fit(rows, &test[..counts[1]], k, rng)?;
    js::distance(&first.mixture, &second.mixture, rng)
}

/// The walk: starts at the lowest mean; for each k in ascending order, unless it
/// is significantly worse than the present choice, moves there when it is
/// significantly better or scatters less.
///
/// # Panics
/// When `candidates` is empty.
pub fn choose(candidates: &[Stability]) -> usize {
    let mut best = 0;
    for (i, candidate) in candidates.iter().enumerate() {
        if candidate.mean < candidates[best].mean {
            best = i;
        }
    }
    for i in 0..candidates.len() {
        if i == best {
            continue;
        }
        let (candidate, present) = (&candidates[i], &candidates[best]);
        if welch::p_greater(&candidate.values, &present.values) < ALPHA {
            continue;
        }
        let better = welch::p_greater(&present.values, &candidate.values) < ALPHA;
        if better || candidate.std < present.std {
            best = i;
        }
    }
    candidates[best].k
}

#[cfg(test)]
mod tests;
