//! How well the demonstrations of a task agree, where one of them does not, and
//! whether it is worth recording another: in figures and in words.

use serde::{Deserialize, Serialize};

use crate::{
    Demonstration, Error, Path,
    alignment::{
        Aligned,
        barycentre::{align_to_mean, mean_of},
    },
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
/// Rate at which demonstrations are compared that nothing is learned from yet, Hz.
const RATE_HZ: f64 = 50.0;

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

impl Place {
    /// Where on the motion, in a worker's words.
    pub fn words(&self) -> &'static str {
        match self.phase {
            phase if phase < 0.1 => "at the beginning",
            phase if phase < 0.4 => "in the first half",
            phase if phase <= 0.6 => "around the middle",
            phase if phase <= 0.9 => "in the second half",
            _ => "at the end",
        }
    }
}

/// The agreement of demonstrations before any training; of none at all, the advice
/// to begin.
///
/// `step` is called after each warping with (done, total) and may end the work.
/// Errors: [`Error::DifferentJointCounts`], and [`Error::DifferentMotions`] when
/// they do not show the same motion.
pub fn of(
    demonstrations: &[Demonstration],
    step: &mut dyn FnMut(usize, usize) -> Result<(), Error>,
) -> Result<Agreement, Error> {
    let Some(first) = demonstrations.first() else {
        return Ok(Agreement {
            takes: Vec::new(),
            enough: false,
            advice: "Show the motion three times. Record the first take.".into(),
        });
    };
    if let Some(other) = demonstrations
        .iter()
        .find(|demonstration| demonstration.joints() != first.joints())
    {
        return Err(Error::DifferentJointCounts {
            name: other.name().to_string(),
            other: first.name().to_string(),
            expected: first.joints(),
            found: other.joints(),
        });
    }
    let aligned = align_to_mean(demonstrations, RATE_HZ, step)?.aligned;
    Ok(agreement(demonstrations, &aligned))
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
            "{} differs from the others, most {} at joint {}. Discard it or record one more.",
            take.name,
            take.worst.words(),
            take.worst.joint
        );
    }
    match takes.len() {
        1 => "Record one more take, and then a third: from one alone nobody can tell what matters."
            .into(),
        2 => "Record one more take.".into(),
        _ => {
            let farthest = takes
                .iter()
                .max_by(|a, b| size(a).total_cmp(&size(b)))
                .unwrap_or(&takes[0]);
            format!(
                "The takes differ from each other, most {} {} at joint {}. Record one more.",
                farthest.name,
                farthest.worst.words(),
                farthest.worst.joint
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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

    fn compared(takes: &[Demonstration]) -> Agreement {
        of(takes, &mut |_, _| Ok(())).unwrap()
    }

    #[test]
    fn takes_that_agree_are_enough_from_three_on() {
        let takes = [take("a", 0.0), take("b", 0.5), take("c", -0.5)];
        assert!(compared(&takes).enough);
        for fewer in [&takes[..2], &takes[..1]] {
            let agreement = compared(fewer);
            assert!(!agreement.enough);
            assert!(agreement.advice.contains("one more"), "{agreement:?}");
        }
        let none = compared(&[]);
        assert!(!none.enough && none.takes.is_empty());
        assert!(none.advice.contains("first take"), "{none:?}");
    }

    #[test]
    fn another_motion_or_another_arm_is_an_error_and_the_work_can_be_ended() {
        let lifting = |u: f64| vec![5.0, 10.0 + 60.0 * u, 20.0 - 50.0 * u, 0.0, -45.0, 0.0];
        let times: Vec<f64> = (0..201).map(|i| 0.02 * f64::from(i)).collect();
        let joints = times.iter().map(|t| lifting(t / 4.0)).collect();
        let lift = Demonstration::new("lift".into(), times.clone(), joints, None).unwrap();
        let swings = [take("a", 0.0), take("b", 0.5)];
        let mixed = [swings[0].clone(), swings[1].clone(), lift];
        assert_eq!(
            of(&mixed, &mut |_, _| Ok(())),
            Err(Error::DifferentMotions {
                groups: [vec!["a".into(), "b".into()], vec!["lift".into()]],
            })
        );
        let single = times.iter().map(|t| vec![*t]).collect();
        let single = Demonstration::new("single".into(), times, single, None).unwrap();
        assert!(matches!(
            of(&[swings[0].clone(), single], &mut |_, _| Ok(())),
            Err(Error::DifferentJointCounts { .. })
        ));
        let ended = of(&swings, &mut |_, _| Err(Error::Cancelled));
        assert_eq!(ended, Err(Error::Cancelled));
    }

    #[test]
    fn the_take_that_differs_is_named_with_joint_and_place() {
        let takes = [
            take("a", 0.0),
            take("b", 0.5),
            take("odd", 30.0),
            take("c", -0.5),
        ];
        let agreement = compared(&takes);
        assert!(!agreement.enough);
        let odd = &agreement.takes[2];
        assert!(odd.differs && agreement.takes.iter().filter(|t| t.differs).count() == 1);
        assert_eq!(odd.worst.joint, 5);
        assert!((odd.worst.phase - 0.5).abs() < 0.1, "{}", odd.worst.phase);
        assert!((odd.worst.off_deg - 30.0).abs() < 3.0);
        assert!(
            agreement.advice.starts_with("odd differs")
                && agreement.advice.contains("around the middle at joint 5"),
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
