//! The robot side against the virtual GoFa, over real sockets.
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

mod connection;
mod faults;
mod guidance;
mod https;
mod runs;
mod signals;
mod support;
