//! The minimum-jerk profile of a point-to-point movement (Flash and Hogan, 1985).

/// Part of the way done at the part `s` of the time; both from 0 to 1, outside held.
pub fn position(s: f64) -> f64 {
    let s = s.clamp(0.0, 1.0);
    s * s * s * (10.0 + s * (6.0 * s - 15.0))
}

/// Derivative of [`position`].
pub fn speed(s: f64) -> f64 {
    let s = s.clamp(0.0, 1.0);
    let rest = s * (1.0 - s);
    30.0 * rest * rest
}

/// Largest value of [`speed`].
pub const PEAK_SPEED: f64 = 1.875;

/// A detour that begins and ends with the movement, smoothly: 0 at both ends, 1 in the middle.
pub fn bow(s: f64) -> f64 {
    let s = s.clamp(0.0, 1.0);
    let rest = 4.0 * s * (1.0 - s);
    rest * rest * rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_profile_starts_and_ends_at_rest_and_is_symmetric() {
        assert_eq!((position(0.0), position(1.0)), (0.0, 1.0));
        assert_eq!((speed(0.0), speed(1.0)), (0.0, 0.0));
        assert_eq!(position(0.5), 0.5);
        assert_eq!(speed(0.5), PEAK_SPEED);
        assert_eq!((bow(0.0), bow(0.5), bow(1.0)), (0.0, 1.0, 0.0));
    }
}
