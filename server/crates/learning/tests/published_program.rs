//! Stage by stage against the published program of the paper, on its own
//! intermediate results. They are read from the folder that the environment
//! variable TEAM_PAPER_DATA names; without it these tests say so and are skipped.

#![expect(
    clippy::unwrap_used,
    reason = "a test stops at what it does not expect"
)]

use std::path::PathBuf;

use learning::{
    Path, TrainingParams,
    dmp::{self, Extent, Imitation},
    metrics,
    mixture::{Mixture, Rows},
    optimisation, regression,
    selection::{self, SelectionParams, Stability, welch},
};
use serde_json::Value;

const TASKS: [&str; 5] = [
    "T1_opening",
    "T2_brush_picking_up",
    "T4_brush_homing",
    "F1_drill",
    "F2_avoid",
];

struct Published {
    figures: Value,
    folder: PathBuf,
    task: &'static str,
}

/// The published results of each task, or none where the folder is not given.
fn published() -> Vec<Published> {
    let Some(folder) = std::env::var_os("TEAM_PAPER_DATA") else {
        println!("skipped: TEAM_PAPER_DATA is not set, the published recordings are not at hand");
        return Vec::new();
    };
    let folder = PathBuf::from(folder).join("reference");
    let text = std::fs::read_to_string(folder.join("published_program.json")).unwrap();
    let all: Value = serde_json::from_str(&text).unwrap();
    TASKS
        .iter()
        .map(|&task| Published {
            figures: all[task].clone(),
            folder: folder.clone(),
            task,
        })
        .collect()
}

impl Published {
    fn number(&self, pointer: &str) -> f64 {
        self.figures.pointer(pointer).unwrap().as_f64().unwrap()
    }

    /// Distances between halves for k = 2..9.
    fn stabilities(&self) -> Vec<Stability> {
        (2..=9)
            .map(|k| {
                let values = &self.figures["js"][k.to_string()]["values"];
                Stability::of(k, numbers(values))
            })
            .collect()
    }

    fn mixture(&self) -> Mixture {
        let gmm = &self.figures["gmm"];
        Mixture {
            weights: numbers(&gmm["weights"]),
            means: gmm["means"]
                .as_array()
                .unwrap()
                .iter()
                .map(numbers)
                .collect(),
            covariances: gmm["covariances"]
                .as_array()
                .unwrap()
                .iter()
                .map(|rows| rows.as_array().unwrap().iter().map(numbers).collect())
                .collect(),
        }
    }

    /// Times and joints of its regression.
    fn gmr(&self) -> (Vec<f64>, Path) {
        let values = npy(&self.folder.join(format!("{}_gmr.npy", self.task)));
        let times = values.chunks_exact(7).map(|row| row[0]).collect();
        (
            times,
            Path::from_rows(6, values.chunks_exact(7).map(|row| &row[1..])),
        )
    }
}

fn numbers(values: &Value) -> Vec<f64> {
    values
        .as_array()
        .unwrap()
        .iter()
        .map(|v| v.as_f64().unwrap())
        .collect()
}

/// Values of a NumPy file of version 1.0, little-endian doubles in C order.
fn npy(path: &std::path::Path) -> Vec<f64> {
    let bytes = std::fs::read(path).unwrap();
    assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00", "{}", path.display());
    let header = usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    let text = std::str::from_utf8(&bytes[10..10 + header]).unwrap();
    assert!(text.contains("'<f8'") && text.contains("'fortran_order': False"));
    bytes[10 + header..]
        .chunks_exact(8)
        .map(|b| f64::from_le_bytes(b.try_into().unwrap()))
        .collect()
}

#[test]
fn the_walk_finds_the_same_k_on_its_own_distances() {
    for task in published() {
        let k = selection::choose(&task.stabilities());
        assert_eq!(k as f64, task.number("/k"), "{}", task.task);
    }
}

#[test]
fn distances_between_halves_agree_on_its_aligned_arrays() {
    for task in published() {
        let values = npy(&task.folder.join(format!("{}_aligned.npy", task.task)));
        let params = SelectionParams {
            k_min: 2,
            k_max: 9,
            splits: task.number("/splits") as usize,
        };
        let ours = selection::stabilities(Rows::new(7, &values), &params, 1, &|| Ok(())).unwrap();
        let mut differing = Vec::new();
        for (ours, theirs) in ours.iter().zip(task.stabilities()) {
            let greater = welch::p_greater(&ours.values, &theirs.values);
            let p = 2.0 * f64::min(greater, 1.0 - greater);
            println!(
                "{} k={} ours {:.4}±{:.4} published {:.4}±{:.4} p={p:.4}",
                task.task, ours.k, ours.mean, ours.std, theirs.mean, theirs.std
            );
            if p < 0.01 {
                differing.push(ours.k);
            }
        }
        assert!(differing.len() <= 2, "{}: k = {differing:?}", task.task);
    }
}

#[test]
fn regression_from_its_mixture_is_its_regression() {
    for task in published() {
        let (times, theirs) = task.gmr();
        let ours = regression::regress(&task.mixture(), &times);
        let worst = worst_difference(&ours.mean_deg, &theirs);
        println!("{} worst difference {worst:e} deg", task.task);
        assert!(worst < 1e-9, "{}: {worst:e}", task.task);
    }
}

#[test]
fn rollout_and_objective_at_its_optimum_agree() {
    for task in published() {
        let (times, path) = task.gmr();
        let dt = times[1] - times[0];
        let primitive = dmp::imitate(
            &path,
            dt,
            task.number("/tau_s"),
            task.number("/bo/alpha_z"),
            task.number("/bo/n_basis") as usize,
            dmp::PUBLISHED_FLOOR,
        );
        let rollout = primitive
            .rollout(path.row(0), path.last(), Extent::AsTaught)
            .unwrap();
        let end: Vec<f64> = rollout
            .last()
            .iter()
            .zip(path.last())
            .map(|(a, b)| a - b)
            .collect();
        let squares: f64 = rollout
            .rows()
            .zip(path.rows())
            .map(|(a, b)| a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>())
            .sum();
        let rms = (squares / path.len() as f64).sqrt();
        let checks = [
            (
                "objective",
                metrics::objective(&rollout, &path),
                task.number("/bo/objective"),
            ),
            (
                "e_j",
                metrics::e_j_deg(rollout.last(), path.last()),
                task.number("/e_j_deg"),
            ),
            (
                "end error",
                end.iter().map(|e| e * e).sum::<f64>().sqrt(),
                task.number("/end_error_l2_deg"),
            ),
            ("rms", rms, task.number("/true_rms_deg")),
            (
                "gmcc",
                metrics::gmcc(&rollout, &path),
                task.number("/gmcc_closed_form_no_intercept"),
            ),
        ];
        for (name, ours, theirs) in checks {
            println!("{} {name} ours {ours} published {theirs}", task.task);
            assert!(
                (ours - theirs).abs() < 1e-6,
                "{} {name}: {ours} {theirs}",
                task.task
            );
        }
    }
}

/// The exhaustive grid finds the published minimum, and Bayesian optimisation that of
/// the grid.
#[test]
fn optimisation_reaches_the_minimum_of_the_whole_grid() {
    for task in published() {
        let (times, path) = task.gmr();
        let (dt, tau) = (times[1] - times[0], task.number("/tau_s"));
        let theirs = task.number("/bo/objective");
        let search = TrainingParams::paper(0).search;
        let imitation = Imitation::of(&path, dt, tau, dmp::PUBLISHED_FLOOR);
        let grid = (search.low[0]..=search.high[0])
            .map(|alpha_z| imitation.with(f64::from(alpha_z)))
            .flat_map(|candidate| {
                (search.low[1]..=search.high[1]).map(move |n| candidate.objective(n as usize))
            })
            .fold(f64::INFINITY, f64::min);
        assert!(
            grid <= theirs * (1.0 + 1e-9),
            "{}: {grid} {theirs}",
            task.task
        );
        let mut near = 0;
        for seed in 0..50 {
            let optimum = optimisation::minimise(&search, seed, &mut |[alpha_z, n_basis]| {
                Ok(imitation
                    .with(f64::from(alpha_z))
                    .objective(n_basis as usize))
            })
            .unwrap();
            near += usize::from(optimum.best.value <= 1.005 * grid);
        }
        println!(
            "{} grid {grid:.4} published {theirs:.4}, {near} of 50",
            task.task
        );
        assert!(near >= 48, "{}: {near} of 50", task.task);
    }
}

fn worst_difference(a: &Path, b: &Path) -> f64 {
    assert_eq!(a.len(), b.len());
    a.rows()
        .zip(b.rows())
        .flat_map(|(x, y)| x.iter().zip(y).map(|(p, q)| (p - q).abs()))
        .fold(0.0, f64::max)
}
