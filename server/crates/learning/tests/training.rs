//! The whole way, as its users see it: what is refused, what is said, and that
//! the same input gives the same model.

#![expect(
    clippy::unwrap_used,
    reason = "a test stops at what it does not expect"
)]

use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::sync::Mutex;

use learning::{
    Demonstration, Error, Model, Progress, Stage, TrainingParams, dmp::Extent, metrics, train,
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

/// The model's file, computed in a pool of its own, and the sizes of the pools in
/// which the steps were reported; 0 for a step outside every pool.
fn computed_in_a_pool(threads: usize, params: &TrainingParams) -> (String, BTreeSet<usize>) {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .unwrap();
    let sizes = Mutex::new(BTreeSet::new());
    let model = pool.install(|| {
        train("pick", &takes(), params, &|_| {
            let size = rayon::current_thread_index().map_or(0, |_| rayon::current_num_threads());
            sizes.lock().unwrap().insert(size);
            ControlFlow::Continue(())
        })
    });
    (model.unwrap().to_json(), sizes.into_inner().unwrap())
}

#[test]
fn the_same_demonstrations_and_seed_give_the_same_bytes_on_any_number_of_threads() {
    for params in methods(7) {
        let (one, _) = computed_in_a_pool(1, &params);
        for threads in [2, 4] {
            let (same, _) = computed_in_a_pool(threads, &params);
            assert_eq!(one, same, "{threads} threads");
        }
        let other = TrainingParams {
            seed: 8,
            ..params.clone()
        };
        assert_ne!(one, computed_in_a_pool(1, &other).0);
    }
}

#[test]
fn every_step_runs_in_the_pool_that_the_caller_installs() {
    for params in methods(7) {
        for threads in [1, 2, 4] {
            let (_, sizes) = computed_in_a_pool(threads, &params);
            assert_eq!(sizes, BTreeSet::from([threads]), "{:?}", params.method);
        }
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
fn a_short_motion_of_an_unsteady_hand_is_one_motion() {
    // 15 deg of one joint; the takes differ by up to 3 deg all along.
    let takes: Vec<Demonstration> = [0.0, 1.5, -1.5]
        .into_iter()
        .map(|off| {
            let times: Vec<f64> = (0..150).map(|i| 0.02 * f64::from(i)).collect();
            let joints = (0..150)
                .map(|i| {
                    vec![
                        15.0 * f64::from(i) / 149.0,
                        10.0 + off,
                        20.0,
                        off,
                        -45.0,
                        0.0,
                    ]
                })
                .collect();
            Demonstration::new(format!("{off}"), times, joints, None).unwrap()
        })
        .collect();
    assert_eq!(trained(&takes, 1).report.demonstrations.len(), 3);
}
