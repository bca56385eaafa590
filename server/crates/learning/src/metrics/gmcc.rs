//! Generalised multiple correlation coefficient (GMCC): how well one curve is a
//! linear image of another. It is close to 1 for any two smooth curves of similar
//! span and never stands alone.

use nalgebra::DMatrix;

use crate::path::Path;

/// GMCC without intercept, as published: the mean of both directions, each
/// |R H - mean(Y)| / |Y - mean(Y)| with H minimising |R H - Y| (Frobenius norms).
/// The shorter curve is padded with its last row.
pub fn gmcc(a: &Path, b: &Path) -> f64 {
    let (a, b) = same_length(a, b);
    0.5 * (one_way(&a, &b) + one_way(&b, &a))
}

/// GMCC after centring both curves: unlike the published form it is invariant to
/// translation and never above 1.
pub fn gmcc_centred(a: &Path, b: &Path) -> f64 {
    let (a, b) = same_length(a, b);
    let (a, b) = (centre(&a), centre(&b));
    0.5 * (one_way(&a, &b) + one_way(&b, &a))
}

fn same_length(a: &Path, b: &Path) -> (DMatrix<f64>, DMatrix<f64>) {
    let n = a.len().max(b.len());
    let matrix = |p: &Path| DMatrix::from_fn(n, p.width(), |i, j| p.row(i.min(p.len() - 1))[j]);
    (matrix(a), matrix(b))
}

fn centre(m: &DMatrix<f64>) -> DMatrix<f64> {
    let mean = m.row_mean();
    DMatrix::from_fn(m.nrows(), m.ncols(), |i, j| m[(i, j)] - mean[j])
}

fn one_way(r: &DMatrix<f64>, y: &DMatrix<f64>) -> f64 {
    let mean = y.row_mean();
    let deviation = |m: &DMatrix<f64>| {
        m.row_iter()
            .map(|row| (row - &mean).norm_squared())
            .sum::<f64>()
            .sqrt()
    };
    let total = deviation(y);
    if total == 0.0 {
        // A curve that stands still is explained by anything.
        return 1.0;
    }
    let svd = r.clone().svd(true, true);
    let cutoff = svd.singular_values.max() * 1e-12;
    match svd.solve(y, cutoff) {
        Ok(h) => deviation(&(r * h)) / total,
        Err(_) => 0.0,
    }
}
