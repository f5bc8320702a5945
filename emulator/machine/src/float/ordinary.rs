//! Fast single precision for four lanes of ordinary values.
//!
//! A word is ordinary if it is a zero or has an exponent field of 1 to 254. If all operands and
//! results are ordinary, the host's IEEE arithmetic interprets them as the SPU does, and no
//! exception is raised. Only truncation remains to be done, and for it the rounding errors of the
//! host are computed exactly. A function returns `None` if a lane is not ordinary, and may do so
//! for a few rare lanes that are. The result then has to come from [`super::single`],
//! [`super::estimate`] or [`super::convert`]. If a function returns words, they equal those of the
//! full functions, and no flags are raised.
//!
//! Each step treats its lanes without branches, for the host's vector unit.

use super::convert::power_of_two;
use super::estimate::base_and_part;
use super::sign::any;
use super::single::{EXPONENT, MAGNITUDE, REBIAS, SHIFT, SIGN, SMALLEST, mask};
use std::array::from_fn;
use std::ops::RangeInclusive;

type Words = [u32; 4];

/// The low bits of a double that the truncation to a single drops.
const DROPPED: u64 = (1 << (32 - SHIFT)) - 1;
/// 2^128, the first single that IEEE does not have.
const INFINITY: u32 = EXPONENT;
/// 2^127. For sums below it, no step that computes the rounding error can overflow.
const LARGE: u32 = 0x7f00_0000;
/// Scales at which every nonzero 32-bit integer converts to an ordinary single.
const SCALES: RangeInclusive<i32> = -90..=126;

/// Ones where `x` is in `from..from + count`. It uses a signed compare, because few hosts have
/// unsigned ones for lanes.
#[inline(always)]
const fn within(x: u32, from: u32, count: u32) -> u32 {
    let lowest = i32::MIN as u32;
    let distance = x.wrapping_add(lowest.wrapping_sub(from)) as i32;
    mask(distance < lowest.wrapping_add(count) as i32)
}

/// Ones where the operand is denormal.
#[inline(always)]
const fn denormal(x: u32) -> u32 {
    within(x << 1, 1, (SMALLEST << 1) - 1)
}

/// Ones where a magnitude is not 0.
#[inline(always)]
const fn not_zero(magnitude: u32) -> u32 {
    mask(magnitude as i32 > 0)
}

/// Ones where a magnitude is neither 0 nor in `from..to`.
#[inline(always)]
const fn outside(magnitude: u32, from: u32, to: u32) -> u32 {
    not_zero(magnitude) & !within(magnitude, from, to - from)
}

#[inline(always)]
fn negated(x: Words) -> Words {
    x.map(|x| x ^ SIGN)
}

#[inline(always)]
fn singles(x: Words) -> [f32; 4] {
    x.map(f32::from_bits)
}

/// The operands, converted exactly to doubles.
#[inline(always)]
fn widened(x: Words) -> [f64; 4] {
    x.map(|x| f64::from(f32::from_bits(x)))
}

/// Doubles within the ordinary range as words of singles, truncated.
#[inline(always)]
fn narrowed(x: [f64; 4]) -> Words {
    let truncated = x.map(|x| f64::from_bits(x.to_bits() & !DROPPED));
    truncated.map(|x| (x as f32).to_bits())
}

/// The upper words of doubles, without their signs.
#[inline(always)]
fn magnitudes(x: [f64; 4]) -> Words {
    x.map(|x| (x.to_bits() >> 32) as u32 & MAGNITUDE)
}

/// As [`narrowed`], with every zero as +0. `None` if a result is not ordinary or the operands are
/// `special`. The magnitude of nonzero doubles must be at least 2^-300.
#[inline(always)]
fn finished(x: [f64; 4], special: Words) -> Option<Words> {
    const FROM: u32 = REBIAS + (SMALLEST >> SHIFT);
    const TO: u32 = REBIAS + (INFINITY >> SHIFT);
    let magnitudes = magnitudes(x);
    let special = from_fn(|n| special[n] | outside(magnitudes[n], FROM, TO));
    if any(special) {
        return None;
    }
    let words = narrowed(x);
    Some(from_fn(|n| words[n] & not_zero(magnitudes[n])))
}

/// `a + b`
#[inline(always)]
#[must_use]
pub fn fa(a: Words, b: Words) -> Option<Words> {
    let (x, y) = (singles(a), singles(b));
    let sum: [f32; 4] = from_fn(|n| x[n] + y[n]);
    let error: [f32; 4] = from_fn(|n| {
        let y_part = sum[n] - x[n];
        (x[n] - (sum[n] - y_part)) + (y[n] - y_part)
    });
    // The host rounded away from zero, so go one step back.
    let truncated: Words = from_fn(|n| {
        let sum = sum[n].to_bits();
        let opposite = (sum ^ error[n].to_bits()) >> 31;
        sum.wrapping_sub(opposite & mask(error[n] != 0.0))
    });
    let magnitudes = truncated.map(|x| x & MAGNITUDE);
    let special =
        from_fn(|n| denormal(a[n]) | denormal(b[n]) | outside(magnitudes[n], SMALLEST, LARGE));
    if any(special) {
        return None;
    }
    // A zero from the host may be negative.
    Some(from_fn(|n| truncated[n] & not_zero(magnitudes[n])))
}

/// `a - b`
#[inline(always)]
#[must_use]
pub fn fs(a: Words, b: Words) -> Option<Words> {
    fa(a, negated(b))
}

#[inline(always)]
fn products(a: Words, b: Words) -> [f64; 4] {
    let (x, y) = (widened(a), widened(b));
    from_fn(|n| x[n] * y[n])
}

/// `a * b`
#[inline(always)]
#[must_use]
pub fn fm(a: Words, b: Words) -> Option<Words> {
    finished(products(a, b), from_fn(|n| denormal(a[n]) | denormal(b[n])))
}

/// `a * b + c`, truncated once.
#[inline(always)]
#[must_use]
pub fn fma(a: Words, b: Words, c: Words) -> Option<Words> {
    let (x, y) = (products(a, b), widened(c));
    let sum: [f64; 4] = from_fn(|n| x[n] + y[n]);
    // Truncation corrects the rounding, unless the rounded sum is itself a single.
    let dropped = sum.map(|sum| sum.to_bits() as u32 & DROPPED as u32);
    if any(dropped.map(|bits| mask(bits == 0))) {
        let rounded: Words = from_fn(|n| {
            let inexact = (sum[n] - x[n] != y[n]) | (sum[n] - y[n] != x[n]);
            mask(inexact & (dropped[n] == 0))
        });
        if any(rounded) {
            return None;
        }
    }
    finished(sum, from_fn(|n| denormal(a[n]) | denormal(b[n]) | denormal(c[n])))
}

/// `a * b - c`, truncated once.
#[inline(always)]
#[must_use]
pub fn fms(a: Words, b: Words, c: Words) -> Option<Words> {
    fma(a, b, negated(c))
}

/// `c - a * b`, truncated once.
#[inline(always)]
#[must_use]
pub fn fnms(a: Words, b: Words, c: Words) -> Option<Words> {
    fma(negated(a), b, c)
}

/// The single that an estimate word represents for operand `a`.
#[inline(always)]
#[must_use]
pub fn fi(a: Words, estimate: Words) -> Option<Words> {
    let special: Words = from_fn(|n| {
        let exponent = estimate[n] & EXPONENT;
        let (base, part) = base_and_part(a[n], estimate[n]);
        mask((exponent == 0) | (exponent == EXPONENT) | (part > base))
    });
    let results = from_fn(|n| {
        let (base, part) = base_and_part(a[n], estimate[n]);
        estimate[n] & (SIGN | EXPONENT) | base.wrapping_sub(part) >> 9
    });
    (!any(special)).then_some(results)
}

#[inline(always)]
fn converted(x: [f64; 4], scale: i32) -> Option<Words> {
    SCALES.contains(&scale).then(|| narrowed(x.map(|x| x * power_of_two(-scale))))
}

/// Signed integers divided by 2^scale, truncated.
#[inline(always)]
#[must_use]
pub fn csflt(x: Words, scale: i32) -> Option<Words> {
    converted(x.map(|x| f64::from(x as i32)), scale)
}

/// Unsigned integers divided by 2^scale, truncated.
#[inline(always)]
#[must_use]
pub fn cuflt(x: Words, scale: i32) -> Option<Words> {
    converted(x.map(f64::from), scale)
}
