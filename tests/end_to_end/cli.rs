//! The command line on files: training from a folder, reproducing from a model file, and what it
//! says when it cannot.

use std::path::Path;
use std::process::Output;

use e2e::{Folder, run_to_end, take};
use serde_json::Value;

use crate::steps::{number, text};
use crate::{PROGRAM, SCRATCH};

/// A path as an argument.
pub fn path(path: &Path) -> &str {
    path.to_str().expect("test folders have plain names")
}

/// What a command printed.
pub fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Runs a command that must fail: with an exit code, in words, on the error stream only.
async fn refused(arguments: &[&str], words: &[&str]) {
    let output = run_to_end(PROGRAM, arguments).await;
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        !output.status.success(),
        "{arguments:?} was accepted:\n{:.400}",
        stdout(&output)
    );
    assert!(
        output.status.code().is_some(),
        "{arguments:?} did not end by itself:\n{said}"
    );
    assert!(
        stdout(&output).is_empty(),
        "{arguments:?}: {}",
        stdout(&output)
    );
    assert!(!said.contains("panicked"), "{arguments:?}:\n{said}");
    for word in words {
        assert!(
            said.contains(word),
            "{arguments:?} does not say {word:?}:\n{said}"
        );
    }
}

/// The rows of a reproduction printed as CSV.
pub fn rows(csv: &str) -> Vec<Vec<f64>> {
    let mut lines = csv.lines();
    assert_eq!(
        lines.next(),
        Some("t_s,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg")
    );
    let row = |line: &str| {
        line.split(',')
            .map(|field| field.parse().expect(line))
            .collect()
    };
    lines.map(row).collect()
}

/// Largest difference between the angles of a row and these.
pub fn off(row: &[f64], angles: &[f64]) -> f64 {
    row[1..]
        .iter()
        .zip(angles)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max)
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_folder_of_recordings_becomes_a_model_that_reproduces() {
    let folder = Folder::new(SCRATCH, "cli");
    let recordings = folder.path().join("setting down");
    std::fs::create_dir(&recordings).expect("a folder can be made");
    for number in 1..=2 {
        let file = recordings.join(format!("take_{number}.csv"));
        std::fs::write(file, take(number, 4.0).csv()).expect("a file can be written");
    }
    let model = folder.path().join("model.json");
    let arguments = [
        "train",
        path(&recordings),
        "--method",
        "paper",
        "--seed",
        "4",
        "--json",
        "--model",
        path(&model),
    ];
    let trained = run_to_end(PROGRAM, &arguments).await;
    let said = String::from_utf8_lossy(&trained.stderr).into_owned();
    assert!(trained.status.success(), "{said}");
    let report: Value = serde_json::from_str(&stdout(&trained)).expect("one JSON object");
    assert_report(&report);

    let by_default = run_to_end(PROGRAM, &["train", path(&recordings), "--json"]).await;
    let report: Value = serde_json::from_str(&stdout(&by_default)).expect("one JSON object");
    assert_ne!(
        text(&report, "method"),
        "paper",
        "the default is a better one"
    );
    assert!(number(&report, "gmcc") > 0.99, "{report}");

    let as_taught = run_to_end(PROGRAM, &["reproduce", path(&model), "--csv"]).await;
    assert!(
        as_taught.status.success(),
        "{}",
        String::from_utf8_lossy(&as_taught.stderr)
    );
    let taught = rows(&stdout(&as_taught));
    assert!(
        taught.windows(2).all(|pair| pair[1][0] > pair[0][0]),
        "time goes on"
    );
    let shown = take(1, 4.0).joints_deg;
    assert!(
        off(&taught[0], &shown[0]) < 3.0,
        "{:?} was shown as {:?}",
        taught[0],
        shown[0]
    );

    // Another start and another goal, both off by some degrees in every joint.
    let start: Vec<f64> = taught[0][1..].iter().map(|angle| angle - 4.0).collect();
    let goal: Vec<f64> = taught[taught.len() - 1][1..]
        .iter()
        .map(|angle| angle + 3.0)
        .collect();
    let list = |angles: &[f64]| {
        angles
            .iter()
            .map(f64::to_string)
            .collect::<Vec<_>>()
            .join(",")
    };
    let (from, to) = (
        format!("--start={}", list(&start)),
        format!("--goal={}", list(&goal)),
    );
    let moved = run_to_end(PROGRAM, &["reproduce", path(&model), &from, &to, "--csv"]).await;
    assert!(
        moved.status.success(),
        "{}",
        String::from_utf8_lossy(&moved.stderr)
    );
    let moved = rows(&stdout(&moved));
    assert!(
        off(&moved[0], &start) < 1e-3,
        "{:?} instead of {start:?}",
        moved[0]
    );
    let last = &moved[moved.len() - 1];
    assert!(off(last, &goal) < 0.3, "{last:?} instead of {goal:?}");

    let outside = format!("--goal={}", list(&[0.0, 0.0, 120.0, 0.0, -45.0, 0.0]));
    refused(
        &["reproduce", path(&model), &outside, "--csv"],
        &["joint 3", "85"],
    )
    .await;
    refused(
        &["reproduce", path(&model), "--goal=1,2,3", "--csv"],
        &["6"],
    )
    .await;
}

/// Everything that the report promises to contain.
fn assert_report(report: &Value) {
    assert_eq!(
        (text(report, "method"), &report["seed"]),
        ("paper", &Value::from(4)),
        "{report}"
    );
    assert_eq!(text(report, "task"), "setting down");
    assert!(!report["demonstrations"].is_null(), "{report}");
    let members = [
        "k",
        "alpha_z",
        "n_basis",
        "objective",
        "bo_calls",
        "gmcc",
        "e_j_deg",
    ];
    for member in members.into_iter().chain(["cpu_s", "wall_s"]) {
        assert!(number(report, member).is_finite(), "{member}: {report}");
    }
    let js = report["js"].as_array().expect("the divergence of every k");
    assert_eq!(
        js.iter()
            .map(|of_k| number(of_k, "k") as u32)
            .collect::<Vec<_>>(),
        [2, 3, 4, 5, 6, 7, 8, 9]
    );
    assert!(
        js.iter()
            .all(|of_k| number(of_k, "mean") >= 0.0 && number(of_k, "std") >= 0.0)
    );
    for member in ["on_bound", "fidelity", "stages_s"] {
        assert!(!report[member].is_null(), "{member}: {report}");
    }
    assert!(number(report, "gmcc") > 0.99, "{report}");
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_folder_that_cannot_be_trained_from_is_refused_in_words() {
    let folder = Folder::new(SCRATCH, "cli-bad");
    let missing = folder.path().join("not there");
    refused(&["train", path(&missing)], &["not there"]).await;

    let empty = folder.path().join("empty");
    std::fs::create_dir(&empty).expect("a folder can be made");
    refused(&["train", path(&empty)], &["empty"]).await;

    // One good recording and one with a hole: the file and the row are named.
    let broken = folder.path().join("broken");
    std::fs::create_dir(&broken).expect("a folder can be made");
    let good = take(1, 3.0).csv();
    std::fs::write(broken.join("good.csv"), &good).expect("a file can be written");
    let mut lines: Vec<&str> = good.lines().collect();
    lines[42] = "0.41,1,2,NaN,4,-45,6";
    std::fs::write(broken.join("hole.csv"), lines.join("\n")).expect("a file can be written");
    let model = folder.path().join("model.json");
    let arguments = ["train", path(&broken), "--model", path(&model)];
    refused(&arguments, &["hole.csv", "42", "joint 3"]).await;
    assert!(!model.exists(), "no model is left behind");

    refused(
        &["train", path(&broken), "--method", "magic"],
        &["magic", "paper"],
    )
    .await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_file_that_is_no_model_is_refused_in_words() {
    let folder = Folder::new(SCRATCH, "cli-no-model");
    refused(
        &["reproduce", "no-such-model.json"],
        &["no-such-model.json"],
    )
    .await;
    let text = folder.write("text.json", "this is not JSON");
    refused(&["reproduce", path(&text)], &["text.json"]).await;
    let other = folder.write("other.json", "{\"format\": \"something else\"}");
    refused(&["reproduce", path(&other)], &["other.json"]).await;
    refused(&["dance"], &["dance"]).await;
}

#[tokio::test]
async fn a_configuration_of_the_cell_that_can_not_be_used_is_refused_at_the_start() {
    let folder = Folder::new(SCRATCH, "cli-cell");
    let cell = folder.path().join("cell.toml");
    let data = folder.path().join("data");
    let start = ["serve", "--data", path(&data), "--config", path(&cell)];
    refused(&start, &["cell.toml", "can't be read"]).await;
    let wrong = "[[robot]]\nid = \"left\"\nkind = \"gofa\"\nrws_password = \"hunter2\"\n";
    std::fs::write(&cell, wrong).expect("the file is written");
    let words = ["cell.toml, line 1", "egm_listen", "for example"];
    refused(&start, &words).await;
    assert!(!data.exists(), "nothing is made before the file is read");
}
