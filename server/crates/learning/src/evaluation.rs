//! The tables of the paper's evaluation, computed again: how repeatable the number
//! of components is, Bayesian optimisation against grid search, and reproductions
//! from noisy starts. Times are measured by the caller.

use std::ops::ControlFlow;

use serde::{Deserialize, Serialize};

use crate::{
    Demonstration, Error, Method, Progress, TrainingParams,
    dmp::Imitation,
    optimisation, progress,
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

/// One search for alpha_z and N.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct OptimisationRun {
    /// The best point it found, (alpha_z, N).
    pub point: [u32; 2],
    /// The objective there, degrees.
    pub value: f64,
    /// Evaluations of the objective.
    pub calls: usize,
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

/// Searches for alpha_z and N on one regression.
pub struct Searches {
    imitation: Imitation,
    params: TrainingParams,
}

impl Searches {
    /// Finds the regression of the demonstrations that `params` gives.
    pub fn prepare(
        demonstrations: &[Demonstration],
        params: &TrainingParams,
        progress: progress::Report,
    ) -> Result<Searches, Error> {
        let encoding = training::encode(demonstrations, params, progress)?;
        Ok(Searches {
            imitation: training::imitation(&encoding.regression, params.method),
            params: params.clone(),
        })
    }

    /// The best point of the whole grid. The paper's grid leaves out the upper ends of
    /// its box (25 x 150 points); so does this one for its method.
    pub fn grid(&self) -> OptimisationRun {
        let open = u32::from(self.params.method == Method::Paper);
        let search = &self.params.search;
        let along = |i: usize| {
            let end = search.high[i] - open * search.step[i];
            (search.low[i]..=end).step_by(search.step[i] as usize)
        };
        let mut best = OptimisationRun {
            point: search.low,
            value: f64::INFINITY,
            calls: 0,
        };
        for alpha_z in along(0) {
            let stiffness = self.imitation.with(f64::from(alpha_z));
            for n_basis in along(1) {
                let value = stiffness.objective(n_basis as usize);
                best.calls += 1;
                if value < best.value {
                    (best.point, best.value) = ([alpha_z, n_basis], value);
                }
            }
        }
        best
    }

    /// Bayesian optimisation with the seed of `run`.
    pub fn bayesian(&self, run: usize) -> Result<OptimisationRun, Error> {
        let seed = with_seed(&self.params, run).seed;
        let optimum = optimisation::minimise(&self.params.search, seed, &mut |point| {
            Ok(training::objective_at(&self.imitation, point))
        })?;
        Ok(OptimisationRun {
            point: optimum.best.point,
            value: optimum.best.value,
            calls: optimum.evaluations.len(),
        })
    }
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
