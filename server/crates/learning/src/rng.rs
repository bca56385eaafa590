//! Seeded random numbers whose every bit is ours to repeat: one stream for each
//! purpose, so that results do not depend on the order or number of threads.

use std::sync::LazyLock;

use rand_core::{Rng, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

/// A stream of random numbers.
#[derive(Clone, Debug)]
pub struct Stream(Xoshiro256PlusPlus);

impl Stream {
    /// The stream that belongs to `seed` and a path of labels, such as
    /// (purpose, number of components, split).
    pub fn derive(seed: u64, labels: &[u64]) -> Stream {
        let mixed = labels
            .iter()
            .fold(mix(seed), |state, &label| mix(state ^ mix(label)));
        Stream(Xoshiro256PlusPlus::seed_from_u64(mixed))
    }

    /// Uniform in [0, 1), 53 bits.
    pub fn uniform(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
    }

    /// Uniform in 0..n; n must not be 0.
    pub fn below(&mut self, n: usize) -> usize {
        // The product's high word; its bias is below n / 2^64.
        ((u128::from(self.0.next_u64()) * n as u128) >> 64) as usize
    }

    /// Shuffles in place (Fisher and Yates).
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, self.below(i + 1));
        }
    }

    /// Standard normal (Marsaglia and Tsang's ziggurat, 256 layers).
    pub fn normal(&mut self) -> f64 {
        let table = &*ZIGGURAT;
        loop {
            let bits = self.0.next_u64();
            let layer = (bits & 0xff) as usize;
            let sign = if bits & 0x100 == 0 { 1.0 } else { -1.0 };
            let x = (bits >> 11) as f64 * (1.0 / (1u64 << 53) as f64) * table.x[layer];
            if x < table.x[layer + 1] {
                return sign * x;
            }
            if layer == 0 {
                return sign * self.tail();
            }
            let (low, high) = (table.f[layer], table.f[layer + 1]);
            if low + (high - low) * self.uniform() < (-0.5 * x * x).exp() {
                return sign * x;
            }
        }
    }

    fn tail(&mut self) -> f64 {
        loop {
            let x = -(1.0 - self.uniform()).ln() / TAIL_BEGINS;
            let y = -(1.0 - self.uniform()).ln();
            if 2.0 * y > x * x {
                return TAIL_BEGINS + x;
            }
        }
    }
}

/// One step of the SplitMix64 finaliser.
fn mix(value: u64) -> u64 {
    let mut z = value.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Right end of the lowest layer, and the area of every layer, for 256 layers.
const TAIL_BEGINS: f64 = 3.654_152_885_361_009;
const LAYER_AREA: f64 = 0.004_928_673_233_974_65;

struct Ziggurat {
    x: [f64; 257],
    f: [f64; 257],
}

static ZIGGURAT: LazyLock<Ziggurat> = LazyLock::new(|| {
    let density = |x: f64| (-0.5 * x * x).exp();
    let mut x = [0.0; 257];
    x[0] = LAYER_AREA / density(TAIL_BEGINS);
    x[1] = TAIL_BEGINS;
    for i in 2..256 {
        x[i] = (-2.0 * (LAYER_AREA / x[i - 1] + density(x[i - 1])).ln()).sqrt();
    }
    Ziggurat {
        x,
        f: x.map(density),
    }
});

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_labels_give_the_same_stream_and_others_another() {
        let draw = |labels: &[u64]| Stream::derive(7, labels).uniform();
        assert_eq!(draw(&[1, 2]), draw(&[1, 2]));
        assert_ne!(draw(&[1, 2]), draw(&[2, 1]));
        assert_ne!(draw(&[1]), draw(&[1, 0]));
    }

    #[test]
    fn normal_numbers_have_the_moments_and_tails_of_the_normal_distribution() {
        let mut stream = Stream::derive(1, &[]);
        let n = 2_000_000;
        let (mut sum, mut squares, mut fourth) = (0.0, 0.0, 0.0);
        let mut beyond = [0usize; 3];
        for _ in 0..n {
            let z = stream.normal();
            sum += z;
            squares += z * z;
            fourth += z.powi(4);
            for (count, limit) in beyond.iter_mut().zip([1.0, 2.0, 3.7]) {
                *count += usize::from(z.abs() > limit);
            }
        }
        let n = f64::from(n);
        // Five standard errors each; tail probabilities 2 (1 - Phi(limit)).
        assert!((sum / n).abs() < 5.0 / n.sqrt());
        assert!((squares / n - 1.0).abs() < 5.0 * (2.0 / n).sqrt());
        assert!((fourth / n - 3.0).abs() < 5.0 * (96.0 / n).sqrt());
        for (count, p) in beyond
            .into_iter()
            .zip([0.317_310_508, 0.045_500_264, 2.155_7e-4])
        {
            let tolerance = 5.0 * (p / n).sqrt();
            assert!((count as f64 / n - p).abs() < tolerance, "{count} {p}");
        }
    }

    #[test]
    fn a_shuffle_is_a_permutation() {
        let mut items: Vec<usize> = (0..100).collect();
        Stream::derive(3, &[]).shuffle(&mut items);
        let mut sorted = items.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..100).collect::<Vec<_>>());
        assert_ne!(items, sorted);
    }
}
