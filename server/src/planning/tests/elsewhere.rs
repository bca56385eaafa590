//! Starts and goals elsewhere than taught: the limits hold and the path stays, time
//! gives way; ends of the joints' ranges; wrists that stand a turn away.

use proptest::prelude::*;

use super::*;

type Offsets = [f64; JOINTS];

const NO_OFFSET: Offsets = [0.0; JOINTS];

fn plus(pose: &[f64], off: &Offsets) -> JointAngles {
    JointAngles(std::array::from_fn(|j| pose[j] + off[j]))
}

fn request_off(model: &Model, start_off: &Offsets, goal_off: &Offsets) -> PlanRequest {
    PlanRequest {
        start: Target::Joints(plus(model.start_deg(), start_off)),
        goal: Target::Joints(plus(model.goal_deg(), goal_off)),
        speed: 1.0,
    }
}

/// Checks all that the arm is sent against the limits, by differences of the samples
/// and apart from the gate.
fn assert_within(plan: &Plan, limits: &RobotLimits) {
    let samples: Vec<[f64; JOINTS]> = plan.samples().iter().map(|s| s.joints.0).collect();
    let rest = [samples[0]; 2];
    let end = [samples[samples.len() - 1]; 2];
    let all = [&rest[..], &samples, &end].concat();
    let at_most = |value: f64, limit: f64| assert!(value <= limit * 1.000_001, "{value} {limit}");
    let h = plan.period_s();
    for j in 0..JOINTS {
        for q in all.windows(3).map(|w| [w[0][j], w[1][j], w[2][j]]) {
            assert!((limits.joint_min_deg[j]..=limits.joint_max_deg[j]).contains(&q[1]));
            at_most((q[2] - q[1]).abs() / h, limits.joint_speed_deg_s[j]);
            let acceleration = (q[2] - 2.0 * q[1] + q[0]) / (h * h);
            at_most(acceleration.abs(), limits.joint_acceleration_deg_s2[j]);
        }
    }
    for pair in samples.windows(2) {
        let [a, b] = [pair[0], pair[1]].map(|q| motion::kinematics::tool0(&JointAngles(q)));
        at_most(a.position.distance(&b.position) / h, limits.tcp_speed_mm_s);
    }
}

/// How far the motion proper of a plan is from the model's own reproduction at the
/// same moment of the unstretched time, up to the landing.
fn off_the_path(model: &Model, planned: &PlannedMotion) -> f64 {
    let path = model
        .reproduce(&planned.start.0, &planned.goal.0, Extent::AsTaught)
        .unwrap();
    let dt_s = model.primitive.dt_s;
    let mut worst = 0.0;
    for (i, row) in path.rows().enumerate() {
        let t_s = planned.plan.approach_s() + i as f64 * dt_s * planned.stretch;
        let there = planned.plan.at(t_s).joints;
        let row = JointAngles(std::array::from_fn(|j| row[j]));
        worst = f64::max(worst, there.max_abs_difference(&row));
    }
    worst
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn limits_hold_and_the_path_stays_wherever_start_and_goal_are(
        start_off in prop::array::uniform6(-30.0..=30.0f64),
        goal_off in prop::array::uniform6(-30.0..=30.0f64),
    ) {
        let request = request_off(model(), &start_off, &goal_off);
        let present = JointAngles([0.0, 0.0, 10.0, 5.0, -60.0, 20.0]);
        let planned = plan(model(), &request, Some(present), &limits()).unwrap();
        assert_within(&planned.plan, &limits());
        prop_assert!(planned.stretch >= 1.0);
        let off = off_the_path(model(), &planned);
        prop_assert!(off < 0.01, "{}", off);
        let goal = plus(model().goal_deg(), &goal_off);
        prop_assert!(planned.plan.last().max_abs_difference(&goal) < 1e-9);
    }
}

#[test]
fn a_goal_too_far_for_the_taught_time_takes_longer_on_the_same_path() {
    let brisk = taught(4.0);
    let far = [30.0, 30.0, 30.0, 0.0, 0.0, 0.0];
    let near = plan(
        &brisk,
        &request_off(&brisk, &NO_OFFSET, &NO_OFFSET),
        None,
        &limits(),
    )
    .unwrap();
    let planned = plan(
        &brisk,
        &request_off(&brisk, &NO_OFFSET, &far),
        None,
        &limits(),
    )
    .unwrap();
    assert!(planned.slowed_by > 1.2 * near.slowed_by);
    assert!(planned.plan.duration_s() > 1.2 * near.plan.duration_s());
    assert!(
        planned
            .warnings
            .iter()
            .any(|w| w.to_string().contains("slower"))
    );
    assert_within(&planned.plan, &limits());
    assert!(off_the_path(&brisk, &planned) < 0.01);
}

#[test]
fn slower_joints_and_tools_are_kept_to_as_well() {
    let mut slow = limits();
    slow.joint_speed_deg_s = [10.0; JOINTS];
    slow.joint_acceleration_deg_s2 = [20.0; JOINTS];
    slow.tcp_speed_mm_s = 100.0;
    let request = request_off(model(), &[-20.0; JOINTS], &[30.0; JOINTS]);
    let planned = plan(model(), &request, None, &slow).unwrap();
    assert_within(&planned.plan, &slow);
    assert!(off_the_path(model(), &planned) < 0.01);
}

#[test]
fn a_goal_beyond_the_range_of_any_joint_is_refused_by_name() {
    for j in 0..JOINTS {
        for (limit, outwards) in [
            (limits().joint_max_deg[j], 1.0),
            (limits().joint_min_deg[j], -1.0),
        ] {
            let mut goal = plus(model().goal_deg(), &NO_OFFSET);
            goal.0[j] = limit + 0.001 * outwards;
            let request = PlanRequest {
                goal: Target::Joints(goal),
                ..as_taught()
            };
            let error = plan(model(), &request, None, &limits()).unwrap_err();
            let PlanError::TargetOutsideRange {
                which,
                joint,
                value_deg,
                ..
            } = error
            else {
                panic!("joint {}: {error}", j + 1);
            };
            assert_eq!((which, joint, value_deg), ("goal", j + 1, goal.0[j]));
        }
    }
}

/// The model with its whole motion of joint `j` (from 0) moved so that it begins or
/// ends at `at_deg`.
fn shifted(j: usize, begins_at: Option<f64>, ends_at: Option<f64>) -> Model {
    let mut model = model().clone();
    let p = &mut model.primitive;
    let way = p.goal_deg[j] - p.start_deg[j];
    p.start_deg[j] = begins_at.or(ends_at.map(|at| at - way)).unwrap();
    p.goal_deg[j] = ends_at.unwrap_or(p.start_deg[j] + way);
    model
}

#[test]
fn a_motion_is_refused_for_what_lies_between_its_ends_too() {
    // Joint 2 swings out by 15 deg between its ends.
    let ending_at = |at_deg: f64| {
        let model = shifted(1, Some(at_deg), Some(at_deg));
        plan(&model, &as_taught(), None, &limits())
    };
    assert_within(&ending_at(164.5).unwrap().plan, &limits());
    let error = ending_at(166.0).unwrap_err();
    assert_eq!(error.code(), "outside_joint_range");
    assert!(error.to_string().contains("joint 2"), "{error}");
}

#[test]
fn a_motion_may_begin_and_end_exactly_at_the_end_of_a_range() {
    // Joints 1 and 5 move upwards, joint 6 rests.
    let models = [
        shifted(0, None, Some(180.0)),
        shifted(0, Some(-180.0), None),
        shifted(4, None, Some(180.0)),
        shifted(4, Some(-180.0), None),
        shifted(5, Some(270.0), Some(270.0)),
        shifted(5, Some(-270.0), Some(-270.0)),
    ];
    for model in models {
        let planned = plan(&model, &as_taught(), None, &limits()).unwrap();
        assert_within(&planned.plan, &limits());
        assert_eq!(planned.plan.last().0.as_slice(), model.goal_deg());
    }
}

/// Joint 6, taught at rest at `taught_deg`, begins at `start_deg`.
fn wrist(taught_deg: f64, start_deg: f64) -> Result<PlannedMotion, PlanError> {
    let model = shifted(5, Some(taught_deg), Some(taught_deg));
    let mut start = plus(model.start_deg(), &NO_OFFSET);
    start.0[5] = start_deg;
    let request = PlanRequest {
        start: Target::Joints(start),
        ..as_taught()
    };
    plan(&model, &request, None, &limits())
}

#[test]
fn a_wrist_ends_at_the_equivalent_angle_of_its_own_turn() {
    for (taught, start, goal) in [
        (-150.0, 129.0, 210.0), // 279 deg off
        (150.0, -129.0, -210.0),
        (-135.0, 135.0, 225.0), // 270 deg off
        (-90.0, 90.5, 270.0),   // the goal exactly at the end of the range
        (-90.1, 270.0, 269.9),  // the start exactly there
        (-270.0, 90.0, 90.0),   // a whole turn
        (-270.0, 270.0, 90.0),  // a turn and a half
    ] {
        let planned = wrist(taught, start).unwrap();
        assert!(
            (planned.goal.0[5] - goal).abs() < 1e-9,
            "{taught} {start}: {:?}",
            planned.goal
        );
        assert!(
            planned
                .warnings
                .iter()
                .any(|w| w.to_string().contains("whole turn"))
        );
        assert_within(&planned.plan, &limits());
        // It takes the short way and does not unwind.
        let between = f64::min(start, goal) - 0.01..=f64::max(start, goal) + 0.01;
        let mut turns = planned.plan.samples().iter().map(|s| s.joints.0[5]);
        assert!(turns.all(|q6| between.contains(&q6)), "{taught} {start}");
    }
}

#[test]
fn a_wrist_whose_goal_would_be_out_of_its_range_is_refused_with_the_reason() {
    for (taught, start, off) in [
        (0.0, 270.0, 270.0),
        (0.0, -270.0, -270.0),
        (-9.0, 270.0, 279.0),
        (45.0, -225.0, -270.0),
        (-89.9, 100.0, 189.9), // a tenth of a degree beyond the range
        (-89.999, 91.0, 180.999),
    ] {
        let error = wrist(taught, start).unwrap_err();
        assert_eq!(error.code(), "joint_turned_away");
        let PlanError::TurnedAway { joint, offset_deg } = error else {
            panic!("{error}");
        };
        assert_eq!(joint, 6);
        assert!((offset_deg - off).abs() < 1e-9, "{offset_deg}");
    }
}

#[test]
fn a_wrist_up_to_half_a_turn_away_goes_to_the_taught_goal() {
    for (taught, start) in [
        (0.0, 180.0),
        (0.0, -180.0),
        (-90.0, 90.0),
        (-90.0, -270.0),
        (90.0, 270.0),
    ] {
        let planned = wrist(taught, start).unwrap();
        assert_eq!(planned.goal.0[5], taught);
        assert_within(&planned.plan, &limits());
    }
    assert_eq!(wrist(0.0, 180.001).unwrap_err().code(), "joint_turned_away");
}

#[test]
fn a_typed_goal_is_taken_at_the_turn_of_the_start_as_the_taught_one_is() {
    let model = shifted(5, Some(-150.0), Some(-150.0));
    let present = plus(model.start_deg(), &[0.0, 0.0, 0.0, 0.0, 0.0, 279.0]);
    let at = |goal_off: &Offsets| PlanRequest {
        start: Target::Present,
        goal: Target::Joints(plus(model.goal_deg(), goal_off)),
        speed: 1.0,
    };
    let typed = at(&[5.0, 0.0, 0.0, 0.0, 0.0, -10.0]);
    let planned = plan(&model, &typed, Some(present), &limits()).unwrap();
    assert!((planned.goal.0[5] - 200.0).abs() < 1e-9);
    assert!(
        planned
            .warnings
            .iter()
            .any(|w| w.to_string().contains("whole turn"))
    );

    // A goal typed at another turn is meant.
    let other = at(&[0.0, 0.0, 0.0, 0.0, 0.0, 360.0]);
    let planned = plan(&model, &other, Some(present), &limits()).unwrap();
    assert!((planned.goal.0[5] - 210.0).abs() < 1e-9);
    assert!(
        !planned
            .warnings
            .iter()
            .any(|w| w.to_string().contains("turn"))
    );
}

#[test]
fn a_joint_that_unwinds_on_its_way_is_named() {
    let model = shifted(5, Some(-150.0), Some(-150.0));
    let request = request_off(&model, &NO_OFFSET, &[0.0, 0.0, 0.0, 0.0, 0.0, 360.0]);
    let planned = plan(&model, &request, None, &limits()).unwrap();
    assert!((planned.goal.0[5] - 210.0).abs() < 1e-9);
    let named = |w: &Warning| w.to_string().contains("Joint 6 turns 360° further");
    assert!(planned.warnings.iter().any(named), "{:?}", planned.warnings);
    assert_within(&planned.plan, &limits());
}
