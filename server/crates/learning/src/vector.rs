//! Arithmetic on many values at once, with the widest vectors that the processor
//! has: kernels are compiled once for every level and chosen at run time.

/// Values that each arithmetic step takes together.
pub const LANES: usize = 8;

/// A value that begins at a cache line, so that no vector in it straddles two.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C, align(64))]
pub struct Aligned<T>(pub T);

/// A computation that is worth vectors. An operation and not a closure, so that it
/// is compiled for the vectors it is dispatched to; `run` and all it calls must be
/// `#[inline(always)]`.
pub trait Kernel {
    /// What comes out.
    type Output;
    /// Computes. `FUSED` says whether the processor multiplies and adds in one step.
    fn run<const FUSED: bool>(self) -> Self::Output;
}

/// Runs a kernel. On one machine the result always has the same bits; a processor
/// without fused multiplication (before 2013) rounds once more in each step.
pub fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    match pulp::Arch::new() {
        pulp::Arch::Scalar => kernel.run::<false>(),
        vectors => vectors.dispatch(Fused(kernel)),
    }
}

struct Fused<K>(K);

impl<K: Kernel> pulp::NullaryFnOnce for Fused<K> {
    type Output = K::Output;

    #[inline(always)]
    fn call(self) -> K::Output {
        self.0.run::<true>()
    }
}

/// a * b + c.
#[inline(always)]
pub fn multiply_add<const FUSED: bool>(a: f64, b: f64, c: f64) -> f64 {
    if FUSED { a.mul_add(b, c) } else { a * b + c }
}

/// Repeats a block for each dimension below `$dimensions` (at most 8), the number in
/// `$i` a constant each time, so that loops up to it are unrolled.
macro_rules! for_each_dimension {
    ($dimensions:expr, $i:ident => $body:block) => {
        for_each_dimension!(@ $dimensions, $i, $body, 0 1 2 3 4 5 6 7)
    };
    (@ $dimensions:expr, $i:ident, $body:block, $($number:literal)*) => {
        $(
            if $number < $dimensions {
                #[expect(non_upper_case_globals, reason = "it stands for a loop variable")]
                const $i: usize = $number;
                $body
            }
        )*
    };
}
pub(crate) use for_each_dimension;

/// A value for each lane. `std::array::from_fn` is not inlined reliably, and a
/// function of its own would be compiled for the plainest processor.
#[inline(always)]
pub fn lanes<const W: usize, T: Copy + Default>(value: impl Fn(usize) -> T) -> [T; W] {
    let mut all = [T::default(); W];
    for (lane, slot) in all.iter_mut().enumerate() {
        *slot = value(lane);
    }
    all
}

/// All lanes combined by an operation that is associative and commutative but for
/// rounding, halves first.
#[inline(always)]
pub fn reduce(x: [f64; LANES], combine: impl Fn(f64, f64) -> f64) -> f64 {
    let four: [f64; 4] = lanes(|i| combine(x[i], x[i + 4]));
    combine(combine(four[0], four[2]), combine(four[1], four[3]))
}
