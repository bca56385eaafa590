//! Alignment: all demonstrations on one time axis.
//!
//! The reference is the demonstration with the smallest sum of dynamic time
//! warping (DTW) distances to the others. Every other demonstration is warped to
//! it and carried over to the reference's own time stamps: a sample of the
//! reference receives the mean of the samples that the warping matches with it.
//! Both series are thus indexed by the warping path, which the paper leaves open.

pub mod barycentre;
pub mod centre;
pub mod dtw;
mod groups;

use crate::{
    Demonstration, Error,
    path::Path,
    timeline::{even_times, interpolate},
};

/// Longer recordings are thinned, so that the table of a warping, two bits for each
/// pair of samples, stays below 0.4 GB: ten minutes at 66 Hz are left as they are.
const MOST_SAMPLES: usize = 40_000;
/// Free samples at both ends of both series.
const PSI: usize = 2;

/// Demonstrations that share one time axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Aligned {
    /// Which demonstration gave the time axis.
    pub reference: usize,
    /// Common times, from 0, seconds.
    pub t_s: Vec<f64>,
    /// Joint angles of each demonstration, in the order given, one row a time, degrees.
    pub joints_deg: Vec<Path>,
}

impl Aligned {
    /// Common duration, seconds.
    pub fn duration_s(&self) -> f64 {
        self.t_s[self.t_s.len() - 1]
    }

    /// Rows (time, joints) of the demonstrations `chosen`, one after the other.
    pub fn rows(&self, chosen: &[usize]) -> Vec<f64> {
        let mut values = Vec::new();
        for &demonstration in chosen {
            for (t, row) in self.t_s.iter().zip(self.joints_deg[demonstration].rows()) {
                values.push(*t);
                values.extend_from_slice(row);
            }
        }
        values
    }
}

/// Aligns the demonstrations and resamples them at `rate_hz`.
///
/// Errors: [`Error::DifferentMotions`] when they do not show the same motion.
/// `step` is called after each warping with (done, total) and may end the work.
pub fn align(
    demonstrations: &[Demonstration],
    rate_hz: f64,
    step: &mut dyn FnMut(usize, usize) -> Result<(), Error>,
) -> Result<Aligned, Error> {
    align_with_clocks(demonstrations, rate_hz, step).map(|(aligned, _)| aligned)
}

/// The same with each demonstration's own time (on its own clock) at each common time.
pub fn align_with_clocks(
    demonstrations: &[Demonstration],
    rate_hz: f64,
    step: &mut dyn FnMut(usize, usize) -> Result<(), Error>,
) -> Result<(Aligned, Vec<Vec<f64>>), Error> {
    let longest = demonstrations.iter().map(|d| d.joints_deg().len()).max();
    let stride = longest.unwrap_or(0).div_ceil(MOST_SAMPLES).max(1);
    let thinned = |path: &Path| Path::from_rows(path.width(), path.rows().step_by(stride));
    let signals: Vec<Path> = demonstrations
        .iter()
        .map(|d| thinned(&d.alignment_signal()))
        .collect();
    let m = demonstrations.len();
    let pairs = m * (m - 1) / 2;
    let total = pairs + m - 1;
    let mut distances = vec![0.0; m * m];
    let mut done = 0;
    for i in 0..m {
        for j in i + 1..m {
            let distance = dtw::squared_distance(&signals[i], &signals[j]).sqrt();
            distances[i * m + j] = distance;
            distances[j * m + i] = distance;
            done += 1;
            step(done, total.max(1))?;
        }
    }
    groups::check_same_motion(demonstrations)?;
    let reference = medoid(&distances, m);
    let times: Vec<f64> = demonstrations[reference]
        .times_s()
        .iter()
        .step_by(stride)
        .copied()
        .collect();
    let mut joints_deg = Vec::with_capacity(m);
    let mut clocks = Vec::with_capacity(m);
    for (i, demonstration) in demonstrations.iter().enumerate() {
        let own_s = Path::from_rows(1, demonstration.times_s().iter().map(|t| [*t]));
        let (on_axis, clock) = if i == reference {
            (thinned(demonstration.joints_deg()), thinned(&own_s))
        } else {
            let warping = dtw::warp(&signals[reference], &signals[i], PSI);
            done += 1;
            step(done, total.max(1))?;
            let carried = |path: &Path| carry_over(&thinned(path), &warping, times.len());
            (carried(demonstration.joints_deg()), carried(&own_s))
        };
        joints_deg.push(on_axis);
        clocks.push(clock);
    }
    let times: Vec<f64> = times.iter().map(|t| t - times[0]).collect();
    let t_s = even_times(times[times.len() - 1], rate_hz);
    let clocks_s = clocks
        .iter()
        .map(|clock| interpolate(&times, clock, &t_s).column(0))
        .collect();
    let aligned = Aligned {
        reference,
        joints_deg: joints_deg
            .iter()
            .map(|path| interpolate(&times, path, &t_s))
            .collect(),
        t_s,
    };
    Ok((aligned, clocks_s))
}

/// Index of the smallest row sum; the first one when several are equal.
fn medoid(distances: &[f64], m: usize) -> usize {
    let sum = |i: usize| distances[i * m..(i + 1) * m].iter().sum::<f64>();
    (1..m).fold(0, |best, i| if sum(i) < sum(best) { i } else { best })
}

/// Mean of the matched samples for each of the `n` samples of the reference;
/// samples that the relaxed ends leave out take the nearest matched ones.
fn carry_over(joints_deg: &Path, warping: &[(usize, usize)], n: usize) -> Path {
    let width = joints_deg.width();
    let mut sums = vec![0.0; n * width];
    let mut counts = vec![0usize; n];
    for &(i, j) in warping {
        counts[i] += 1;
        for (sum, q) in sums[i * width..].iter_mut().zip(joints_deg.row(j)) {
            *sum += q;
        }
    }
    let first = warping.first().map_or(0, |&(i, _)| i);
    let last = warping.last().map_or(0, |&(i, _)| i);
    let mut path = Path::with_capacity(width, n);
    for i in 0..n {
        let source = i.clamp(first, last);
        let row: Vec<f64> = sums[source * width..(source + 1) * width]
            .iter()
            .map(|sum| sum / counts[source].max(1) as f64)
            .collect();
        path.push(&row);
    }
    path
}

#[cfg(test)]
mod tests;
