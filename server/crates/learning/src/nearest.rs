//! Distances of points to the nearest sample of a curve, many samples at a time.

use crate::{
    path::Path,
    vector::{self, Aligned, Kernel, LANES, multiply_add},
};

/// The samples of a curve, prepared for asking.
pub struct Curve {
    width: usize,
    /// [`LANES`] samples after another; for each of their coordinates one vector. The
    /// last one is filled up with copies of the last sample.
    vectors: Vec<Aligned<[f64; LANES]>>,
}

impl Curve {
    /// Prepares a path, which must not be empty.
    pub fn new(path: &Path) -> Curve {
        let (width, n) = (path.width(), path.len());
        let mut vectors = Vec::with_capacity(n.div_ceil(LANES) * width);
        for first in (0..n).step_by(LANES) {
            for coordinate in 0..width {
                vectors.push(Aligned(std::array::from_fn(|lane| {
                    path.row((first + lane).min(n - 1))[coordinate]
                })));
            }
        }
        Curve { width, vectors }
    }

    /// Distance of each row of `points`, which has the curve's width, to the nearest
    /// sample.
    pub fn distances(&self, points: &Path) -> Vec<f64> {
        vector::dispatch(Distances {
            curve: self,
            points,
        })
    }
}

struct Distances<'a> {
    curve: &'a Curve,
    points: &'a Path,
}

impl Kernel for Distances<'_> {
    type Output = Vec<f64>;

    #[inline(always)]
    fn run<const FUSED: bool>(self) -> Vec<f64> {
        let mut distances = Vec::with_capacity(self.points.len());
        for point in self.points.rows() {
            let mut nearest = [f64::INFINITY; LANES];
            for samples in self.curve.vectors.chunks_exact(self.curve.width) {
                let mut square = [0.0; LANES];
                for (sample, p) in samples.iter().zip(point) {
                    for lane in 0..LANES {
                        let d = sample.0[lane] - p;
                        square[lane] = multiply_add::<FUSED>(d, d, square[lane]);
                    }
                }
                for lane in 0..LANES {
                    nearest[lane] = if square[lane] < nearest[lane] {
                        square[lane]
                    } else {
                        nearest[lane]
                    };
                }
            }
            distances.push(vector::reduce(nearest, |a, b| if a < b { a } else { b }).sqrt());
        }
        distances
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn it_is_the_least_of_all_distances(
            width in 1usize..11, points in 1usize..20, samples in 1usize..40, seed in 0u64..1000,
        ) {
            let mut rng = crate::rng::Stream::derive(seed, &[]);
            let mut draw = |n: usize| {
                Path::from_rows(width, (0..n).map(|_| (0..width).map(|_| rng.normal()).collect::<Vec<_>>()))
            };
            let (points, curve) = (draw(points), draw(samples));
            for (p, found) in points.rows().zip(Curve::new(&curve).distances(&points)) {
                let least = curve
                    .rows()
                    .map(|q| p.iter().zip(q).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt())
                    .fold(f64::INFINITY, f64::min);
                prop_assert!((found - least).abs() < 1e-12);
            }
        }
    }
}
