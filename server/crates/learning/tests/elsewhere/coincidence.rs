//! What happens when the start and the goal of a joint coincide or nearly so, or
//! change sides: nothing to ours, much to a primitive that scales.

use std::ops::ControlFlow;

use learning::{TrainingParams, dmp::Extent, train};
use proptest::prelude::*;

use crate::{
    motions::{Motion, amplitude, apart, bow},
    moved_by,
    scaling::Scaling,
    unmoved,
};

/// Distances from start to goal, degrees.
const GAPS_DEG: [f64; 4] = [0.0, 1e-9, 1e-3, 0.1];
const BOW_DEG: f64 = 20.0;

#[test]
fn a_joint_keeps_its_shape_however_near_its_goal_is_to_its_start() {
    let closed = bow(BOW_DEG, 0.0).primitive(30.0, 300);
    for gap_deg in GAPS_DEG {
        let p = bow(BOW_DEG, gap_deg).primitive(30.0, 300);
        for goal_off in [-30.0, -5.0, 0.0, 5.0, 30.0] {
            let path = moved_by(&p, &[0.0], &[goal_off], Extent::AsTaught);
            let closed = moved_by(&closed, &[0.0], &[goal_off], Extent::AsTaught);
            let most = 1.1 * gap_deg + 1e-9;
            assert!(apart(&path, &closed) <= most, "{gap_deg} {goal_off}");
            assert!(amplitude(&path, 0) < BOW_DEG + f64::abs(goal_off) + 0.5);
        }
    }
}

#[test]
fn a_scaling_primitive_bursts_where_start_and_goal_nearly_coincide() {
    for gap_deg in [1e-9, 1e-3, 0.1] {
        let ours = bow(BOW_DEG, gap_deg).primitive(30.0, 300);
        let scaling = Scaling::like(&ours);
        for goal_off in [5.0, 15.0, 30.0] {
            let (start, goal) = (&ours.start_deg, [ours.goal_deg[0] + goal_off]);
            let kept = amplitude(&moved_by(&ours, &[0.0], &[goal_off], Extent::AsTaught), 0);
            let burst = amplitude(&scaling.rollout(start, &goal), 0);
            println!("gap {gap_deg:e} goal +{goal_off}: {kept:.1} deg, scaling {burst:.3e} deg");
            assert!(kept <= BOW_DEG + goal_off + 0.5);
            // The bow grows with the gap's ratio.
            assert!(burst > 0.9 * BOW_DEG * goal_off / gap_deg);
        }
    }
}

#[test]
fn a_scaling_primitive_cannot_learn_a_joint_that_ends_exactly_where_it_began() {
    let ours = bow(BOW_DEG, 0.0).primitive(30.0, 300);
    assert_eq!(ours.start_deg, ours.goal_deg);
    assert!(!Scaling::like(&ours).is_finite());
    assert!((amplitude(&unmoved(&ours), 0) - BOW_DEG).abs() < 0.5);
}

#[test]
fn a_scaling_primitive_forgets_the_shape_when_the_new_goal_is_the_start() {
    let ours = bow(BOW_DEG, 10.0).primitive(30.0, 300);
    let (start, goal) = (&ours.start_deg, &ours.start_deg);
    let flat = Scaling::like(&ours).rollout(start, goal);
    assert!(amplitude(&flat, 0) < 1e-9);
    let kept = moved_by(&ours, &[0.0], &[-10.0], Extent::AsTaught);
    assert!(amplitude(&kept, 0) > BOW_DEG - 10.0);
    assert!((kept.last()[0] - goal[0]).abs() < 0.01);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    /// Both are pushed by their forcing terms through the same spring. What is left of
    /// a motion after the spring's way to the goal is what was taught, and the scaling
    /// one turns it over when the goal changes sides.
    #[test]
    fn a_scaling_primitive_mirrors_the_shape_when_the_goal_changes_sides(
        gap_deg in 1.0..10.0f64,
        beyond_deg in 1.0..20.0f64,
    ) {
        let ours = bow(BOW_DEG, gap_deg).primitive(30.0, 300);
        let goal = [ours.start_deg[0] - beyond_deg];
        let scaling = Scaling::like(&ours);
        let mut unforced = ours.clone();
        unforced.weights[0].fill(0.0);
        let shape = |path: &learning::Path, goal: &[f64]| -> Vec<f64> {
            let spring = unforced.rollout(&ours.start_deg, goal, Extent::AsTaught).unwrap();
            path.rows().zip(spring.rows()).map(|(a, b)| a[0] - b[0]).collect()
        };
        let taught = shape(&unmoved(&ours), &ours.goal_deg);
        let kept = ours.rollout(&ours.start_deg, &goal, Extent::AsTaught).unwrap();
        let kept = shape(&kept, &goal);
        let mirrored = shape(&scaling.rollout(&ours.start_deg, &goal), &goal);
        let ratio = -beyond_deg / gap_deg;
        for ((taught, kept), mirrored) in taught.iter().zip(&kept).zip(&mirrored) {
            prop_assert!((kept - taught).abs() < 1e-9);
            prop_assert!((mirrored - ratio * taught).abs() < 1e-9 * (1.0 + ratio.abs()));
        }
    }
}

#[test]
fn a_trained_model_keeps_its_shape_where_start_and_goal_coincide() {
    // One joint that goes away and comes back, and one that goes for good.
    let away = bow(BOW_DEG, 0.0).joints.remove(0);
    let gone = bow(15.0, 25.0).joints.remove(0);
    let motion = Motion {
        duration_s: 6.0,
        start_deg: vec![-10.0, 40.0],
        joints: vec![away, gone],
    };
    let takes: Vec<_> = [(1.0, 0.0), (1.1, 0.8), (0.9, -0.8)]
        .map(|(pace, sway)| motion.take(pace, sway))
        .into();
    let params = TrainingParams::faithful(1);
    let model = train("there and back", &takes, &params, &|_| {
        ControlFlow::Continue(())
    })
    .unwrap();
    let taught = unmoved(&model.primitive);
    for goal_off in [[30.0, 0.0], [-30.0, 30.0], [5.0, -15.0]] {
        let goal: Vec<f64> = model
            .goal_deg()
            .iter()
            .zip(goal_off)
            .map(|(q, off)| q + off)
            .collect();
        let path = model
            .reproduce(model.start_deg(), &goal, Extent::AsTaught)
            .unwrap();
        let p = &model.primitive;
        let expected = crate::response::moved(&taught, p, &[0.0, 0.0], &goal_off);
        assert!(apart(&path, &expected) < 1e-9);
        for j in 0..2 {
            assert!(amplitude(&path, j) <= amplitude(&taught, j) + f64::abs(goal_off[j]) + 1e-9);
            assert!((path.last()[j] - goal[j]).abs() < 0.05);
        }
    }
}
