//! The arm's chain against the tool positions that a real controller reported:
//! micrometres while the arm stands still. Reads the recordings named by
//! TEAM_PAPER_DATA and is skipped without them.

#![expect(
    clippy::unwrap_used,
    reason = "a test stops at what it does not expect"
)]

use std::path::{Path, PathBuf};

use learning::{Demonstration, read};

fn recordings(folder: &Path) -> Vec<Demonstration> {
    let mut files: Vec<PathBuf> = Vec::new();
    for task in std::fs::read_dir(folder.join("paper")).unwrap() {
        let task = task.unwrap().path();
        if task.is_dir() {
            files.extend(std::fs::read_dir(task).unwrap().map(|f| f.unwrap().path()));
        }
    }
    files
        .iter()
        .filter(|file| file.extension().is_some_and(|e| e == "json"))
        .map(|file| {
            let text = std::fs::read_to_string(file).unwrap();
            read::from_str(&file.display().to_string(), &text).unwrap()
        })
        .collect()
}

#[test]
fn at_standstill_the_tool_is_where_the_controller_says() {
    let Some(folder) = std::env::var_os("TEAM_PAPER_DATA") else {
        println!("skipped: TEAM_PAPER_DATA is not set, the published recordings are not at hand");
        return;
    };
    let mut errors_um = Vec::new();
    for demonstration in recordings(Path::new(&folder)) {
        let (times, joints) = (demonstration.times_s(), demonstration.joints_deg());
        let computed = demonstration.tool_path_mm().unwrap();
        let reported = demonstration.recorded_tcp_mm().unwrap();
        // The recorder reads positions and joints one after the other: they belong
        // together only while the arm stands before and after.
        let speed = |i: usize| {
            let squares: f64 = joints
                .row(i)
                .iter()
                .zip(joints.row(i + 1))
                .map(|(a, b)| (a - b) * (a - b))
                .sum();
            squares.sqrt() / (times[i + 1] - times[i])
        };
        for i in 2..times.len() - 2 {
            if (i - 2..i + 2).all(|k| speed(k) < 0.02) {
                let squares: f64 = (0..3)
                    .map(|a| (computed[i][a] - reported[i][a]).powi(2))
                    .sum();
                errors_um.push(1000.0 * squares.sqrt());
            }
        }
    }
    errors_um.sort_by(f64::total_cmp);
    let n = errors_um.len();
    println!(
        "{n} samples at standstill: median {:.2} um, 90 % {:.2} um, worst {:.2} um",
        errors_um[n / 2],
        errors_um[n * 9 / 10],
        errors_um[n - 1]
    );
    assert!(n > 1000);
    assert!(errors_um[n / 2] < 1.0 && errors_um[n * 9 / 10] < 2.0);
    assert!(errors_um[n - 1] < 30.0);
}
