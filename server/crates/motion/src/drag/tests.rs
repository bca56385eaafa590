//! Properties of dragging: its limits hold whatever the finger does.

use super::*;
use crate::kinematics::Jacobian;
use crate::{JointVelocities, kinematics};
use proptest::prelude::*;

const HOME: JointAngles = JointAngles([0.0, 8.0, 24.0, 0.0, -45.0, 0.0]);
/// How often a server moves the drag on, s.
const TICK_S: f64 = 0.02;

fn limits() -> RobotLimits {
    RobotLimits::gofa5()
}

fn at(tool_mm: [f64; 3]) -> Target {
    Target {
        tool_mm,
        turn_deg: [0.0; 3],
    }
}

fn beside_home(by_mm: [f64; 3]) -> [f64; 3] {
    let home = tool0(&HOME).position.0;
    [0, 1, 2].map(|i| home[i] + by_mm[i])
}

/// Checks two places one short step apart, and the speeds before and between them. The joints'
/// accelerations may be `most` times their limits.
fn check_step(
    before: &JointAngles,
    after: &JointAngles,
    speeds: &mut JointVelocities,
    step_s: f64,
    most: f64,
) -> Result<(), TestCaseError> {
    let limits = limits();
    prop_assert!(after.is_finite());
    prop_assert_eq!(limits.joint_out_of_range(after), None);
    let now = JointVelocities(std::array::from_fn(|joint| {
        (after.0[joint] - before.0[joint]) / step_s
    }));
    // A joint that meets the end of its range stops there, whatever that does to the others.
    let at_an_end = [before, after].into_iter().any(|joints| {
        (0..JOINTS).any(|joint| {
            joints.0[joint] < limits.joint_min_deg[joint] + 1e-6
                || joints.0[joint] > limits.joint_max_deg[joint] - 1e-6
        })
    });
    for joint in 0..JOINTS {
        prop_assert!(now.0[joint].abs() <= limits.joint_speed_deg_s[joint] * 1.0001);
        let change = (now.0[joint] - speeds.0[joint]).abs() / step_s;
        prop_assert!(
            change <= limits.joint_acceleration_deg_s2[joint] * most || at_an_end,
            "joint {} changes its speed by {change}",
            joint + 1
        );
    }
    let tool_mm_s = Jacobian::of(before, [0.0; 3]).point_speed_mm_s(&now);
    prop_assert!(
        tool_mm_s <= TOOL_MM_S * 1.0001,
        "the tool moves at {tool_mm_s}"
    );
    *speeds = now;
    Ok(())
}

/// Where the arm is every 4 ms while a finger does `finger` at each tick.
fn dragged(
    from: JointAngles,
    finger: &[Option<Target>],
    most: f64,
) -> Result<Vec<JointAngles>, TestCaseError> {
    let mut drag = Drag::begin(from, &limits());
    let mut speeds = JointVelocities::ZERO;
    let mut path = vec![from];
    for target in finger {
        target.iter().for_each(|target| drag.aim(target));
        for _ in 0..5 {
            let before = path[path.len() - 1];
            let after = drag.advance(TICK_S / 5.0);
            check_step(&before, &after, &mut speeds, TICK_S / 5.0, most)?;
            path.push(after);
        }
    }
    Ok(path)
}

#[test]
fn the_tool_follows_a_circle_of_the_finger_and_keeps_its_orientation() {
    // 80 mm about a point beside home in six seconds: 84 mm/s.
    let finger: Vec<_> = (0..=300)
        .map(|tick| {
            let turn = f64::from(tick) / 300.0 * std::f64::consts::TAU;
            Some(at(beside_home([
                0.0,
                80.0 * turn.sin(),
                80.0 * (turn.cos() - 1.0),
            ])))
        })
        .collect();
    let path = dragged(HOME, &finger, 1.01).unwrap();
    let centre = beside_home([0.0, 0.0, -80.0]);
    for joints in &path {
        let pose = tool0(joints);
        let radius = pose.position.distance(&Position(centre));
        assert!((radius - 80.0).abs() < 1.0, "{radius}");
        assert!((pose.position.0[0] - centre[0]).abs() < 1.0);
        let turned = inverse::error(&tool0(&HOME), &pose).turn_deg;
        assert!(inverse::length(turned) < 1.0, "{turned:?}");
    }
    let end = tool0(&path[path.len() - 1]).position;
    assert!(
        end.distance(&tool0(&HOME).position) < 8.0,
        "it lags by less than 0.1 s"
    );
}

#[test]
fn a_finger_that_rests_brings_the_arm_there_and_no_farther() {
    let target = beside_home([-60.0, 120.0, 40.0]);
    let path = dragged(HOME, &[Some(at(target)); 150], 1.01).unwrap();
    let places: Vec<_> = path.iter().map(|joints| tool0(joints).position).collect();
    let left: Vec<_> = places
        .iter()
        .map(|place| place.distance(&Position(target)))
        .collect();
    assert!(left[left.len() - 1] < 0.1, "{}", left[left.len() - 1]);
    // It comes nearer all the time: it neither swings nor passes the target.
    for pair in left.windows(2) {
        assert!(pair[1] <= pair[0] + 0.05, "{pair:?}");
    }
}

#[test]
fn the_wrist_turns_by_what_is_asked_and_the_flange_stays_in_its_place() {
    let target = Target {
        tool_mm: tool0(&HOME).position.0,
        turn_deg: [0.0, 0.0, 40.0],
    };
    let path = dragged(HOME, &[Some(target); 150], 1.01).unwrap();
    let end = path[path.len() - 1];
    assert!((end.0[5] - HOME.0[5] - 40.0).abs() < 0.1, "{end:?}");
    for joints in &path {
        let place = tool0(joints).position;
        assert!(place.distance(&tool0(&HOME).position) < 1.0);
    }
}

#[test]
fn a_target_that_nobody_repeats_is_let_go() {
    let mut drag = Drag::begin(HOME, &limits());
    drag.aim(&at(beside_home([0.0, 600.0, 0.0])));
    let mut age_s = 0.0;
    while !drag.is_at_rest() {
        drag.advance(TICK_S);
        age_s += TICK_S;
        assert!(age_s < 2.0, "it goes on");
    }
    assert!(age_s > PATIENCE_S);
    let left = drag.advance(TICK_S);
    assert_eq!(drag.advance(1.0), left, "and it stays");
    let way = tool0(&left).position.distance(&tool0(&HOME).position);
    assert!((10.0..150.0).contains(&way), "{way}");
}

#[test]
fn what_is_not_a_number_is_no_target() {
    let mut drag = Drag::begin(HOME, &limits());
    drag.aim(&at([f64::NAN, 0.0, 0.0]));
    drag.aim(&Target {
        tool_mm: [0.0; 3],
        turn_deg: [0.0, f64::INFINITY, 0.0],
    });
    for elapsed_s in [f64::NAN, f64::INFINITY, -1.0, 1e9] {
        assert_eq!(drag.advance(elapsed_s), HOME);
    }
}

#[test]
fn through_the_stretched_wrist_the_arm_stays_calm() {
    let from = JointAngles([0.0, 20.0, 10.0, 0.0, -8.0, 0.0]);
    let here = tool0(&from).position.0;
    // Up and beside: the way leads close to where joints 4 and 6 turn about one axis.
    let finger: Vec<_> = (0..300)
        .map(|tick| {
            let way = f64::from(tick) / 2.0;
            Some(at([here[0], here[1] + 0.3 * way, here[2] + way]))
        })
        .collect();
    let path = dragged(from, &finger, 1.01).unwrap();
    let end = tool0(&path[path.len() - 1]).position;
    let wanted = finger[finger.len() - 1]
        .map(|target| Position(target.tool_mm))
        .unwrap();
    assert!(end.distance(&wanted) < 15.0, "{end:?}");
}

#[test]
fn out_of_reach_the_arm_stretches_towards_the_finger_and_comes_back() {
    let out = at([3_000.0, 0.0, 600.0]);
    let back = at(tool0(&HOME).position.0);
    let finger: Vec<_> = std::iter::repeat_n(Some(out), 1_000)
        .chain(std::iter::repeat_n(Some(back), 300))
        .collect();
    let path = dragged(HOME, &finger, 1.01).unwrap();
    let stretched = tool0(&path[5_000]);
    // With the flange pointing where it did, no place is farther along x than about the reach.
    assert!(stretched.position.0[0] > 750.0, "{stretched:?}");
    let rests = path[4_900].max_abs_difference(&path[5_000]);
    assert!(rests < 0.1, "it swings by {rests}");
    let end = tool0(&path[path.len() - 1]).position;
    assert!(end.distance(&tool0(&HOME).position) < 1.0, "{end:?}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn a_wild_finger_never_leads_the_arm_beyond_its_limits(
        from in prop::array::uniform6(-0.95..0.95),
        finger in prop::collection::vec(
            (
                1_usize..40,
                prop::option::weighted(0.8, (
                    prop::array::uniform3(-1_500.0..1_500.0),
                    prop::array::uniform3(-200.0..200.0),
                )),
            ),
            1..12,
        ),
    ) {
        let limits = limits();
        let from = JointAngles(std::array::from_fn(|joint| {
            let (low, high) = (limits.joint_min_deg[joint], limits.joint_max_deg[joint]);
            (low + high) / 2.0 + from[joint] * (high - low) / 2.0
        }));
        let finger: Vec<_> = finger
            .into_iter()
            .flat_map(|(ticks, target)| {
                let target = target.map(|(tool_mm, turn_deg)| Target { tool_mm, turn_deg });
                std::iter::repeat_n(target, ticks)
            })
            .collect();
        // The tool's speed comes first: to keep it when everything turns at once, a joint may
        // brake harder.
        dragged(from, &finger, 2.0)?;
    }

    #[test]
    fn uneven_ticks_lead_to_the_same_place(ticks in prop::collection::vec(0.001..0.1, 120..200)) {
        let mut drag = Drag::begin(HOME, &limits());
        let target = beside_home([40.0, -90.0, -50.0]);
        for elapsed_s in &ticks {
            drag.aim(&at(target));
            drag.advance(*elapsed_s);
        }
        let end = kinematics::tool0(&drag.advance(0.0)).position;
        prop_assert!(ticks.iter().sum::<f64>() < 3.0 || end.distance(&Position(target)) < 0.5);
    }
}
