//! What a fault leaves to chance: seeded draws.

use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::Rng;

/// A number in 0 to 1, 1 excepted.
pub fn share(random: &mut Xoshiro256PlusPlus) -> f64 {
    // A double holds 53 bits.
    (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64
}

/// A whole number below `limit`; 0 when the limit is 0.
pub fn below(random: &mut Xoshiro256PlusPlus, limit: u32) -> u32 {
    (share(random) * f64::from(limit)) as u32
}

/// One of `things`, of which there is at least one.
pub fn pick<'a, T>(random: &mut Xoshiro256PlusPlus, things: &'a [T]) -> &'a T {
    &things[below(random, things.len() as u32) as usize]
}
