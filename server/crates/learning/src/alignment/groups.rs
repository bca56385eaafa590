//! Do all demonstrations of a task show the same motion?

use super::dtw;
use crate::{Demonstration, Error, path::Path};

/// Largest distance from the most typical take, in units of how far the motion
/// itself spreads: of the tool, and of the joints.
///
/// Measured on 21 recordings of five tasks: takes of one task are at most 0.15
/// (tool) and 0.39 (joints) apart, takes of different tasks at least 0.30 in one
/// of them for the tool.
const SAME_TOOL_PATH: f64 = 0.25;
const SAME_JOINT_PATH: f64 = 0.60;
/// The spread counts as at least this much: a short motion, shown twice, differs by
/// the unsteadiness of the hand. In the signal's unit (mm of the tool, or degrees).
const LEAST_TOOL_SPREAD_MM: f64 = 120.0;
const LEAST_JOINT_SPREAD_DEG: f64 = 20.0;

/// Refuses when a demonstration is further from the most typical one than takes
/// of one motion are.
pub fn check_same_motion(demonstrations: &[Demonstration]) -> Result<(), Error> {
    let m = demonstrations.len();
    let signals: Vec<Path> = demonstrations
        .iter()
        .map(|d| thinned(&d.alignment_signal(), d.duration_s()))
        .collect();
    let tool_known = demonstrations.iter().all(|d| d.tool_path_mm().is_some());
    let least = if tool_known {
        LEAST_TOOL_SPREAD_MM
    } else {
        LEAST_JOINT_SPREAD_DEG
    };
    let joints: Vec<Path> = demonstrations
        .iter()
        .map(|d| thinned(d.joints_deg(), d.duration_s()))
        .collect();
    let mut distances = vec![0.0; m * m];
    for i in 0..m {
        for j in i + 1..m {
            let distance = relative(&signals[i], &signals[j], least);
            distances[i * m + j] = distance;
            distances[j * m + i] = distance;
        }
    }
    let typical = super::medoid(&distances, m);
    let same = |i: usize| {
        distances[i * m + typical] <= SAME_TOOL_PATH
            && relative(&joints[i], &joints[typical], LEAST_JOINT_SPREAD_DEG) <= SAME_JOINT_PATH
    };
    let (same, other): (Vec<usize>, Vec<usize>) = (0..m).partition(|&i| same(i));
    if other.is_empty() {
        return Ok(());
    }
    let names = |group: &[usize]| {
        group
            .iter()
            .map(|&i| demonstrations[i].name().to_string())
            .collect()
    };
    Err(Error::DifferentMotions {
        groups: [names(&same), names(&other)],
    })
}

/// At most this many samples are compared: motions differ in the large.
const COMPARED_SAMPLES: usize = 500;
/// But a long motion in so many a second: further apart, two takes would differ by
/// where on the way their samples happen to lie.
const COMPARED_RATE_HZ: f64 = 5.0;

fn thinned(path: &Path, duration_s: f64) -> Path {
    let n = path.len();
    let count = n.min(COMPARED_SAMPLES.max((COMPARED_RATE_HZ * duration_s) as usize));
    let pick = |i: usize| i * (n - 1) / (count - 1);
    Path::from_rows(path.width(), (0..count).map(|i| path.row(pick(i))))
}

/// DTW distance per sample in units of the larger spread of the two, which counts
/// as at least `least`.
fn relative(a: &Path, b: &Path, least: f64) -> f64 {
    let samples = a.len().max(b.len()) as f64;
    let distance = dtw::squared_distance(a, b).sqrt();
    distance / samples.sqrt() / spread(a).max(spread(b)).max(least)
}

/// Root mean square distance of the samples from their mean.
pub fn spread(signal: &Path) -> f64 {
    let n = signal.len() as f64;
    let variance: f64 = (0..signal.width())
        .map(|c| {
            let column = signal.column(c);
            let mean = column.iter().sum::<f64>() / n;
            column.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / n
        })
        .sum();
    variance.sqrt()
}
