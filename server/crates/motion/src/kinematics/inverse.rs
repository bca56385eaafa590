//! Inverse kinematics: which joint angles bring the tool flange towards a wanted pose.
//!
//! The wrist of this arm is not spherical, so there is no closed form with decoupled wrist; it is
//! solved by damped least squares. With the error `e` of the pose and the Jacobian `J` one step is
//!
//! `Δq = (JᵀJ + λ²I)⁻¹ Jᵀ e`
//!
//! (Siciliano, Sciavicco, Villani, Oriolo: Robotics. Modelling, Planning and Control, section
//! 3.5.2; Wampler, IEEE Transactions on Systems, Man, and Cybernetics 16, 1986). The damping grows
//! with the error, `λ² = λ₀² + κ |e|`, as in the Levenberg-Marquardt methods of Sugihara (IEEE
//! Transactions on Robotics 27, 2011) and of Fan and Yuan (Computing 74, 2005): what `JᵀJ` leaves
//! out of the curvature is in proportion to `|e|`, so that a pose out of reach makes the steps end
//! at the nearest pose instead of swinging about it. `λ₀` bounds the steps near singular poses.
//!
//! A joint that a step would lead out of its range is held at the end of the range, and the step
//! of the other joints is solved again without it.

use nalgebra::{SMatrix, SVector};

use super::{Axis, Jacobian, about, multiply, tool0};
use crate::limits::RobotLimits;
use crate::{JOINTS, JointAngles, Orientation, Pose};

/// One radian of orientation weighs as much as so many millimetres.
const RADIAN_MM: f64 = 500.0;
/// Smallest damping `λ₀`, mm/rad: it takes over where the wrist is within 2° of its stretched pose.
const DAMPING_MM: f64 = 20.0;
/// Damping for each millimetre of error `κ`, mm: half the arm's reach, which bounds the curvature.
const CURVATURE_MM: f64 = 500.0;

type Matrix = SMatrix<f64, JOINTS, JOINTS>;
type Vector = SVector<f64, JOINTS>;

/// How far it is from one pose to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseError {
    /// Along x, y and z of the base, mm.
    pub position_mm: [f64; 3],
    /// About x, y and z of the base: one turn about the axis with these parts, by its length, deg.
    pub turn_deg: [f64; 3],
}

/// One step from `from` towards the pose `wanted` of tool0. No joint leaves its range or turns
/// farther than `longest_deg`; a pose that is not a number moves nothing.
#[must_use]
pub fn step(
    from: &JointAngles,
    wanted: &Pose,
    limits: &RobotLimits,
    longest_deg: &[f64; JOINTS],
) -> JointAngles {
    let error = error(&tool0(from), wanted);
    let (position, turn) = (error.position_mm, error.turn_deg);
    let e = Vector::from_fn(|row, _| match row {
        0..3 => position[row],
        _ => turn[row - 3].to_radians() * RADIAN_MM,
    });
    let jacobian = Jacobian::of(from, [0.0; 3]);
    let j = Matrix::from_fn(|row, joint| match row {
        // From each degree to each radian.
        0..3 => jacobian.linear[row][joint].to_degrees(),
        _ => jacobian.angular[row - 3][joint] * RADIAN_MM,
    });
    let damping = DAMPING_MM * DAMPING_MM + CURVATURE_MM * e.norm();
    let hessian = j.transpose() * j + Matrix::identity() * damping;
    let turned = within_ranges(&hessian, &(j.transpose() * e), from, limits);
    if !turned.iter().all(|angle| angle.is_finite()) {
        return *from;
    }
    let share = turned
        .iter()
        .zip(longest_deg)
        .fold(1.0_f64, |share, (angle, longest)| {
            share.min(longest / angle.abs().max(f64::MIN_POSITIVE))
        });
    JointAngles(std::array::from_fn(|joint| {
        from.0[joint] + share * turned[joint]
    }))
}

/// The step of least squares in degrees, with joints held that would leave their ranges.
fn within_ranges(
    hessian: &Matrix,
    gradient: &Vector,
    from: &JointAngles,
    limits: &RobotLimits,
) -> [f64; JOINTS] {
    let mut held: [Option<f64>; JOINTS] = [None; JOINTS];
    // Each round holds at least one joint more.
    for _ in 0..=JOINTS {
        let mut matrix = *hessian;
        let mut right = *gradient;
        for (joint, angle) in held.iter().enumerate() {
            let Some(angle_deg) = angle else { continue };
            let angle = angle_deg.to_radians();
            right -= hessian.column(joint) * angle;
            matrix.fill_row(joint, 0.0);
            matrix.fill_column(joint, 0.0);
            matrix[(joint, joint)] = 1.0;
        }
        for (joint, angle) in held.iter().enumerate() {
            if let Some(angle_deg) = angle {
                right[joint] = angle_deg.to_radians();
            }
        }
        // Only a pose that is not a number makes a matrix that has no factors.
        let Some(factors) = matrix.cholesky() else {
            return [f64::NAN; JOINTS];
        };
        let solved = factors.solve(&right);
        let found: [f64; JOINTS] = std::array::from_fn(|joint| match held[joint] {
            Some(angle_deg) => angle_deg,
            None => solved[joint].to_degrees(),
        });
        // One joint after the other, because a joint that is held may keep another inside.
        let mut farthest = None;
        for joint in (0..JOINTS).filter(|joint| held[*joint].is_none()) {
            // A joint that already stands outside may not go farther out.
            let lowest = (limits.joint_min_deg[joint] - from.0[joint]).min(0.0);
            let highest = (limits.joint_max_deg[joint] - from.0[joint]).max(0.0);
            let end = found[joint].clamp(lowest, highest);
            let beyond = (found[joint] - end).abs();
            if beyond > farthest.map_or(0.0, |(_, _, most)| most) {
                farthest = Some((joint, end, beyond));
            }
        }
        match farthest {
            Some((joint, end, _)) => held[joint] = Some(end),
            None => return found,
        }
    }
    std::array::from_fn(|joint| held[joint].unwrap_or(0.0))
}

/// The way from one pose to another, the shorter way round.
#[must_use]
pub fn error(from: &Pose, to: &Pose) -> PoseError {
    let back = Orientation {
        w: from.orientation.w,
        x: -from.orientation.x,
        y: -from.orientation.y,
        z: -from.orientation.z,
    };
    let turn = multiply(&to.orientation, &back);
    let side = if turn.w < 0.0 { -1.0 } else { 1.0 };
    let vector = [turn.x, turn.y, turn.z].map(|part| part * side);
    let sine = length(vector);
    let angle_deg = (2.0 * sine.atan2(turn.w * side)).to_degrees();
    let per_part = if sine > 0.0 { angle_deg / sine } else { 0.0 };
    PoseError {
        position_mm: [0, 1, 2].map(|i| to.position.0[i] - from.position.0[i]),
        turn_deg: vector.map(|part| part * per_part),
    }
}

/// The pose that a share of the way from `from` leads to.
#[must_use]
pub fn on_the_way(from: &Pose, way: &PoseError, moved: f64, turned: f64) -> Pose {
    let turn = about_vector(way.turn_deg.map(|part| part * turned));
    let mut pose = *from;
    for (place, part) in pose.position.0.iter_mut().zip(way.position_mm) {
        *place += moved * part;
    }
    pose.orientation = multiply(&turn, &from.orientation);
    pose
}

/// An orientation turned in its own frame: once, about the axis with these parts, by its length.
#[must_use]
pub fn turned(orientation: &Orientation, turn_deg: [f64; 3]) -> Orientation {
    multiply(orientation, &about_vector(turn_deg))
}

fn about_vector(turn_deg: [f64; 3]) -> Orientation {
    let angle_deg = length(turn_deg);
    let along_x = about(Axis::X, angle_deg.to_radians());
    let share = if angle_deg > 0.0 {
        along_x.x / angle_deg
    } else {
        0.0
    };
    let [x, y, z] = turn_deg.map(|part| part * share);
    Orientation {
        w: along_x.w,
        x,
        y,
        z,
    }
}

/// Euclidean length.
#[must_use]
pub fn length(vector: [f64; 3]) -> f64 {
    vector.iter().map(|part| part * part).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests;
