//! What a motion that the arm made is worth: end error, correlation with what was learnt, and
//! how well the arm followed. Pure.

use learning::Path;
use learning::metrics::{e_j_deg, gmcc};
use learning::regression::Regression;

use crate::store::cycles::Cycle;
use crate::store::flights::CycleCounts;
use crate::store::reproductions::TrackingError;

/// The figures of one run. What can't be computed from a run that broke off is missing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Figures {
    pub(super) e_j_deg: Option<f64>,
    pub(super) e_j_commanded_deg: Option<f64>,
    pub(super) gmcc: Option<f64>,
    pub(super) tracking_error_deg: Option<TrackingError>,
    pub(super) cycles: Option<CycleCounts>,
}

/// Where in the plan the motion proper lies.
#[derive(Clone, Copy, Debug)]
pub(super) struct MotionPart {
    /// When it begins, in seconds.
    pub(super) begins_s: f64,
    /// How many times slower than learnt it goes.
    pub(super) stretch: f64,
}

/// Adds up a record cycle by cycle, so that a long one need not be in memory.
#[derive(Default)]
pub(super) struct Measure {
    sum: [f64; 6],
    squares: [f64; 6],
    largest: [f64; 6],
    counts: CycleCounts,
    last: Option<Cycle>,
    motion: Option<Resampled>,
}

/// The measured motion at the learnt path's own times. What the arm does after these, to come to
/// rest at the goal, has nothing to be compared with.
struct Resampled {
    begins_s: f64,
    /// The times that are wanted, as times within the plan.
    wanted_s: Vec<f64>,
    rows: Vec<[f64; 6]>,
    pair: Option<(Cycle, Cycle)>,
    first: Option<Cycle>,
}

impl Measure {
    /// For a run that went all the way.
    pub(super) fn along(part: MotionPart, learnt: &Regression) -> Self {
        let wanted_s = learnt
            .t_s
            .iter()
            .map(|t_s| part.begins_s + part.stretch * t_s);
        Self {
            motion: Some(Resampled {
                begins_s: part.begins_s,
                wanted_s: wanted_s.collect(),
                rows: Vec::with_capacity(learnt.t_s.len()),
                pair: None,
                first: None,
            }),
            ..Self::default()
        }
    }

    /// The next cycles of the record.
    pub(super) fn add(&mut self, cycles: &[Cycle]) {
        for cycle in cycles {
            for joint in 0..6 {
                let error = (cycle.commanded_deg[joint] - cycle.measured_deg[joint]).abs();
                self.sum[joint] += error;
                self.squares[joint] += error * error;
                self.largest[joint] = self.largest[joint].max(error);
            }
            self.counts.total += 1;
            if let Some(details) = &cycle.details {
                self.counts.lost += u64::from(details.lost);
                self.counts.late += u64::from(details.late);
                self.counts.held += u64::from(details.held);
                self.counts.limited += u64::from(details.limited);
            }
            if let Some(motion) = &mut self.motion {
                motion.add(cycle);
            }
            self.last = Some(*cycle);
        }
    }

    /// Distance of the arm's end from the goal and how well it followed, from a whole run; the
    /// correlation compares the measured motion, without the approach, with the learnt path.
    pub(super) fn completed(mut self, goal_deg: &[f64], learnt: &Regression) -> Figures {
        let motion = self.motion.take();
        let end = |of: fn(&Cycle) -> &[f64; 6]| {
            self.last.as_ref().map(|last| e_j_deg(of(last), goal_deg))
        };
        Figures {
            e_j_deg: end(|last| &last.measured_deg),
            e_j_commanded_deg: end(|last| &last.commanded_deg),
            gmcc: motion.and_then(|motion| motion.correlation(learnt)),
            ..self.broken()
        }
    }

    /// How well the arm followed until a run broke off.
    pub(super) fn broken(&self) -> Figures {
        let Some(_) = self.last else {
            return Figures::default();
        };
        let total = self.counts.total as f64;
        Figures {
            tracking_error_deg: Some(TrackingError {
                mean: self.sum.iter().sum::<f64>() / (6.0 * total),
                max: self.largest.iter().copied().fold(0.0, f64::max),
                max_by_joint: Some(self.largest),
                rms_by_joint: Some(self.squares.map(|sum| (sum / total).sqrt())),
            }),
            cycles: Some(self.counts),
            ..Figures::default()
        }
    }
}

impl Resampled {
    fn add(&mut self, cycle: &Cycle) {
        if cycle.plan_t_s < self.begins_s {
            return;
        }
        let before = self.pair.map(|(_, last)| last).or(self.first);
        let Some(before) = before else {
            self.first = Some(*cycle);
            return;
        };
        self.pair = Some((before, *cycle));
        while let Some(t_s) = self.wanted_s.get(self.rows.len())
            && cycle.plan_t_s > *t_s
        {
            self.rows.push(between(&before, cycle, *t_s));
        }
    }

    fn correlation(mut self, learnt: &Regression) -> Option<f64> {
        let (before, after) = self.pair?;
        if learnt.t_s.len() < 2 || learnt.mean_deg.width() != 6 {
            return None;
        }
        while let Some(t_s) = self.wanted_s.get(self.rows.len()) {
            self.rows.push(between(&before, &after, *t_s));
        }
        let measured = Path::from_rows(6, self.rows);
        let gmcc = gmcc(&measured, &learnt.mean_deg);
        gmcc.is_finite().then_some(gmcc)
    }
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
    use crate::store::cycles::{CycleDetails, CyclePhase};

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
                    details: None,
                }
            })
            .collect()
    }

    /// In pages, as a record is read.
    fn of_completed(cycles: &[Cycle]) -> Figures {
        let mut measure = Measure::along(PART, &learnt());
        cycles.chunks(7).for_each(|page| measure.add(page));
        measure.completed(&curve(1.0), &learnt())
    }

    fn of_broken(cycles: &[Cycle]) -> Figures {
        let mut measure = Measure::default();
        measure.add(cycles);
        measure.broken()
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
        let figures = of_completed(&run(0.0));
        assert!((figures.gmcc.unwrap() - 1.0).abs() < 1e-6);
        assert!(figures.e_j_deg.unwrap() < 1e-9);
        assert!(figures.tracking_error_deg.unwrap().max < 1e-9);
    }

    #[test]
    fn the_measured_end_counts_and_not_the_commanded_one() {
        let figures = of_completed(&run(0.25));
        assert!((figures.e_j_deg.unwrap() - 0.25).abs() < 1e-9);
        assert!(figures.e_j_commanded_deg.unwrap() < 1e-9);
        let tracking = figures.tracking_error_deg.unwrap();
        assert!((tracking.mean - 0.25).abs() < 1e-9);
        assert!((tracking.max - 0.25).abs() < 1e-9);
        let by_joint = [tracking.max_by_joint, tracking.rms_by_joint].map(Option::unwrap);
        assert!(
            by_joint
                .iter()
                .flatten()
                .all(|error| (error - 0.25).abs() < 1e-9)
        );
    }

    #[test]
    fn what_was_out_of_the_ordinary_is_counted_and_one_spike_shows_at_its_joint() {
        let mut cycles = run(0.0);
        let details = CycleDetails {
            commanded_deg_s: [0.0; 6],
            utilization_percent: None,
            lost: 3,
            phase: CyclePhase::Motion,
            late: true,
            held: false,
            limited: true,
            motors_on: true,
            rapid_running: true,
        };
        for at in [10, 20] {
            cycles[at].details = Some(details);
        }
        cycles[30].measured_deg[4] += 2.0;
        let figures = of_broken(&cycles);
        let counts = CycleCounts {
            total: 2501,
            lost: 6,
            late: 2,
            held: 0,
            limited: 2,
        };
        assert_eq!(figures.cycles, Some(counts));
        let tracking = figures.tracking_error_deg.unwrap();
        assert_eq!(tracking.max_by_joint.unwrap()[3], 0.0);
        assert!((tracking.max_by_joint.unwrap()[4] - 2.0).abs() < 1e-9);
        let rms = 2.0 / f64::sqrt(2501.0);
        assert!((tracking.rms_by_joint.unwrap()[4] - rms).abs() < 1e-9);
    }

    #[test]
    fn a_run_that_broke_off_has_no_end_error() {
        let figures = of_broken(&run(0.1)[..100]);
        assert_eq!((figures.e_j_deg, figures.gmcc), (None, None));
        assert!((figures.tracking_error_deg.unwrap().mean - 0.1).abs() < 1e-9);
        assert_eq!(of_broken(&[]), Figures::default());
    }
}
