//! Single precision: extended range, no NaN, no infinity, truncation, saturation, flush to zero.
//!
//! Operands are converted to `f64`, where every product of two singles is exact. A sum is rounded
//! there, but its rounding error is computed exactly (Knuth's two-sum), which turns the sum into a
//! truncated one. Truncating that again to 24 bits amounts to one truncation of the exact value.
//! Converted values and their errors stay between 2^-310 and 2^260, so `f64` itself neither
//! overflows nor underflows. So a fused multiply-add (`fma`, `fms`, `fnms`) rounds once.
//!
//! The rules are from SPU ISA 1.2. One of them is inferred: that a sum is truncated exactly,
//! however far apart its operands are. No output from hardware for that case is known.

use super::fpscr::Flags;
use std::array::from_fn;

pub(super) const SIGN: u32 = 0x8000_0000;
pub(super) const MAGNITUDE: u32 = 0x7fff_ffff;
pub(super) const EXPONENT: u32 = 0x7f80_0000;

/// The smallest number above zero, 2^-126.
pub const SMALLEST: u32 = 0x0080_0000;
/// The largest number, (2 - 2^-23) * 2^128.
pub const LARGEST: u32 = MAGNITUDE;

// A double is handled as two words, because hosts shuffle four lanes of 32 bits best.

/// The difference between the exponent biases, at the position of the exponent in a double's upper
/// word.
pub(super) const REBIAS: u32 = (1023 - 127) << 20;
/// How many bits further right fraction and exponent are in a double than in a single.
pub(super) const SHIFT: u32 = 3;
/// Upper words of the smallest and the largest single as doubles.
const SMALLEST_UPPER: u32 = (SMALLEST >> SHIFT) + REBIAS;
const LARGEST_UPPER: u32 = (LARGEST >> SHIFT) + REBIAS;
/// Lower word of the largest single as a double.
const LARGEST_LOWER: u32 = LARGEST << (32 - SHIFT);

/// The exact value of a single. Exponent 0 means zero, and exponent 255 is an ordinary exponent.
#[inline]
#[must_use]
pub fn to_f64(x: u32) -> f64 {
    let shifted = (x as i32 >> SHIFT) as u32 & (SIGN | MAGNITUDE >> SHIFT);
    let upper = shifted.wrapping_add(REBIAS);
    let lower = x << (32 - SHIFT);
    let not_zero = mask(x & EXPONENT != 0);
    f64::from_bits(u64::from(upper & not_zero) << 32 | u64::from(lower & not_zero))
}

/// The nearest single to `value` toward zero. Values above the largest single give the largest,
/// values below the smallest give +0. An infinity or a NaN gives the largest with its sign.
#[inline]
#[must_use]
pub fn from_f64(value: f64) -> u32 {
    let bits = value.to_bits();
    narrow((bits >> 32) as u32, bits as u32)
}

/// [`from_f64`] on the double's two words.
#[inline]
const fn narrow(upper: u32, lower: u32) -> u32 {
    let magnitude = upper & MAGNITUDE;
    let fits = magnitude.wrapping_sub(REBIAS) << SHIFT | lower >> (32 - SHIFT);
    // Both are below 2^31, so signed compares order them correctly. Every host has those for
    // lanes.
    let above = mask(magnitude as i32 > LARGEST_UPPER as i32);
    let below = mask((magnitude as i32) < SMALLEST_UPPER as i32);
    (upper & SIGN | (fits | above) & MAGNITUDE) & !below
}

/// Whether IEEE arithmetic would interpret the operand or result differently.
#[inline]
const fn differs_from_ieee(x: u32) -> bool {
    let exponent = x & EXPONENT;
    (exponent == EXPONENT) | (exponent == 0) & (x & MAGNITUDE != 0)
}

/// The result and the flags of an operation in each of `N` lanes.
pub type Lanes<const N: usize> = ([u32; N], [Flags; N]);

/// Converts doubles that hold the exact results truncated to 53 bits. `inexact` is whether that
/// truncation dropped anything. The flags do not include a `DIFFERENT` that the operands cause.
#[inline]
pub(super) fn finish<const N: usize>(truncated: [f64; N], inexact: [bool; N]) -> Lanes<N> {
    let upper = truncated.map(|value| (value.to_bits() >> 32) as u32);
    let lower = truncated.map(|value| value.to_bits() as u32);
    let results: [u32; N] = from_fn(|n| narrow(upper[n], lower[n]));
    let flags = from_fn(|n| {
        let magnitude = upper[n] & MAGNITUDE;
        let largest = results[n] & MAGNITUDE == LARGEST;
        let beyond = (magnitude != LARGEST_UPPER) | (lower[n] != LARGEST_LOWER) | inexact[n];
        let overflow = largest & beyond;
        // Nonzero values are so large that their upper word is never 0.
        let underflow = ((magnitude as i32) < SMALLEST_UPPER as i32) & (magnitude != 0);
        Flags::OVERFLOW.when(overflow)
            | Flags::UNDERFLOW.when(underflow)
            | Flags::DIFFERENT.when(underflow | differs_from_ieee(results[n]))
    });
    (results, flags)
}

/// Sums, truncated to 53 bits and then finished.
#[inline]
fn sum<const N: usize>(x: [f64; N], y: [f64; N]) -> Lanes<N> {
    let rounded: [f64; N] = from_fn(|n| x[n] + y[n]);
    let error: [f64; N] = from_fn(|n| {
        let y_part = rounded[n] - x[n];
        (x[n] - (rounded[n] - y_part)) + (y[n] - y_part)
    });
    let truncated = from_fn(|n| {
        let bits = rounded[n].to_bits();
        let opposite = (bits ^ error[n].to_bits()) >> 63;
        let inexact = u64::from(error[n] != 0.0);
        f64::from_bits(bits - (opposite & inexact))
    });
    finish(truncated, error.map(|error| error != 0.0))
}

#[inline]
fn also_different<const N: usize>((results, flags): Lanes<N>, operands: [u32; N]) -> Lanes<N> {
    let different = operands.map(|x| Flags::DIFFERENT.when(differs_from_ieee(x)));
    (results, from_fn(|n| flags[n] | different[n]))
}

#[inline]
fn negated<const N: usize>(x: [u32; N]) -> [u32; N] {
    x.map(|x| x ^ SIGN)
}

/// [`fa`] in `N` lanes, with its exceptions.
#[inline]
#[must_use]
pub fn fa_lanes<const N: usize>(a: [u32; N], b: [u32; N]) -> Lanes<N> {
    let sum = sum(a.map(to_f64), b.map(to_f64));
    also_different(also_different(sum, a), b)
}

/// [`fs`] in `N` lanes, with its exceptions.
#[inline]
#[must_use]
pub fn fs_lanes<const N: usize>(a: [u32; N], b: [u32; N]) -> Lanes<N> {
    fa_lanes(a, negated(b))
}

#[inline]
fn exact_products<const N: usize>(a: [u32; N], b: [u32; N]) -> [f64; N] {
    from_fn(|n| to_f64(a[n]) * to_f64(b[n]))
}

/// [`fm`] in `N` lanes, with its exceptions.
#[inline]
#[must_use]
pub fn fm_lanes<const N: usize>(a: [u32; N], b: [u32; N]) -> Lanes<N> {
    let products = finish(exact_products(a, b), [false; N]);
    also_different(also_different(products, a), b)
}

/// [`fma`] in `N` lanes, with its exceptions.
#[inline]
#[must_use]
pub fn fma_lanes<const N: usize>(a: [u32; N], b: [u32; N], c: [u32; N]) -> Lanes<N> {
    let sum = sum(exact_products(a, b), c.map(to_f64));
    also_different(also_different(also_different(sum, a), b), c)
}

/// [`fms`] in `N` lanes, with its exceptions.
#[inline]
#[must_use]
pub fn fms_lanes<const N: usize>(a: [u32; N], b: [u32; N], c: [u32; N]) -> Lanes<N> {
    fma_lanes(a, b, negated(c))
}

/// [`fnms`] in `N` lanes, with its exceptions.
#[inline]
#[must_use]
pub fn fnms_lanes<const N: usize>(a: [u32; N], b: [u32; N], c: [u32; N]) -> Lanes<N> {
    fma_lanes(negated(a), b, c)
}

/// `a + b`
#[inline]
#[must_use]
pub fn fa(a: u32, b: u32) -> u32 {
    fa_lanes([a], [b]).0[0]
}

/// `a - b`
#[inline]
#[must_use]
pub fn fs(a: u32, b: u32) -> u32 {
    fs_lanes([a], [b]).0[0]
}

/// `a * b`
#[inline]
#[must_use]
pub fn fm(a: u32, b: u32) -> u32 {
    fm_lanes([a], [b]).0[0]
}

/// `a * b + c`, truncated once.
#[inline]
#[must_use]
pub fn fma(a: u32, b: u32, c: u32) -> u32 {
    fma_lanes([a], [b], [c]).0[0]
}

/// `a * b - c`, truncated once.
#[inline]
#[must_use]
pub fn fms(a: u32, b: u32, c: u32) -> u32 {
    fms_lanes([a], [b], [c]).0[0]
}

/// `c - a * b`, truncated once.
#[inline]
#[must_use]
pub fn fnms(a: u32, b: u32, c: u32) -> u32 {
    fnms_lanes([a], [b], [c]).0[0]
}

/// An integer with the same order as the single. All zeros map to 0.
#[inline]
const fn order(x: u32) -> i32 {
    let magnitude = (x & MAGNITUDE) as i32;
    if x & EXPONENT == 0 {
        0
    } else if x & SIGN == 0 {
        magnitude
    } else {
        -magnitude
    }
}

#[inline]
pub(super) const fn mask(condition: bool) -> u32 {
    (condition as u32).wrapping_neg()
}

/// All ones if `a == b`, else 0.
#[inline]
#[must_use]
pub fn fceq(a: u32, b: u32) -> u32 {
    mask(order(a) == order(b))
}

/// All ones if `a > b`, else 0.
#[inline]
#[must_use]
pub fn fcgt(a: u32, b: u32) -> u32 {
    mask(order(a) > order(b))
}

/// All ones if `|a| == |b|`, else 0.
#[inline]
#[must_use]
pub fn fcmeq(a: u32, b: u32) -> u32 {
    fceq(a & MAGNITUDE, b & MAGNITUDE)
}

/// All ones if `|a| > |b|`, else 0.
#[inline]
#[must_use]
pub fn fcmgt(a: u32, b: u32) -> u32 {
    fcgt(a & MAGNITUDE, b & MAGNITUDE)
}
