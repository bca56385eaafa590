//! A sequence of points of equal width in one flat buffer: joint angles over
//! time, or positions of the tool.

use serde::{Deserialize, Serialize};

/// Squared distance of two points of equal width.
pub(crate) fn squared_distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum()
}

/// n rows of `width` values, row after row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Path {
    width: usize,
    values: Vec<f64>,
}

impl Path {
    /// An empty path of rows of `width` values; room for `rows`.
    pub fn with_capacity(width: usize, rows: usize) -> Path {
        Path {
            width,
            values: Vec::with_capacity(width * rows),
        }
    }

    /// From rows that all have `width` values.
    ///
    /// # Panics
    /// When a row has another width: a bug of the caller, who checks input before.
    pub fn from_rows<R: AsRef<[f64]>>(width: usize, rows: impl IntoIterator<Item = R>) -> Path {
        let mut path = Path::with_capacity(width, 0);
        for row in rows {
            path.push(row.as_ref());
        }
        path
    }

    /// Appends one row.
    ///
    /// # Panics
    /// When the row has another width.
    pub fn push(&mut self, row: &[f64]) {
        assert_eq!(row.len(), self.width, "a row of another width");
        self.values.extend_from_slice(row);
    }

    /// Values in a row.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.values.len() / self.width
    }

    /// True without rows.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// Row `i`.
    pub fn row(&self, i: usize) -> &[f64] {
        &self.values[i * self.width..(i + 1) * self.width]
    }

    /// Last row; the path must not be empty.
    pub fn last(&self) -> &[f64] {
        self.row(self.len() - 1)
    }

    /// All rows in order.
    pub fn rows(&self) -> std::slice::ChunksExact<'_, f64> {
        self.values.chunks_exact(self.width)
    }

    /// Column `j` as a vector.
    pub fn column(&self, j: usize) -> Vec<f64> {
        self.rows().map(|row| row[j]).collect()
    }

    /// Largest minus smallest value of column `j`.
    pub fn column_span(&self, j: usize) -> f64 {
        let (min, max) = self
            .rows()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(min, max), row| {
                (f64::min(min, row[j]), f64::max(max, row[j]))
            });
        (max - min).max(0.0)
    }
}
