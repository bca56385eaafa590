//! How well the demonstrations of a task agree, where one of them does not, and
//! whether it is worth recording another: in figures and in words.

use serde::{Deserialize, Serialize};

use crate::{
    Demonstration, Path,
    alignment::{Aligned, barycentre::mean_of},
    demonstration::tool_path_mm,
    statistics::median,
};

/// A take differs when it is this many times further from the others than they
/// typically are, ...
const DIFFERS_RATIO: f64 = 2.0;
/// ... and at least this far: less is the unsteadiness of a hand.
const DIFFERS_MM: f64 = 10.0;
const DIFFERS_DEG: f64 = 3.0;
/// The mean path is known well enough when its standard error is at most this.
const ENOUGH_MM: f64 = 15.0;
const ENOUGH_DEG: f64 = 4.0;
/// Fewer takes than this are never enough.
const LEAST_TAKES: usize = 3;

/// The agreement of all demonstrations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Agreement {
    /// Each demonstration against the mean of the others, in the order given.
    pub takes: Vec<TakeAgreement>,
    /// Whether another take would hardly change the motion.
    pub enough: bool,
    /// What to do, in a worker's words.
    pub advice: String,
}

/// One demonstration against the mean of the others. With a single demonstration
/// there are no others, and it agrees with itself.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TakeAgreement {
    /// Name of the demonstration.
    pub name: String,
    /// Mean distance of the tool at the same phase, mm; none unless six joints.
    pub off_mm: Option<f64>,
    /// Root mean square of the joints' distance (vector), degrees.
    pub off_deg: f64,
    /// Where it differs most.
    pub worst: Place,
    /// Whether it clearly differs from the others.
    pub differs: bool,
}

/// A place on the motion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Place {
    /// Share of the motion's time, 0 to 1.
    pub phase: f64,
    /// Joint, from 1.
    pub joint: usize,
    /// By how much the joint is off there, degrees.
    pub off_deg: f64,
}

/// Compares each aligned demonstration with the mean of the others.
pub fn agreement(demonstrations: &[Demonstration], aligned: &Aligned) -> Agreement {
    let m = demonstrations.len();
    let mut takes: Vec<TakeAgreement> = (0..m)
        .map(|i| {
            let others: Vec<Path> = (0..m)
                .filter(|&j| j != i || m == 1)
                .map(|j| aligned.joints_deg[j].clone())
                .collect();
            compare(
                demonstrations[i].name(),
                &aligned.joints_deg[i],
                &mean_of(&others),
            )
        })
        .collect();
    let sizes: Vec<f64> = takes.iter().map(size).collect();
    for (i, take) in takes.iter_mut().enumerate() {
        let mut others = sizes.clone();
        others.remove(i);
        let typical = median(&others);
        let least = if take.off_mm.is_some() {
            DIFFERS_MM
        } else {
            DIFFERS_DEG
        };
        take.differs = m >= LEAST_TAKES && sizes[i] > least && sizes[i] > DIFFERS_RATIO * typical;
    }
    let enough = m >= LEAST_TAKES
        && takes.iter().all(|take| !take.differs)
        && standard_error(&sizes)
            <= if takes[0].off_mm.is_some() {
                ENOUGH_MM
            } else {
                ENOUGH_DEG
            };
    Agreement {
        advice: advice(&takes, enough),
        takes,
        enough,
    }
}

/// What is compared: the tool where it is known, else the joints.
fn size(take: &TakeAgreement) -> f64 {
    take.off_mm.unwrap_or(take.off_deg)
}

/// Standard error of the mean of all, from the distances to the mean of the others:
/// these have the variance of one take plus that of a mean of m - 1.
fn standard_error(sizes: &[f64]) -> f64 {
    let m = sizes.len() as f64;
    let mean_square = sizes.iter().map(|s| s * s).sum::<f64>() / m;
    (mean_square * (m - 1.0) / m).sqrt() / m.sqrt()
}

fn compare(name: &str, own: &Path, mean: &Path) -> TakeAgreement {
    let n = own.len();
    let mut worst = Place {
        phase: 0.0,
        joint: 1,
        off_deg: 0.0,
    };
    let mut squares = 0.0;
    for (i, (row, other)) in own.rows().zip(mean.rows()).enumerate() {
        for (j, (q, p)) in row.iter().zip(other).enumerate() {
            let off_deg = q - p;
            squares += off_deg * off_deg;
            if off_deg.abs() > worst.off_deg.abs() {
                worst = Place {
                    phase: i as f64 / (n - 1).max(1) as f64,
                    joint: j + 1,
                    off_deg,
                };
            }
        }
    }
    let off_mm = tool_path_mm(own).zip(tool_path_mm(mean)).map(|(a, b)| {
        let distance =
            |p: &[f64; 3], q: &[f64; 3]| (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt();
        a.iter().zip(&b).map(|(p, q)| distance(p, q)).sum::<f64>() / n as f64
    });
    TakeAgreement {
        name: name.to_string(),
        off_mm,
        off_deg: (squares / n as f64).sqrt(),
        worst,
        differs: false,
    }
}

fn advice(takes: &[TakeAgreement], enough: bool) -> String {
    if enough {
        return "The takes agree: that's enough.".into();
    }
    if let Some(take) = takes.iter().find(|take| take.differs) {
        return format!(
            "{} differs from the others, most at joint {} about {:.0} % of the way. Discard it or record one more.",
            take.name,
            take.worst.joint,
            100.0 * take.worst.phase
        );
    }
    match takes.len() {
        1 => "Record two more takes: from one alone nobody can tell what matters.".into(),
        2 => "Record one more take.".into(),
        _ => {
            let farthest = takes
                .iter()
                .max_by(|a, b| size(a).total_cmp(&size(b)))
                .unwrap_or(&takes[0]);
            format!(
                "The takes differ from each other, most {} at joint {} about {:.0} % of the way. Record one more.",
                farthest.name,
                farthest.worst.joint,
                100.0 * farthest.worst.phase
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::alignment::barycentre::align_to_mean;

    /// Joint 1 turns by 40 deg; joint 5 nods by `nod_deg` in the middle.
    fn take(name: &str, nod_deg: f64) -> Demonstration {
        let times: Vec<f64> = (0..201).map(|i| 0.02 * f64::from(i)).collect();
        let joints = times
            .iter()
            .map(|t| {
                let u = t / 4.0;
                let nod = nod_deg * (-((u - 0.5) / 0.1).powi(2)).exp();
                vec![40.0 * u, 10.0, 20.0, 0.0, -45.0 + nod, 0.0]
            })
            .collect();
        Demonstration::new(name.into(), times, joints, None).unwrap()
    }

    fn of(takes: &[Demonstration]) -> Agreement {
        agreement(
            takes,
            &align_to_mean(takes, 100.0, &mut |_, _| Ok(())).unwrap(),
        )
    }

    #[test]
    fn takes_that_agree_are_enough_from_three_on() {
        let takes = [take("a", 0.0), take("b", 0.5), take("c", -0.5)];
        assert!(of(&takes).enough);
        assert!(!of(&takes[..2]).enough);
        assert!(of(&takes[..1]).advice.contains("two more"));
    }

    #[test]
    fn the_take_that_differs_is_named_with_joint_and_place() {
        let takes = [
            take("a", 0.0),
            take("b", 0.5),
            take("odd", 30.0),
            take("c", -0.5),
        ];
        let agreement = of(&takes);
        assert!(!agreement.enough);
        let odd = &agreement.takes[2];
        assert!(odd.differs && agreement.takes.iter().filter(|t| t.differs).count() == 1);
        assert_eq!(odd.worst.joint, 5);
        assert!((odd.worst.phase - 0.5).abs() < 0.1, "{}", odd.worst.phase);
        assert!((odd.worst.off_deg - 30.0).abs() < 3.0);
        assert!(
            agreement.advice.starts_with("odd differs"),
            "{}",
            agreement.advice
        );
    }

    /// Three numbers 0, 3 and 6 about their mean 3 have a variance of 9, so the mean
    /// has a standard error of sqrt(9 / 3); from the means of the others they are
    /// 4.5, 0 and 4.5 away.
    #[test]
    fn the_standard_error_is_that_of_the_mean() {
        assert!((standard_error(&[4.5, 0.0, 4.5]) - 3f64.sqrt()).abs() < 1e-12);
    }
}
