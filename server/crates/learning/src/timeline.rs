//! Paths over time: equally spaced times, and a path at other times than its own.

use crate::Path;

/// Equally spaced times from 0 to `duration_s`, both included, about `rate_hz`
/// apart: round(duration * rate) + 1 of them, but at least three.
pub fn even_times(duration_s: f64, rate_hz: f64) -> Vec<f64> {
    let count = ((duration_s * rate_hz).round() as usize).max(2) + 1;
    (0..count)
        .map(|i| duration_s * i as f64 / (count - 1) as f64)
        .collect()
}

/// The path at the times `at_s`, linear between its own times and held at both
/// ends. Neither the path's times nor `at_s` may decrease; there must be at least
/// two rows.
pub fn interpolate(times_s: &[f64], path: &Path, at_s: &[f64]) -> Path {
    let mut result = Path::with_capacity(path.width(), at_s.len());
    let mut left = 0;
    let mut row = Vec::with_capacity(path.width());
    for &t in at_s {
        while left + 2 < times_s.len() && times_s[left + 1] <= t {
            left += 1;
        }
        let (a, b) = (times_s[left], times_s[left + 1]);
        let u = if b > a {
            ((t - a) / (b - a)).clamp(0.0, 1.0)
        } else {
            0.0
        };
        row.clear();
        row.extend(
            path.row(left)
                .iter()
                .zip(path.row(left + 1))
                .map(|(p, q)| p + u * (q - p)),
        );
        result.push(&row);
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_go_from_zero_to_the_end() {
        assert_eq!(even_times(2.0, 2.0), [0.0, 0.5, 1.0, 1.5, 2.0]);
        assert_eq!(even_times(1e-9, 100.0).len(), 3);
    }

    #[test]
    fn a_line_is_read_exactly_and_held_at_its_ends() {
        let path = Path::from_rows(2, [[0.0, 10.0], [1.0, 8.0], [3.0, 4.0]]);
        let read = interpolate(&[0.0, 1.0, 3.0], &path, &[-1.0, 0.5, 1.0, 2.0, 9.0]);
        let expected = [[0.0, 10.0], [0.5, 9.0], [1.0, 8.0], [2.0, 6.0], [3.0, 4.0]];
        assert!(read.rows().eq(expected.iter().map(|row| &row[..])));
    }
}
