//! How training grows with a task: processor and wall seconds and peak memory by number
//! and length of demonstrations and by number of components, as CSV: `cargo bench -p
//! learning --bench growth`. Fails where a task that must fit into memory does not.
//!
//! A process's peak of memory never falls, so each case runs in a process of its own.
//! `-- --write` also writes the table and its figures into docs/performance, and
//! `-- --draw` only draws the figures anew from the table there.

#![expect(
    clippy::unwrap_used,
    reason = "a benchmark stops at what it does not expect"
)]

mod cases;
mod figure;
mod measured;
#[path = "../takes/mod.rs"]
mod takes;

use std::path::PathBuf;

use cases::Case;
use measured::Measured;

const TABLE: &str = "growth.csv";

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let given = |flag: &str| arguments.iter().any(|argument| argument == flag);
    if let Some(at) = arguments.iter().position(|a| a == "--one") {
        println!("{}", Case::from_csv(&arguments[at + 1]).run().to_csv());
    } else if given("--draw") {
        let table = std::fs::read_to_string(folder().join(TABLE)).unwrap();
        let rows: Vec<Measured> = table.lines().skip(1).map(Measured::from_csv).collect();
        draw(&rows);
    } else if given("--bench") {
        measure(given("--write"));
    } else {
        println!("skipped: this measures minutes long, and only `cargo bench` asks for it");
    }
}

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../docs/performance")
}

fn measure(write: bool) {
    println!("{}", Measured::HEADER);
    let mut rows = Vec::new();
    for case in Case::all() {
        let row = case.run_apart();
        println!("{}", row.to_csv());
        rows.push(row);
    }
    if write {
        let lines: Vec<String> = rows.iter().map(Measured::to_csv).collect();
        let table = format!("{}\n{}\n", Measured::HEADER, lines.join("\n"));
        std::fs::create_dir_all(folder()).unwrap();
        std::fs::write(folder().join(TABLE), table).unwrap();
        draw(&rows);
    }
    let too_large: Vec<String> = rows
        .iter()
        .filter(|row| row.is_too_large())
        .map(Measured::to_csv)
        .collect();
    assert!(
        too_large.is_empty(),
        "more memory than allowed:\n{}",
        too_large.join("\n")
    );
}

fn draw(rows: &[Measured]) {
    for figure in cases::figures(rows) {
        std::fs::write(folder().join(figure.file), figure.to_svg()).unwrap();
    }
}
