//! A training as seen from a terminal: a bar, and what each stage took.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use indicatif::{ProgressBar, ProgressStyle};
use learning::{Progress, Stage};

/// Watches a training. The bar is drawn on a terminal only.
pub struct Watch {
    bar: ProgressBar,
    stages: Mutex<Stages>,
}

struct Stages {
    began: Instant,
    done: Vec<(Stage, f64)>,
    present: Option<Stage>,
}

impl Watch {
    pub fn begin(visible: bool) -> Watch {
        let bar = if visible {
            ProgressBar::new(1000)
        } else {
            ProgressBar::hidden()
        };
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {percent:>3} %  {msg}") {
            bar.set_style(style);
        }
        Watch {
            bar,
            stages: Mutex::new(Stages {
                began: now(),
                done: Vec::new(),
                present: None,
            }),
        }
    }

    /// Takes one report of progress; never cancels.
    pub fn see(&self, progress: Progress) -> ControlFlow<()> {
        let mut stages = self.stages.lock().unwrap_or_else(PoisonError::into_inner);
        if stages.present != Some(progress.stage) {
            stages.close();
            stages.present = Some(progress.stage);
            self.bar.set_message(progress.stage.words());
        }
        self.bar.set_position((progress.fraction * 1000.0) as u64);
        ControlFlow::Continue(())
    }

    /// Ends the bar; seconds of each stage, in order.
    pub fn finish(&self) -> Vec<(Stage, f64)> {
        self.bar.finish_and_clear();
        let mut stages = self.stages.lock().unwrap_or_else(PoisonError::into_inner);
        stages.close();
        std::mem::take(&mut stages.done)
    }
}

impl Stages {
    fn close(&mut self) {
        let ended = now();
        if let Some(stage) = self.present.take() {
            self.done
                .push((stage, ended.duration_since(self.began).as_secs_f64()));
        }
        self.began = ended;
    }
}

/// The clock of the command line; nothing that is computed depends on it.
pub fn now() -> Instant {
    Instant::now()
}
