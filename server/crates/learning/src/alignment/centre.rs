//! The middle of a bundle of aligned demonstrations: where most of them went, and
//! above all those that took their time.
//!
//! At each time it is the geometric median of the tool's places (Weiszfeld's
//! iteration), which one odd demonstration cannot pull away, each weighted by its
//! pace there: a hand that slows down aims. Weighting by pace can lead the path from
//! one demonstration's resting place to another's; so it goes only as far as the
//! path does not become longer than what was shown.

use super::{Aligned, barycentre::mean_of};
use crate::{Path, demonstration::tool_path_mm, path::squared_distance};

/// Strengths of the weight by pace that are tried, the strongest first; where none
/// will do, pace has no weight.
const STRENGTHS: [f64; 3] = [1.0, 0.5, 0.25];
/// Distances are not told apart below the unsteadiness of a hand: millimetres of the
/// tool, or degrees of the joints where the tool is not known.
const UNSTEADY_MM: f64 = 5.0;
const UNSTEADY_DEG: f64 = 1.5;
/// Half window over which pace and weights are smoothed, seconds.
const SMOOTHING_S: f64 = 0.2;
/// A clock that stands still counts as one that runs at this rate.
const SLOWEST_RATE: f64 = 0.02;
const ITERATIONS: usize = 20;
/// Length is measured in steps of this, which leaves tremor out.
const LENGTH_STEP_S: f64 = 0.1;

/// The demonstrations, all moved alike at each time so that their mean is the middle
/// of the bundle; what they differ by stays. `clocks_s` holds each demonstration's own
/// time at each common time.
pub fn centred(aligned: &Aligned, clocks_s: &[Vec<f64>]) -> Aligned {
    if aligned.joints_deg.len() < 2 {
        return aligned.clone();
    }
    let bundle = Bundle::of(aligned, clocks_s);
    let shown = bundle.length_shown();
    let mut centre = bundle.centre(0.0);
    for strength in STRENGTHS {
        let candidate = bundle.centre(strength);
        if bundle.length(&places(&candidate).0) <= shown {
            centre = candidate;
            break;
        }
    }
    let mean = mean_of(&aligned.joints_deg);
    Aligned {
        joints_deg: aligned
            .joints_deg
            .iter()
            .map(|path| moved(path, &mean, &centre))
            .collect(),
        ..aligned.clone()
    }
}

/// `path` + `to` - `from`, row by row.
fn moved(path: &Path, from: &Path, to: &Path) -> Path {
    let mut result = Path::with_capacity(path.width(), path.len());
    let mut row = vec![0.0; path.width()];
    for i in 0..path.len() {
        for (j, value) in row.iter_mut().enumerate() {
            *value = path.row(i)[j] + to.row(i)[j] - from.row(i)[j];
        }
        result.push(&row);
    }
    result
}

/// Where the tool is (or, without one, the joints), and what counts as near there.
fn places(joints_deg: &Path) -> (Path, f64) {
    match tool_path_mm(joints_deg) {
        Some(positions) => (Path::from_rows(3, positions), UNSTEADY_MM),
        None => (joints_deg.clone(), UNSTEADY_DEG),
    }
}

struct Bundle<'a> {
    joints_deg: &'a [Path],
    places: Vec<Path>,
    near: f64,
    /// How much of its own time each demonstration spends per common time.
    paces: Vec<Vec<f64>>,
    /// Samples in half a smoothing window, and in a step of length.
    half: usize,
    stride: usize,
}

impl Bundle<'_> {
    fn of<'a>(aligned: &'a Aligned, clocks_s: &[Vec<f64>]) -> Bundle<'a> {
        let step_s = aligned.t_s[1] - aligned.t_s[0];
        let half = (SMOOTHING_S / step_s).round() as usize;
        let found: Vec<(Path, f64)> = aligned.joints_deg.iter().map(places).collect();
        let pace = |clock: &Vec<f64>| {
            let last = clock.len() - 1;
            let rates: Vec<f64> = (0..=last)
                .map(|i| {
                    let (a, b) = (i.saturating_sub(1), (i + 1).min(last));
                    (clock[b] - clock[a]) / ((b - a) as f64 * step_s)
                })
                .collect();
            let smooth = smoothed(&rates, half);
            smooth.iter().map(|r| r.max(SLOWEST_RATE)).collect()
        };
        Bundle {
            joints_deg: &aligned.joints_deg,
            near: found[0].1,
            places: found.into_iter().map(|(path, _)| path).collect(),
            paces: clocks_s.iter().map(pace).collect(),
            half,
            stride: ((LENGTH_STEP_S / step_s).round() as usize).max(1),
        }
    }

    fn centre(&self, strength: f64) -> Path {
        let (n, m) = (self.places[0].len(), self.places.len());
        let mut weights = vec![vec![0.0; n]; m];
        for i in 0..n {
            for (weights, w) in weights.iter_mut().zip(self.weights(i, strength)) {
                weights[i] = w;
            }
        }
        for weights in &mut weights {
            *weights = smoothed(weights, self.half);
        }
        let width = self.joints_deg[0].width();
        let mut path = Path::with_capacity(width, n);
        for i in 0..n {
            let total: f64 = weights.iter().map(|w| w[i]).sum();
            let row: Vec<f64> = (0..width)
                .map(|j| {
                    let paths = self.joints_deg.iter().zip(&weights);
                    paths.map(|(path, w)| w[i] * path.row(i)[j]).sum::<f64>() / total
                })
                .collect();
            path.push(&row);
        }
        path
    }

    /// Share of each demonstration in the geometric median at sample `i`.
    fn weights(&self, i: usize, strength: f64) -> Vec<f64> {
        let paces: Vec<f64> = self.paces.iter().map(|p| p[i].powf(strength)).collect();
        let mut weights = normalised(paces.clone());
        // Of two, every place between is as good as any other.
        if weights.len() == 2 {
            return weights;
        }
        for _ in 0..ITERATIONS {
            let width = self.places[0].width();
            let middle: Vec<f64> = (0..width)
                .map(|d| {
                    let places = self.places.iter().zip(&weights);
                    places.map(|(path, w)| w * path.row(i)[d]).sum()
                })
                .collect();
            weights = normalised(
                self.places
                    .iter()
                    .zip(&paces)
                    .map(|(path, pace)| {
                        let square = squared_distance(path.row(i), &middle) + self.near * self.near;
                        pace / square.sqrt()
                    })
                    .collect(),
            );
        }
        weights
    }

    fn length(&self, places: &Path) -> f64 {
        let at: Vec<usize> = (0..places.len()).step_by(self.stride).collect();
        at.windows(2)
            .map(|pair| squared_distance(places.row(pair[0]), places.row(pair[1])).sqrt())
            .sum()
    }

    /// Mean length of the demonstrations.
    fn length_shown(&self) -> f64 {
        let lengths = self.places.iter().map(|p| self.length(p));
        lengths.sum::<f64>() / self.places.len() as f64
    }
}

fn normalised(mut weights: Vec<f64>) -> Vec<f64> {
    let total: f64 = weights.iter().sum();
    for weight in &mut weights {
        *weight /= total;
    }
    weights
}

/// Three running means, which together are nearly a bell.
fn smoothed(values: &[f64], half: usize) -> Vec<f64> {
    let mut values = values.to_vec();
    for _ in 0..3 {
        let mut sums = vec![0.0; values.len() + 1];
        for (i, value) in values.iter().enumerate() {
            sums[i + 1] = sums[i] + value;
        }
        for (i, value) in values.iter_mut().enumerate() {
            let (from, to) = (i.saturating_sub(half), (i + half + 1).min(sums.len() - 1));
            *value = (sums[to] - sums[from]) / (to - from) as f64;
        }
    }
    values
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::timeline::even_times;

    const SAMPLES: usize = 200;

    /// A swing of all joints, each take off by its own constant angle and with a
    /// tremor of its own.
    fn takes(offsets_deg: &[f64], tremor_deg: f64) -> (Aligned, Vec<Vec<f64>>) {
        let t_s = even_times(2.0, (SAMPLES - 1) as f64 / 2.0);
        let take = |number: usize, off: f64| {
            Path::from_rows(
                6,
                t_s.iter().map(|t| {
                    let tremor = tremor_deg * (20.0 * t + 2.0 * number as f64).sin();
                    let swing = 20.0 * (1.5 * t).sin() + tremor;
                    [swing, 30.0 + off, swing, -swing, 40.0 + off, off]
                }),
            )
        };
        let joints_deg = (0..)
            .zip(offsets_deg)
            .map(|(i, &off)| take(i, off))
            .collect();
        let clocks_s = vec![t_s.clone(); offsets_deg.len()];
        let aligned = Aligned {
            reference: 0,
            t_s,
            joints_deg,
        };
        (aligned, clocks_s)
    }

    fn furthest(a: &Path, b: &Path) -> f64 {
        (0..a.len())
            .flat_map(|i| a.row(i).iter().zip(b.row(i)).map(|(p, q)| (p - q).abs()))
            .fold(0.0, f64::max)
    }

    #[test]
    fn one_odd_take_does_not_pull_the_others_away() {
        let (aligned, clocks) = takes(&[0.0, 0.3, -0.3, 12.0], 0.1);
        let centre = mean_of(&centred(&aligned, &clocks).joints_deg);
        let off_centre = furthest(&centre, &aligned.joints_deg[0]);
        let off_mean = furthest(&mean_of(&aligned.joints_deg), &aligned.joints_deg[0]);
        assert!(
            off_mean > 2.9 && off_centre < 0.5,
            "{off_mean} {off_centre}"
        );
    }

    #[test]
    fn where_one_take_slows_down_its_word_counts_more() {
        let (aligned, mut clocks) = takes(&[-0.2, 0.2], 2.0);
        // The second take spends 1.9 s of its own on the second half, 0.1 s on the first.
        for (i, t) in clocks[1].iter_mut().enumerate() {
            let u = i as f64 / (SAMPLES - 1) as f64;
            *t = if u < 0.5 {
                0.2 * u
            } else {
                0.1 + 3.8 * (u - 0.5)
            };
        }
        let centre = mean_of(&centred(&aligned, &clocks).joints_deg);
        let middle = mean_of(&aligned.joints_deg);
        let shift = |i: usize| centre.row(i)[5] - middle.row(i)[5];
        assert!(shift(SAMPLES / 5) < -0.02, "{}", shift(SAMPLES / 5));
        assert!(shift(SAMPLES * 4 / 5) > 0.02, "{}", shift(SAMPLES * 4 / 5));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(16))]

        /// What takes differ by stays, and the middle is within them.
        #[test]
        fn takes_are_moved_alike_and_their_middle_is_among_them(
            offsets in proptest::collection::vec(-10.0..10.0f64, 1..6),
        ) {
            let (aligned, clocks) = takes(&offsets, 0.1);
            let moved = centred(&aligned, &clocks);
            for (a, b) in aligned.joints_deg.iter().zip(&moved.joints_deg) {
                for i in [0, SAMPLES / 2, SAMPLES - 1] {
                    let before = a.row(i)[5] - aligned.joints_deg[0].row(i)[5];
                    let after = b.row(i)[5] - moved.joints_deg[0].row(i)[5];
                    prop_assert!((before - after).abs() < 1e-9);
                }
            }
            let centre = mean_of(&moved.joints_deg);
            let (least, most) = offsets.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &x| {
                (f64::min(a, x), f64::max(b, x))
            });
            for i in 0..SAMPLES {
                let off = centre.row(i)[5];
                prop_assert!(off >= least - 1e-9 && off <= most + 1e-9);
            }
        }
    }
}
