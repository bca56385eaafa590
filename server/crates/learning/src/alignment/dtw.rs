//! Dynamic time warping with squared Euclidean local cost and the steps (1,1),
//! (1,0), (0,1), all of weight one.

use crate::path::Path;

/// Cost of the best warping of `a` to `b`: the sum of squared distances along it.
/// Two rows of memory.
pub fn squared_distance(a: &Path, b: &Path) -> f64 {
    let m = b.len();
    let mut row = vec![f64::INFINITY; m + 1];
    row[0] = 0.0;
    for p in a.rows() {
        let mut diagonal = row[0];
        row[0] = f64::INFINITY;
        let mut left = f64::INFINITY;
        for (cell, q) in row[1..].iter_mut().zip(b.rows()) {
            let up = *cell;
            let best = f64::min(f64::min(diagonal, up), left);
            left = best + squared(p, q);
            *cell = left;
            diagonal = up;
        }
    }
    row[m]
}

const DIAGONAL: u8 = 0;
const UP: u8 = 1;
const LEFT: u8 = 2;

/// The best warping as pairs (index in `a`, index in `b`), both never decreasing.
///
/// Up to `psi` samples at the beginning and the end of either series may stay
/// unmatched at no cost. Equal predecessors are taken in the order diagonal,
/// previous of `a`, previous of `b`.
pub fn warp(a: &Path, b: &Path, psi: usize) -> Vec<(usize, usize)> {
    let (n, m) = (a.len(), b.len());
    let (psi_a, psi_b) = (psi.min(n - 1), psi.min(m - 1));
    let mut from = vec![DIAGONAL; n * m];
    let mut row = vec![f64::INFINITY; m + 1];
    row[..=psi_b].fill(0.0);
    // Cost of leaving out the end of `a`: the last column of its last rows.
    let mut best = (f64::INFINITY, n, m);
    for (i, p) in a.rows().enumerate() {
        let mut diagonal = row[0];
        row[0] = if i < psi_a { 0.0 } else { f64::INFINITY };
        let mut left = row[0];
        let steps = &mut from[i * m..(i + 1) * m];
        for ((cell, q), step) in row[1..].iter_mut().zip(b.rows()).zip(steps) {
            let up = *cell;
            let (mut cost, mut choice) = (diagonal, DIAGONAL);
            if up < cost {
                (cost, choice) = (up, UP);
            }
            if left < cost {
                (cost, choice) = (left, LEFT);
            }
            *step = choice;
            left = cost + squared(p, q);
            *cell = left;
            diagonal = up;
        }
        if i + 1 + psi_a >= n && row[m] < best.0 {
            best = (row[m], i + 1, m);
        }
    }
    for j in m - psi_b..=m {
        if row[j] < best.0 {
            best = (row[j], n, j);
        }
    }
    let (_, mut i, mut j) = best;
    let mut pairs = Vec::with_capacity(n + m);
    while i > 0 && j > 0 {
        pairs.push((i - 1, j - 1));
        match from[(i - 1) * m + j - 1] {
            DIAGONAL => (i, j) = (i - 1, j - 1),
            UP => i -= 1,
            _ => j -= 1,
        }
    }
    pairs.reverse();
    pairs
}

fn squared(p: &[f64], q: &[f64]) -> f64 {
    p.iter().zip(q).map(|(a, b)| (a - b) * (a - b)).sum()
}
