//! What a training is run with. Nobody has to set any of it: a method and a seed
//! determine the rest.

use serde::{Deserialize, Serialize};

use crate::{optimisation::SearchBox, selection::SelectionParams};

/// How a motion is learned.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// Goes where the demonstrations went: the paper's steps, with an alignment to
    /// the common mean, components along time, their number chosen by what a
    /// left-out demonstration would miss, and pinned ends.
    #[default]
    Faithful,
    /// The paper's method, to its protocol.
    Paper,
}

impl Method {
    /// The name used on the command line and in the API.
    pub fn name(self) -> &'static str {
        match self {
            Method::Faithful => "faithful",
            Method::Paper => "paper",
        }
    }

    /// The method of that name.
    pub fn from_name(name: &str) -> Option<Method> {
        [Method::Faithful, Method::Paper]
            .into_iter()
            .find(|method| method.name() == name)
    }
}

/// All settings of a training.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TrainingParams {
    /// The method.
    pub method: Method,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Rate to which aligned demonstrations are resampled, Hz.
    pub rate_hz: f64,
    /// How the number of components is found by the paper's method.
    pub selection: SelectionParams,
    /// Numbers of components that the faithful method tries, ascending.
    pub candidates: Vec<usize>,
    /// Where alpha_z and the number of basis functions are searched.
    pub search: SearchBox,
}

impl TrainingParams {
    /// The paper's protocol: 100 Hz; k = 2..9 with 50 random halves each; alpha_z
    /// in 5..=30 and N in 50..=200.
    pub fn paper(seed: u64) -> TrainingParams {
        TrainingParams {
            method: Method::Paper,
            seed,
            rate_hz: 100.0,
            selection: SelectionParams {
                k_min: 2,
                k_max: 9,
                splits: 50,
            },
            candidates: Vec::new(),
            search: SearchBox {
                low: [5, 50],
                high: [30, 200],
                step: [1, 1],
                max_calls: 100,
            },
        }
    }

    /// The faithful method.
    ///
    /// Its box reaches further than the paper's, whose optima mostly lie on the
    /// edge. alpha_z begins where a start that is off no longer matters at the goal:
    /// of the offset, (1 + alpha_z / 2) exp(-alpha_z / 2) is left after the motion's
    /// time, 2e-5 at 27.
    pub fn faithful(seed: u64) -> TrainingParams {
        TrainingParams {
            method: Method::Faithful,
            candidates: vec![2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 30, 40, 50],
            search: SearchBox {
                low: [27, 100],
                high: [100, 1000],
                step: [1, 10],
                max_calls: 40,
            },
            ..TrainingParams::paper(seed)
        }
    }

    /// The settings of `method`.
    pub fn of(method: Method, seed: u64) -> TrainingParams {
        match method {
            Method::Faithful => TrainingParams::faithful(seed),
            Method::Paper => TrainingParams::paper(seed),
        }
    }
}
