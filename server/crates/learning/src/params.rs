//! What a training is run with. Nobody has to set any of it: a method and a seed
//! determine the rest.

use serde::{Deserialize, Serialize};

use crate::{optimisation::SearchBox, selection::SelectionParams};

/// How a motion is learned.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// The paper's method, to its protocol.
    #[default]
    Paper,
}

impl Method {
    /// The name used on the command line and in the API.
    pub fn name(self) -> &'static str {
        match self {
            Method::Paper => "paper",
        }
    }

    /// The method of that name.
    pub fn from_name(name: &str) -> Option<Method> {
        [Method::Paper].into_iter().find(|m| m.name() == name)
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
    /// How the number of components is found.
    pub selection: SelectionParams,
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
            search: SearchBox {
                low: [5, 50],
                high: [30, 200],
                max_calls: 100,
            },
        }
    }

    /// The settings of `method`.
    pub fn of(method: Method, seed: u64) -> TrainingParams {
        match method {
            Method::Paper => TrainingParams::paper(seed),
        }
    }
}
