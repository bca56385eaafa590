//! Which sizes are measured, what is done with each, and which figures show them.

use std::ops::ControlFlow;
use std::process::Command;

use learning::{
    Demonstration, Method, TrainingParams, alignment,
    mixture::{self, Rows},
    rng::Stream,
    train,
};

use crate::{
    figure::{Figure, Series},
    measured::{Measured, measured},
    takes,
};

/// Of the protocol's 50 halves for each k, where the whole protocol would take long.
const FEW_SPLITS: usize = 5;
/// What T1 may need, and what three demonstrations of ten minutes may, MB.
const ALLOWED_T1_MB: f64 = 100.0;
const ALLOWED_LONG_MB: f64 = 1000.0;
const LONG_S: u32 = 600;

const T1: &str = "T1";
/// As many takes as T1 has, and as long, where T1 is not at hand.
const LIKE_T1: &str = "like T1";
const MADE_UP: &str = "synthetic";

const FAITHFUL: &str = "faithful";
const PAPER: &str = "paper";
const PAPER_BRIEF: &str = "paper with 5 splits";
const ALONG_TIME: &str = "one fit along time";
const FROM_KMEANS: &str = "one fit from k-means";

/// One size, and what is done with it.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    pub growth: String,
    pub task: String,
    pub what: String,
    pub demonstrations: usize,
    pub length_s: u32,
    /// Components of a single fit; 0 where a whole training finds them.
    pub k: usize,
}

impl Case {
    fn new(growth: &str, what: &str, demonstrations: usize, length_s: u32, k: usize) -> Case {
        Case {
            growth: growth.into(),
            task: MADE_UP.into(),
            what: what.into(),
            demonstrations,
            length_s,
            k,
        }
    }

    /// All sizes, in the order in which they are measured.
    pub fn all() -> Vec<Case> {
        let mut cases = Vec::new();
        let task = if takes::published("T1_opening").is_some() {
            T1
        } else {
            LIKE_T1
        };
        for what in [FAITHFUL, PAPER] {
            let task = task.to_string();
            let case = Case::new("none", what, 6, 34, 0);
            cases.push(Case { task, ..case });
        }
        let mut add = |growth: &str, what: &str, sizes: &[(usize, u32, usize)]| {
            for &(demonstrations, length_s, k) in sizes {
                cases.push(Case::new(growth, what, demonstrations, length_s, k));
            }
        };
        let count = |n: usize| (n, 30, 0);
        let counts = [1, 2, 3, 5, 8, 12, 20].map(count);
        add("demonstrations", FAITHFUL, &counts);
        add("demonstrations", PAPER_BRIEF, &[2, 5, 10, 20].map(count));
        let length = |s: u32| (3, s, 0);
        let lengths = [10, 30, 60, 120, 240, LONG_S].map(length);
        add("length", FAITHFUL, &lengths);
        add("length", PAPER_BRIEF, &[10, 60, 180, LONG_S].map(length));
        let components = |k: usize| (3, 60, k);
        let ks = [2, 3, 5, 8, 12, 20, 30, 50].map(components);
        add("components", ALONG_TIME, &ks);
        add("components", FROM_KMEANS, &ks);
        cases
    }

    /// The most memory that the case may need, MB.
    pub fn allowed_mb(&self) -> Option<f64> {
        if self.task != MADE_UP {
            Some(ALLOWED_T1_MB)
        } else {
            (self.length_s == LONG_S).then_some(ALLOWED_LONG_MB)
        }
    }

    /// Runs it in a process of its own.
    pub fn run_apart(&self) -> Measured {
        let output = Command::new(std::env::current_exe().unwrap())
            .args(["--one", &self.to_csv()])
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{self:?} failed: {said}");
        let said = String::from_utf8(output.stdout).unwrap();
        Measured::from_csv(said.trim())
    }

    /// Runs it in this process.
    pub fn run(self) -> Measured {
        let demonstrations = match self.task.as_str() {
            T1 => takes::published("T1_opening").unwrap(),
            _ => takes::synthetic(self.demonstrations, f64::from(self.length_s)),
        };
        let few = || {
            let mut params = TrainingParams::paper(1);
            params.selection.splits = FEW_SPLITS;
            params
        };
        match self.what.as_str() {
            FAITHFUL => self.training(&demonstrations, &TrainingParams::of(Method::Faithful, 1)),
            PAPER => self.training(&demonstrations, &TrainingParams::of(Method::Paper, 1)),
            PAPER_BRIEF => self.training(&demonstrations, &few()),
            _ => self.fit(&demonstrations),
        }
    }

    fn training(self, demonstrations: &[Demonstration], params: &TrainingParams) -> Measured {
        let go_on = |_| ControlFlow::Continue(());
        measured(self, || {
            train("growth", demonstrations, params, &go_on).unwrap();
        })
    }

    fn fit(self, demonstrations: &[Demonstration]) -> Measured {
        let aligned = alignment::align(demonstrations, 100.0, &mut |_, _| Ok(())).unwrap();
        let all: Vec<usize> = (0..demonstrations.len()).collect();
        let values = aligned.rows(&all);
        let rows = Rows::new(7, &values);
        let (chosen, k) = (rows.by_time(), self.k);
        let along_time = self.what == ALONG_TIME;
        measured(self, || {
            if along_time {
                mixture::fit_along_time(rows, k).unwrap();
            } else {
                mixture::fit(rows, &chosen, k, &mut Stream::derive(1, &[])).unwrap();
            }
        })
    }
}

/// The figures for the sizes that were measured.
pub fn figures(rows: &[Measured]) -> Vec<Figure> {
    let series = |growth: &str, x: fn(&Case) -> f64, y: fn(&Measured) -> Option<f64>| {
        let mut found: Vec<Series> = Vec::new();
        for row in rows.iter().filter(|row| row.case.growth == growth) {
            let Some(y) = y(row) else { continue };
            let name = &row.case.what;
            if found.iter().all(|series| series.name != *name) {
                found.push(Series::named(name));
            }
            let series = found.iter_mut().find(|series| series.name == *name);
            series.unwrap().points.push((x(&row.case), y));
        }
        found
    };
    let (cpu_s, peak_mb) = (
        |row: &Measured| Some(row.cpu_s),
        |row: &Measured| row.peak_mb,
    );
    let (seconds, memory) = ("time of processor [s]", "peak memory [MB]");
    let count = |case: &Case| case.demonstrations as f64;
    let length = |case: &Case| f64::from(case.length_s);
    let (by_count, by_length) = (
        "demonstrations of 30 s each [number]",
        "length of each of 3 demonstrations [s]",
    );
    let by_k = "components k, on 3 demonstrations of 60 s [number]";
    let figure = |file, x, y, series| Figure { file, x, y, series };
    vec![
        figure(
            "time-by-demonstrations.svg",
            by_count,
            seconds,
            series("demonstrations", count, cpu_s),
        ),
        figure(
            "time-by-length.svg",
            by_length,
            seconds,
            series("length", length, cpu_s),
        ),
        figure(
            "time-by-components.svg",
            by_k,
            seconds,
            series("components", |case| case.k as f64, cpu_s),
        ),
        figure(
            "memory-by-demonstrations.svg",
            by_count,
            memory,
            series("demonstrations", count, peak_mb),
        ),
        figure(
            "memory-by-length.svg",
            by_length,
            memory,
            series("length", length, peak_mb),
        ),
    ]
}
