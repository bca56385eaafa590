//! An exponential for many values at once, in a form that compilers turn into
//! vector instructions.

use crate::vector::{lanes, multiply_add};

/// exp of each lane. Relative error below 8e-16 for arguments in [-708, 709];
/// below -708 the result is exactly 0 (the true value is under 3.4e-308).
#[inline(always)]
pub fn exp_lanes<const FUSED: bool, const W: usize>(x: [f64; W]) -> [f64; W] {
    lanes(|i| exp::<FUSED>(x[i]))
}

#[inline(always)]
fn exp<const FUSED: bool>(x: f64) -> f64 {
    // ln 2 in two parts; the first has trailing zeros, so n times it is exact.
    const LN2_HIGH: f64 = 6.931_471_803_691_238e-1;
    const LN2_LOW: f64 = 1.908_214_929_270_587_7e-10;
    // Adding and subtracting 1.5 * 2^52 rounds to an integer, left in the low bits.
    const ROUND: f64 = 6_755_399_441_055_744.0;
    let clamped = if x < -708.0 { -708.0 } else { x };
    let shifted = multiply_add::<FUSED>(clamped, std::f64::consts::LOG2_E, ROUND);
    let n = shifted - ROUND;
    let r = multiply_add::<FUSED>(-n, LN2_HIGH, clamped);
    let r = multiply_add::<FUSED>(-n, LN2_LOW, r);
    // Taylor series to r^13 on |r| <= ln(2)/2: the remainder is below 5e-18. Paired
    // (Estrin), so that steps do not wait for each other.
    let pair = |low: f64, high: f64| multiply_add::<FUSED>(high, r, low);
    let r2 = r * r;
    let r4 = r2 * r2;
    let four = |low: f64, high: f64| multiply_add::<FUSED>(high, r2, low);
    let last = pair(1.0 / 479_001_600.0, 1.0 / 6_227_020_800.0);
    let third = four(
        pair(1.0 / 40_320.0, 1.0 / 362_880.0),
        pair(1.0 / 3_628_800.0, 1.0 / 39_916_800.0),
    );
    let second = four(
        pair(1.0 / 24.0, 1.0 / 120.0),
        pair(1.0 / 720.0, 1.0 / 5_040.0),
    );
    let first = four(pair(1.0, 1.0), pair(0.5, 1.0 / 6.0));
    let sum = multiply_add::<FUSED>(last, r4, third);
    let sum = multiply_add::<FUSED>(sum, r4, second);
    let sum = multiply_add::<FUSED>(sum, r4, first);
    let scale = f64::from_bits((shifted.to_bits() << 52).wrapping_add(1023 << 52));
    let result = sum * scale;
    if x < -708.0 { 0.0 } else { result }
}

#[cfg(test)]
mod tests {
    use super::exp_lanes;

    fn worst_error<const FUSED: bool>() -> f64 {
        (0..400_000)
            .map(|i| {
                let x = -708.0 + f64::from(i) * (1417.0 / 400_000.0);
                let [y] = exp_lanes::<FUSED, 1>([x]);
                (y / x.exp() - 1.0).abs()
            })
            .fold(0.0, f64::max)
    }

    #[test]
    fn agrees_with_the_standard_library() {
        assert!(worst_error::<false>() < 8e-16);
        assert!(worst_error::<true>() < 8e-16);
    }

    #[test]
    fn special_values() {
        assert_eq!(
            exp_lanes::<true, 4>([0.0, -709.0, -1e300, f64::NEG_INFINITY]),
            [1.0, 0.0, 0.0, 0.0]
        );
        assert!(exp_lanes::<true, 1>([f64::NAN])[0].is_nan());
    }
}
