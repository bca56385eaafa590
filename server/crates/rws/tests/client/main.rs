//! The client against a scripted controller on a real socket.
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

mod resources;
mod scripted;
mod sessions;
mod tls;
