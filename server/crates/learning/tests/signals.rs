//! Signals on their whole way through a training: where a learned motion works them, what
//! is refused, and that motions without them are what they were.

#![expect(
    clippy::unwrap_used,
    reason = "a test stops at what it does not expect"
)]

use std::ops::ControlFlow;

use learning::{
    Demonstration, Error, Model, SignalEvent, TrainingParams, dmp::Extent, read, train, write,
};

/// Where the hand stops and works the gripper, on joint 1, degrees.
const GRASP_DEG: f64 = 30.0;

/// From 0 to 30 deg, a rest of `rest_s`, on to 50 deg; the gripper closes `after_s` into the
/// rest.
fn take(name: &str, pace: f64, rest_s: f64, after_s: f64) -> Demonstration {
    let share = |u: f64| {
        let u = u.clamp(0.0, 1.0);
        u * u * u * (10.0 - 15.0 * u + 6.0 * u * u)
    };
    let (there_s, back_s) = (2.5 * pace, 2.0 * pace);
    let whole_s = 0.5 + there_s + rest_s + back_s + 0.5;
    let count = (whole_s * 50.0) as usize;
    let times: Vec<f64> = (0..=count).map(|i| 0.02 * i as f64).collect();
    let rows = times
        .iter()
        .map(|t| {
            let first = share((t - 0.5) / there_s);
            let second = share((t - 0.5 - there_s - rest_s) / back_s);
            vec![
                GRASP_DEG * first + 20.0 * second,
                10.0 + 15.0 * first - 12.0 * second,
                20.0,
                0.0,
                -45.0,
                0.0,
            ]
        })
        .collect();
    let demonstration = Demonstration::new(name.into(), times, rows, None).unwrap();
    let closes = SignalEvent {
        name: "Gripper".into(),
        at_s: 0.5 + there_s + after_s,
        on: true,
    };
    demonstration.with_signals(vec![closes]).unwrap()
}

fn takes() -> Vec<Demonstration> {
    vec![
        take("take 1", 1.0, 1.0, 0.2),
        take("take 2", 1.2, 0.8, 0.3),
        take("take 3", 0.9, 1.2, 0.2),
    ]
}

fn trained(takes: &[Demonstration], params: &TrainingParams) -> Result<Model, Error> {
    train("grasp", takes, params, &|_| ControlFlow::Continue(()))
}

fn methods() -> [TrainingParams; 2] {
    let mut paper = TrainingParams::paper(1);
    paper.selection.splits = 4;
    [TrainingParams::faithful(1), paper]
}

fn joint_1(model: &Model, phase: f64) -> f64 {
    let extent = Extent::UntilSettled {
        tolerance_deg: 0.25,
        longest_s: 60.0,
    };
    let path = model
        .reproduce(model.start_deg(), model.goal_deg(), extent)
        .unwrap();
    let row = (phase * model.duration_s() / model.primitive.dt_s).round() as usize;
    path.row(row)[0]
}

#[test]
fn the_gripper_closes_where_it_was_closed_and_has_time_to() {
    let model = trained(&takes(), &TrainingParams::faithful(1)).unwrap();
    let [closes] = &model.signals[..] else {
        panic!("{:?}", model.signals);
    };
    assert!(closes.on && closes.name == "Gripper");
    assert!((joint_1(&model, closes.phase) - GRASP_DEG).abs() < 1.0);
    // The hands waited for half a second or more after the event; the arm stays within a degree
    // for that long too, where it went 20 degrees further in the two seconds behind.
    let later = closes.phase + 0.5 / model.duration_s();
    assert!(
        (joint_1(&model, later) - GRASP_DEG).abs() < 1.0,
        "{}",
        joint_1(&model, later)
    );
}

#[test]
fn both_methods_put_the_event_into_the_rest() {
    for params in methods() {
        let model = trained(&takes(), &params).unwrap();
        let closes = &model.signals[0];
        let shown = model.regression();
        let row = (closes.phase * (shown.t_s.len() - 1) as f64).round() as usize;
        // The paper's coarse mixture cuts the rest short; it must still be near the place.
        assert!(
            (shown.mean_deg.row(row)[0] - GRASP_DEG).abs() < 5.0,
            "{params:?}"
        );
        assert!(closes.spread_s < 1.0);
        assert_eq!(Model::from_json(&model.to_json()).unwrap(), model);
    }
}

#[test]
fn takes_that_work_the_gripper_differently_make_no_model() {
    let mut mixed = takes();
    mixed[1] = mixed[1].clone().with_signals(Vec::new()).unwrap();
    for params in methods() {
        let error = trained(&mixed, &params).unwrap_err();
        assert_eq!(error.code(), "signals_differ");
        assert_eq!(error.where_().demonstration.as_deref(), Some("take 2"));
        assert!(error.to_string().contains("no signal is worked"), "{error}");
    }
}

#[test]
fn a_motion_without_changes_of_signals_has_the_file_it_had() {
    let plain: Vec<Demonstration> = takes()
        .into_iter()
        .map(|take| take.with_signals(Vec::new()).unwrap())
        .collect();
    let stood: Vec<Demonstration> = plain
        .iter()
        .map(|take| {
            let stands = SignalEvent {
                name: "Gripper".into(),
                at_s: take.times_s()[0],
                on: true,
            };
            take.clone().with_signals(vec![stands]).unwrap()
        })
        .collect();
    let params = TrainingParams::faithful(1);
    let plain = trained(&plain, &params).unwrap();
    assert!(!plain.to_json().contains("signals"));
    let stood = trained(&stood, &params).unwrap();
    assert_eq!(
        (&stood.primitive, &stood.mixture),
        (&plain.primitive, &plain.mixture)
    );
    assert!(
        stood.signals.is_empty(),
        "what nobody changes is none of the motion's business"
    );
}

#[test]
fn a_demonstrations_file_carries_its_signals() {
    let take = take("take 1", 1.0, 1.0, 0.2);
    let text = write::to_json(&take);
    assert_eq!(read::from_str("take 1", &text).unwrap(), take);
    let outside = text.replace("\"at_s\":", "\"at_s\":1");
    let error = read::from_str("take 1", &outside).unwrap_err();
    assert_eq!(error.code(), "demonstration_signal_bad");
}
