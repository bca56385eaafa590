//! The way of a hand from rest to rest: minimum jerk (Flash and Hogan 1985).

/// Share of the way that is done at share `u` of the time, both 0 to 1, held at
/// both ends: 10 u³ - 15 u⁴ + 6 u⁵.
pub fn share(u: f64) -> f64 {
    let u = u.clamp(0.0, 1.0);
    u * u * u * (10.0 - 15.0 * u + 6.0 * u * u)
}

/// Its slope, 30 u² (1 - u)²: speed in units of the mean speed, at most
/// [`PEAK`], zero at and beyond both ends.
pub fn slope(u: f64) -> f64 {
    let u = u.clamp(0.0, 1.0);
    30.0 * u * u * (1.0 - u) * (1.0 - u)
}

/// Largest speed in units of the mean speed.
pub const PEAK: f64 = 15.0 / 8.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_goes_from_rest_to_rest_and_is_the_integral_of_its_slope() {
        assert_eq!(
            (share(-1.0), share(0.0), share(1.0), share(2.0)),
            (0.0, 0.0, 1.0, 1.0)
        );
        assert_eq!((slope(0.0), slope(1.0), slope(3.0)), (0.0, 0.0, 0.0));
        let steps = 10_000;
        let mut sum = 0.0;
        for i in 0..steps {
            sum += slope((f64::from(i) + 0.5) / f64::from(steps)) / f64::from(steps);
            let u = f64::from(i + 1) / f64::from(steps);
            assert!((sum - share(u)).abs() < 1e-7);
        }
        assert!((slope(0.5) - PEAK).abs() < 1e-12);
    }
}
