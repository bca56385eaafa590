//! Typed quantities shared by every crate. Angles are degrees, lengths
//! millimetres; no type here knows the robot's chain or its limits.

use serde::{Deserialize, Serialize};

/// Number of joints of the arm.
pub const JOINTS: usize = 6;

/// Angles of joints 1 to 6, degrees.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct JointAngles(pub [f64; JOINTS]);

/// Speeds of joints 1 to 6, degrees per second.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct JointVelocities(pub [f64; JOINTS]);

/// A point in the base frame, millimetres.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Position(pub [f64; 3]);

/// A unit quaternion, `w` first as the controller writes it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Orientation {
    /// Scalar part.
    pub w: f64,
    /// Vector part along x of the base.
    pub x: f64,
    /// Vector part along y of the base.
    pub y: f64,
    /// Vector part along z of the base.
    pub z: f64,
}

/// Position and orientation of a frame in the base frame.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pose {
    /// Origin of the frame, millimetres.
    pub position: Position,
    /// Orientation of the frame.
    pub orientation: Orientation,
}

impl JointAngles {
    /// True when no angle is NaN or infinite.
    pub fn is_finite(&self) -> bool {
        self.0.iter().all(|angle| angle.is_finite())
    }

    /// Largest absolute difference over the joints, degrees.
    pub fn max_abs_difference(&self, other: &JointAngles) -> f64 {
        self.0
            .iter()
            .zip(&other.0)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max)
    }
}

impl JointVelocities {
    /// The arm standing still.
    pub const ZERO: JointVelocities = JointVelocities([0.0; JOINTS]);

    /// True when no speed is NaN or infinite.
    pub fn is_finite(&self) -> bool {
        self.0.iter().all(|speed| speed.is_finite())
    }
}

impl Position {
    /// Euclidean distance, millimetres.
    pub fn distance(&self, other: &Position) -> f64 {
        let [dx, dy, dz] = [0, 1, 2].map(|i| self.0[i] - other.0[i]);
        (dx * dx + dy * dy + dz * dz).sqrt()
    }
}
