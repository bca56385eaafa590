//! The detour by which a person's way between two points differs from a straight one.

/// A detour that begins and ends with the movement, smoothly: 0 at both ends, 1 in the middle.
pub fn bow(s: f64) -> f64 {
    let s = s.clamp(0.0, 1.0);
    let rest = 4.0 * s * (1.0 - s);
    rest * rest * rest
}

#[cfg(test)]
mod tests {
    use super::bow;

    #[test]
    fn it_is_nothing_at_the_ends_and_whole_in_the_middle() {
        assert_eq!((bow(0.0), bow(0.5), bow(1.0)), (0.0, 1.0, 0.0));
    }
}
