//! Motions made for these tests, from minimum-jerk reaches of single joints, and
//! what is measured on a path.

use learning::{
    Demonstration, Path,
    dmp::{self, MovementPrimitive},
};
use motion::minimum_jerk;
use proptest::prelude::*;

pub const DT_S: f64 = 0.01;

/// One reach of one joint, from rest to rest. Times are shares of the motion's.
#[derive(Clone, Debug)]
pub struct Reach {
    pub begin: f64,
    pub lasts: f64,
    pub by_deg: f64,
}

/// Joints that reach; all are at rest at both ends.
#[derive(Clone, Debug)]
pub struct Motion {
    pub duration_s: f64,
    pub start_deg: Vec<f64>,
    /// Reaches of each joint.
    pub joints: Vec<Vec<Reach>>,
}

impl Motion {
    /// The joints at a share of the time.
    pub fn at(&self, share: f64) -> Vec<f64> {
        let of = |reaches: &Vec<Reach>| {
            let way = |r: &Reach| r.by_deg * minimum_jerk::share((share - r.begin) / r.lasts);
            reaches.iter().map(way).sum::<f64>()
        };
        let moved = self.joints.iter().map(of);
        self.start_deg
            .iter()
            .zip(moved)
            .map(|(q, by)| q + by)
            .collect()
    }

    pub fn path(&self) -> Path {
        let steps = (self.duration_s / DT_S).round() as usize;
        Path::from_rows(
            self.joints.len(),
            (0..=steps).map(|i| self.at(i as f64 / steps as f64)),
        )
    }

    /// A primitive that imitates it over its whole time, as the faithful method does.
    pub fn primitive(&self, alpha_z: f64, n_basis: usize) -> MovementPrimitive {
        let floor = dmp::SMALLEST_FLOOR;
        dmp::imitate(&self.path(), DT_S, self.duration_s, alpha_z, n_basis, floor)
    }

    /// A take of it: at a pace of its own, off by `sway_deg` in the middle.
    pub fn take(&self, pace: f64, sway_deg: f64) -> Demonstration {
        let samples = (self.duration_s * 50.0).round() as usize;
        let (mut times, mut rows) = (Vec::new(), Vec::new());
        for i in 0..=samples {
            let share = i as f64 / samples as f64;
            let sway = sway_deg * 4.0 * share * (1.0 - share) * (9.0 * share).sin();
            times.push(share * self.duration_s * pace);
            rows.push(self.at(share).iter().map(|q| q + sway).collect());
        }
        Demonstration::new(format!("at pace {pace}"), times, rows, None).unwrap()
    }
}

/// A joint that swings out by `bow_deg` and comes back to `gap_deg` from where it
/// began, in 6 s.
pub fn bow(bow_deg: f64, gap_deg: f64) -> Motion {
    let reach = |begin: f64, by_deg: f64| Reach {
        begin,
        lasts: 0.4,
        by_deg,
    };
    Motion {
        duration_s: 6.0,
        start_deg: vec![12.0],
        joints: vec![vec![reach(0.1, bow_deg), reach(0.5, gap_deg - bow_deg)]],
    }
}

/// Joints in this order: two that go somewhere, one that ends where it began, one
/// that hardly moves, one that stands still.
pub fn any_motion() -> impl Strategy<Value = Motion> {
    let reach = |most_deg: f64| {
        (0.05..0.5f64, 0.25..0.45f64, -most_deg..most_deg).prop_map(|(begin, lasts, by_deg)| {
            Reach {
                begin,
                lasts,
                by_deg,
            }
        })
    };
    let goes = move || prop::collection::vec(reach(30.0), 1..4);
    let returns = (5.0..30.0f64).prop_map(|by| bow(by, 0.0).joints.remove(0));
    (
        4.0..10.0f64,
        prop::collection::vec(-60.0..60.0f64, 5),
        (goes(), goes(), returns, reach(0.1)),
    )
        .prop_map(|(duration_s, start_deg, (a, b, c, hardly))| Motion {
            duration_s,
            start_deg,
            joints: vec![a, b, c, vec![hardly], Vec::new()],
        })
}

/// Largest magnitude of the `order`-th difference of column `j`, per second to the
/// power of `order`. The arm rests before the path begins.
pub fn peak(path: &Path, j: usize, order: u32) -> f64 {
    let mut values = path.column(j);
    values.splice(0..0, std::iter::repeat_n(values[0], order as usize));
    for _ in 0..order {
        values = values.windows(2).map(|w| (w[1] - w[0]) / DT_S).collect();
    }
    values.iter().fold(0.0, |most, v| f64::max(most, v.abs()))
}

/// Largest difference of two paths, over the rows that both have.
pub fn apart(a: &Path, b: &Path) -> f64 {
    let rows = a.rows().zip(b.rows());
    rows.flat_map(|(a, b)| a.iter().zip(b).map(|(x, y)| (x - y).abs()))
        .fold(0.0, f64::max)
}

/// Largest travel of a joint from where it begins.
pub fn amplitude(path: &Path, j: usize) -> f64 {
    let values = path.column(j);
    values
        .iter()
        .fold(0.0, |most, v| f64::max(most, (v - values[0]).abs()))
}

pub fn plus(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + b).collect()
}
