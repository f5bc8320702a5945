//! The kernels of `math`: reciprocals, square roots and their reciprocals, each from the bare
//! estimate to two Newton steps.

pub mod error;

use std::ops::RangeInclusive;

use crate::prelude::*;
use spu_emulator::float::single::{LARGEST, SMALLEST};
use twins::math;

/// Short arrays of quadwords, and long ones.
const QUADWORDS: Objects = Objects::List(32, 128);
/// The quadwords in a pass. Arrays are rounded up to a multiple of it.
const PASS: usize = 4;

/// The function of an operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// 1/x.
    Reciprocal,
    /// 1/sqrt(x).
    ReciprocalRoot,
    /// sqrt(x).
    Root,
}

/// A kernel of `math`.
#[derive(Clone, Copy, Debug)]
pub struct Function {
    /// The kernel.
    pub kernel: &'static str,
    /// The function that it computes.
    pub quantity: Quantity,
    /// Its operation on one lane.
    pub twin: fn(Single) -> Single,
    /// The magnitudes of operands for which its error is stated.
    pub domain: [Single; 2],
}

impl Quantity {
    /// The exact result.
    #[must_use]
    pub fn exactly(self, x: f64) -> f64 {
        match self {
            Self::Reciprocal => 1.0 / x,
            Self::ReciprocalRoot => 1.0 / x.sqrt(),
            Self::Root => x.sqrt(),
        }
    }

    /// Operands from which all others differ only by an exponent that does not change a digit of
    /// the result: those from 1 to below 2, or to below 4 for roots.
    #[must_use]
    pub const fn all_fractions(self) -> RangeInclusive<Single> {
        match self {
            Self::Reciprocal => 0x3f80_0000..=0x3fff_ffff,
            Self::ReciprocalRoot | Self::Root => 0x3f80_0000..=0x407f_ffff,
        }
    }

    /// Whether operands below 0 are in the domain.
    #[must_use]
    pub const fn takes_negative(self) -> bool {
        matches!(self, Self::Reciprocal)
    }
}

/// Operands whose reciprocals are normal, except for 2^126 itself, whose estimate is 0.
const RECIPROCAL: [Single; 2] = [SMALLEST, 0x7e7f_ffff];
const NORMAL: [Single; 2] = [SMALLEST, LARGEST];
/// Operands for which the remainder after subtracting the root's square is not flushed to 0.
const WITH_REMAINDER: [Single; 2] = [0x0b80_0000, LARGEST];

const fn function(
    kernel: &'static str,
    quantity: Quantity,
    twin: fn(Single) -> Single,
    domain: [Single; 2],
) -> Function {
    Function { kernel, quantity, twin, domain }
}

/// All kernels of `math`. For each quantity, the cheapest is first.
pub const FUNCTIONS: [Function; 12] = {
    use Quantity::{Reciprocal, ReciprocalRoot, Root};
    [
        function("recip_estimate", Reciprocal, math::recip_estimate, RECIPROCAL),
        function("recip_interpolated", Reciprocal, math::recip_interpolated, RECIPROCAL),
        function("recip_newton1", Reciprocal, math::reciprocal, RECIPROCAL),
        function("recip_newton2", Reciprocal, math::recip_newton2, RECIPROCAL),
        function("rsqrt_estimate", ReciprocalRoot, math::rsqrt_estimate, NORMAL),
        function("rsqrt_interpolated", ReciprocalRoot, math::rsqrt_interpolated, NORMAL),
        function("rsqrt_newton1", ReciprocalRoot, math::rsqrt, NORMAL),
        function("rsqrt_newton2", ReciprocalRoot, math::rsqrt_newton2, NORMAL),
        function("sqrt_estimate", Root, math::sqrt_estimate, NORMAL),
        function("sqrt_interpolated", Root, math::sqrt_interpolated, NORMAL),
        function("sqrt_newton1", Root, math::sqrt, WITH_REMAINDER),
        function("sqrt_newton2", Root, math::sqrt_newton2, WITH_REMAINDER),
    ]
};

fn row<const NUMBER: usize>() -> Kernel {
    Kernel::of([case("any operands", QUADWORDS, |count| {
        let mut random = ChaCha8Rng::seed_from_u64(SEED);
        let operands = (0..count).map(|_| random.random()).collect();
        Operands::<NUMBER> { operands, anything: 0, in_place: false }
    })])
    .rays(4)
    .error(|bench, random| error::largest(bench, random, &FUNCTIONS[NUMBER]))
}

/// The kernels in this file.
pub fn kernels() -> Vec<Kernel> {
    vec![
        row::<0>(),
        row::<1>(),
        row::<2>(),
        row::<3>(),
        row::<4>(),
        row::<5>(),
        row::<6>(),
        row::<7>(),
        row::<8>(),
        row::<9>(),
        row::<10>(),
        row::<11>(),
    ]
}

/// Operands of one of the [`FUNCTIONS`].
#[derive(Clone, Debug)]
pub struct Operands<const NUMBER: usize> {
    /// The operands.
    pub operands: Vec<[Single; 4]>,
    /// The operands in the rest of the last pass.
    pub anything: Single,
    /// Whether the results overwrite the operands.
    pub in_place: bool,
}

impl<const NUMBER: usize> Description for Operands<NUMBER> {
    const KERNEL: &'static str = FUNCTIONS[NUMBER].kernel;
    const ROUNDS: [usize; 2] = [4, 1200];
    const LENGTHS: &'static [usize] = &[0, 1, 2, 3, 4, 5, 7, 8, 9, 16, 33, 100];
    type Placed = Place;
    type Found = Vec<[Single; 4]>;

    /// Numbers of quadwords: those around a pass, and some more.
    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut operand = || operand(random, &FUNCTIONS[NUMBER]);
        let operands = (0..count).map(|_| [(); 4].map(|()| operand())).collect();
        Self { operands, anything: random.random(), in_place: random.random() }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let operands = (0..count).map(|_| random.random()).collect();
        Self { operands, anything: random.random(), in_place: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let [from, apart] = put_operands(bench, &self.operands, self.anything);
        let to = if self.in_place { from } else { apart };
        (to, vec![from.address, to.address, self.operands.len() as u32])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Self::Found {
        results(bench, *placed)
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let mut results = self.operands.clone();
        results.resize(results.len().next_multiple_of(PASS), [self.anything; 4]);
        results.into_iter().map(|quadword| quadword.map(FUNCTIONS[NUMBER].twin)).collect()
    }
}

/// The quadwords in a buffer.
fn results(bench: &Bench, place: Place) -> Vec<[Single; 4]> {
    let results: Vec<[U32; 4]> = bench.read_all(place);
    results.into_iter().map(|quadword| quadword.map(U32::get)).collect()
}

/// Puts operands into local store, with `anything` in the rest of the last pass, and a buffer for
/// the results.
fn put_operands(bench: &mut Bench, operands: &[[Single; 4]], anything: Single) -> [Place; 2] {
    let padded = operands.len().next_multiple_of(PASS);
    let mut words: Vec<[U32; 4]> = operands.iter().map(|quadword| quadword.map(U32::new)).collect();
    words.resize(padded, [U32::new(anything); 4]);
    let operands = put(bench, &words);
    let results = bench.place(&vec![0x55; size_of::<[U32; 4]>() * padded]);
    [operands, results]
}

/// Returns a kernel's results, including those for the rest of the last pass, where the operands
/// are 0.
pub fn call(bench: &mut Bench, kernel: &str, operands: &[[Single; 4]]) -> Vec<[Single; 4]> {
    bench.reset();
    let [from, to] = put_operands(bench, operands, 0);
    bench.call(kernel, &[from.address, to.address, operands.len() as u32]);
    results(bench, to)
}

/// A random operand of the domain. All exponents and fractions are equally likely.
pub fn operand(random: &mut impl Rng, function: &Function) -> Single {
    let [min, max] = function.domain;
    let sign = function.quantity.takes_negative() && random.random();
    random.random_range(min..=max) | u32::from(sign) << 31
}
