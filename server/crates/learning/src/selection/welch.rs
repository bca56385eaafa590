//! Welch's t-test, one-tailed.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// p-value of "the mean behind `a` is greater than the mean behind `b`": small
/// when `a` is clearly greater.
///
/// Fewer than two values on a side decide nothing (p = 1). Without any variance
/// the comparison of the means is certain.
pub fn p_greater(a: &[f64], b: &[f64]) -> f64 {
    if a.len() < 2 || b.len() < 2 {
        return 1.0;
    }
    let ((mean_a, error_a), (mean_b, error_b)) = (mean_and_error(a), mean_and_error(b));
    let squared_error = error_a + error_b;
    if squared_error <= 0.0 {
        return if mean_a > mean_b { 0.0 } else { 1.0 };
    }
    let t = (mean_a - mean_b) / squared_error.sqrt();
    let freedom = squared_error * squared_error
        / (error_a * error_a / (a.len() - 1) as f64 + error_b * error_b / (b.len() - 1) as f64);
    match StudentsT::new(0.0, 1.0, freedom) {
        Ok(distribution) => distribution.cdf(-t),
        Err(_) => 1.0,
    }
}

/// Mean, and sample variance divided by the number of values.
fn mean_and_error(values: &[f64]) -> (f64, f64) {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let squares: f64 = values.iter().map(|v| (v - mean) * (v - mean)).sum();
    (mean, squares / (n - 1.0) / n)
}
