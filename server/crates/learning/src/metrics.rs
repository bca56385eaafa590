//! Figures of quality: the paper's, and the path fidelity that looks at what was
//! shown.

mod fidelity;
mod gmcc;
mod kinetics;

pub use fidelity::{Fidelity, fidelity, missed_mean_mm};
pub use gmcc::{Gmcc, gmcc, gmcc_both};
pub use kinetics::Kinetics;

use crate::path::{Path, squared_distance};

/// Mean over the joints of |end - goal|, degrees (e_j of the paper).
pub fn e_j_deg(end_deg: &[f64], goal_deg: &[f64]) -> f64 {
    let sum: f64 = end_deg
        .iter()
        .zip(goal_deg)
        .map(|(end, goal)| (end - goal).abs())
        .sum();
    sum / end_deg.len() as f64
}

/// Objective of the optimisation as the published figures have it:
/// (1/sqrt(T)) sum_t |y_t - y_G,t| + |y_T - G|, degrees. Paths of equal length.
pub fn objective(reproduction_deg: &Path, regression_deg: &Path) -> f64 {
    let sum: f64 = reproduction_deg
        .rows()
        .zip(regression_deg.rows())
        .map(|(y, reference)| squared_distance(y, reference).sqrt())
        .sum();
    sum / (regression_deg.len() as f64).sqrt()
        + squared_distance(reproduction_deg.last(), regression_deg.last()).sqrt()
}

/// Objective as the paper's text prints it, with the root mean square, degrees.
pub fn objective_rms(reproduction_deg: &Path, regression_deg: &Path) -> f64 {
    let sum: f64 = reproduction_deg
        .rows()
        .zip(regression_deg.rows())
        .map(|(y, reference)| squared_distance(y, reference))
        .sum();
    (sum / regression_deg.len() as f64).sqrt()
        + squared_distance(reproduction_deg.last(), regression_deg.last()).sqrt()
}

#[cfg(test)]
mod tests;
