//! The tables of the paper's evaluation, computed again: how repeatable the number
//! of components is, Bayesian optimisation against grid search, and reproductions
//! from noisy starts. Times are measured by the caller.

use std::ops::ControlFlow;

use serde::{Deserialize, Serialize};

use crate::{
    Demonstration, Error, Method, Progress, TrainingParams,
    optimisation::{self, Evaluation},
    progress,
    report::NoiseFigures,
    statistics::{median, population_std},
    training,
};

/// The number of components over many runs that differ by their seed only.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Repeatability {
    /// k* of each run.
    pub k_of_runs: Vec<usize>,
    /// Their median.
    pub median: f64,
    /// Their population standard deviation.
    pub std: f64,
}

/// One run of Bayesian optimisation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct OptimisationRun {
    /// The best point it found, (alpha_z, N).
    pub point: [u32; 2],
    /// The objective there, degrees.
    pub value: f64,
    /// Evaluations of the objective.
    pub calls: usize,
}

/// Grid search and Bayesian optimisation on one regression.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Search {
    /// The best point of the grid.
    pub grid: OptimisationRun,
    /// Bayesian optimisation, once for each seed.
    pub bayesian: Vec<OptimisationRun>,
}

/// Chooses k `runs` times, with seeds from `params.seed` on. `progress` is called
/// with (run, progress of the run) and may end the work.
pub fn repeatability(
    demonstrations: &[Demonstration],
    params: &TrainingParams,
    runs: usize,
    progress: &(dyn Fn(usize, Progress) -> ControlFlow<()> + Sync),
) -> Result<Repeatability, Error> {
    let mut k_of_runs = Vec::with_capacity(runs);
    for run in 0..runs {
        let seeded = with_seed(params, run);
        let report = |p: Progress| progress(run, p);
        k_of_runs.push(training::encode(demonstrations, &seeded, &report)?.k);
    }
    let values: Vec<f64> = k_of_runs.iter().map(|&k| k as f64).collect();
    Ok(Repeatability {
        median: median(&values),
        std: population_std(&values),
        k_of_runs,
    })
}

/// Searches alpha_z and N over the whole grid, and by Bayesian optimisation with
/// `runs` seeds, on the regression that `params` gives. The paper's grid leaves out
/// the upper ends of its box (25 x 150 points); so does this one for its method.
pub fn search(
    demonstrations: &[Demonstration],
    params: &TrainingParams,
    runs: usize,
    progress: progress::Report,
) -> Result<Search, Error> {
    let encoding = training::encode(demonstrations, params, progress)?;
    let imitation = training::imitation(&encoding.regression, params.method);
    let mut grid: Option<Evaluation> = None;
    let mut calls = 0;
    let open = usize::from(params.method == Method::Paper);
    let along = |i: usize| {
        let search = &params.search;
        let count = ((search.high[i] - search.low[i]) / search.step[i]) as usize + 1 - open;
        (0..count).map(move |n| search.low[i] + search.step[i] * n as u32)
    };
    for first in along(0) {
        let stiffness = imitation.with(f64::from(first));
        for second in along(1) {
            let point = [first, second];
            let value = stiffness.objective(second as usize);
            calls += 1;
            if grid.is_none_or(|best| value < best.value) {
                grid = Some(Evaluation { point, value });
            }
        }
    }
    let grid = grid.ok_or(Error::NoDemonstrations)?;
    let bayesian = (0..runs)
        .map(|run| {
            let seed = with_seed(params, run).seed;
            let optimum = optimisation::minimise(&params.search, seed, &mut |point| {
                Ok(training::objective_at(&imitation, point))
            })?;
            Ok(OptimisationRun {
                point: optimum.best.point,
                value: optimum.best.value,
                calls: optimum.evaluations.len(),
            })
        })
        .collect::<Result<_, Error>>()?;
    Ok(Search {
        grid: OptimisationRun {
            point: grid.point,
            value: grid.value,
            calls,
        },
        bayesian,
    })
}

/// Trains once and gives the figures of reproductions from noisy starts.
pub fn noise(
    task: &str,
    demonstrations: &[Demonstration],
    params: &TrainingParams,
    progress: progress::Report,
) -> Result<Vec<NoiseFigures>, Error> {
    Ok(training::train(task, demonstrations, params, progress)?
        .report
        .start_noise)
}

fn with_seed(params: &TrainingParams, run: usize) -> TrainingParams {
    TrainingParams {
        seed: params.seed.wrapping_add(run as u64),
        ..params.clone()
    }
}
