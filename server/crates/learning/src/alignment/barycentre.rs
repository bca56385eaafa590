//! Alignment without a favourite: all demonstrations are warped to their common
//! mean, which is found by warping and averaging in turns (a DTW barycentre).
//!
//! Idle time at both ends is left out. Tool and joints together decide what
//! matches what, each in units of its own spread. The mean runs on the mean of
//! the demonstrations' clocks, so that its pace is theirs.

use super::{Aligned, dtw, groups, medoid};
use crate::{
    Demonstration, Error, Path,
    timeline::{even_times, interpolate},
};

/// Warping and averaging in turns; the mean changes little after the third.
const PASSES: usize = 5;
/// Rate of the passes, Hz.
const PASS_RATE_HZ: f64 = 50.0;
/// Left standing before and after the motion, seconds.
const MARGIN_S: f64 = 0.3;

/// Demonstrations aligned to their barycentre.
pub struct Barycentre {
    /// The demonstrations on the common time.
    pub aligned: Aligned,
    /// Each demonstration's own time (without its idle start) at each common time.
    pub clocks_s: Vec<Vec<f64>>,
    /// Where on its own clock each demonstration's idle start ends.
    pub origins_s: Vec<f64>,
}

impl Barycentre {
    /// Each demonstration's own time, on its own clock, at each common time.
    pub fn recorded_s(&self) -> Vec<Vec<f64>> {
        self.clocks_s
            .iter()
            .zip(&self.origins_s)
            .map(|(clock, origin)| clock.iter().map(|t| t + origin).collect())
            .collect()
    }
}

/// Aligns the demonstrations to their barycentre, at `rate_hz`.
///
/// Errors: [`Error::DifferentMotions`] when they do not show the same motion.
/// `step` is called after each warping with (done, total) and may end the work.
pub fn align_to_mean(
    demonstrations: &[Demonstration],
    rate_hz: f64,
    step: &mut dyn FnMut(usize, usize) -> Result<(), Error>,
) -> Result<Barycentre, Error> {
    let active: Vec<Recorded> = demonstrations.iter().map(Recorded::active).collect();
    let scales = Scales::of(&active);
    let m = active.len();
    let total = steps(m);
    let mut done = 0;
    let mut tick = || {
        done += 1;
        step(done, total)
    };
    let signals: Vec<Path> = active
        .iter()
        .map(|recorded| recorded.signal(&even_times(recorded.duration_s, PASS_RATE_HZ), &scales))
        .collect();
    let mut distances = vec![0.0; m * m];
    for i in 0..m {
        for j in i + 1..m {
            let distance = dtw::squared_distance(&signals[i], &signals[j]).sqrt();
            distances[i * m + j] = distance;
            distances[j * m + i] = distance;
            tick()?;
        }
    }
    groups::check_same_motion(demonstrations)?;
    let reference = medoid(&distances, m);

    // For each demonstration, its own time at each sample of the mean.
    let own = even_times(active[reference].duration_s, PASS_RATE_HZ);
    let mut mean = signals[reference].clone();
    let mut clocks = vec![own; m];
    for _ in 0..PASSES {
        for (i, recorded) in active.iter().enumerate() {
            clocks[i] = matched_times(&mean, &signals[i], recorded.duration_s);
            tick()?;
        }
        clocks = on_mean_clock(&clocks, PASS_RATE_HZ);
        mean = average(&active, &clocks, |recorded, times| {
            recorded.signal(times, &scales)
        });
    }
    let clocks = on_mean_clock(&clocks, rate_hz);
    let duration: f64 = active.iter().map(|r| r.duration_s).sum::<f64>() / m as f64;
    let count = clocks[0].len();
    let aligned = Aligned {
        reference,
        t_s: (0..count)
            .map(|i| duration * i as f64 / (count - 1) as f64)
            .collect(),
        joints_deg: active
            .iter()
            .zip(&clocks)
            .map(|(recorded, times)| recorded.joints_at(times))
            .collect(),
    };
    Ok(Barycentre {
        aligned,
        clocks_s: clocks,
        origins_s: active.iter().map(|recorded| recorded.origin_s).collect(),
    })
}

/// Number of warpings for `m` demonstrations.
pub fn steps(m: usize) -> usize {
    m * (m - 1) / 2 + PASSES * m
}

/// The active part of a demonstration, its clock from 0. Working a signal is activity as
/// much as moving is: a hand that waits while the gripper closes waits on purpose.
struct Recorded {
    origin_s: f64,
    times_s: Vec<f64>,
    joints_deg: Path,
    tool: Option<Path>,
    duration_s: f64,
}

impl Recorded {
    fn active(demonstration: &Demonstration) -> Recorded {
        let (path, times) = (demonstration.joints_deg(), demonstration.times_s());
        let n = path.len();
        let moving = demonstration.moving();
        let worked = demonstration.signal_changes();
        let (begins, ends) = worked.iter().fold(
            (times[*moving.start()], times[*moving.end()]),
            |(begins, ends), event| (begins.min(event.at_s), ends.max(event.at_s)),
        );
        let first = times.partition_point(|&t| t < begins - MARGIN_S).min(n - 2);
        let last = times
            .partition_point(|&t| t <= ends + MARGIN_S)
            .clamp(first + 2, n);
        let origin = times[first];
        let tool = demonstration
            .tool_path_mm()
            .map(|tool| Path::from_rows(3, &tool[first..last]));
        Recorded {
            origin_s: origin,
            times_s: times[first..last].iter().map(|t| t - origin).collect(),
            joints_deg: Path::from_rows(path.width(), (first..last).map(|i| path.row(i))),
            tool,
            duration_s: times[last - 1] - origin,
        }
    }

    fn joints_at(&self, times_s: &[f64]) -> Path {
        interpolate(&self.times_s, &self.joints_deg, times_s)
    }

    /// Tool and joints at the given times, scaled.
    fn signal(&self, times_s: &[f64], scales: &Scales) -> Path {
        let joints = self.joints_at(times_s);
        let tool = self
            .tool
            .as_ref()
            .map(|tool| interpolate(&self.times_s, tool, times_s));
        let width = joints.width() + if tool.is_some() { 3 } else { 0 };
        let mut signal = Path::with_capacity(width, times_s.len());
        let mut row = Vec::with_capacity(width);
        for i in 0..times_s.len() {
            row.clear();
            row.extend(joints.row(i).iter().map(|q| q / scales.joints_deg));
            if let Some(tool) = &tool {
                row.extend(tool.row(i).iter().map(|p| p / scales.tool_mm));
            }
            signal.push(&row);
        }
        signal
    }
}

/// Spread of all demonstrations together.
struct Scales {
    joints_deg: f64,
    tool_mm: f64,
}

impl Scales {
    fn of(active: &[Recorded]) -> Scales {
        let mean = |spreads: Vec<f64>| {
            (spreads.iter().sum::<f64>() / spreads.len().max(1) as f64).max(1e-9)
        };
        Scales {
            joints_deg: mean(
                active
                    .iter()
                    .map(|r| groups::spread(&r.joints_deg))
                    .collect(),
            ),
            tool_mm: mean(
                active
                    .iter()
                    .filter_map(|r| r.tool.as_ref().map(groups::spread))
                    .collect(),
            ),
        }
    }
}

/// Mean time of the samples of `signal` that match each sample of `mean`; the
/// ends belong to each other.
fn matched_times(mean: &Path, signal: &Path, duration_s: f64) -> Vec<f64> {
    let mut sums = vec![0.0; mean.len()];
    let mut counts = vec![0.0; mean.len()];
    for (i, j) in dtw::warp(mean, signal, 0) {
        sums[i] += j as f64;
        counts[i] += 1.0;
    }
    let step = duration_s / (signal.len() - 1) as f64;
    let mut times: Vec<f64> = sums
        .iter()
        .zip(&counts)
        .map(|(sum, count)| sum / count * step)
        .collect();
    let last = times.len() - 1;
    times[0] = 0.0;
    times[last] = duration_s;
    times
}

/// The same clocks, sampled where their mean advances evenly.
fn on_mean_clock(clocks: &[Vec<f64>], rate_hz: f64) -> Vec<Vec<f64>> {
    let m = clocks.len() as f64;
    let mean: Vec<f64> = (0..clocks[0].len())
        .map(|i| clocks.iter().map(|clock| clock[i]).sum::<f64>() / m)
        .collect();
    let even = even_times(mean[mean.len() - 1], rate_hz);
    clocks
        .iter()
        .map(|clock| {
            let column = Path::from_rows(1, clock.iter().map(|t| [*t]));
            interpolate(&mean, &column, &even).column(0)
        })
        .collect()
}

fn average(
    active: &[Recorded],
    clocks: &[Vec<f64>],
    signal: impl Fn(&Recorded, &[f64]) -> Path,
) -> Path {
    let signals: Vec<Path> = active
        .iter()
        .zip(clocks)
        .map(|(recorded, times)| signal(recorded, times))
        .collect();
    mean_of(&signals)
}

/// Row by row mean of paths of equal length.
pub fn mean_of(paths: &[Path]) -> Path {
    let (n, width) = (paths[0].len(), paths[0].width());
    let mut mean = Path::with_capacity(width, n);
    for i in 0..n {
        let row: Vec<f64> = (0..width)
            .map(|c| paths.iter().map(|p| p.row(i)[c]).sum::<f64>() / paths.len() as f64)
            .collect();
        mean.push(&row);
    }
    mean
}
