//! How far a training is, in words for people.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use serde::Serialize;

use crate::Error;

/// The steps of a training.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Stage {
    /// Demonstrations are brought onto one time axis.
    Alignment,
    /// The number of components is found.
    Selection,
    /// The mixture is fitted.
    Mixture,
    /// The motion is read off the mixture.
    Regression,
    /// alpha_z and N are found.
    Optimisation,
    /// The figures of quality are computed.
    Evaluation,
}

impl Stage {
    /// All stages in order, each with its usual share of the time.
    pub const ALL: [(Stage, f64); 6] = [
        (Stage::Alignment, 0.10),
        (Stage::Selection, 0.76),
        (Stage::Mixture, 0.01),
        (Stage::Regression, 0.01),
        (Stage::Optimisation, 0.07),
        (Stage::Evaluation, 0.05),
    ];

    /// A stable name for programs.
    pub fn name(self) -> &'static str {
        match self {
            Stage::Alignment => "alignment",
            Stage::Selection => "selection",
            Stage::Mixture => "mixture",
            Stage::Regression => "regression",
            Stage::Optimisation => "optimisation",
            Stage::Evaluation => "evaluation",
        }
    }

    /// What is happening, in a worker's words.
    pub fn words(self) -> &'static str {
        match self {
            Stage::Alignment => "Comparing the takes",
            Stage::Selection => "Finding what the takes have in common",
            Stage::Mixture | Stage::Regression => "Drawing the motion",
            Stage::Optimisation => "Teaching the arm to follow it",
            Stage::Evaluation => "Checking the result",
        }
    }
}

/// One report of progress.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Progress {
    /// The present stage.
    pub stage: Stage,
    /// Steps of the stage that are done.
    pub done: usize,
    /// Steps of the stage.
    pub total: usize,
    /// Share of the whole training that is done, 0 to 1.
    pub fraction: f64,
}

/// Called with every step; may be called from several threads at once. Breaking
/// cancels the training.
pub type Report<'a> = &'a (dyn Fn(Progress) -> ControlFlow<()> + Sync);

/// Counts the steps of one stage.
pub struct Counter<'a> {
    report: Report<'a>,
    cancelled: AtomicBool,
    stage: Stage,
    done: AtomicUsize,
    total: usize,
}

impl<'a> Counter<'a> {
    /// Begins a stage of `total` steps.
    pub fn begin(report: Report<'a>, stage: Stage, total: usize) -> Result<Counter<'a>, Error> {
        let counter = Counter {
            report,
            cancelled: AtomicBool::new(false),
            stage,
            done: AtomicUsize::new(0),
            total: total.max(1),
        };
        counter.tell(0)?;
        Ok(counter)
    }

    /// One more step is done.
    pub fn step(&self) -> Result<(), Error> {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        self.tell(done.min(self.total))
    }

    fn tell(&self, done: usize) -> Result<(), Error> {
        if self.cancelled.load(Ordering::Relaxed) {
            return Err(Error::Cancelled);
        }
        let (mut before, mut share) = (0.0, 0.0);
        for (stage, weight) in Stage::ALL {
            share = weight;
            if stage == self.stage {
                break;
            }
            before += weight;
        }
        let fraction = before + share * done as f64 / self.total as f64;
        let progress = Progress {
            stage: self.stage,
            done,
            total: self.total,
            fraction: fraction.min(1.0),
        };
        match (self.report)(progress) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => {
                self.cancelled.store(true, Ordering::Relaxed);
                Err(Error::Cancelled)
            }
        }
    }
}
