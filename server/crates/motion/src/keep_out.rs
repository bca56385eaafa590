//! Boxes into which neither the tool nor the arm may go. The arm is taken as the line through
//! its joints, which is what can be said without its hull: a box is to be made as much larger as
//! the arm is thick.

use serde::{Deserialize, Serialize};

use crate::{JointAngles, Position, kinematics};

/// A box in the robot's base frame, its sides along the frame's axes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct KeepOut {
    /// What stands there; it is shown when a motion is refused.
    pub name: String,
    /// Its lowest corner, millimetres.
    pub min_mm: [f64; 3],
    /// Its highest corner, millimetres.
    pub max_mm: [f64; 3],
}

impl KeepOut {
    /// Whether the arm in this pose, or its tool, is in the box. `tool_mm` is where the tool's
    /// point is in the frame of tool0.
    pub fn is_entered(&self, joints: &JointAngles, tool_mm: [f64; 3]) -> bool {
        let line = kinematics::centre_line(joints, tool_mm);
        line.windows(2).any(|ends| self.meets(&ends[0], &ends[1]))
    }

    /// Whether the straight line between two points meets the box (slab method): for each axis
    /// the part of the line between the two faces, and all three parts together.
    fn meets(&self, from: &Position, to: &Position) -> bool {
        let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
        for axis in 0..3 {
            let (start, way) = (from.0[axis], to.0[axis] - from.0[axis]);
            let (low, high) = (self.min_mm[axis] - start, self.max_mm[axis] - start);
            if way == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return false;
                }
                continue;
            }
            let (near, far) = (low / way, high / way);
            enters = enters.max(near.min(far));
            leaves = leaves.min(near.max(far));
        }
        enters <= leaves
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cube(centre: [f64; 3], half: f64) -> KeepOut {
        KeepOut {
            name: "cube".into(),
            min_mm: centre.map(|c| c - half),
            max_mm: centre.map(|c| c + half),
        }
    }

    /// The data sheet: with every joint at zero the tool is at (571, 0, 899).
    #[test]
    fn the_tool_and_the_links_are_seen_and_the_air_beside_them_is_not() {
        let zero = JointAngles([0.0; 6]);
        let none = [0.0; 3];
        for inside in [[571.0, 0.0, 899.0], [0.0, 0.0, 500.0], [200.0, 0.0, 819.0]] {
            assert!(cube(inside, 5.0).is_entered(&zero, none), "{inside:?}");
        }
        for beside in [
            [571.0, 20.0, 899.0],
            [300.0, 0.0, 500.0],
            [800.0, 0.0, 899.0],
        ] {
            assert!(!cube(beside, 5.0).is_entered(&zero, none), "{beside:?}");
        }
        // A tool of 230 mm reaches where the flange does not.
        assert!(cube([795.0, 0.0, 899.0], 5.0).is_entered(&zero, [0.0, 0.0, 230.0]));
    }

    proptest! {
        #[test]
        fn a_line_meets_a_box_exactly_when_one_of_its_points_is_inside(
            from in proptest::array::uniform3(-10.0..10.0_f64),
            to in proptest::array::uniform3(-10.0..10.0_f64),
            half in 0.5..5.0_f64,
        ) {
            let keep_out = cube([0.0; 3], half);
            let meets = keep_out.meets(&Position(from), &Position(to));
            // As near as any of ten thousand points comes, in the largest coordinate.
            let nearest = (0..=10_000)
                .map(|step| {
                    let u = f64::from(step) / 10_000.0;
                    (0..3)
                        .map(|axis| (from[axis] + u * (to[axis] - from[axis])).abs())
                        .fold(0.0, f64::max)
                })
                .fold(f64::INFINITY, f64::min);
            if nearest <= half {
                prop_assert!(meets);
            } else if nearest > half + 0.01 {
                prop_assert!(!meets);
            }
        }
    }
}
