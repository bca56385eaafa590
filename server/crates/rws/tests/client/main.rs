//! The client against a scripted controller on a real socket.
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

mod cell;
mod resources;
mod scripted;
mod sessions;
mod subscriptions;
mod tls;
