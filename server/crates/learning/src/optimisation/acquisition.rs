//! The acquisition function.

use statrs::function::erf::erfc;

/// E[max(target - f, 0)] for a normal f of `mean` and `deviation`: how much better
/// than `target` a point is expected to be (minimisation).
pub fn expected_improvement(target: f64, mean: f64, deviation: f64) -> f64 {
    let gain = target - mean;
    if deviation.is_nan() || deviation <= 0.0 {
        return gain.max(0.0);
    }
    let z = gain / deviation;
    let density = (-0.5 * z * z).exp() / (2.0 * std::f64::consts::PI).sqrt();
    let cumulative = 0.5 * erfc(-z / std::f64::consts::SQRT_2);
    gain * cumulative + deviation * density
}
