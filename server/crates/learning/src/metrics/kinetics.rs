//! Peaks of speed, acceleration and jerk, smoothed as a derivative of recorded angles
//! needs it.

use motion::filter::savitzky_golay;
use serde::{Deserialize, Serialize};

use crate::{Demonstration, path::Path, timeline::interpolate};

/// Half window of the smoothing before derivatives are taken, at 10 ms.
const SMOOTHING_HALF: usize = 10;
const GRID_S: f64 = 0.01;

/// Largest rates over all joints.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Kinetics {
    /// Speed, deg/s.
    pub peak_speed_deg_s: f64,
    /// Acceleration, deg/s².
    pub peak_acceleration_deg_s2: f64,
    /// Jerk, deg/s³.
    pub peak_jerk_deg_s3: f64,
}

/// The path on a grid of 10 ms, linear between samples.
fn on_grid(times_s: &[f64], joints_deg: &Path) -> Path {
    let (first, last) = (times_s[0], times_s[times_s.len() - 1]);
    let count = ((last - first) / GRID_S) as usize + 1;
    let grid: Vec<f64> = (0..count).map(|i| first + i as f64 * GRID_S).collect();
    interpolate(times_s, joints_deg, &grid)
}

impl Kinetics {
    /// Of a path with rows `dt_s` apart.
    pub fn of_path(path_deg: &Path, dt_s: f64) -> Kinetics {
        let times: Vec<f64> = (0..path_deg.len()).map(|i| i as f64 * dt_s).collect();
        kinetics(&on_grid(&times, path_deg))
    }

    /// The largest of all demonstrations.
    pub fn of_all(demonstrations: &[Demonstration]) -> Kinetics {
        let mut all = Kinetics::default();
        for demonstration in demonstrations {
            let grid = on_grid(demonstration.times_s(), demonstration.joints_deg());
            all.widen(&kinetics(&grid));
        }
        all
    }

    fn widen(&mut self, other: &Kinetics) {
        self.peak_speed_deg_s = self.peak_speed_deg_s.max(other.peak_speed_deg_s);
        self.peak_acceleration_deg_s2 = self
            .peak_acceleration_deg_s2
            .max(other.peak_acceleration_deg_s2);
        self.peak_jerk_deg_s3 = self.peak_jerk_deg_s3.max(other.peak_jerk_deg_s3);
    }
}

fn kinetics(grid: &Path) -> Kinetics {
    let peak = |signal: &[f64]| signal.iter().map(|v| v.abs()).fold(0.0, f64::max);
    let derive = |signal: &[f64]| -> Vec<f64> {
        savitzky_golay(signal, SMOOTHING_HALF, true)
            .iter()
            .map(|v| v / GRID_S)
            .collect()
    };
    let mut all = Kinetics::default();
    for j in 0..grid.width() {
        let speed = derive(&grid.column(j));
        let acceleration = derive(&speed);
        let jerk = derive(&acceleration);
        all.widen(&Kinetics {
            peak_speed_deg_s: peak(&speed),
            peak_acceleration_deg_s2: peak(&acceleration),
            peak_jerk_deg_s3: peak(&jerk),
        });
    }
    all
}
