//! How fast the tool moves and turns when the joints turn: the geometric Jacobian.
//!
//! A joint that turns about the axis `z` through the point `o` moves a point `p` by `z × (p - o)`
//! and turns everything behind it about `z` (Siciliano, Sciavicco, Villani, Oriolo: Robotics.
//! Modelling, Planning and Control, section 3.1.3).

use super::{Axis, CHAIN, IDENTITY, about, cross, multiply, rotate};
use crate::{JOINTS, JointAngles, JointVelocities};

/// The Jacobian of a point that is fixed to the tool flange, in the base frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jacobian {
    /// How far the point moves along x, y and z of the base when each joint turns, mm/deg.
    pub linear: [[f64; JOINTS]; 3],
    /// How far the flange turns about x, y and z of the base when each joint turns, deg/deg.
    pub angular: [[f64; JOINTS]; 3],
}

impl Jacobian {
    /// Of the point at `tool_mm` in the frame of tool0, while the arm stands at `joints`.
    #[must_use]
    pub fn of(joints: &JointAngles, tool_mm: [f64; 3]) -> Self {
        let mut origins = [[0.0; 3]; JOINTS];
        let mut axes = [[0.0; 3]; JOINTS];
        let mut position = [0.0; 3];
        let mut orientation = IDENTITY;
        for (joint, (&(offset, axis), &angle_deg)) in CHAIN.iter().zip(&joints.0).enumerate() {
            let step = rotate(&orientation, offset);
            position = [0, 1, 2].map(|i| position[i] + step[i]);
            origins[joint] = position;
            axes[joint] = rotate(&orientation, along(axis));
            orientation = multiply(&orientation, &about(axis, angle_deg.to_radians()));
        }
        let point = super::tool_point(joints, tool_mm).0;
        let mut jacobian = Self {
            linear: [[0.0; JOINTS]; 3],
            angular: [[0.0; JOINTS]; 3],
        };
        for joint in 0..JOINTS {
            let lever = [0, 1, 2].map(|i| point[i] - origins[joint][i]);
            let moved = cross(axes[joint], lever);
            for i in 0..3 {
                jacobian.linear[i][joint] = moved[i].to_radians();
                jacobian.angular[i][joint] = axes[joint][i];
            }
        }
        jacobian
    }

    /// Speed of the point when the joints turn like this, mm/s.
    #[must_use]
    pub fn point_speed_mm_s(&self, speeds: &JointVelocities) -> f64 {
        let along = self.linear.map(|row| {
            let parts = row.iter().zip(speeds.0);
            parts.map(|(part, speed)| part * speed).sum::<f64>()
        });
        along.iter().map(|speed| speed * speed).sum::<f64>().sqrt()
    }
}

fn along(axis: Axis) -> [f64; 3] {
    match axis {
        Axis::X => [1.0, 0.0, 0.0],
        Axis::Y => [0.0, 1.0, 0.0],
        Axis::Z => [0.0, 0.0, 1.0],
    }
}
