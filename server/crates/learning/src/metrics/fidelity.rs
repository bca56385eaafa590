//! Path fidelity: how far the reproduced tool path is from the demonstrated ones,
//! in millimetres, without any alignment in time.

use serde::{Deserialize, Serialize};

use super::Kinetics;
use crate::{
    Demonstration,
    demonstration::tool_path_mm,
    nearest::Curve,
    path::{Path, squared_distance},
};

/// Distances between tool paths, mm. d(p, C) is the distance of a point to the
/// nearest sample of a curve.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fidelity {
    /// d(demonstrated point, reproduction): mean of the demonstrations' means.
    pub missed_mean_mm: f64,
    /// The largest of them.
    pub missed_max_mm: f64,
    /// Over the reproduction's points, the distance to the nearest demonstration: mean.
    pub off_path_mean_mm: f64,
    /// The largest of them.
    pub off_path_max_mm: f64,
    /// The same as `missed` between the demonstrations; none with one demonstration.
    pub mutual_mean_mm: Option<f64>,
    /// The largest of them.
    pub mutual_max_mm: Option<f64>,
    /// `missed_mean_mm / mutual_mean_mm`: below 1 the path runs inside the bundle.
    pub missed_over_mutual: Option<f64>,
    /// Distance of the reproduction's first point to each demonstration's first.
    pub start_mm: Vec<f64>,
    /// Distance of the reproduction's last point to each demonstration's last.
    pub end_mm: Vec<f64>,
    /// Largest distance between two demonstrations' first points.
    pub start_spread_mm: f64,
    /// Largest distance between two demonstrations' last points.
    pub end_spread_mm: f64,
    /// Peaks of the reproduction.
    pub reproduction: Kinetics,
    /// Peaks over the demonstrations, smoothed alike.
    pub demonstrations: Kinetics,
    /// Duration of the reproduction, seconds.
    pub duration_s: f64,
    /// Mean duration of the demonstrations without idle ends, seconds.
    pub demonstrated_duration_s: f64,
}

/// Compares a reproduction (rows `dt_s` apart) with the demonstrations. None
/// unless they are six-joint paths, whose tool positions are known.
pub fn fidelity(
    demonstrations: &[Demonstration],
    reproduction_deg: &Path,
    dt_s: f64,
) -> Option<Fidelity> {
    let path = Tool::path(&tool_path_mm(reproduction_deg)?);
    let shown: Vec<Tool> = demonstrations
        .iter()
        .map(|d| Some(Tool::path(&d.tool_path_mm()?)))
        .collect::<Option<_>>()?;
    let missed: Vec<(f64, f64)> = shown.iter().map(|d| mean_and_max(d, &path)).collect();
    let mut off = vec![f64::INFINITY; path.points.len()];
    for tool in &shown {
        for (off, distance) in off.iter_mut().zip(tool.curve.distances(&path.points)) {
            *off = off.min(distance);
        }
    }
    let mutual = mutual(&shown);
    let missed_mean_mm = mean(missed.iter().map(|m| m.0));
    let ends = |pick: fn(&Path) -> &[f64]| -> (Vec<f64>, f64) {
        let points: Vec<&[f64]> = shown.iter().map(|d| pick(&d.points)).collect();
        let reached = pick(&path.points);
        let from_path = points
            .iter()
            .map(|p| squared_distance(p, reached).sqrt())
            .collect();
        let spread = points
            .iter()
            .flat_map(|p| points.iter().map(move |q| squared_distance(p, q).sqrt()))
            .fold(0.0, f64::max);
        (from_path, spread)
    };
    let (start_mm, start_spread_mm) = ends(|d| d.row(0));
    let (end_mm, end_spread_mm) = ends(Path::last);
    Some(Fidelity {
        missed_mean_mm,
        missed_max_mm: missed.iter().map(|m| m.1).fold(0.0, f64::max),
        off_path_mean_mm: mean(off.iter().copied()),
        off_path_max_mm: off.iter().copied().fold(0.0, f64::max),
        mutual_mean_mm: mutual.map(|m| m.0),
        mutual_max_mm: mutual.map(|m| m.1),
        missed_over_mutual: mutual.filter(|m| m.0 > 0.0).map(|m| missed_mean_mm / m.0),
        start_mm,
        end_mm,
        start_spread_mm,
        end_spread_mm,
        reproduction: Kinetics::of_path(reproduction_deg, dt_s),
        demonstrations: Kinetics::of_all(demonstrations),
        duration_s: (reproduction_deg.len() - 1) as f64 * dt_s,
        demonstrated_duration_s: mean(demonstrations.iter().map(active_duration_s)),
    })
}

/// Mean distance of the demonstrated points to a path of the joints (mean of the
/// demonstrations' means), mm. None unless all are six-joint paths.
pub fn missed_mean_mm(demonstrations: &[Demonstration], path_deg: &Path) -> Option<f64> {
    let path = Tool::path(&tool_path_mm(path_deg)?);
    let missed = demonstrations
        .iter()
        .map(|d| Some(mean_and_max(&Tool::path(&d.tool_path_mm()?), &path).0))
        .collect::<Option<Vec<f64>>>()?;
    Some(mean(missed.into_iter()))
}

/// For each demonstration the mean of d(p, this one) over the points of the
/// others; the mean of these, and the overall maximum.
fn mutual(shown: &[Tool]) -> Option<(f64, f64)> {
    if shown.len() < 2 {
        return None;
    }
    let (mut means, mut max) = (Vec::new(), 0.0);
    for (i, curve) in shown.iter().enumerate() {
        let (mut sum, mut count) = (0.0, 0usize);
        for (j, other) in shown.iter().enumerate() {
            if i != j {
                let (other_mean, other_max) = mean_and_max(other, curve);
                sum += other_mean * other.points.len() as f64;
                count += other.points.len();
                max = f64::max(max, other_max);
            }
        }
        means.push(sum / count as f64);
    }
    Some((mean(means.into_iter()), max))
}

fn mean_and_max(points: &Tool, curve: &Tool) -> (f64, f64) {
    let distances = curve.curve.distances(&points.points);
    let max = distances.iter().copied().fold(0.0, f64::max);
    (mean(distances.into_iter()), max)
}

/// A path of the tool, prepared for asking how far others are from it.
struct Tool {
    points: Path,
    curve: Curve,
}

impl Tool {
    fn path(positions_mm: &[[f64; 3]]) -> Tool {
        let points = Path::from_rows(3, positions_mm);
        Tool {
            curve: Curve::new(&points),
            points,
        }
    }
}

fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let n = values.len() as f64;
    values.sum::<f64>() / n
}

/// Duration without the time in which the arm still stands at the start or
/// already at the end, seconds.
fn active_duration_s(demonstration: &Demonstration) -> f64 {
    let (moving, times) = (demonstration.moving(), demonstration.times_s());
    times[*moving.end()] - times[*moving.start()]
}
