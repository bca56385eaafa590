//! Generalised multiple correlation coefficient (GMCC): how well one curve is a
//! linear image of another. It is close to 1 for any two smooth curves of similar
//! span and never stands alone.

use nalgebra::DMatrix;

use crate::path::Path;

/// Both forms of the coefficient, each the mean of both directions,
/// |R H - mean(Y)| / |Y - mean(Y)| with H minimising |R H - Y| (Frobenius norms).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gmcc {
    /// Without intercept, as published.
    pub published: f64,
    /// With intercept, which is that of both curves centred: unlike the published form
    /// it is invariant to translation and never above 1.
    pub centred: f64,
}

/// Both forms for two curves; the shorter one is padded with its last row.
pub fn gmcc_both(a: &Path, b: &Path) -> Gmcc {
    let curves = Curves::of(a, b);
    let centred = |m: &DMatrix<f64>| m - &curves.ones * curves.mean(m);
    Gmcc {
        published: symmetric(&curves, &curves.a, &curves.b),
        centred: symmetric(&curves, &centred(&curves.a), &centred(&curves.b)),
    }
}

/// [`Gmcc::published`].
pub fn gmcc(a: &Path, b: &Path) -> f64 {
    gmcc_both(a, b).published
}

fn symmetric(curves: &Curves, a: &DMatrix<f64>, b: &DMatrix<f64>) -> f64 {
    0.5 * (curves.one_way(a, b) + curves.one_way(b, a))
}

/// Two curves and a column of ones, turned by the same orthogonal matrix so that few
/// rows are left (QR of all columns together): norms and products of columns, which
/// is all that the coefficient looks at, stay what they are.
struct Curves {
    ones: DMatrix<f64>,
    a: DMatrix<f64>,
    b: DMatrix<f64>,
}

impl Curves {
    fn of(a: &Path, b: &Path) -> Curves {
        let n = a.len().max(b.len());
        let (first, second) = (a.width(), b.width());
        let all = DMatrix::from_fn(n, 1 + first + second, |i, j| {
            if j == 0 {
                1.0
            } else if j <= first {
                a.row(i.min(a.len() - 1))[j - 1]
            } else {
                b.row(i.min(b.len() - 1))[j - 1 - first]
            }
        });
        let turned = all.qr().unpack_r();
        Curves {
            ones: turned.columns(0, 1).into_owned(),
            a: turned.columns(1, first).into_owned(),
            b: turned.columns(1 + first, second).into_owned(),
        }
    }

    /// Mean row.
    fn mean(&self, m: &DMatrix<f64>) -> DMatrix<f64> {
        self.ones.tr_mul(m) / self.ones.norm_squared()
    }

    fn one_way(&self, r: &DMatrix<f64>, y: &DMatrix<f64>) -> f64 {
        let mean = &self.ones * self.mean(y);
        let total = (y - &mean).norm();
        if total <= STANDS_STILL * y.norm() {
            // A curve that stands still is explained by anything.
            return 1.0;
        }
        let svd = r.clone().svd(true, true);
        let cutoff = svd.singular_values.max() * 1e-12;
        match svd.solve(y, cutoff) {
            Ok(h) => (r * h - mean).norm() / total,
            Err(_) => 0.0,
        }
    }
}

/// Deviation below which a curve stands still, as a share of its size: rounding.
const STANDS_STILL: f64 = 1e-13;
