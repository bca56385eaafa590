//! What a training has to say about its result. Everything in it follows from the
//! demonstrations, the parameters and the seed; times are measured by the caller.

use serde::{Deserialize, Serialize};

use crate::{
    Demonstration, Method,
    agreement::Agreement,
    metrics::Fidelity,
    selection::{LeftOut, Stability},
};

/// An end that is further than this from all demonstrated ends, beyond their own
/// spread, is worth a word.
const END_TOLERANCE_MM: f64 = 5.0;

/// The report of one model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// Name of the task.
    pub task: String,
    /// How it was learned.
    pub method: Method,
    /// Seed of all random numbers.
    pub seed: u64,
    /// What it was learned from.
    pub demonstrations: Vec<Lineage>,
    /// Name of the demonstration that gave the time axis.
    pub reference: String,
    /// Remarks on the demonstrations, in words.
    pub notes: Vec<String>,
    /// How well the demonstrations agree, and whether to record another.
    pub agreement: Agreement,
    /// Number of components of the mixture.
    pub k: usize,
    /// Jensen-Shannon distance between mixtures for each number of components: of
    /// random halves (paper), or of fits with another demonstration left out.
    pub js: Vec<Stability>,
    /// How far a left-out demonstration is from what the others teach, for each
    /// number of components; empty for the paper's method.
    pub left_out: Vec<LeftOut>,
    /// Mean distance of the demonstrated points to the mean of the aligned
    /// demonstrations, mm: what the alignment alone allows, beside
    /// `fidelity.missed_mean_mm`.
    #[serde(default)]
    pub alignment_missed_mean_mm: Option<f64>,
    /// Stiffness of the spring.
    pub alpha_z: f64,
    /// Number of basis functions.
    pub n_basis: usize,
    /// Objective of the optimisation at its optimum, as published, degrees.
    pub objective: f64,
    /// The same with the true root mean square, as printed in the paper, degrees.
    pub objective_rms: f64,
    /// Evaluations of the objective.
    pub bo_calls: usize,
    /// Whether the optimum lies on the edge of the searched box.
    pub on_bound: bool,
    /// Which of alpha_z and n_basis lie there.
    pub on_bound_of: Vec<String>,
    /// GMCC of the reproduction against the regression, without intercept.
    pub gmcc: f64,
    /// The same with both curves centred.
    pub gmcc_centred: f64,
    /// Mean over the joints of |end - goal| of the commanded reproduction, degrees.
    pub e_j_deg: f64,
    /// The same figures from random starts around the taught one.
    pub start_noise: Vec<NoiseFigures>,
    /// The path against what was shown; none unless there are six joints.
    pub fidelity: Option<Fidelity>,
}

/// One demonstration a model was learned from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Lineage {
    /// Its name.
    pub name: String,
    /// SHA-256 of its times and joint angles.
    pub sha256: String,
    /// Its samples.
    pub samples: usize,
    /// Its duration, seconds.
    pub duration_s: f64,
}

/// Means over reproductions from starts with normal noise on every joint.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NoiseFigures {
    /// Standard deviation of the noise, degrees.
    pub noise_deg: f64,
    /// Reproductions.
    pub runs: usize,
    /// Mean GMCC against the regression.
    pub gmcc: f64,
    /// Smallest GMCC.
    pub gmcc_min: f64,
    /// Mean GMCC with intercept (both curves centred).
    #[serde(default)]
    pub gmcc_centred: Option<f64>,
    /// Mean e_j, degrees.
    pub e_j_deg: f64,
    /// Largest e_j, degrees.
    pub e_j_max_deg: f64,
}

impl Lineage {
    /// The lineage entry of a demonstration.
    pub fn of(demonstration: &Demonstration) -> Lineage {
        Lineage {
            name: demonstration.name().to_string(),
            sha256: demonstration.hash(),
            samples: demonstration.len(),
            duration_s: demonstration.duration_s(),
        }
    }
}

impl Report {
    /// The result in a sentence or two that a worker understands.
    pub fn summary(&self) -> String {
        let mut summary = match self.demonstrations.len() {
            1 => "Learned from one take.".to_string(),
            takes => format!("Learned from {takes} takes."),
        };
        if self.e_j_deg < 0.005 {
            summary += " The arm will reach the goal exactly.";
        } else {
            summary += &format!(
                " The arm will end {:.2}° from the goal on average.",
                self.e_j_deg
            );
        }
        if let Some(fidelity) = &self.fidelity {
            summary += &format!(
                " Its path runs {:.0} mm from what you showed on average, {:.0} mm at worst.",
                fidelity.missed_mean_mm, fidelity.missed_max_mm
            );
            let nearest_end = fidelity
                .end_mm
                .iter()
                .copied()
                .fold(f64::INFINITY, f64::min);
            if nearest_end > fidelity.end_spread_mm + END_TOLERANCE_MM {
                summary += &format!(" It ends {nearest_end:.0} mm away from where you ended.");
            }
            if fidelity.missed_over_mutual.is_some_and(|ratio| ratio > 1.0) {
                summary += " That is further than your takes are from each other: look at the preview before you run it.";
            }
        }
        summary
    }
}

/// Remarks on demonstrations that can be learned but deserve a word.
pub fn notes(demonstrations: &[Demonstration]) -> Vec<String> {
    let mut notes = Vec::new();
    if demonstrations.len() == 1 {
        notes.push(
            "There is only one take: small slips of the hand are learned as part of the motion, \
             and nothing says how exactly each place matters. Three takes are better."
                .to_string(),
        );
    }
    let joints = demonstrations.first().map_or(0, Demonstration::joints);
    let still: Vec<String> = (0..joints)
        .filter(|j| demonstrations.iter().all(|d| d.still_joints().contains(j)))
        .map(|j| (j + 1).to_string())
        .collect();
    match &still[..] {
        [] => {}
        [joint] => notes.push(format!(
            "Joint {joint} never moved in the takes and stays still in the motion."
        )),
        joints => notes.push(format!(
            "Joints {} never moved in the takes and stay still in the motion.",
            joints.join(", ")
        )),
    }
    notes
}
