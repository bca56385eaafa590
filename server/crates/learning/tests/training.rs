//! The whole way, as its users see it: what is refused, what is said, and that
//! the same input gives the same model.

#![expect(
    clippy::unwrap_used,
    reason = "a test stops at what it does not expect"
)]

use std::ops::ControlFlow;
use std::sync::Mutex;

use learning::{
    Demonstration, Error, Model, Progress, Stage, TrainingParams, dmp::Extent, metrics, read,
    train, write,
};

/// A pick-and-place of six joints, at a pace and with a sway of its own.
fn take(name: &str, pace: f64, sway_deg: f64) -> Demonstration {
    let n = 240;
    let times: Vec<f64> = (0..n).map(|i| 0.02 * pace * f64::from(i)).collect();
    let joints = (0..n)
        .map(|i| {
            let u = (f64::from(i) / 220.0).min(1.0);
            let s = u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
            let bump = (std::f64::consts::PI * s).sin();
            vec![
                40.0 * s,
                10.0 + 15.0 * bump + sway_deg * bump,
                20.0 - 10.0 * s,
                5.0 * bump,
                -45.0 + 5.0 * s + sway_deg * bump,
                0.0,
            ]
        })
        .collect();
    Demonstration::new(name.into(), times, joints, None).unwrap()
}

fn takes() -> Vec<Demonstration> {
    vec![
        take("take 1", 1.0, 0.0),
        take("take 2", 1.1, 1.0),
        take("take 3", 0.9, -1.0),
    ]
}

/// The paper's protocol with fewer halves, so that the tests are quick.
fn paper(seed: u64) -> TrainingParams {
    let mut params = TrainingParams::paper(seed);
    params.selection.splits = 4;
    params
}

/// Both methods.
fn methods(seed: u64) -> [TrainingParams; 2] {
    [TrainingParams::faithful(seed), paper(seed)]
}

fn with(demonstrations: &[Demonstration], params: &TrainingParams) -> Model {
    train("pick", demonstrations, params, &|_| {
        ControlFlow::Continue(())
    })
    .unwrap()
}

/// By the default method.
fn trained(demonstrations: &[Demonstration], seed: u64) -> Model {
    with(demonstrations, &TrainingParams::faithful(seed))
}

#[test]
fn it_reproduces_from_another_start_to_another_goal() {
    for params in methods(1) {
        let model = with(&takes(), &params);
        let shifted = |q: &[f64], by: f64| q.iter().map(|v| v + by).collect::<Vec<_>>();
        let goal = shifted(model.goal_deg(), 5.0);
        let extent = Extent::UntilSettled {
            tolerance_deg: 0.001,
            longest_s: 60.0,
        };
        let path = model
            .reproduce(&shifted(model.start_deg(), 5.0), &goal, extent)
            .unwrap();
        assert!(metrics::e_j_deg(path.last(), &goal) <= 0.001);
        assert!(metrics::gmcc(&path, &model.regression().mean_deg) >= 0.99);
    }
}

#[test]
fn the_same_demonstrations_and_seed_give_the_same_bytes_on_any_number_of_threads() {
    let bytes = |threads: usize, params: &TrainingParams| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| with(&takes(), params).to_json())
    };
    for params in methods(7) {
        let one = bytes(1, &params);
        assert_eq!(one, bytes(2, &params));
        let other = TrainingParams {
            seed: 8,
            ..params.clone()
        };
        assert_ne!(one, bytes(1, &other));
    }
}

#[test]
fn a_faithful_path_runs_within_the_bundle_and_ends_where_the_takes_ended() {
    let model = trained(&takes(), 1);
    let fidelity = model.report.fidelity.unwrap();
    assert!(fidelity.missed_over_mutual.unwrap() < 0.75, "{fidelity:?}");
    let ends = |distances: &[f64], spread: f64| distances.iter().all(|d| *d <= spread + 0.5);
    assert!(
        ends(&fidelity.start_mm, fidelity.start_spread_mm),
        "{fidelity:?}"
    );
    assert!(
        ends(&fidelity.end_mm, fidelity.end_spread_mm),
        "{fidelity:?}"
    );
    let (ours, shown) = (&fidelity.reproduction, &fidelity.demonstrations);
    assert!(ours.peak_speed_deg_s <= 1.2 * shown.peak_speed_deg_s);
}

#[test]
fn a_faithful_motion_begins_and_ends_at_rest_where_the_takes_did() {
    let model = trained(&takes(), 1);
    let regression = model.regression();
    let (curve, n) = (&regression.mean_deg, regression.t_s.len());
    let dt = regression.t_s[1];
    for (a, b) in [(0, 1), (n - 2, n - 1)] {
        for (p, q) in curve.row(a).iter().zip(curve.row(b)) {
            assert!(((q - p) / dt).abs() < 0.1);
        }
    }
    assert!((curve.last()[0] - 40.0).abs() < 0.2 && (curve.row(0)[0]).abs() < 0.2);
    assert_eq!(model.goal_deg(), curve.last());
}

#[test]
fn a_model_file_reads_back_exactly_and_says_what_it_holds() {
    let model = trained(&takes(), 1);
    let text = model.to_json();
    assert_eq!(Model::from_json(&text).unwrap(), model);
    for word in ["degrees", "millimetres", "\"seed\": 1", "sha256", "take 2"] {
        assert!(text.contains(word), "{word}");
    }
}

#[test]
fn a_damaged_model_file_is_refused() {
    let text = trained(&takes(), 1).to_json();
    let damaged = [
        text[..text.len() / 2].to_string(),
        text.replace("team-model", "another"),
        text.replace("\"dt_s\": ", "\"dt_s\": -"),
        text.replace("\"steps\": ", "\"steps\": 99999999"),
    ];
    for text in damaged {
        assert!(matches!(
            Model::from_json(&text),
            Err(Error::BadModel { .. })
        ));
    }
}

#[test]
fn one_take_is_learned_and_what_is_lost_is_said() {
    let model = trained(&takes()[..1], 1);
    assert!(
        model.report.notes[0].contains("only one take"),
        "{:?}",
        model.report.notes
    );
    assert!(model.summary().starts_with("Learned from one take."));
    let fidelity = model.report.fidelity.unwrap();
    assert_eq!(fidelity.mutual_mean_mm, None);
}

#[test]
fn a_joint_that_never_moves_is_learned_and_named() {
    let model = trained(&takes(), 1);
    assert!(
        model
            .report
            .notes
            .iter()
            .any(|n| n.contains("Joint 6 never moved"))
    );
    let path = model
        .reproduce(model.start_deg(), model.goal_deg(), Extent::AsTaught)
        .unwrap();
    assert!(path.rows().all(|row| row[5].abs() < 1e-6));
}

#[test]
fn one_to_seven_joints_can_be_learned() {
    for d in 1..=7 {
        let takes: Vec<Demonstration> = (0..2)
            .map(|i| {
                let times: Vec<f64> = (0..120).map(|k| 0.02 * f64::from(k)).collect();
                let joints = times
                    .iter()
                    .map(|t| {
                        (0..d)
                            .map(|j| 10.0 * (t + 0.1 * (j + i) as f64).sin() - 50.0)
                            .collect()
                    })
                    .collect();
                Demonstration::new(format!("take {i}"), times, joints, None).unwrap()
            })
            .collect();
        let model = trained(&takes, 1);
        assert_eq!(model.joints(), d);
        assert_eq!(model.report.fidelity.is_some(), d == 6);
    }
}

#[test]
fn progress_goes_through_every_stage_and_never_back() {
    let seen: Mutex<Vec<Progress>> = Mutex::new(Vec::new());
    train("pick", &takes(), &paper(1), &|progress| {
        seen.lock().unwrap().push(progress);
        ControlFlow::Continue(())
    })
    .unwrap();
    let seen = seen.into_inner().unwrap();
    for (stage, _) in Stage::ALL {
        assert!(seen.iter().any(|p| p.stage == stage), "{stage:?}");
    }
    let order = |p: &Progress| Stage::ALL.iter().position(|(s, _)| *s == p.stage);
    assert!(seen.windows(2).all(|w| order(&w[0]) <= order(&w[1])));
    assert!(
        seen.iter()
            .all(|p| (0.0..=1.0).contains(&p.fraction) && p.done <= p.total)
    );
}

#[test]
fn it_can_be_cancelled_in_every_stage() {
    for (stage, _) in Stage::ALL {
        let result = train(
            "pick",
            &takes(),
            &TrainingParams::faithful(1),
            &|progress| {
                if progress.stage == stage {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            },
        );
        assert_eq!(result.unwrap_err(), Error::Cancelled, "{stage:?}");
    }
}

#[test]
fn what_cannot_be_learned_together_is_refused() {
    let nothing = train("pick", &[], &TrainingParams::faithful(1), &|_| {
        ControlFlow::Continue(())
    });
    assert_eq!(nothing.unwrap_err(), Error::NoDemonstrations);
    let times: Vec<f64> = (0..120).map(|k| 0.02 * f64::from(k)).collect();
    let joints = times.iter().map(|t| vec![10.0 * t]).collect();
    let single = Demonstration::new("single".into(), times, joints, None).unwrap();
    let mixed = [takes().remove(0), single];
    let result = train("pick", &mixed, &TrainingParams::faithful(1), &|_| {
        ControlFlow::Continue(())
    });
    assert!(matches!(
        result.unwrap_err(),
        Error::DifferentJointCounts { name, expected: 6, found: 1, .. } if name == "single"
    ));
    let first = takes().remove(0);
    let reversed: Vec<Vec<f64>> = first
        .joints_deg()
        .rows()
        .rev()
        .map(<[f64]>::to_vec)
        .collect();
    let backwards = Demonstration::new(
        "backwards".into(),
        takes()[0].times_s().to_vec(),
        reversed,
        None,
    )
    .unwrap();
    let both = [takes().remove(0), takes().remove(1), backwards];
    let result = train("pick", &both, &TrainingParams::faithful(1), &|_| {
        ControlFlow::Continue(())
    });
    let Error::DifferentMotions { groups } = result.unwrap_err() else {
        panic!("a motion and its reverse are two motions");
    };
    assert_eq!(groups[1], ["backwards"]);
}

#[test]
fn a_demonstration_survives_its_own_json_exactly() {
    let take = take("take 1", 1.0, 0.3);
    assert_eq!(
        read::from_str("take 1", &write::to_json(&take)).unwrap(),
        take
    );
}

#[test]
fn csv_with_dots_or_german_commas_reads_the_same() {
    let mut dots = String::from("t_s,q1_deg,q2_deg\n");
    let mut commas = String::from("\u{feff}t_s;q1_deg;q2_deg\r\n");
    for i in 0..100 {
        let (t, q) = (f64::from(i) * 0.02, f64::from(i) * 0.25);
        dots += &format!("{t},{q},-1.5\n");
        commas += &format!("{t};{q};-1.5\r\n").replace('.', ",");
    }
    let a = read::from_str("x", &dots).unwrap();
    assert_eq!(a, read::from_str("x", &commas).unwrap());
    assert_eq!((a.len(), a.joints()), (100, 2));
}

#[test]
fn bad_csv_is_refused_with_the_place() {
    let rows = |extra: &str| {
        let mut text = String::from("t_s,q1_deg\n");
        for i in 0..100 {
            text += &format!("{},{}\n", f64::from(i) * 0.02, i);
        }
        text + extra
    };
    let read = |text: &str| read::from_str("x", text).unwrap_err();
    assert!(matches!(read(&rows("3.0\n")), Error::Ragged { what, .. } if what == "row 101"));
    assert!(matches!(
        read(&rows("3.0,NaN\n")),
        Error::NotFinite { row: 101, .. }
    ));
    assert!(matches!(
        read(&rows("3.0,oops\n")),
        Error::NotFinite { row: 101, .. }
    ));
    assert!(matches!(
        read(&rows("1.98,5\n")),
        Error::TimeNotIncreasing { row: 101, .. }
    ));
    assert!(matches!(
        read(&rows("1.0,5\n")),
        Error::TimeNotIncreasing { row: 101, .. }
    ));
    assert!(matches!(
        read("t_s,q1_rad\n0,0\n"),
        Error::Unreadable { .. }
    ));
    assert!(matches!(
        read("t_s,q1_deg,q3_deg\n"),
        Error::Unreadable { .. }
    ));
    assert!(matches!(read(""), Error::Unreadable { .. }));
    assert!(matches!(
        read("t_s,q1_deg\n0,0\n0.5,1\n"),
        Error::TooShort { .. }
    ));
    assert!(matches!(read("t_s,q1_deg\n"), Error::TooShort { .. }));
}

/// A recording as the paper's recorder wrote them, with one column changed.
fn recording(change: impl Fn(&str, usize) -> Option<serde_json::Value>) -> String {
    let names = [
        "timestamp",
        "tcp_x",
        "tcp_y",
        "tcp_z",
        "tcp_q1",
        "tcp_q2",
        "tcp_q3",
        "tcp_q4",
        "cf1",
        "cf4",
        "cf6",
        "cfx",
        "joint_1",
        "joint_2",
        "joint_3",
        "joint_4",
        "joint_5",
        "joint_6",
    ];
    let columns: Vec<String> = names
        .iter()
        .map(|name| {
            let values: Vec<serde_json::Value> = (0..100)
                .filter_map(|i| match change(name, i) {
                    Some(value) if value == serde_json::json!("absent") => None,
                    Some(value) => Some(value),
                    None if *name == "timestamp" => Some(serde_json::json!(0.02 * (i + 1) as f64)),
                    None if *name == "joint_2" => Some(serde_json::json!(0.3 * i as f64)),
                    None => Some(serde_json::json!(1.0)),
                })
                .collect();
            format!("\"{name}\": {}", serde_json::to_string(&values).unwrap())
        })
        .collect();
    format!("{{{}}}", columns.join(", "))
}

#[test]
fn the_recorders_files_are_read_by_position() {
    let demonstration = read::from_str("x", &recording(|_, _| None)).unwrap();
    assert_eq!((demonstration.len(), demonstration.joints()), (100, 6));
    assert!((demonstration.joints_deg().row(10)[1] - 3.0).abs() < 1e-12);
    assert_eq!(demonstration.recorded_tcp_mm().unwrap()[0], [1.0; 3]);
}

#[test]
fn damaged_recordings_are_refused_with_the_place() {
    let read = |change: &dyn Fn(&str, usize) -> Option<serde_json::Value>| {
        read::from_str("x", &recording(change)).unwrap_err()
    };
    let at = |name: &'static str, row: usize, value: serde_json::Value| {
        move |n: &str, i: usize| (n == name && i == row).then(|| value.clone())
    };
    let ragged = read(&at("joint_3", 50, serde_json::json!("absent")));
    assert!(
        matches!(ragged, Error::Ragged { what, expected: 100, found: 99, .. } if what == "joint_3")
    );
    let null = read(&at("joint_4", 7, serde_json::Value::Null));
    assert!(matches!(null, Error::NotFinite { what, row: 8, .. } if what == "joint_4"));
    let back = read(&at("timestamp", 30, serde_json::json!(0.1)));
    assert!(matches!(back, Error::TimeNotIncreasing { row: 31, .. }));
    let range = read(&at("joint_3", 20, serde_json::json!(120.0)));
    assert!(matches!(
        range,
        Error::JointOutOfRange {
            joint: 3,
            row: 21,
            ..
        }
    ));
    let location = range.where_();
    assert_eq!((location.joint, location.row), (Some(3), Some(21)));
    let still = read(&|n, _| (n == "joint_2").then(|| serde_json::json!(4.0)));
    assert!(matches!(still, Error::NoMotion { .. }));
    assert!(!still.advice().is_empty());
}

proptest::proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig {
        failure_persistence: None,
        ..Default::default()
    })]

    #[test]
    fn no_text_makes_the_readers_panic(text in ".{0,400}") {
        let _ = read::from_str("x", &text);
        let _ = read::from_str("x", &format!("{{{text}"));
        let _ = read::from_str("x", &format!("t_s,q1_deg\n{text}"));
        let _ = Model::from_json(&text);
    }
}
