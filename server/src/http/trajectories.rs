//! Columns of numbers for plots: thinned out, joint by joint.

use motion::{JointAngles, kinematics};
use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};

use super::error::ApiError;
use super::signals::{RunSignalMark, SignalMark};
use crate::store::cycles::Cycle;
use crate::store::samples::Sample;
use crate::trimming::Recording;

/// How many points a plot wants at most.
#[derive(Debug, Deserialize, IntoParams)]
pub struct MaxPoints {
    /// From 2 to 20000.
    max_points: Option<usize>,
}

impl MaxPoints {
    /// The number, or `default`.
    ///
    /// # Errors
    /// 422 when it is out of range.
    pub fn points(&self, default: usize) -> Result<usize, ApiError> {
        match self.max_points {
            None => Ok(default),
            Some(points @ 2..=20_000) => Ok(points),
            Some(_) => Err(ApiError::unprocessable(
                "out_of_range",
                "max_points",
                "max_points must be from 2 to 20000.",
            )),
        }
    }
}

/// What was recorded.
#[derive(Debug, Serialize, ToSchema)]
pub struct Trajectory {
    /// Times in seconds since the recording began.
    t_s: Vec<f64>,
    /// For each joint, its angle at these times in degrees.
    joints_deg: Vec<Vec<f64>>,
    /// For x, y and z, the tool's position at these times in millimetres.
    tcp_mm: Vec<Vec<f64>>,
    /// Stretches without samples.
    gaps: Vec<GapAnswer>,
    /// Where the recording was held up.
    pauses: Vec<PauseMark>,
    /// What was done with signals.
    signals: Vec<SignalMark>,
}

/// A place where a recording was held up; its time is closed up.
#[derive(Debug, Serialize, ToSchema)]
pub struct PauseMark {
    /// Where, in seconds since the recording began.
    at_s: f64,
    /// How long it was, in seconds; nothing when the recording ended in it.
    length_s: Option<f64>,
}

/// A stretch without samples.
#[derive(Debug, Serialize, ToSchema)]
pub struct GapAnswer {
    /// Where it begins, in seconds since the recording began.
    at_s: f64,
    /// How long it is, in seconds.
    length_s: f64,
}

/// What was commanded and what was measured.
#[derive(Debug, Serialize, ToSchema)]
pub struct RunTrajectory {
    /// Times in seconds since the arm was started.
    t_s: Vec<f64>,
    /// For each joint, the angle asked for in degrees.
    commanded_deg: Vec<Vec<f64>>,
    /// For each joint, the angle that the controller reported in degrees.
    measured_deg: Vec<Vec<f64>>,
    /// The signals that were set on the way.
    signals: Vec<RunSignalMark>,
}

impl RunTrajectory {
    /// The same with the signals that were set.
    pub fn with_signals(self, signals: Vec<RunSignalMark>) -> Self {
        Self { signals, ..self }
    }
}

/// The learnt motion.
#[derive(Debug, Serialize, ToSchema)]
pub struct Curve {
    /// Times in seconds since the motion begins.
    t_s: Vec<f64>,
    /// For each joint, the mean of what was shown in degrees.
    mean_deg: Vec<Vec<f64>>,
    /// For each joint, how far the takes lie apart in degrees.
    std_deg: Vec<Vec<f64>>,
}

/// A demonstration's columns.
pub fn trajectory_of(recorded: Recording, max_points: usize) -> Trajectory {
    let samples = &recorded.samples;
    let picked: Vec<&Sample> = picks(samples.len(), max_points)
        .map(|i| &samples[i])
        .collect();
    let tool = picked.iter().map(|sample| {
        let joints = JointAngles(sample.joints_deg);
        sample
            .tcp_mm
            .unwrap_or_else(|| kinematics::tool0(&joints).position.0)
    });
    Trajectory {
        t_s: picked.iter().map(|sample| seconds(sample.at_us)).collect(),
        joints_deg: columns(picked.iter().map(|sample| sample.joints_deg)),
        tcp_mm: columns(tool),
        gaps: recorded
            .gaps
            .iter()
            .map(|gap| GapAnswer {
                at_s: seconds(gap.at_us),
                length_s: seconds(gap.length_us),
            })
            .collect(),
        pauses: recorded
            .pauses
            .iter()
            .map(|pause| PauseMark {
                at_s: seconds(pause.at_us),
                length_s: pause.length_us.map(seconds),
            })
            .collect(),
        signals: SignalMark::all(recorded.signals),
    }
}

/// A reproduction's columns, from the cycles that were picked.
pub fn run_trajectory_of(picked: &[Cycle]) -> RunTrajectory {
    RunTrajectory {
        t_s: picked.iter().map(|cycle| seconds(cycle.at_us)).collect(),
        commanded_deg: columns(picked.iter().map(|cycle| cycle.commanded_deg)),
        measured_deg: columns(picked.iter().map(|cycle| cycle.measured_deg)),
        signals: Vec::new(),
    }
}

/// A model's columns.
pub fn curve_of(model: &learning::Model, max_points: usize) -> Curve {
    let regression = model.regression();
    let std_deg = regression.std_deg();
    let picked: Vec<usize> = picks(regression.t_s.len(), max_points).collect();
    let pick = |path: &learning::Path| {
        (0..path.width())
            .map(|joint| picked.iter().map(|row| path.row(*row)[joint]).collect())
            .collect()
    };
    Curve {
        t_s: picked.iter().map(|row| regression.t_s[*row]).collect(),
        mean_deg: pick(&regression.mean_deg),
        std_deg: pick(&std_deg),
    }
}

/// A plan's columns: times, joints and the tool's position.
pub fn plan_columns(
    plan: &motion::plan::Plan,
    max_points: usize,
) -> (Vec<f64>, Vec<Vec<f64>>, Vec<Vec<f64>>) {
    let samples = plan.samples();
    let picked: Vec<usize> = picks(samples.len(), max_points).collect();
    let joints = picked.iter().map(|i| samples[*i].joints);
    (
        picked.iter().map(|i| plan.period_s() * *i as f64).collect(),
        columns(joints.clone().map(|joints| joints.0)),
        columns(joints.map(|joints| kinematics::tool0(&joints).position.0)),
    )
}

/// Evenly spread indices of `len` things, at most `max_points`, the first and the last included.
pub(super) fn picks(len: usize, max_points: usize) -> impl Iterator<Item = usize> + Clone {
    let points = len.min(max_points.max(2));
    let intervals = points.saturating_sub(1).max(1);
    (0..points).map(move |i| (i * (len - 1) + intervals / 2) / intervals)
}

pub(super) fn columns<const N: usize>(
    rows: impl Iterator<Item = [f64; N]> + Clone,
) -> Vec<Vec<f64>> {
    (0..N)
        .map(|column| rows.clone().map(|row| row[column]).collect())
        .collect()
}

pub(super) fn seconds(us: u64) -> f64 {
    us as f64 / 1e6
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::store::recordings::Gap;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn picks_keep_both_ends_and_their_order(len in 1usize..5_000, max in 2usize..400) {
            let picked: Vec<usize> = picks(len, max).collect();
            prop_assert_eq!(picked.len(), len.min(max));
            prop_assert_eq!((picked[0], picked[picked.len() - 1]), (0, len - 1));
            prop_assert!(picked.windows(2).all(|pair| pair[0] < pair[1]));
        }
    }

    #[test]
    fn nothing_recorded_is_empty_columns() {
        let empty = trajectory_of(Recording::default(), 300);
        assert_eq!(
            (empty.t_s.len(), empty.joints_deg.len(), empty.tcp_mm.len()),
            (0, 6, 3)
        );
    }

    #[test]
    fn joints_come_as_columns_with_the_tool_beside() {
        let samples: Vec<Sample> = (0..100_u32)
            .map(|i| Sample {
                at_us: 10_000 * u64::from(i),
                joints_deg: [f64::from(i), 1.0, 2.0, 3.0, 4.0, 5.0],
                tcp_mm: None,
            })
            .collect();
        let gap = Gap {
            at_us: 500_000,
            length_us: 20_000,
        };
        let recorded = Recording {
            samples,
            gaps: vec![gap],
            ..Recording::default()
        };
        let answer = trajectory_of(recorded, 10);
        assert_eq!(
            answer.t_s,
            [0.0, 0.11, 0.22, 0.33, 0.44, 0.55, 0.66, 0.77, 0.88, 0.99]
        );
        assert_eq!(answer.joints_deg[0][9], 99.0);
        assert!(answer.joints_deg[5].iter().all(|angle| *angle == 5.0));
        assert!((answer.gaps[0].length_s - 0.02).abs() < 1e-12);
        let reach = |i: usize| answer.tcp_mm[0][i].hypot(answer.tcp_mm[1][i]);
        assert!(
            (reach(0) - reach(9)).abs() < 1e-6,
            "joint 1 turns the tool about the base"
        );
    }
}
