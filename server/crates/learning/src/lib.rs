//! Learning a motion from demonstrations, and reproducing it from any start to any
//! goal, without a parameter to tune.
//!
//! The steps, one module each: [`alignment`] brings the demonstrations onto one
//! time axis; [`mixture`] and [`selection`] fit a Gaussian mixture whose number of
//! components is found from the data; [`regression`] reads the motion off it;
//! [`dmp`] turns the motion into a damped spring that reproduces it;
//! [`optimisation`] finds the spring's two parameters; [`metrics`] says how well
//! it all went. [`train`] does them in order.
//!
//! Pure: no I/O, no clock, no global state. Randomness comes from seeds; the same
//! demonstrations, parameters and seed give the same model, whatever the number of
//! threads. Parallel parts run in the rayon pool that the caller installs.
//!
//! ```
//! use learning::{Demonstration, TrainingParams, train};
//! use std::ops::ControlFlow;
//!
//! // Two takes of one joint that swings over and rests.
//! let take = |stretch: f64| {
//!     let times: Vec<f64> = (0..150).map(|i| f64::from(i) * 0.02 * stretch).collect();
//!     let angles = (0..150)
//!         .map(|i| vec![20.0 * (1.0 - (f64::from(i) / 149.0 * 3.14159).cos())])
//!         .collect();
//!     Demonstration::new(format!("stretched {stretch}"), times, angles, None)
//! };
//! let params = TrainingParams::faithful(1);
//! let model = train("swing", &[take(1.0)?, take(1.1)?], &params, &|_| ControlFlow::Continue(()))?;
//! let path = model.reproduce(&[5.0], &[30.0], learning::dmp::Extent::AsTaught)?;
//! assert!((path.last()[0] - 30.0).abs() < 1.0);
//! # Ok::<(), learning::Error>(())
//! ```
#![warn(missing_docs)]

pub mod agreement;
pub mod alignment;
pub mod demonstration;
pub mod dmp;
mod error;
pub mod evaluation;
mod exp;
pub mod metrics;
pub mod mixture;
pub mod model;
mod nearest;
pub mod optimisation;
mod params;
mod path;
mod progress;
pub mod read;
pub mod regression;
pub mod report;
pub mod rng;
pub mod selection;
pub mod signals;
pub mod statistics;
mod timeline;
mod training;
mod vector;
pub mod write;

pub use demonstration::Demonstration;
pub use error::{Error, Location};
pub use model::Model;
pub use params::{Method, TrainingParams};
pub use path::Path;
pub use progress::{Progress, Stage};
pub use report::Report;
pub use signals::{ModelSignal, SignalEvent};
pub use training::train;
