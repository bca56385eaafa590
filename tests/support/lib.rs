//! What the whole-system tests share: a server in this process or as a process of its own,
//! an HTTP client, made-up demonstrations, folders that vanish, and the one place that waits.
//!
//! Nothing here asserts anything about the product; the tests do.

mod client;
mod folder;
mod live;
mod motions;
mod process;
mod wait;

pub use client::{Client, Reply};
pub use folder::Folder;
pub use live::Live;
pub use motions::{Take, take};
pub use process::{Process, run_to_end};
pub use wait::{LONG, SHORT, eventually};
