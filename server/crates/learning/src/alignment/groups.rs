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

/// Refuses when a demonstration is further from the most typical one than takes
/// of one motion are. `distances` are the pairwise DTW distances of `signals`.
pub fn check_same_motion(
    demonstrations: &[Demonstration],
    signals: &[Path],
    distances: &[f64],
) -> Result<(), Error> {
    let m = demonstrations.len();
    let typical = super::medoid(distances, m);
    let joints = demonstrations[typical].joints_deg();
    let same = |i: usize| {
        let tool = relative(distances[i * m + typical], &signals[i], &signals[typical]);
        let own = demonstrations[i].joints_deg();
        i == typical
            || (tool <= SAME_TOOL_PATH
                && relative(dtw::squared_distance(own, joints).sqrt(), own, joints)
                    <= SAME_JOINT_PATH)
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

/// DTW distance per sample in units of the larger spread of the two.
fn relative(distance: f64, a: &Path, b: &Path) -> f64 {
    let samples = a.len().max(b.len()) as f64;
    distance / samples.sqrt() / f64::max(spread(a), spread(b)).max(1e-9)
}

/// Root mean square distance of the samples from their mean.
fn spread(signal: &Path) -> f64 {
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
