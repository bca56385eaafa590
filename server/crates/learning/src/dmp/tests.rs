//! What a primitive promises: it imitates, it arrives, it moves with its start.

use proptest::prelude::*;

use super::*;
use crate::metrics;

const DT: f64 = 0.01;

/// Two joints that swing and rest at the end, 8 s.
fn taught() -> Path {
    Path::from_rows(
        2,
        (0..801).map(|i| {
            let u = (f64::from(i) / 700.0).min(1.0);
            let s = u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
            [30.0 * s, 15.0 * (std::f64::consts::PI * s).sin() - 20.0]
        }),
    )
}

fn primitive() -> MovementPrimitive {
    let path = taught();
    imitate(
        &path,
        DT,
        time_constant_s(&path, DT),
        25.0,
        100,
        PUBLISHED_FLOOR,
    )
}

#[test]
fn it_imitates_what_it_was_taught() {
    let (path, primitive) = (taught(), primitive());
    let rollout = primitive
        .rollout(&primitive.start_deg, &primitive.goal_deg, Extent::AsTaught)
        .unwrap();
    assert_eq!(rollout.len(), path.len());
    let worst = rollout
        .rows()
        .zip(path.rows())
        .flat_map(|(a, b)| a.iter().zip(b).map(|(x, y)| (x - y).abs()))
        .fold(0.0, f64::max);
    assert!(worst < 0.8, "{worst}");
    assert!(metrics::e_j_deg(rollout.last(), path.last()) < 0.05);
}

#[test]
fn the_time_constant_is_when_the_motion_ends_whichever_way_it_goes() {
    let path = taught();
    let mirrored = Path::from_rows(2, path.rows().map(|row| [-row[0], -row[1]]));
    let tau = time_constant_s(&path, DT);
    assert!(tau > 5.5 && tau < 7.0, "{tau}");
    assert_eq!(tau, time_constant_s(&mirrored, DT));
}

/// Without forcing, y is the critically damped response of rate p = alpha / (2 tau)
/// to a goal that approaches G at the rate q = alpha / 6. With unit step,
/// y(t) = 1 - A exp(-q t) - (B + C t) exp(-p t), A = p² / (p - q)², B = 1 - A and
/// C = p B + q A, from y(0) = y'(0) = 0.
#[test]
fn without_forcing_a_step_of_the_goal_is_answered_by_the_closed_form() {
    let (alpha, tau, dt) = (20.0, 2.0, 1e-4);
    let still = MovementPrimitive {
        alpha_z: alpha,
        tau_s: tau,
        dt_s: dt,
        steps: 60_000,
        start_deg: vec![0.0],
        goal_deg: vec![0.0],
        weights: vec![vec![0.0; 20]],
    };
    let rollout = still.rollout(&[0.0], &[10.0], Extent::AsTaught).unwrap();
    let (p, q) = (alpha / (2.0 * tau), alpha / 6.0);
    let a = p * p / ((p - q) * (p - q));
    let b = 1.0 - a;
    let c = p * b + q * a;
    for (i, row) in rollout.rows().enumerate().step_by(500) {
        let t = i as f64 * dt;
        let exact = 1.0 - a * (-q * t).exp() - (b + c * t) * (-p * t).exp();
        assert!(
            (row[0] - 10.0 * exact).abs() < 5e-3,
            "{t}: {} {}",
            row[0],
            10.0 * exact
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn it_reaches_any_goal_from_any_start(
        start in prop::array::uniform2(-90.0..90.0f64),
        goal in prop::array::uniform2(-90.0..90.0f64),
    ) {
        let extent = Extent::UntilSettled { tolerance_deg: 0.01, longest_s: 60.0 };
        let rollout = primitive().rollout(&start, &goal, extent).unwrap();
        prop_assert!(metrics::e_j_deg(rollout.last(), &goal) <= 0.01);
        prop_assert_eq!(rollout.row(0), &start[..]);
    }

    #[test]
    fn moving_start_and_goal_alike_moves_the_whole_path(shift in -60.0..60.0f64) {
        let p = primitive();
        let moved = |q: &Vec<f64>| q.iter().map(|v| v + shift).collect::<Vec<_>>();
        let a = p.rollout(&p.start_deg, &p.goal_deg, Extent::AsTaught).unwrap();
        let b = p
            .rollout(&moved(&p.start_deg), &moved(&p.goal_deg), Extent::AsTaught)
            .unwrap();
        for (x, y) in a.rows().zip(b.rows()) {
            prop_assert!((x[0] + shift - y[0]).abs() < 1e-9);
            prop_assert!((x[1] + shift - y[1]).abs() < 1e-9);
        }
    }
}

#[test]
fn it_begins_at_rest() {
    let p = primitive();
    let rollout = p
        .rollout(&[3.0, -9.0], &[40.0, 5.0], Extent::AsTaught)
        .unwrap();
    assert_eq!(rollout.row(0), rollout.row(1));
    let first_speed = (rollout.row(2)[0] - rollout.row(1)[0]).abs() / DT;
    assert!(first_speed < 0.5, "{first_speed}");
}

#[test]
fn targets_that_do_not_fit_are_refused() {
    let p = primitive();
    let short = p
        .rollout(&[1.0], &p.goal_deg, Extent::AsTaught)
        .unwrap_err();
    assert!(matches!(short, Error::BadTarget { which: "start", .. }));
    let nan = p
        .rollout(&p.start_deg, &[f64::NAN, 0.0], Extent::AsTaught)
        .unwrap_err();
    assert!(matches!(nan, Error::BadTarget { which: "goal", .. }));
}
