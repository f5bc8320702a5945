//! The estimates and their interpolation.
//!
//! An estimate is a word with a sign, an exponent, 13 bits of base and 10 bits of step. `fi`
//! subtracts from the base a part of the step, which the operand's low bits select. The
//! architecture leaves the tables to the machine. These are the Cell's. Known weakness: output
//! printed on hardware covers 10 of the 32 and 13 of the 64 entries. The rest agrees with one
//! other emulator.

use super::fpscr::Flags;
use super::single::{EXPONENT, SIGN};

const FRACTION: u32 = 0x007f_ffff;
const STEP_BITS: u32 = 10;

/// Base and step of an entry.
type Entry = (u16, u16);

#[rustfmt::skip]
const RECIPROCAL: [Entry; 32] = [
    (8190, 992), (8161, 934), (7227, 882), (7202, 832), (6370, 786), (6350, 746), (5604, 708), (5586, 672),
    (4914, 638), (4900, 610), (4290, 580), (4277, 554), (3723, 530), (3711, 506), (3205, 484), (3196, 466),
    (2730, 446), (2721, 428), (2293, 410), (2287, 398), (1889, 374), (1889, 374), (1515, 346), (1515, 346),
    (1169, 323), (1169, 323), ( 846, 301), ( 846, 301), ( 545, 282), ( 545, 282), ( 263, 263), ( 263, 263),
];

/// The first half is for even exponent fields, the second half for odd ones.
#[rustfmt::skip]
const RECIPROCAL_ROOT: [Entry; 64] = [
    (3392, 352), (3386, 340), (3046, 317), (3046, 317), (2729, 291), (2729, 291), (2438, 269), (2438, 269),
    (2169, 249), (2169, 249), (1920, 233), (1920, 233), (1687, 217), (1687, 217), (1470, 203), (1470, 203),
    (1267, 192), (1267, 192), (1075, 179), (1075, 179), ( 896, 170), ( 896, 170), ( 726, 161), ( 726, 161),
    ( 565, 152), ( 565, 152), ( 413, 145), ( 413, 145), ( 268, 137), ( 268, 137), ( 131, 131), ( 131, 131),
    (8191, 500), (8180, 478), (7702, 456), (7695, 442), (7253, 412), (7253, 412), (6841, 380), (6841, 380),
    (6461, 353), (6461, 353), (6108, 329), (6108, 329), (5779, 307), (5779, 307), (5472, 287), (5472, 287),
    (5185, 271), (5185, 271), (4914, 254), (4914, 254), (4660, 240), (4660, 240), (4420, 228), (4420, 228),
    (4192, 215), (4192, 215), (3977, 204), (3977, 204), (3773, 195), (3773, 195), (3578, 186), (3578, 186),
];

/// The entries, packed as in an estimate word.
const fn packed<const N: usize>(table: [Entry; N]) -> [u32; N] {
    let mut words = [0; N];
    let mut n = 0;
    while n < N {
        let (base, step) = table[n];
        words[n] = (base as u32) << STEP_BITS | step as u32;
        n += 1;
    }
    words
}

static RECIPROCAL_WORDS: [u32; 32] = packed(RECIPROCAL);
static RECIPROCAL_ROOT_WORDS: [u32; 64] = packed(RECIPROCAL_ROOT);

/// The estimates' fractions of `frest`, by bits 9 to 13 of the operand.
#[must_use]
pub fn reciprocal_words() -> &'static [u32; 32] {
    &RECIPROCAL_WORDS
}

/// The estimates' fractions of `frsqest`, by bits 8 to 13 of the operand.
#[must_use]
pub fn reciprocal_root_words() -> &'static [u32; 64] {
    &RECIPROCAL_ROOT_WORDS
}

#[inline]
const fn exponent(x: u32) -> u32 {
    (x & EXPONENT) >> 23
}

/// Whether `frest` and `frsqest` of `x` raise divide-by-zero, because the exponent field is 0.
#[inline]
#[must_use]
pub const fn divides_by_zero(x: u32) -> bool {
    exponent(x) == 0
}

/// The estimate word of `1 / x`.
#[inline]
#[must_use]
pub fn frest(x: u32) -> u32 {
    let exponent = match exponent(x) {
        0 => 255,
        e => 253u32.saturating_sub(e),
    };
    x & SIGN | exponent << 23 | RECIPROCAL_WORDS[(x >> 18 & 31) as usize]
}

/// The estimate word of `1 / sqrt(|x|)`.
#[inline]
#[must_use]
pub fn frsqest(x: u32) -> u32 {
    let exponent = match exponent(x) {
        0 => 255,
        e => (380 - e) >> 1,
    };
    exponent << 23 | RECIPROCAL_ROOT_WORDS[(x >> 18 & 63) as usize]
}

/// The base of the estimate word and the part of its step that `a` selects, in units of 2^-32.
/// `fi` computes one plus the base minus the part.
#[inline]
pub(super) const fn base_and_part(a: u32, estimate: u32) -> (u32, u32) {
    let base = (estimate >> STEP_BITS & 0x1fff) << 19;
    let step = estimate & 0x3ff;
    let position = a & 0x7_ffff;
    (base, step * position)
}

/// The single that the estimate word `estimate` represents for operand `a`.
#[inline]
#[must_use]
pub fn fi(a: u32, estimate: u32) -> u32 {
    fi_flagged(a, estimate).0
}

/// [`fi`] with its exceptions. Here `a` is not a number but a position within the step, so it
/// raises no flags.
#[inline]
#[must_use]
pub fn fi_flagged(a: u32, estimate: u32) -> (u32, Flags) {
    const ONE: u64 = 1 << 32;
    let (base, part) = base_and_part(a, estimate);
    // At least 2^32 - 1023 * (2^19 - 1), so at most one shift normalises it.
    let significand = ONE + u64::from(base) - u64::from(part);
    let shift = u32::from(significand < ONE);
    let exponent = exponent(estimate);
    if exponent == 0 {
        let denormal = estimate & FRACTION != 0;
        return (0, Flags::DIFFERENT.when(denormal));
    }
    if exponent == shift {
        return (0, Flags::UNDERFLOW | Flags::DIFFERENT);
    }
    let fraction = (significand << shift >> 9) as u32 & FRACTION;
    let result = estimate & SIGN | (exponent - shift) << 23 | fraction;
    (result, Flags::DIFFERENT.when(exponent == 255))
}
