//! The chain against an independent description of it.

use super::*;
use crate::limits::RobotLimits;
use nalgebra::{Matrix4, Rotation3, Vector3};
use proptest::prelude::*;

/// Any joint angles in the arm's ranges.
pub(super) fn any_joints() -> impl Strategy<Value = JointAngles> {
    let limits = RobotLimits::gofa5();
    let ranges: [_; 6] =
        std::array::from_fn(|joint| limits.joint_min_deg[joint]..limits.joint_max_deg[joint]);
    ranges.prop_map(JointAngles)
}

/// The same arm in standard Denavit-Hartenberg form (theta offset deg, d, a,
/// alpha deg): an independent description of the chain.
fn by_denavit_hartenberg(joints: &JointAngles) -> Matrix4<f64> {
    let rows = [
        (0.0, 265.0, 0.0, -90.0),
        (-90.0, 0.0, 444.0, 0.0),
        (0.0, 0.0, 110.0, -90.0),
        (0.0, 470.0, 0.0, 90.0),
        (0.0, 0.0, 80.0, -90.0),
        (180.0, 101.0, 0.0, 0.0),
    ];
    let mut pose = Matrix4::identity();
    for ((offset, d, a, alpha), q) in rows.into_iter().zip(joints.0) {
        let theta = f64::to_radians(q + offset);
        let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), theta).to_homogeneous()
            * Matrix4::new_translation(&Vector3::new(a, 0.0, d))
            * Rotation3::from_axis_angle(&Vector3::x_axis(), f64::to_radians(alpha))
                .to_homogeneous();
        pose *= turn;
    }
    pose
}

#[test]
fn euler_angles_are_those_of_nalgebra() {
    for (roll, pitch, yaw) in [(10.0, 20.0, 30.0), (-170.0, -60.0, 95.0), (0.0, 0.0, -45.0)] {
        let rotation = nalgebra::UnitQuaternion::from_euler_angles(
            f64::to_radians(roll),
            f64::to_radians(pitch),
            f64::to_radians(yaw),
        );
        let found = euler_xyz_deg(&Orientation {
            w: rotation.w,
            x: rotation.i,
            y: rotation.j,
            z: rotation.k,
        });
        for (angle, expected) in found.into_iter().zip([roll, pitch, yaw]) {
            assert!((angle - expected).abs() < 1e-9, "{found:?}");
        }
    }
}

#[test]
fn agrees_with_the_denavit_hartenberg_form() {
    for joints in [
        [0.0; 6],
        [39.6, 33.3, 26.7, 42.4, -69.6, 160.4],
        [-170.0, 80.0, -200.0, 120.0, 90.0, -260.0],
        [12.0, -45.0, 60.0, -81.5, -2.1, 15.0],
    ] {
        let joints = JointAngles(joints);
        let pose = tool0(&joints);
        let reference = by_denavit_hartenberg(&joints);
        for i in 0..3 {
            assert!((pose.position.0[i] - reference[(i, 3)]).abs() < 1e-9);
        }
        // Columns of the rotation: where the frame's axes point.
        for (column, axis) in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
            .into_iter()
            .enumerate()
        {
            let turned = rotate(&pose.orientation, axis);
            for i in 0..3 {
                assert!((turned[i] - reference[(i, column)]).abs() < 1e-12);
            }
        }
    }
}

proptest! {
    #[test]
    fn the_jacobian_is_the_slope_of_the_forward_kinematics(
        joints in any_joints(),
        tool_mm in [-200.0..200.0, -200.0..200.0, -200.0..200.0],
    ) {
        const BESIDE_DEG: f64 = 1e-3;
        let jacobian = Jacobian::of(&joints, tool_mm);
        for joint in 0..6 {
            let beside = |by_deg: f64| {
                let mut joints = joints;
                joints.0[joint] += by_deg;
                joints
            };
            let (before, after) = (beside(-BESIDE_DEG), beside(BESIDE_DEG));
            let [from, to] = [before, after].map(|joints| tool_point(&joints, tool_mm).0);
            let turn = inverse::error(&tool0(&before), &tool0(&after)).turn_deg;
            for i in 0..3 {
                let moved = (to[i] - from[i]) / (2.0 * BESIDE_DEG);
                prop_assert!((jacobian.linear[i][joint] - moved).abs() < 1e-6);
                let turned = turn[i] / (2.0 * BESIDE_DEG);
                prop_assert!((jacobian.angular[i][joint] - turned).abs() < 1e-6);
            }
        }
    }
}
