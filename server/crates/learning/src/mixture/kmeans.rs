//! k-means, the start of every mixture: greedy k-means++ (2 + floor(ln k)
//! candidates for each new centre, the one that leaves the lowest potential is
//! kept), then Lloyd's iterations until the centres' total squared shift is at
//! most 1e-4 of the mean variance of the columns, or 300 iterations.

use super::{Blocks, LANES};
use crate::rng::Stream;

const MAX_ITERATIONS: usize = 300;
const RELATIVE_TOLERANCE: f64 = 1e-4;

/// Cluster (0..k) of each sample.
pub fn cluster<const D: usize>(data: &Blocks<D>, k: usize, rng: &mut Stream) -> Vec<usize> {
    let tolerance = RELATIVE_TOLERANCE * mean_variance(data);
    let mut centres = seed(data, k, rng);
    let mut labels = vec![usize::MAX; data.len()];
    for _ in 0..MAX_ITERATIONS {
        let (new_labels, distances) = assign(data, &centres);
        let unchanged = new_labels == labels;
        labels = new_labels;
        let new_centres = means(data, &mut labels, &distances, k);
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
    assign(data, &centres).0
}

/// Nearest centre of each sample and the squared distance to it.
fn assign<const D: usize>(data: &Blocks<D>, centres: &[[f64; D]]) -> (Vec<usize>, Vec<f64>) {
    let mut labels = Vec::with_capacity(data.len());
    let mut distances = Vec::with_capacity(data.len());
    for (index, block) in data.iter().enumerate() {
        let mut nearest = [f64::INFINITY; LANES];
        let mut label = [0.0; LANES];
        for (c, centre) in centres.iter().enumerate() {
            let distance = distance_lanes(block, centre);
            for lane in 0..LANES {
                let closer = distance[lane] < nearest[lane];
                nearest[lane] = if closer {
                    distance[lane]
                } else {
                    nearest[lane]
                };
                label[lane] = if closer { c as f64 } else { label[lane] };
            }
        }
        let filled = data.filled(index);
        labels.extend(label[..filled].iter().map(|&c| c as usize));
        distances.extend_from_slice(&nearest[..filled]);
    }
    (labels, distances)
}

#[inline(always)]
fn distance_lanes<const D: usize>(block: &[[f64; LANES]; D], centre: &[f64; D]) -> [f64; LANES] {
    let mut distance = [0.0; LANES];
    for (x, c) in block.iter().zip(centre) {
        for lane in 0..LANES {
            let d = x[lane] - c;
            distance[lane] += d * d;
        }
    }
    distance
}

/// Means of the clusters. An empty cluster takes the sample farthest from its centre.
fn means<const D: usize>(
    data: &Blocks<D>,
    labels: &mut [usize],
    distances: &[f64],
    k: usize,
) -> Vec<[f64; D]> {
    let mut counts = vec![0usize; k];
    for &label in labels.iter() {
        counts[label] += 1;
    }
    if counts.contains(&0) {
        let mut farthest: Vec<usize> = (0..labels.len()).collect();
        farthest.sort_by(|&a, &b| distances[b].total_cmp(&distances[a]));
        let mut farthest = farthest.into_iter();
        for empty in 0..k {
            if counts[empty] > 0 {
                continue;
            }
            if let Some(sample) = farthest.find(|&i| counts[labels[i]] > 1) {
                counts[labels[sample]] -= 1;
                counts[empty] = 1;
                labels[sample] = empty;
            }
        }
    }
    let mut sums = vec![[0.0; D]; k];
    for (i, &label) in labels.iter().enumerate() {
        for (sum, x) in sums[label].iter_mut().zip(data.sample(i)) {
            *sum += x;
        }
    }
    for (sum, &count) in sums.iter_mut().zip(&counts) {
        for value in sum.iter_mut() {
            *value /= count.max(1) as f64;
        }
    }
    sums
}

fn seed<const D: usize>(data: &Blocks<D>, k: usize, rng: &mut Stream) -> Vec<[f64; D]> {
    let n = data.len();
    let trials = 2 + (k as f64).ln() as usize;
    let first = data.sample(rng.below(n));
    let mut centres = vec![first];
    let mut nearest = distances_to(data, &first);
    while centres.len() < k {
        let potential: f64 = nearest.iter().sum();
        let mut best: Option<(f64, Vec<f64>, [f64; D])> = None;
        for _ in 0..trials {
            let candidate = data.sample(pick(&nearest, rng.uniform() * potential));
            let mut distances = distances_to(data, &candidate);
            for (d, &old) in distances.iter_mut().zip(&nearest) {
                *d = d.min(old);
            }
            let left: f64 = distances.iter().sum();
            if best.as_ref().is_none_or(|(lowest, ..)| left < *lowest) {
                best = Some((left, distances, candidate));
            }
        }
        if let Some((_, distances, centre)) = best {
            nearest = distances;
            centres.push(centre);
        }
    }
    centres
}

/// First sample at which the running sum of `weights` reaches `target`.
fn pick(weights: &[f64], target: f64) -> usize {
    let mut sum = 0.0;
    weights
        .iter()
        .position(|w| {
            sum += w;
            sum >= target
        })
        .unwrap_or(weights.len() - 1)
}

fn distances_to<const D: usize>(data: &Blocks<D>, centre: &[f64; D]) -> Vec<f64> {
    let mut distances = Vec::with_capacity(data.len());
    for (index, block) in data.iter().enumerate() {
        let lanes = distance_lanes(block, centre);
        distances.extend_from_slice(&lanes[..data.filled(index)]);
    }
    distances
}

fn mean_variance<const D: usize>(data: &Blocks<D>) -> f64 {
    let n = data.len() as f64;
    let mut mean = [0.0; D];
    for i in 0..data.len() {
        for (m, x) in mean.iter_mut().zip(data.sample(i)) {
            *m += x / n;
        }
    }
    let total: f64 = (0..data.len())
        .map(|i| squared(&data.sample(i), &mean))
        .sum();
    total / n / D as f64
}

fn squared<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum()
}
