//! The whole system through its front doors: HTTP, the live socket, UDP, the command line and the
//! browser, each against a real server with the virtual controller.

mod api;
mod cli;
mod crash;
mod doctor;
mod dragging;
mod flight;
mod hold;
mod https;
mod in_process;
mod independent;
mod pace;
mod pairing;
mod positions;
mod prepared;
mod published;
mod signals;
mod steps;
mod stop;
mod teach_and_reproduce;
mod teaching;
mod tidy;
mod virtual_robot;
mod webapp;

/// The server as a program, built beside these tests.
const PROGRAM: &str = env!("CARGO_BIN_EXE_server_under_test");

/// Where tests may leave files while they run.
const SCRATCH: &str = env!("CARGO_TARGET_TMPDIR");
