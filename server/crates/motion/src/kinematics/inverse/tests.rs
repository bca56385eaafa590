//! Properties of the inverse kinematics.

use super::super::tests::any_joints;
use super::*;
use crate::Position;
use proptest::prelude::*;

const LONGEST_DEG: [f64; JOINTS] = [2.0; JOINTS];

/// The weighted error that the steps make small, mm.
fn cost(joints: &JointAngles, wanted: &Pose) -> f64 {
    let error = error(&tool0(joints), wanted);
    let turn_mm = length(error.turn_deg).to_radians() * RADIAN_MM;
    length(error.position_mm).hypot(turn_mm)
}

fn limits() -> RobotLimits {
    RobotLimits::gofa5()
}

/// Takes steps and checks each of them.
fn steps(from: &JointAngles, wanted: &Pose, count: usize) -> Result<JointAngles, TestCaseError> {
    let mut joints = *from;
    for _ in 0..count {
        let next = step(&joints, wanted, &limits(), &LONGEST_DEG);
        prop_assert!(next.is_finite());
        prop_assert_eq!(limits().joint_out_of_range(&next), None);
        prop_assert!(next.max_abs_difference(&joints) <= LONGEST_DEG[0] + 1e-9);
        joints = next;
    }
    Ok(joints)
}

/// How far the arm is from losing a direction: the smallest singular value, mm/rad.
fn agility(joints: &JointAngles) -> f64 {
    let jacobian = Jacobian::of(joints, [0.0; 3]);
    let j = Matrix::from_fn(|row, joint| match row {
        0..3 => jacobian.linear[row][joint].to_degrees(),
        _ => jacobian.angular[row - 3][joint] * RADIAN_MM,
    });
    j.singular_values().min()
}

#[test]
fn the_way_between_poses_leads_there() {
    let from = tool0(&JointAngles([10.0, 20.0, -30.0, 40.0, -50.0, 60.0]));
    let to = tool0(&JointAngles([-100.0, 50.0, 20.0, -140.0, 50.0, 160.0]));
    let way = error(&from, &to);
    assert!(length(way.turn_deg) <= 180.0);
    let there = on_the_way(&from, &way, 1.0, 1.0);
    let left = error(&there, &to);
    assert!(length(left.position_mm) < 1e-9 && length(left.turn_deg) < 1e-9);
    assert_eq!(on_the_way(&from, &way, 0.0, 0.0), from);
}

#[test]
fn a_turn_is_about_the_axes_of_the_flange() {
    let flange = tool0(&JointAngles([0.0; JOINTS])).orientation;
    // At zero the z axis of the flange lies along x of the base.
    let turned = turned(&flange, [0.0, 0.0, 90.0]);
    let by_joint_6 = tool0(&JointAngles([0.0, 0.0, 0.0, 0.0, 0.0, 90.0])).orientation;
    let at = |orientation| Pose {
        position: Position([0.0; 3]),
        orientation,
    };
    assert!(length(error(&at(turned), &at(by_joint_6)).turn_deg) < 1e-9);
}

#[test]
fn a_pose_that_is_not_a_number_moves_nothing() {
    let from = JointAngles([0.0, 8.0, 24.0, 0.0, -45.0, 0.0]);
    for bad in [f64::NAN, f64::INFINITY, f64::MAX] {
        let mut wanted = tool0(&from);
        wanted.position.0[1] = bad;
        assert_eq!(step(&from, &wanted, &limits(), &LONGEST_DEG), from);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn a_pose_near_by_is_reached(
        from in any_joints(),
        beside in prop::array::uniform6(-15.0..15.0),
    ) {
        let there = JointAngles(std::array::from_fn(|joint| from.0[joint] + beside[joint]));
        prop_assume!(limits().joint_out_of_range(&there).is_none());
        prop_assume!(agility(&from) > 40.0 && agility(&there) > 40.0);
        let wanted = tool0(&there);
        let reached = steps(&from, &wanted, 400)?;
        // Another way into the same pose may lead against the end of a range.
        let limits = limits();
        let at_an_end = (0..JOINTS).any(|joint| {
            reached.0[joint] <= limits.joint_min_deg[joint] + 1e-6
                || reached.0[joint] >= limits.joint_max_deg[joint] - 1e-6
        });
        prop_assume!(!at_an_end);
        let left = error(&tool0(&reached), &wanted);
        prop_assert!(length(left.position_mm) < 0.01, "{left:?} after {reached:?}");
        prop_assert!(length(left.turn_deg) < 0.01, "{left:?} after {reached:?}");
    }

    #[test]
    fn out_of_reach_the_steps_end_at_the_nearest_pose(
        from in any_joints(),
        towards in prop::array::uniform3(-1.0..1.0),
        beyond_mm in 1_000.0..4_000.0,
        tries in prop::collection::vec(prop::array::uniform6(-1.0..1.0), 40),
    ) {
        let far = length(towards);
        prop_assume!(far > 0.1);
        let mut wanted = tool0(&from);
        wanted.position = Position(towards.map(|part| part / far * beyond_mm));
        wanted.position.0[2] += 265.0;
        let ended = steps(&from, &wanted, 3_000)?;
        prop_assert!(cost(&ended, &wanted) <= cost(&from, &wanted) + 1e-6);
        let again = step(&ended, &wanted, &limits(), &LONGEST_DEG);
        prop_assert!(again.max_abs_difference(&ended) < 0.01, "it does not come to rest");
        for beside in tries {
            let near = JointAngles(std::array::from_fn(|joint| {
                let angle: f64 = ended.0[joint] + beside[joint];
                angle.clamp(limits().joint_min_deg[joint], limits().joint_max_deg[joint])
            }));
            prop_assert!(
                cost(&near, &wanted) > cost(&ended, &wanted) - 0.5,
                "{near:?} is nearer than {ended:?}"
            );
        }
    }
}
