//! Smoothing of recorded signals before they are differentiated.

/// Savitzky-Golay smoothing of an equally spaced signal: at each sample the value
/// (or the derivative, in units per sample) of the least-squares cubic through
/// the `2 * half + 1` samples around it; at the ends the window is moved inside.
///
/// `half` of 10 is the 21-sample cubic filter that the published figures of hand
/// guiding were made with. Signals shorter than four samples come back unchanged
/// (derivative: zero).
pub fn savitzky_golay(signal: &[f64], half: usize, derivative: bool) -> Vec<f64> {
    let n = signal.len();
    let half = half.min(n.saturating_sub(1) / 2);
    if half < 2 {
        return if derivative {
            vec![0.0; n]
        } else {
            signal.to_vec()
        };
    }
    let interior = weights(half, 0.0, derivative);
    (0..n)
        .map(|i| {
            let centre = i.clamp(half, n - 1 - half);
            let window = &signal[centre - half..=centre + half];
            let dot = |w: &[f64]| w.iter().zip(window).map(|(w, v)| w * v).sum();
            if centre == i {
                dot(&interior)
            } else {
                dot(&weights(half, i as f64 - centre as f64, derivative))
            }
        })
        .collect()
}

/// Weights that evaluate the cubic fitted over `-half..=half` at `x`, from the
/// discrete orthogonal polynomials of that window.
fn weights(half: usize, x: f64, derivative: bool) -> Vec<f64> {
    let m = half as f64;
    let points: Vec<f64> = (0..=2 * half).map(|i| i as f64 - m).collect();
    let s2: f64 = points.iter().map(|t| t * t).sum();
    let s4: f64 = points.iter().map(|t| t.powi(4)).sum();
    let count = points.len() as f64;
    // Monic orthogonal polynomials 1, t, t² - a, t³ - b t.
    let (a, b) = (s2 / count, s4 / s2);
    let basis = |t: f64| [1.0, t, t * t - a, t * t * t - b * t];
    let slope = |t: f64| [0.0, 1.0, 2.0 * t, 3.0 * t * t - b];
    let mut norms = [0.0; 4];
    for &t in &points {
        for (norm, value) in norms.iter_mut().zip(basis(t)) {
            *norm += value * value;
        }
    }
    let at = if derivative { slope(x) } else { basis(x) };
    points
        .iter()
        .map(|&t| {
            let values = basis(t);
            (0..4).map(|k| values[k] * at[k] / norms[k]).sum()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_passes_unchanged_and_has_its_own_derivative() {
        let cubic = |t: f64| 2.0 - 0.3 * t + 0.05 * t * t - 0.001 * t * t * t;
        let slope = |t: f64| -0.3 + 0.1 * t - 0.003 * t * t;
        let signal: Vec<f64> = (0..50).map(|i| cubic(f64::from(i))).collect();
        let smooth = savitzky_golay(&signal, 10, false);
        let speed = savitzky_golay(&signal, 10, true);
        for i in 0..50 {
            let t = i as f64;
            assert!((smooth[i] - cubic(t)).abs() < 1e-9);
            assert!((speed[i] - slope(t)).abs() < 1e-9);
        }
    }

    #[test]
    fn the_five_point_weights_are_the_textbook_ones() {
        // Savitzky and Golay 1964, quadratic/cubic smoothing over five points.
        let expected = [-3.0, 12.0, 17.0, 12.0, -3.0].map(|w| w / 35.0);
        for (w, e) in weights(2, 0.0, false).iter().zip(expected) {
            assert!((w - e).abs() < 1e-12);
        }
    }

    #[test]
    fn short_signals_come_back_as_they_are() {
        assert_eq!(savitzky_golay(&[1.0, 5.0, 2.0], 10, false), [1.0, 5.0, 2.0]);
        assert_eq!(savitzky_golay(&[], 10, true), Vec::<f64>::new());
    }
}
