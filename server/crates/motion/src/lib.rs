//! What the whole project agrees on about the arm: units, joint angles, the
//! kinematic chain of the GoFa, its limits, and the gate that every motion must
//! pass before it may be streamed.
//!
//! Pure: no I/O, no clock, no randomness. Angles are degrees and lengths
//! millimetres everywhere; radians exist only inside [`kinematics`].
#![warn(missing_docs)]

pub mod drag;
pub mod filter;
pub mod follower;
pub mod gate;
pub mod keep_out;
pub mod kinematics;
pub mod limits;
pub mod minimum_jerk;
pub mod path_speed;
pub mod plan;
pub mod spline;
mod units;

pub use units::{JOINTS, JointAngles, JointVelocities, Orientation, Pose, Position};
