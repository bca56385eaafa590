//! Externally Guided Motion (EGM): the 250 Hz UDP interface of an ABB controller.
//!
//! What lives here: the protobuf messages of RobotWare 6 and 7 ([`messages`]), their encoding and
//! decoding for programs that may allocate ([`codec`]), a reader and writer without allocation
//! for the control loop ([`wire`]), and the rules of a conversation ([`session`]). Sockets, threads
//! and clocks do not live here.
//!
//! All joint angles are degrees, speeds degrees per second, positions millimetres.
#![warn(missing_docs)]

pub mod codec;
pub mod error;
pub mod header;
pub mod messages;
pub mod session;
pub mod wire;

pub use error::Error;
pub use header::{ControllerTime, SequenceNumber};
pub use wire::{Correction, MAX_CORRECTION_BYTES, RobotFeedback, encode_correction, read_feedback};

/// The largest datagram we accept, in bytes.
///
/// A RobotWare 7 message has about 600 bytes; a UDP datagram on Ethernet carries at most 1472.
pub const MAX_DATAGRAM_BYTES: usize = 1500;
