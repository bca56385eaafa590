//! Reading feedback and writing references without allocation, for the control loop.
//!
//! The reader takes from an `EgmRobot` exactly the fields the loop needs and skips the rest; on
//! every message the general decoder accepts, it finds the same values. The writer makes an
//! `EgmSensor` with header, joint positions and joint speeds. The general messages are in
//! [`crate::codec`].

mod fields;
mod read;
mod write;

pub use read::{ClockTime, RobotFeedback, read_feedback};
pub use write::{Correction, MAX_CORRECTION_BYTES, encode_correction};
