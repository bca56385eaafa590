//! A smooth curve through equally spaced points: the cubic spline with continuous
//! acceleration, at rest at both ends.

use crate::{JOINTS, JointAngles};

/// The spline through joint angles `period_s` apart.
#[derive(Clone, Debug)]
pub struct Spline {
    period_s: f64,
    points: Vec<JointAngles>,
    /// Slope at each point, degrees per period.
    slopes: Vec<[f64; JOINTS]>,
}

impl Spline {
    /// Through `points`, of which there must be at least one.
    ///
    /// # Panics
    /// Without points.
    pub fn through(points: Vec<JointAngles>, period_s: f64) -> Spline {
        assert!(!points.is_empty(), "a curve needs a point");
        let slopes = slopes(&points);
        Spline {
            period_s,
            points,
            slopes,
        }
    }

    /// Time from the first to the last point, seconds.
    pub fn duration_s(&self) -> f64 {
        (self.points.len() - 1) as f64 * self.period_s
    }

    /// The angles at `t_s`, held at both ends.
    pub fn at(&self, t_s: f64) -> JointAngles {
        let last = self.points.len() - 1;
        let position = (t_s / self.period_s).clamp(0.0, last as f64);
        let index = (position as usize).min(last.saturating_sub(1));
        if last == 0 {
            return self.points[0];
        }
        let u = position - index as f64;
        JointAngles(std::array::from_fn(|j| {
            let (p0, p1) = (self.points[index].0[j], self.points[index + 1].0[j]);
            let (m0, m1) = (self.slopes[index][j], self.slopes[index + 1][j]);
            let c2 = 3.0 * (p1 - p0) - 2.0 * m0 - m1;
            let c3 = 2.0 * (p0 - p1) + m0 + m1;
            p0 + u * (m0 + u * (c2 + u * c3))
        }))
    }
}

/// Slopes that make the second derivative continuous, zero at both ends:
/// m[i-1] + 4 m[i] + m[i+1] = 3 (p[i+1] - p[i-1]), solved by elimination.
fn slopes(points: &[JointAngles]) -> Vec<[f64; JOINTS]> {
    let n = points.len();
    let mut slopes = vec![[0.0; JOINTS]; n];
    let mut factors = vec![0.0; n];
    for i in 1..n.saturating_sub(1) {
        let pivot = 4.0 - factors[i - 1];
        factors[i] = 1.0 / pivot;
        for j in 0..JOINTS {
            let right = 3.0 * (points[i + 1].0[j] - points[i - 1].0[j]);
            slopes[i][j] = (right - slopes[i - 1][j]) / pivot;
        }
    }
    for i in (1..n.saturating_sub(1)).rev() {
        for j in 0..JOINTS {
            slopes[i][j] -= factors[i] * slopes[i + 1][j];
        }
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(f: impl Fn(f64) -> f64, n: u32, h: f64) -> Spline {
        let points = (0..n)
            .map(|i| JointAngles([f(f64::from(i) * h), 0.0, 0.0, 0.0, -45.0, 0.0]))
            .collect();
        Spline::through(points, h)
    }

    #[test]
    fn it_passes_through_its_points_and_follows_a_smooth_function() {
        // Slope zero at both ends, as the spline assumes.
        let f = |t: f64| 20.0 * (1.0 - (std::f64::consts::PI * t).cos());
        let spline = curve(f, 101, 0.01);
        for i in 0..1000 {
            let t = f64::from(i) * 0.001;
            assert!((spline.at(t).0[0] - f(t)).abs() < 1e-6, "{t}");
        }
        assert_eq!(spline.at(-1.0).0[0], f(0.0));
        assert_eq!(spline.at(9.0).0[0], f(1.0));
        assert!((spline.duration_s() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn its_acceleration_has_no_steps() {
        let spline = curve(|t| (9.0 * t).sin() + t * t, 60, 0.02);
        let d = 1e-4;
        let acceleration = |t: f64| {
            (spline.at(t + d).0[0] - 2.0 * spline.at(t).0[0] + spline.at(t - d).0[0]) / (d * d)
        };
        // The ends are held at rest, which this function is not.
        for i in 10..50 {
            let knot = f64::from(i) * 0.02;
            let step = acceleration(knot + 2.0 * d) - acceleration(knot - 2.0 * d);
            assert!(step.abs() < 3.0, "{knot}: {step}");
        }
    }

    #[test]
    fn one_and_two_points_are_curves_too() {
        let point = JointAngles([1.0; 6]);
        assert_eq!(Spline::through(vec![point], 0.01).at(3.0), point);
        let two = Spline::through(vec![point, JointAngles([3.0; 6])], 1.0);
        assert!((two.at(0.5).0[0] - 2.0).abs() < 1e-12);
    }
}
