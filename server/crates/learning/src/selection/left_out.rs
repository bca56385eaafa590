//! The number of components by what a left-out demonstration would miss.
//!
//! For every candidate k, the mixture is fitted along time to all demonstrations
//! but one, and the one that was left out is held against the regression. Small
//! mixtures miss because they are coarse; beyond some k nothing is gained. The
//! smallest k that is nearly as good as the best is taken.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::{Stability, js};
use crate::{
    Error, Path,
    alignment::Aligned,
    demonstration::tool_path_mm,
    mixture::{self, Mixture, Rows},
    nearest::Curve,
    regression,
    rng::Stream,
    statistics::mean,
};

/// A k is nearly as good as the best when it misses at most this much more.
const NEARLY: f64 = 1.05;
/// Points of a left-out demonstration that are asked for their distance.
const POINTS: usize = 1000;
/// Most demonstrations that are left out in turn.
const MAX_FOLDS: usize = 6;
const STREAM_FOLDS: u64 = 5;

/// How much a left-out demonstration misses with one number of components.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LeftOut {
    /// Number of components.
    pub k: usize,
    /// Mean over the left-out demonstrations of the mean distance of their points
    /// to the regression of the others: tool in mm, a degree of a joint as 3.5 mm.
    pub missed: f64,
}

/// What was found for one candidate.
#[derive(Clone, Debug, PartialEq)]
pub struct Tried {
    /// What was missed.
    pub left_out: LeftOut,
    /// Distances between the mixtures of successive folds.
    pub stability: Stability,
}

/// Tries every candidate with each demonstration left out in turn (the first
/// [`MAX_FOLDS`]). A single demonstration is held against itself.
///
/// Runs in the caller's thread pool; `step` is called after each fit.
pub fn leave_one_out(
    aligned: &Aligned,
    candidates: &[usize],
    seed: u64,
    step: &(dyn Fn() -> Result<(), Error> + Sync),
) -> Result<Vec<Tried>, Error> {
    let m = aligned.joints_deg.len();
    let folds = m.min(MAX_FOLDS);
    let signals: Vec<Path> = aligned.joints_deg.iter().map(signal).collect();
    let tasks: Vec<(usize, usize)> = candidates
        .iter()
        .flat_map(|&k| (0..folds).map(move |fold| (k, fold)))
        .collect();
    let fits = tasks
        .par_iter()
        .map(|&(k, fold)| {
            let kept: Vec<usize> = (0..m).filter(|&i| i != fold || m == 1).collect();
            let rows = aligned.rows(&kept);
            let width = aligned.joints_deg[0].width() + 1;
            let mixture = mixture::fit_along_time(Rows::new(width, &rows), k)?.mixture;
            let regression = regression::regress(&mixture, &aligned.t_s);
            let missed = mean_distance(&signals[fold], &signal(&regression.mean_deg));
            step()?;
            Ok((mixture, missed))
        })
        .collect::<Result<Vec<(Mixture, f64)>, Error>>()?;
    candidates
        .par_iter()
        .zip(fits.par_chunks(folds))
        .map(|(&k, fits)| {
            let missed = fits.iter().map(|(_, missed)| missed).sum::<f64>() / folds as f64;
            let mut rng = Stream::derive(seed, &[STREAM_FOLDS, k as u64]);
            let distances = fits
                .windows(2)
                .map(|pair| js::distance(&pair[0].0, &pair[1].0, &mut rng))
                .collect::<Result<Vec<f64>, Error>>()?;
            let distances = if distances.is_empty() {
                vec![0.0]
            } else {
                distances
            };
            Ok(Tried {
                left_out: LeftOut { k, missed },
                stability: Stability::of(k, distances),
            })
        })
        .collect()
}

/// The numbers of components that miss nearly as little as the best, the best first,
/// the smaller one of equals.
pub fn by_missed(tried: &[Tried]) -> Vec<usize> {
    let mut order: Vec<&LeftOut> = tried.iter().map(|t| &t.left_out).collect();
    order.sort_by(|a, b| a.missed.total_cmp(&b.missed).then(a.k.cmp(&b.k)));
    let least = order.first().map_or(0.0, |best| best.missed);
    order.retain(|t| t.missed <= NEARLY * least);
    order.iter().map(|t| t.k).collect()
}

/// What is compared: joints and, where known, tool positions, so that the turn of
/// the wrist counts as well as the place.
fn signal(joints_deg: &Path) -> Path {
    let tool = tool_path_mm(joints_deg);
    let width = joints_deg.width() + if tool.is_some() { 3 } else { 0 };
    let mut signal = Path::with_capacity(width, joints_deg.len());
    let mut row = Vec::with_capacity(width);
    for (i, joints) in joints_deg.rows().enumerate() {
        row.clear();
        row.extend(joints.iter().map(|q| q * MM_PER_DEG));
        if let Some(tool) = &tool {
            row.extend(tool[i]);
        }
        signal.push(&row);
    }
    signal
}

/// What a degree of a joint counts beside a millimetre of the tool: about the arc
/// that a degree of the wrist draws at the tip of a gripper of 200 mm.
const MM_PER_DEG: f64 = 3.5;

/// Mean distance of the points to the nearest sample of the curve.
fn mean_distance(points: &Path, curve: &Path) -> f64 {
    // Every fifth point, neighbours of 10 ms say the same; of a long motion about
    // POINTS, which is plenty for a mean.
    let step = (points.len() / POINTS).max(5);
    let chosen = Path::from_rows(points.width(), points.rows().step_by(step));
    mean(&Curve::new(curve).distances(&chosen))
}
