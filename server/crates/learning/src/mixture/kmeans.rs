//! k-means, the start of every mixture: greedy k-means++ (2 + floor(ln k)
//! candidates for each new centre, the one that leaves the lowest potential is
//! kept), then Lloyd's iterations until the centres' total squared shift is at
//! most 1e-4 of the mean variance of the columns, or 300 iterations.
//!
//! A block whose ball is nearer to one centre than to any other belongs to it as a
//! whole, and its samples are not looked at; the labels are the same.

use super::{Blocks, blocks::Moments};
use crate::{
    rng::Stream,
    vector::{self, Kernel, LANES, multiply_add},
};

const MAX_ITERATIONS: usize = 300;
const RELATIVE_TOLERANCE: f64 = 1e-4;
/// What rounding may do to a distance, relative.
const ROUNDING: f64 = 1e-9;

/// Cluster (0..k) of each sample.
pub fn cluster<const D: usize>(data: &Blocks<D>, k: usize, rng: &mut Stream) -> Vec<u16> {
    let tolerance = RELATIVE_TOLERANCE * mean_variance(data);
    let mut centres = seed(data, k, rng);
    let mut labels = vec![u16::MAX; data.len()];
    for _ in 0..MAX_ITERATIONS {
        let mut clusters = assign(data, &centres);
        let unchanged = clusters.labels == labels;
        if clusters.counts.contains(&0.0) {
            clusters.fill_empty(data, &centres);
        }
        let new_centres = clusters.means();
        labels = clusters.labels;
        let shift: f64 = centres
            .iter()
            .zip(&new_centres)
            .map(|(a, b)| squared(a, b))
            .sum();
        centres = new_centres;
        if unchanged {
            return labels;
        }
        if shift <= tolerance {
            break;
        }
    }
    assign(data, &centres).labels
}

/// Labels of the samples; count and sum of each cluster.
struct Clusters<const D: usize> {
    labels: Vec<u16>,
    counts: Vec<f64>,
    sums: Vec<[f64; LANES]>,
}

impl<const D: usize> Clusters<D> {
    fn means(&self) -> Vec<[f64; D]> {
        self.sums
            .iter()
            .zip(&self.counts)
            .map(|(sum, &count)| std::array::from_fn(|d| sum[d] / count.max(1.0)))
            .collect()
    }

    /// Gives each empty cluster the sample farthest from its centre.
    fn fill_empty(&mut self, data: &Blocks<D>, centres: &[[f64; D]]) {
        let distance = |i: usize| squared(&data.sample(i), &centres[usize::from(self.labels[i])]);
        let mut farthest: Vec<(f64, usize)> = (0..data.len()).map(|i| (distance(i), i)).collect();
        farthest.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut farthest = farthest.into_iter().map(|(_, i)| i);
        for empty in 0..self.counts.len() {
            if self.counts[empty] > 0.0 {
                continue;
            }
            let held = |i: usize| usize::from(self.labels[i]);
            if let Some(sample) = farthest.find(|&i| self.counts[held(i)] > 1.0) {
                let (from, x) = (held(sample), data.sample(sample));
                self.counts[from] -= 1.0;
                self.counts[empty] = 1.0;
                for (sum, x) in self.sums[from].iter_mut().zip(x) {
                    *sum -= x;
                }
                self.sums[empty][..D].copy_from_slice(&x);
                self.labels[sample] = empty as u16;
            }
        }
    }
}

fn assign<const D: usize>(data: &Blocks<D>, centres: &[[f64; D]]) -> Clusters<D> {
    vector::dispatch(Assign { data, centres })
}

struct Assign<'a, const D: usize> {
    data: &'a Blocks<D>,
    centres: &'a [[f64; D]],
}

impl<const D: usize> Kernel for Assign<'_, D> {
    type Output = Clusters<D>;

    #[inline(always)]
    fn run<const FUSED: bool>(self) -> Clusters<D> {
        let k = self.centres.len();
        let mut clusters = Clusters {
            labels: vec![0; self.data.len()],
            counts: vec![0.0; k],
            sums: vec![[0.0; LANES]; k],
        };
        let blocks = self.data.moments();
        let between = distances_between(self.centres);
        let (mut squares, mut inner) = (vec![[0.0; LANES]; k], vec![[0.0; LANES]; k]);
        for (index, group) in self.data.groups().iter().enumerate() {
            let nearest = Nearest::of::<FUSED, D>(&group.mean, self.centres, &mut squares);
            let first = index * LANES;
            for (lane, moments) in blocks[first..].iter().take(LANES).enumerate() {
                let begin = (first + lane) * LANES;
                let filled = self.data.filled(first + lane);
                let labels = &mut clusters.labels[begin..begin + filled];
                if nearest.holds_ball(group.radius[lane], lane, &squares, &between) {
                    let label = nearest.label[lane] as usize;
                    labels.fill(label as u16);
                    clusters.counts[label] += moments.zeroth;
                    add(&mut clusters.sums[label], moments);
                } else {
                    let block = &self.data.samples()[first + lane].0;
                    let nearest = Nearest::of::<FUSED, D>(block, self.centres, &mut inner);
                    let label = nearest.label[0];
                    if nearest.label == [label; LANES] {
                        labels.fill(label as u16);
                        clusters.counts[label as usize] += moments.zeroth;
                        add(&mut clusters.sums[label as usize], moments);
                        continue;
                    }
                    for (lane, label) in labels.iter_mut().enumerate() {
                        let c = nearest.label[lane] as usize;
                        *label = c as u16;
                        clusters.counts[c] += 1.0;
                        for (sum, x) in clusters.sums[c].iter_mut().zip(block) {
                            *sum += x[lane];
                        }
                    }
                }
            }
        }
        clusters
    }
}

#[inline(always)]
fn add<const D: usize>(sum: &mut [f64; LANES], moments: &Moments<D>) {
    for (sum, x) in sum.iter_mut().zip(moments.first) {
        *sum += x;
    }
}

/// Distances between all centres, k for each.
fn distances_between<const D: usize>(centres: &[[f64; D]]) -> Vec<f64> {
    let distance = |a: &[f64; D], b: &[f64; D]| squared(a, b).sqrt();
    centres
        .iter()
        .flat_map(|a| centres.iter().map(move |b| distance(a, b)))
        .collect()
}

/// The nearest centre of each of [`LANES`] points, and its squared distance.
struct Nearest {
    label: [f64; LANES],
    square: [f64; LANES],
}

impl Nearest {
    #[inline(always)]
    fn of<const FUSED: bool, const D: usize>(
        points: &[[f64; LANES]; D],
        centres: &[[f64; D]],
        squares_to: &mut [[f64; LANES]],
    ) -> Nearest {
        let mut found = Nearest {
            label: [0.0; LANES],
            square: [f64::INFINITY; LANES],
        };
        for (c, centre) in centres.iter().enumerate() {
            let square = squares::<FUSED, D>(points, centre);
            squares_to[c] = square;
            for lane in 0..LANES {
                let closer = square[lane] < found.square[lane];
                found.square[lane] = if closer {
                    square[lane]
                } else {
                    found.square[lane]
                };
                found.label[lane] = if closer { c as f64 } else { found.label[lane] };
            }
        }
        found
    }

    /// Whether all of a ball around point `lane` is on this side of the planes half
    /// way to the other centres. The distance to the plane between a and c is
    /// (|x - c|² - |x - a|²) / (2 |a - c|).
    #[inline(always)]
    fn holds_ball(
        &self,
        radius: f64,
        lane: usize,
        squares_to: &[[f64; LANES]],
        between: &[f64],
    ) -> bool {
        let own = self.label[lane] as usize;
        let between = &between[own * squares_to.len()..];
        squares_to
            .iter()
            .zip(between)
            .enumerate()
            .all(|(c, (square, apart))| {
                let margin = square[lane] * (1.0 - ROUNDING) - self.square[lane];
                c == own || margin > 2.0 * radius * apart
            })
    }
}

#[inline(always)]
fn squares<const FUSED: bool, const D: usize>(
    points: &[[f64; LANES]; D],
    centre: &[f64; D],
) -> [f64; LANES] {
    let mut square = [0.0; LANES];
    for (x, c) in points.iter().zip(centre) {
        for lane in 0..LANES {
            let d = x[lane] - c;
            square[lane] = multiply_add::<FUSED>(d, d, square[lane]);
        }
    }
    square
}

fn seed<const D: usize>(data: &Blocks<D>, k: usize, rng: &mut Stream) -> Vec<[f64; D]> {
    let trials = 2 + (k as f64).ln() as usize;
    let first = data.sample(rng.below(data.len()));
    let mut centres = vec![first];
    let unknown = vec![[f64::INFINITY; LANES]; data.samples().len()];
    let (mut nearest, mut potential) = nearer(data, &unknown, &first);
    while centres.len() < k {
        let mut best: Option<(f64, Vec<[f64; LANES]>, [f64; D])> = None;
        for _ in 0..trials {
            let candidate = data.sample(pick(&nearest, data.len(), rng.uniform() * potential));
            let (distances, left) = nearer(data, &nearest, &candidate);
            if best.as_ref().is_none_or(|(lowest, ..)| left < *lowest) {
                best = Some((left, distances, candidate));
            }
        }
        if let Some((left, distances, centre)) = best {
            (nearest, potential) = (distances, left);
            centres.push(centre);
        }
    }
    centres
}

/// First sample at which the running sum of `weights` reaches `target`.
fn pick(weights: &[[f64; LANES]], samples: usize, target: f64) -> usize {
    let mut sum = 0.0;
    for (index, block) in weights.iter().enumerate() {
        let whole: f64 = block.iter().sum();
        if sum + whole >= target {
            for (lane, weight) in block.iter().enumerate() {
                sum += weight;
                if sum >= target {
                    return index * LANES + lane;
                }
            }
        } else {
            sum += whole;
        }
    }
    samples - 1
}

/// Squared distances of the samples to the nearest centre when `centre` is added to
/// those that gave `nearest`, and their sum; lanes without a sample have 0.
fn nearer<const D: usize>(
    data: &Blocks<D>,
    nearest: &[[f64; LANES]],
    centre: &[f64; D],
) -> (Vec<[f64; LANES]>, f64) {
    vector::dispatch(Nearer {
        data,
        nearest,
        centre,
    })
}

struct Nearer<'a, const D: usize> {
    data: &'a Blocks<D>,
    nearest: &'a [[f64; LANES]],
    centre: &'a [f64; D],
}

impl<const D: usize> Kernel for Nearer<'_, D> {
    type Output = (Vec<[f64; LANES]>, f64);

    #[inline(always)]
    fn run<const FUSED: bool>(self) -> Self::Output {
        let mut distances = Vec::with_capacity(self.nearest.len());
        let mut sum = [0.0; LANES];
        let blocks = self.data.samples().iter().zip(self.nearest);
        for (index, (block, nearest)) in blocks.enumerate() {
            let mut square = squares::<FUSED, D>(&block.0, self.centre);
            for lane in 0..LANES {
                let old = nearest[lane];
                square[lane] = if square[lane] < old {
                    square[lane]
                } else {
                    old
                };
            }
            square[self.data.filled(index)..].fill(0.0);
            for lane in 0..LANES {
                sum[lane] += square[lane];
            }
            distances.push(square);
        }
        (distances, sum.iter().sum())
    }
}

/// Mean over the columns of their variances.
fn mean_variance<const D: usize>(data: &Blocks<D>) -> f64 {
    // The samples are relative to their mean.
    let squares: f64 = data
        .moments()
        .iter()
        .map(|m| (0..D).map(|d| m.second[d][d]).sum::<f64>())
        .sum();
    squares / data.len() as f64 / D as f64
}

fn squared<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum()
}
