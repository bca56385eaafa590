//! Both methods from end to end on the recordings that the paper's authors
//! published. They are read from the folder that the environment variable
//! TEAM_PAPER_DATA names; without it these tests say so and are skipped.

#![expect(
    clippy::unwrap_used,
    reason = "a test stops at what it does not expect"
)]

use std::ops::ControlFlow;
use std::path::PathBuf;

use learning::{Demonstration, Method, Report, TrainingParams, read, train};

const TASKS: [&str; 5] = [
    "T1_opening",
    "T2_brush_picking_up",
    "T4_brush_homing",
    "F1_drill",
    "F2_avoid",
];

/// Demonstrations of each task, or none where the folder is not given.
fn tasks() -> Vec<(&'static str, Vec<Demonstration>)> {
    let Some(folder) = std::env::var_os("TEAM_PAPER_DATA") else {
        println!("skipped: TEAM_PAPER_DATA is not set, the published recordings are not at hand");
        return Vec::new();
    };
    let folder = PathBuf::from(folder).join("paper");
    TASKS
        .iter()
        .map(|&task| {
            let files = std::fs::read_dir(folder.join(task)).unwrap();
            let mut files: Vec<PathBuf> = files.map(|file| file.unwrap().path()).collect();
            files.sort();
            let demonstrations = files
                .iter()
                .map(|file| {
                    let name = file.file_name().unwrap().to_string_lossy();
                    read::from_str(&name, &std::fs::read_to_string(file).unwrap()).unwrap()
                })
                .collect();
            (task, demonstrations)
        })
        .collect()
}

fn report(task: &str, demonstrations: &[Demonstration], method: Method) -> Report {
    let params = TrainingParams::of(method, 1);
    train(
        task,
        demonstrations,
        &params,
        &|_| ControlFlow::Continue(()),
    )
    .unwrap()
    .report
}

/// The worst e_j of the paper's table is 0.30 deg, its GMCC 0.99.
fn assert_reproduces(report: &Report) {
    for noise in &report.start_noise {
        println!(
            "{} {} at {} deg: GMCC least {:.5}, e_j most {:.4} deg",
            report.task,
            report.method.name(),
            noise.noise_deg,
            noise.gmcc_min,
            noise.e_j_max_deg
        );
        assert!(noise.gmcc_min >= 0.99 && noise.e_j_max_deg <= 0.30);
    }
    assert_eq!(report.start_noise.len(), 4);
}

#[test]
fn the_papers_method_reproduces_within_the_papers_figures() {
    for (task, demonstrations) in tasks() {
        assert_reproduces(&report(task, &demonstrations, Method::Paper));
    }
}

/// Missed over mutual: the published program needs 0.90 to 2.11 by its protocol,
/// the plain mean of its aligned demonstrations 0.66 to 0.83, a barycentre without a
/// model 0.54 to 0.64.
#[test]
fn the_faithful_path_runs_through_the_middle_of_the_bundle_from_start_to_end() {
    for (task, demonstrations) in tasks() {
        let report = report(task, &demonstrations, Method::Faithful);
        assert_reproduces(&report);
        for noise in &report.start_noise {
            assert!(noise.e_j_max_deg <= 0.001, "{task}: {noise:?}");
            assert!(noise.gmcc_centred.unwrap() >= 0.999, "{task}: {noise:?}");
        }
        let fidelity = report.fidelity.as_ref().unwrap();
        let ratio = fidelity.missed_over_mutual.unwrap();
        let alignment = report.alignment_missed_mean_mm.unwrap();
        println!(
            "{task} faithful: missed over mutual {ratio:.3}, the alignment's own mean {:.3}; {}",
            alignment / fidelity.mutual_mean_mm.unwrap(),
            report.agreement.advice
        );
        assert!(ratio <= 0.65, "{task}: {ratio}");
        assert!(fidelity.missed_mean_mm <= 1.05 * alignment, "{task}");
        let mutual_max_mm = fidelity.mutual_max_mm.unwrap();
        assert!(fidelity.missed_max_mm <= mutual_max_mm, "{task}");
        assert!(fidelity.off_path_max_mm <= 0.5 * mutual_max_mm, "{task}");
        let farthest = |distances: &[f64]| distances.iter().copied().fold(0.0, f64::max);
        assert!(
            farthest(&fidelity.start_mm) <= fidelity.start_spread_mm,
            "{task}"
        );
        assert!(
            farthest(&fidelity.end_mm) <= fidelity.end_spread_mm,
            "{task}"
        );
        let (ours, shown) = (&fidelity.reproduction, &fidelity.demonstrations);
        assert!(
            ours.peak_acceleration_deg_s2 <= 1.1 * shown.peak_acceleration_deg_s2,
            "{task}"
        );
    }
}
