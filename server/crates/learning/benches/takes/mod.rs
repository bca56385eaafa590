//! What the benchmarks learn from: takes made up here, which need no files, and the
//! published recordings where they are at hand. Nothing is measured here.

use std::path::PathBuf;

use learning::{Demonstration, read, rng::Stream};
use motion::minimum_jerk;

/// Samples per second of the takes made here.
const RATE_HZ: f64 = 100.0;
/// The arm goes from pose to pose, in about this time each.
const SEGMENT_S: f64 = 2.5;
/// It stands before the first pose and after the last one.
const IDLE_S: f64 = 0.4;
/// Poses are drawn evenly around a pose in the middle of the workspace.
const MIDDLE_DEG: [f64; 6] = [0.0, 10.0, 10.0, 0.0, 40.0, 0.0];
const REACH_DEG: [f64; 6] = [60.0, 25.0, 25.0, 40.0, 30.0, 90.0];
/// How takes differ: standard deviations of the poses and of the logarithm of the pace.
const POSES_DEG: f64 = 1.0;
const PACE: f64 = 0.15;
/// The hand's tremor: its standard deviation, and what is left of it after a sample.
const TREMOR_DEG: f64 = 0.05;
const TREMOR_KEPT: f64 = 0.8;

/// `count` takes of one motion of six joints, each about `duration_s` long: sums of
/// minimum-jerk movements, each take with poses and a pace of its own, and a tremor.
pub fn synthetic(count: usize, duration_s: f64) -> Vec<Demonstration> {
    let segments = ((duration_s - 2.0 * IDLE_S) / SEGMENT_S).round().max(1.0) as usize;
    let mut rng = Stream::derive(1, &[]);
    let poses: Vec<[f64; 6]> = (0..=segments)
        .map(|_| {
            std::array::from_fn(|j| MIDDLE_DEG[j] + REACH_DEG[j] * (2.0 * rng.uniform() - 1.0))
        })
        .collect();
    let segment_s = (duration_s - 2.0 * IDLE_S) / segments as f64;
    (0..count)
        .map(|number| take(number, &poses, segment_s))
        .collect()
}

fn take(number: usize, poses: &[[f64; 6]], segment_s: f64) -> Demonstration {
    let mut rng = Stream::derive(2, &[number as u64]);
    let poses: Vec<[f64; 6]> = poses
        .iter()
        .map(|pose| pose.map(|q| q + POSES_DEG * rng.normal()))
        .collect();
    // Begin of each movement, and the end of the last one.
    let mut begins = vec![IDLE_S];
    for _ in 1..poses.len() {
        let last = begins[begins.len() - 1];
        begins.push(last + segment_s * (PACE * rng.normal()).exp());
    }
    let end = begins[begins.len() - 1] + IDLE_S;
    let times: Vec<f64> = (0..=(end * RATE_HZ) as usize)
        .map(|i| i as f64 / RATE_HZ)
        .collect();
    let mut tremor = [0.0; 6];
    let joints = times
        .iter()
        .map(|&t| {
            let mut row = poses[0];
            for (i, pair) in poses.windows(2).enumerate() {
                let (begin, end) = (begins[i], begins[i + 1]);
                if t > begin {
                    let share = minimum_jerk::share((t - begin) / (end - begin));
                    for j in 0..6 {
                        row[j] += share * (pair[1][j] - pair[0][j]);
                    }
                }
            }
            for (q, sway) in row.iter_mut().zip(&mut tremor) {
                let drawn = TREMOR_DEG * (1.0 - TREMOR_KEPT * TREMOR_KEPT).sqrt();
                *sway = TREMOR_KEPT * *sway + drawn * rng.normal();
                *q += *sway;
            }
            row.to_vec()
        })
        .collect();
    Demonstration::new(format!("take {}", number + 1), times, joints, None).unwrap()
}

/// The published recordings of `task`, in the folder that TEAM_PAPER_DATA names; none
/// where it is not set.
pub fn published(task: &str) -> Option<Vec<Demonstration>> {
    let folder = PathBuf::from(std::env::var_os("TEAM_PAPER_DATA")?)
        .join("paper")
        .join(task);
    let files = std::fs::read_dir(folder).unwrap();
    let mut files: Vec<PathBuf> = files.map(|file| file.unwrap().path()).collect();
    files.sort();
    let read = |file: &PathBuf| {
        let name = file.file_name().unwrap().to_string_lossy();
        read::from_str(&name, &std::fs::read_to_string(file).unwrap()).unwrap()
    };
    Some(files.iter().map(read).collect())
}
