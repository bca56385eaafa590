//! What a motion that the arm made is worth: end error, correlation with what was learnt, and
//! how well the arm followed. Pure.

use learning::Path;
use learning::metrics::{e_j_deg, gmcc};
use learning::regression::Regression;

use crate::store::reproductions::TrackingError;
use crate::store::samples::Cycle;

/// The figures of one run. What can't be computed from a run that broke off is missing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Figures {
    pub(super) e_j_deg: Option<f64>,
    pub(super) e_j_commanded_deg: Option<f64>,
    pub(super) gmcc: Option<f64>,
    pub(super) tracking_error_deg: Option<TrackingError>,
}

/// Where in the plan the motion proper lies.
#[derive(Clone, Copy, Debug)]
pub(super) struct MotionPart {
    /// When it begins, in seconds.
    pub(super) begins_s: f64,
    /// How many times slower than learnt it goes.
    pub(super) stretch: f64,
}

/// Distance of the arm's end from the goal and how well it followed, from a whole run; the
/// correlation compares the measured motion, without the approach, with the learnt path.
pub(super) fn of_completed(
    cycles: &[Cycle],
    part: MotionPart,
    goal_deg: &[f64],
    learnt: &Regression,
) -> Figures {
    let Some(last) = cycles.last() else {
        return Figures::default();
    };
    Figures {
        e_j_deg: Some(e_j_deg(&last.measured_deg, goal_deg)),
        e_j_commanded_deg: Some(e_j_deg(&last.commanded_deg, goal_deg)),
        gmcc: correlation(cycles, part, learnt),
        tracking_error_deg: tracking(cycles),
    }
}

/// How well the arm followed until a run broke off.
pub(super) fn of_broken(cycles: &[Cycle]) -> Figures {
    Figures {
        tracking_error_deg: tracking(cycles),
        ..Figures::default()
    }
}

fn tracking(cycles: &[Cycle]) -> Option<TrackingError> {
    let errors = cycles.iter().flat_map(|cycle| {
        cycle
            .commanded_deg
            .iter()
            .zip(cycle.measured_deg)
            .map(|(commanded, measured)| (commanded - measured).abs())
    });
    let (count, sum, max) = errors.fold((0_u32, 0.0, 0.0), |(count, sum, max), error| {
        (count + 1, sum + error, f64::max(max, error))
    });
    (count > 0).then(|| TrackingError {
        mean: sum / f64::from(count),
        max,
    })
}

/// The measured motion, sampled at the learnt path's own times, correlated with it. What the arm
/// does after these, to come to rest at the goal, has nothing to be compared with.
fn correlation(cycles: &[Cycle], part: MotionPart, learnt: &Regression) -> Option<f64> {
    let motion: Vec<&Cycle> = cycles
        .iter()
        .filter(|cycle| cycle.plan_t_s >= part.begins_s)
        .collect();
    if motion.len() < 2 || learnt.t_s.len() < 2 || learnt.mean_deg.width() != 6 {
        return None;
    }
    let mut next = 0;
    let rows = learnt.t_s.iter().map(|t_s| {
        let t_s = part.begins_s + part.stretch * t_s;
        while next + 2 < motion.len() && motion[next + 1].plan_t_s <= t_s {
            next += 1;
        }
        between(motion[next], motion[next + 1], t_s)
    });
    let measured = Path::from_rows(6, rows);
    let gmcc = gmcc(&measured, &learnt.mean_deg);
    gmcc.is_finite().then_some(gmcc)
}

fn between(before: &Cycle, after: &Cycle, t_s: f64) -> [f64; 6] {
    let length = after.plan_t_s - before.plan_t_s;
    let share = if length > 0.0 {
        ((t_s - before.plan_t_s) / length).clamp(0.0, 1.0)
    } else {
        1.0
    };
    std::array::from_fn(|joint| {
        let (a, b) = (before.measured_deg[joint], after.measured_deg[joint]);
        a + share * (b - a)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Six curves of which none is a sum of the others.
    fn curve(s: f64) -> [f64; 6] {
        std::array::from_fn(|joint| 30.0 * ((joint + 1) as f64 * 1.3 * s + joint as f64).sin())
    }

    /// The learnt motion takes 2 s and is run at half its speed.
    const PART: MotionPart = MotionPart {
        begins_s: 2.0,
        stretch: 2.0,
    };

    fn run(lag: f64) -> Vec<Cycle> {
        (0..=2500)
            .map(|i| {
                let plan_t_s = 0.004 * f64::from(i);
                let share = ((plan_t_s - PART.begins_s) / 4.0).clamp(0.0, 1.0);
                Cycle {
                    at_us: 4_000 * i as u64,
                    plan_t_s,
                    commanded_deg: curve(share),
                    measured_deg: curve(share).map(|angle| angle + lag),
                }
            })
            .collect()
    }

    fn learnt() -> Regression {
        let shares: Vec<f64> = (0..=200).map(|i| f64::from(i) / 200.0).collect();
        Regression {
            t_s: shares.iter().map(|share| 2.0 * share).collect(),
            mean_deg: Path::from_rows(6, shares.iter().map(|share| curve(*share))),
            covariance_deg2: Path::from_rows(36, shares.iter().map(|_| [0.0; 36])),
        }
    }

    #[test]
    fn a_run_along_the_learnt_path_correlates_with_it_and_ends_at_the_goal() {
        let figures = of_completed(&run(0.0), PART, &curve(1.0), &learnt());
        assert!((figures.gmcc.unwrap() - 1.0).abs() < 1e-6);
        assert!(figures.e_j_deg.unwrap() < 1e-9);
        assert!(figures.tracking_error_deg.unwrap().max < 1e-9);
    }

    #[test]
    fn the_measured_end_counts_and_not_the_commanded_one() {
        let figures = of_completed(&run(0.25), PART, &curve(1.0), &learnt());
        assert!((figures.e_j_deg.unwrap() - 0.25).abs() < 1e-9);
        assert!(figures.e_j_commanded_deg.unwrap() < 1e-9);
        let tracking = figures.tracking_error_deg.unwrap();
        assert!((tracking.mean - 0.25).abs() < 1e-9);
        assert!((tracking.max - 0.25).abs() < 1e-9);
    }

    #[test]
    fn a_run_that_broke_off_has_no_end_error() {
        let figures = of_broken(&run(0.1)[..100]);
        assert_eq!((figures.e_j_deg, figures.gmcc), (None, None));
        assert!((figures.tracking_error_deg.unwrap().mean - 0.1).abs() < 1e-9);
        assert_eq!(of_broken(&[]), Figures::default());
    }
}
