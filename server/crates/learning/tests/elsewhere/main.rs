//! Starts and goals elsewhere than taught: what stays, what is added, and how large
//! that can get. Compared with a primitive that scales its forcing term.

#![expect(
    clippy::unwrap_used,
    reason = "a test stops at what it does not expect"
)]

mod coincidence;
mod figures;
mod motions;
mod response;
mod scaling;

use learning::{
    Path,
    dmp::{Extent, MovementPrimitive},
};
use motions::*;
use proptest::prelude::*;
use response::{Response, moved};

/// How far starts and goals are moved, on each joint.
const FARTHEST_DEG: f64 = 30.0;
/// Rounding of a few hundred steps.
const ROUNDING_DEG: f64 = 1e-9;

fn offsets() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-FARTHEST_DEG..=FARTHEST_DEG, 5)
}

fn primitives() -> impl Strategy<Value = (Motion, MovementPrimitive)> {
    (any_motion(), 25.0..100.0f64, 200..500usize).prop_map(|(motion, alpha_z, n_basis)| {
        let primitive = motion.primitive(alpha_z, n_basis);
        (motion, primitive)
    })
}

/// The reproduction with start and goal moved by so much from the taught ones.
fn moved_by(p: &MovementPrimitive, start_off: &[f64], goal_off: &[f64], extent: Extent) -> Path {
    let (start, goal) = (plus(&p.start_deg, start_off), plus(&p.goal_deg, goal_off));
    p.rollout(&start, &goal, extent).unwrap()
}

/// The reproduction from the taught start to the taught goal.
fn unmoved(p: &MovementPrimitive) -> Path {
    p.rollout(&p.start_deg, &p.goal_deg, Extent::AsTaught)
        .unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// The system is linear in start, goal and forcing term: moving the ends adds
    /// the spring's answer to their offsets and nothing else.
    #[test]
    fn a_motion_elsewhere_is_the_taught_one_and_a_smooth_transient(
        (motion, p) in primitives(),
        start_off in offsets(),
        goal_off in offsets(),
    ) {
        let path = moved_by(&p, &start_off, &goal_off, Extent::AsTaught);
        let expected = moved(&unmoved(&p), &p, &start_off, &goal_off);
        prop_assert!(path.rows().flatten().all(|q| q.is_finite()));
        prop_assert!(apart(&path, &expected) < ROUNDING_DEG);

        // The shape is as near to what was taught as it is without any offset.
        let taught = motion.path();
        let imitation = apart(&unmoved(&p), &taught);
        prop_assert!(imitation < 1.5, "{}", imitation);
        let elsewhere = apart(&path, &moved(&taught, &p, &start_off, &goal_off));
        prop_assert!(elsewhere < imitation + ROUNDING_DEG);
    }

    #[test]
    fn a_joint_never_leaves_the_taught_course_by_more_than_its_ends_were_moved(
        (_, p) in primitives(),
        start_off in offsets(),
        goal_off in offsets(),
    ) {
        let path = moved_by(&p, &start_off, &goal_off, Extent::AsTaught);
        for (row, taught) in path.rows().zip(unmoved(&p).rows()) {
            for j in 0..row.len() {
                let (least, most) = (
                    start_off[j].min(goal_off[j]) - ROUNDING_DEG,
                    start_off[j].max(goal_off[j]) + ROUNDING_DEG,
                );
                let off = row[j] - taught[j];
                prop_assert!((least..=most).contains(&off), "joint {}: {}", j + 1, off);
            }
        }
    }

    #[test]
    fn speed_acceleration_and_jerk_grow_by_no_more_than_the_springs_own(
        (_, p) in primitives(),
        start_off in offsets(),
        goal_off in offsets(),
    ) {
        let (path, taught) = (moved_by(&p, &start_off, &goal_off, Extent::AsTaught), unmoved(&p));
        let response = Response::of(&p);
        for j in 0..path.width() {
            let offset = (goal_off[j] - start_off[j]).abs();
            for order in 1..=3 {
                let limit = peak(&taught, j, order) + offset * response.bound(order);
                // The third difference magnifies rounding by 1 / dt³.
                let rounding = 1e-12 / DT_S.powi(order as i32);
                let found = peak(&path, j, order);
                prop_assert!(found <= limit + rounding, "order {}: {} {}", order, found, limit);
            }
        }
    }

    #[test]
    fn it_settles_at_the_goal_within_the_tolerance_that_is_asked_for(
        (_, p) in primitives(),
        start_off in offsets(),
        goal_off in offsets(),
        tolerance_deg in 0.001..0.25f64,
    ) {
        let extent = Extent::UntilSettled { tolerance_deg, longest_s: 60.0 };
        let path = moved_by(&p, &start_off, &goal_off, extent);
        let goal = plus(&p.goal_deg, &goal_off);
        for (q, goal) in path.last().iter().zip(&goal) {
            prop_assert!((q - goal).abs() <= tolerance_deg);
        }
        // A motion that rests at its end needs little time beyond its own.
        prop_assert!(path.len() < p.steps + p.steps / 2, "{} of {}", path.len(), p.steps);
    }

    #[test]
    fn moving_both_ends_alike_moves_every_point_alike(
        (_, p) in primitives(),
        off in offsets(),
    ) {
        let path = moved_by(&p, &off, &off, Extent::AsTaught);
        let shifted = Path::from_rows(5, unmoved(&p).rows().map(|row| plus(row, &off)));
        prop_assert!(apart(&path, &shifted) < ROUNDING_DEG);
    }

    #[test]
    fn the_transient_rises_from_0_to_1_and_never_turns_back(
        tau_s in 2.0..40.0f64,
        alpha_z in 5.0..120.0f64,
    ) {
        let still = MovementPrimitive {
            alpha_z,
            tau_s,
            dt_s: DT_S,
            steps: (3.0 * tau_s / DT_S) as usize,
            start_deg: vec![0.0],
            goal_deg: vec![0.0],
            weights: vec![vec![0.0; 10]],
        };
        let step = still.rollout(&[0.0], &[1.0], Extent::AsTaught).unwrap();
        let rising = step.column(0);
        prop_assert!(rising.windows(2).all(|w| w[0] <= w[1] + 1e-15));
        prop_assert!(rising[0] == 0.0 && rising.iter().all(|b| *b <= 1.0 + 1e-12));
        let stated = Response::of(&still);
        for (b, expected) in rising.iter().zip(stated.rows(rising.len())) {
            prop_assert!((b - expected).abs() < 1e-12);
        }
        for order in 1..=3 {
            prop_assert!(peak(&step, 0, order) <= stated.bound(order) + 1e-12 / DT_S.powi(order as i32));
        }
    }
}
