//! The server: what records, trains, plans and reproduces, and the pages and interfaces to it.
//!
//! Inside, `http` knows HTTP, `store` knows SQL, `jobs` does background work; the arm is in the
//! crate `robot`, the learning in `learning`, numbers and the gate in `motion`.

mod agreement;
mod announce;
mod app;
mod arms;
pub mod cell;
mod certificates;
pub mod cli;
pub mod clock;
pub mod config;
mod control;
mod dragging;
mod events;
mod flight;
mod http;
pub mod ids;
mod jobs;
mod pairing;
mod pictures;
pub mod planning;
mod plans;
mod positions;
pub mod program;
mod questionnaire;
mod recording;
mod reproducing;
mod shutdown;
mod store;
#[cfg(test)]
mod test_support;
mod training;
mod trimming;
mod uninterrupted;
mod uploads;
mod words;

pub use announce::announcement;
pub use app::{App, RunningApp, StartError};
pub use shutdown::asked_by_the_system;
