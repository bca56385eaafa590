//! Bayesian optimisation of two whole numbers: a Gaussian process describes what
//! is known of the objective, and the point with the largest expected improvement
//! is tried next, until two successive queries are equal (section "Parameters
//! optimization" of the paper). That rule can stop beside the minimum; since an
//! evaluation costs milliseconds, the neighbours of the best point are then tried
//! until none of them is better.

mod acquisition;
mod gaussian_process;
mod simplex;

use serde::{Deserialize, Serialize};

use crate::{Error, rng::Stream};
use acquisition::expected_improvement;
use gaussian_process::GaussianProcess;

const STREAM_OPTIMISATION: u64 = 3;
/// Points drawn at random before the process is asked.
const RANDOM_POINTS: usize = 10;
/// Improvement that counts, in units of the objective.
const XI: f64 = 0.01;

/// The box that is searched, ends included.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SearchBox {
    /// Lower ends.
    pub low: [u32; 2],
    /// Upper ends; a whole number of steps above the lower ones.
    pub high: [u32; 2],
    /// Distance of the points that are tried.
    pub step: [u32; 2],
    /// Most evaluations.
    pub max_calls: usize,
}

/// One evaluation of the objective.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Evaluation {
    /// Where.
    pub point: [u32; 2],
    /// The objective there.
    pub value: f64,
}

/// All evaluations in order, and the best of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimum {
    /// The best evaluation, the first one of equals.
    pub best: Evaluation,
    /// Every evaluation.
    pub evaluations: Vec<Evaluation>,
}

/// Minimises `objective` over the whole numbers of the box.
pub fn minimise(
    search: &SearchBox,
    seed: u64,
    objective: &mut dyn FnMut([u32; 2]) -> Result<f64, Error>,
) -> Result<Optimum, Error> {
    let mut rng = Stream::derive(seed, &[STREAM_OPTIMISATION]);
    let mut evaluations: Vec<Evaluation> = Vec::new();
    let mut process = None;
    while evaluations.len() < search.max_calls {
        let point = if evaluations.len() < RANDOM_POINTS {
            random_point(search, &mut rng)
        } else {
            propose(search, &evaluations, &mut process, &mut rng)
        };
        let repeated = evaluations.last().is_some_and(|last| last.point == point);
        let known = evaluations.iter().find(|e| e.point == point);
        let value = match known {
            Some(evaluation) => evaluation.value,
            None => objective(point)?,
        };
        evaluations.push(Evaluation { point, value });
        if repeated {
            break;
        }
    }
    descend(search, &mut evaluations, objective)?;
    let best = best(&evaluations);
    Ok(Optimum { best, evaluations })
}

/// Tries the neighbours of the best point until none of them is better.
fn descend(
    search: &SearchBox,
    evaluations: &mut Vec<Evaluation>,
    objective: &mut dyn FnMut([u32; 2]) -> Result<f64, Error>,
) -> Result<(), Error> {
    loop {
        let centre = best(evaluations).point;
        for point in neighbours(search, centre) {
            if !evaluations.iter().any(|e| e.point == point) {
                let value = objective(point)?;
                evaluations.push(Evaluation { point, value });
            }
        }
        if best(evaluations).point == centre {
            return Ok(());
        }
    }
}

/// The points of the box that are at most one step from `centre` in each direction.
fn neighbours(search: &SearchBox, centre: [u32; 2]) -> Vec<[u32; 2]> {
    let near = |i: usize| {
        let step = search.step[i];
        let from = centre[i].saturating_sub(step).max(search.low[i]);
        (from..=(centre[i] + step).min(search.high[i])).step_by(step as usize)
    };
    near(0)
        .flat_map(|first| near(1).map(move |second| [first, second]))
        .filter(|&point| point != centre)
        .collect()
}

fn random_point(search: &SearchBox, rng: &mut Stream) -> [u32; 2] {
    std::array::from_fn(|i| {
        let count = ((search.high[i] - search.low[i]) / search.step[i] + 1) as usize;
        search.low[i] + search.step[i] * rng.below(count) as u32
    })
}

/// The point of the box with the largest expected improvement. Where no point
/// promises any, the best one so far, which ends the search when asked twice.
fn propose(
    search: &SearchBox,
    evaluations: &[Evaluation],
    process: &mut Option<gaussian_process::Hyperparameters>,
    rng: &mut Stream,
) -> [u32; 2] {
    let incumbent = best(evaluations);
    let inputs: Vec<[f64; 2]> = evaluations
        .iter()
        .map(|e| scaled(search, e.point))
        .collect();
    let values: Vec<f64> = evaluations.iter().map(|e| e.value).collect();
    let Some(fitted) = GaussianProcess::fit(&inputs, &values, process.as_ref(), rng) else {
        return incumbent.point;
    };
    *process = Some(fitted.hyperparameters().clone());
    let mut chosen = (XI * 1e-3, incumbent.point);
    let along = |i: usize| (search.low[i]..=search.high[i]).step_by(search.step[i] as usize);
    for first in along(0) {
        for second in along(1) {
            let point = [first, second];
            let (mean, deviation) = fitted.predict(scaled(search, point));
            let gain = expected_improvement(incumbent.value - XI, mean, deviation);
            if gain > chosen.0 {
                chosen = (gain, point);
            }
        }
    }
    chosen.1
}

fn best(evaluations: &[Evaluation]) -> Evaluation {
    let mut best = evaluations[0];
    for evaluation in evaluations {
        if evaluation.value < best.value {
            best = *evaluation;
        }
    }
    best
}

fn scaled(search: &SearchBox, point: [u32; 2]) -> [f64; 2] {
    std::array::from_fn(|i| {
        let span = f64::from((search.high[i] - search.low[i]).max(1));
        f64::from(point[i] - search.low[i]) / span
    })
}

#[cfg(test)]
mod tests;
