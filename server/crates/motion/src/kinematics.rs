//! Kinematics of the ABB GoFa CRB 15000-5/0.95: forward here, its derivative and its inverse
//! in the modules below. The only place where radians exist.
//!
//! The chain (all frames parallel when every joint is zero): each joint turns
//! about one axis of a frame that stands off from the frame before it. The wrist
//! is not spherical: axes 5 and 6 are 80 mm apart.

pub mod inverse;
mod jacobian;
#[cfg(test)]
mod tests;

pub use jacobian::Jacobian;

use crate::{JointAngles, Orientation, Pose, Position};

const IDENTITY: Orientation = Orientation {
    w: 1.0,
    x: 0.0,
    y: 0.0,
    z: 0.0,
};

#[derive(Clone, Copy)]
enum Axis {
    X,
    Y,
    Z,
}

/// Origin of each joint in its parent's frame (mm) and the axis it turns about.
const CHAIN: [([f64; 3], Axis); 6] = [
    ([0.0, 0.0, 265.0], Axis::Z),
    ([0.0, 0.0, 0.0], Axis::Y),
    ([0.0, 0.0, 444.0], Axis::Y),
    ([0.0, 0.0, 110.0], Axis::X),
    ([470.0, 0.0, 0.0], Axis::Y),
    ([101.0, 0.0, 80.0], Axis::X),
];

/// Pose of tool0 (the bare flange, z pointing out of it) in the base frame.
///
/// ```
/// use motion::{JointAngles, kinematics};
/// let at_zero = kinematics::tool0(&JointAngles([0.0; 6]));
/// assert_eq!(at_zero.position.0, [571.0, 0.0, 899.0]);
/// ```
pub fn tool0(joints: &JointAngles) -> Pose {
    let mut position = [0.0; 3];
    let mut orientation = IDENTITY;
    for (&(offset, axis), &angle_deg) in CHAIN.iter().zip(&joints.0) {
        let step = rotate(&orientation, offset);
        for (p, s) in position.iter_mut().zip(step) {
            *p += s;
        }
        orientation = multiply(&orientation, &about(axis, radians(angle_deg)));
    }
    // tool0 is turned a quarter about y, so that its z axis points out of the flange.
    let flange = about(Axis::Y, std::f64::consts::FRAC_PI_2);
    Pose {
        position: Position(position),
        orientation: multiply(&orientation, &flange),
    }
}

/// An angle for other programs that want it in radians, such as viewers of recordings. Nothing else
/// of this project reckons in them.
///
/// ```
/// assert_eq!(motion::kinematics::radians(180.0), std::f64::consts::PI);
/// ```
pub fn radians(angle_deg: f64) -> f64 {
    angle_deg.to_radians()
}

/// Where the tool's point is in the base frame, when it is at `tool_mm` in the frame of tool0.
pub fn tool_point(joints: &JointAngles, tool_mm: [f64; 3]) -> Position {
    let flange = tool0(joints);
    let reach = rotate(&flange.orientation, tool_mm);
    Position([0, 1, 2].map(|axis| flange.position.0[axis] + reach[axis]))
}

/// The line through the arm: base, every joint, flange and the tool's point, in the base frame.
pub fn centre_line(joints: &JointAngles, tool_mm: [f64; 3]) -> [Position; 8] {
    let mut line = [Position([0.0; 3]); 8];
    let mut position = [0.0; 3];
    let mut orientation = IDENTITY;
    for (joint, (&(offset, axis), &angle_deg)) in CHAIN.iter().zip(&joints.0).enumerate() {
        let step = rotate(&orientation, offset);
        for (p, s) in position.iter_mut().zip(step) {
            *p += s;
        }
        line[joint + 1] = Position(position);
        orientation = multiply(&orientation, &about(axis, angle_deg.to_radians()));
    }
    line[7] = tool_point(joints, tool_mm);
    line
}

/// Angles about the fixed axes x, y and z, in this order, that give an orientation, degrees.
/// This is how EGM writes orientations beside quaternions.
pub fn euler_xyz_deg(q: &Orientation) -> [f64; 3] {
    let about_x = (2.0 * (q.w * q.x + q.y * q.z)).atan2(1.0 - 2.0 * (q.x * q.x + q.y * q.y));
    let about_y = (2.0 * (q.w * q.y - q.z * q.x)).clamp(-1.0, 1.0).asin();
    let about_z = (2.0 * (q.w * q.z + q.x * q.y)).atan2(1.0 - 2.0 * (q.y * q.y + q.z * q.z));
    [about_x, about_y, about_z].map(f64::to_degrees)
}

fn about(axis: Axis, angle_rad: f64) -> Orientation {
    let (sin, cos) = (angle_rad / 2.0).sin_cos();
    let (x, y, z) = match axis {
        Axis::X => (sin, 0.0, 0.0),
        Axis::Y => (0.0, sin, 0.0),
        Axis::Z => (0.0, 0.0, sin),
    };
    Orientation { w: cos, x, y, z }
}

fn multiply(a: &Orientation, b: &Orientation) -> Orientation {
    Orientation {
        w: a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
        x: a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
        y: a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
        z: a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
    }
}

fn rotate(q: &Orientation, v: [f64; 3]) -> [f64; 3] {
    // v + 2 w (u x v) + 2 u x (u x v), with u the vector part of q.
    let u = [q.x, q.y, q.z];
    let c = cross(u, v);
    let cc = cross(u, c);
    [0, 1, 2].map(|i| v[i] + 2.0 * (q.w * c[i] + cc[i]))
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
