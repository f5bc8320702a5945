//! Double precision: IEEE arithmetic with four rounding modes, in which denormal operands count as
//! zero.
//!
//! Denormal results are produced. Every NaN result is the default NaN. Functions take and return
//! bit patterns, and also return the flags that the instruction raises in its slice. Compares and
//! `dftsv` belong to the double-precision extension. No text about their flags and denormals was
//! available, so here they treat operands as the other instructions do.

use super::fpscr::{Flags, Rounding};
use super::host_double;
use super::softfloat::{DOUBLE, Format, Number, SINGLE, Value, unpack};
use std::cmp::Ordering;

const SIGN: u64 = 1 << 63;
const DEFAULT_NAN: u64 = DOUBLE.default_nan();

/// An invalid operation on operands that are not NaNs.
const INVALID: (u64, Flags) = (DEFAULT_NAN, Flags::DOUBLE_INVALID);

/// Unpacks an operand, and raises the flags that it raises in every operation.
fn operand(format: Format, bits: u64, flags: &mut Flags) -> Value {
    let value = unpack(format, bits, flags);
    if let Value::Nan { signalling } = value {
        *flags |= Flags::DOUBLE_NAN | Flags::DOUBLE_INVALID.when(signalling);
    }
    value
}

/// Unpacks operands, and rounds their exact result, which is invalid if there is none.
fn operation<const N: usize>(
    operands: [u64; N],
    rounding: Rounding,
    exact: impl FnOnce([Value; N]) -> Option<Value>,
) -> (u64, Flags) {
    let mut flags = Flags::NONE;
    let operands = operands.map(|bits| operand(DOUBLE, bits, &mut flags));
    let result = exact(operands);
    let (value, raised) = result.map_or(INVALID, |value| value.round(DOUBLE, rounding));
    (value, raised | flags)
}

/// The exact product of two operands, with unlimited range. `None` if the operation is invalid.
fn product(x: Value, y: Value) -> Option<Value> {
    use Value::{Finite, Infinity, Nan, Zero};
    Some(match (x, y) {
        (Nan { signalling }, _) | (_, Nan { signalling }) => Nan { signalling },
        (Infinity { .. }, Zero { .. }) | (Zero { .. }, Infinity { .. }) => return None,
        (Finite(x), Finite(y)) => Finite(x.times(y)),
        (Infinity { negative: x }, other) | (other, Infinity { negative: x }) => {
            Infinity { negative: x != is_negative(other) }
        }
        (Zero { negative: x }, other) | (other, Zero { negative: x }) => {
            Zero { negative: x != is_negative(other) }
        }
    })
}

const fn is_negative(value: Value) -> bool {
    match value {
        Value::Nan { .. } => false,
        Value::Infinity { negative } | Value::Zero { negative } => negative,
        Value::Finite(Number { negative, .. }) => negative,
    }
}

/// The exact `x + y`. `None` if the operation is invalid.
fn sum(x: Value, y: Value, rounding: Rounding) -> Option<Value> {
    use Value::{Finite, Infinity, Nan, Zero};
    // An exact zero is negative only if both terms are, or if the mode rounds down.
    let cancelled = Zero { negative: rounding == Rounding::Down };
    Some(match (x, y) {
        (Nan { signalling }, _) | (_, Nan { signalling }) => Nan { signalling },
        (Infinity { negative: x }, Infinity { negative: y }) if x != y => return None,
        (Infinity { negative }, _) | (_, Infinity { negative }) => Infinity { negative },
        (Zero { negative: x }, Zero { negative: y }) if x == y => Zero { negative: x },
        (Zero { .. }, Zero { .. }) => cancelled,
        (Zero { .. }, Finite(number)) | (Finite(number), Zero { .. }) => Finite(number),
        (Finite(x), Finite(y)) => x.plus(y).map_or(cancelled, Finite),
    })
}

fn negated(value: u64) -> u64 {
    if value == DEFAULT_NAN { value } else { value ^ SIGN }
}

/// `a + b`
#[must_use]
pub fn dfa(a: u64, b: u64, rounding: Rounding) -> (u64, Flags) {
    if rounding == Rounding::NearestEven
        && let Some(sum) = host_double::sum(a, b)
    {
        return sum;
    }
    operation([a, b], rounding, |[a, b]| sum(a, b, rounding))
}

/// `a - b`
#[must_use]
pub fn dfs(a: u64, b: u64, rounding: Rounding) -> (u64, Flags) {
    dfa(a, b ^ SIGN, rounding)
}

/// `a * b`
#[must_use]
pub fn dfm(a: u64, b: u64, rounding: Rounding) -> (u64, Flags) {
    if rounding == Rounding::NearestEven
        && let Some(product) = host_double::product(a, b)
    {
        return product;
    }
    operation([a, b], rounding, |[a, b]| product(a, b))
}

/// `a * b + t`
#[must_use]
pub fn dfma(a: u64, b: u64, t: u64, rounding: Rounding) -> (u64, Flags) {
    if rounding == Rounding::NearestEven
        && let Some(fused) = host_double::fused(a, b, t)
    {
        return fused;
    }
    operation([a, b, t], rounding, |[a, b, t]| sum(product(a, b)?, t, rounding))
}

/// `a * b - t`
#[must_use]
pub fn dfms(a: u64, b: u64, t: u64, rounding: Rounding) -> (u64, Flags) {
    dfma(a, b, t ^ SIGN, rounding)
}

/// `-(a * b - t)`. The sign changes after rounding.
#[must_use]
pub fn dfnms(a: u64, b: u64, t: u64, rounding: Rounding) -> (u64, Flags) {
    let (value, flags) = dfms(a, b, t, rounding);
    (negated(value), flags)
}

/// `-(a * b + t)`. The sign changes after rounding.
#[must_use]
pub fn dfnma(a: u64, b: u64, t: u64, rounding: Rounding) -> (u64, Flags) {
    let (value, flags) = dfma(a, b, t, rounding);
    (negated(value), flags)
}

/// An IEEE single as a double.
#[must_use]
pub fn fesd(single: u32) -> (u64, Flags) {
    // A double can represent every single, so the rounding mode has no effect.
    converted(SINGLE, u64::from(single), DOUBLE, Rounding::NearestEven)
}

/// A double as an IEEE single.
#[must_use]
pub fn frds(double: u64, rounding: Rounding) -> (u32, Flags) {
    let (bits, flags) = converted(DOUBLE, double, SINGLE, rounding);
    (bits as u32, flags)
}

fn converted(from: Format, bits: u64, to: Format, rounding: Rounding) -> (u64, Flags) {
    let mut flags = Flags::NONE;
    let (bits, raised) = operand(from, bits, &mut flags).round(to, rounding);
    (bits, raised | flags)
}

/// The order of two operands. `None` if one is a NaN.
fn compare(a: u64, b: u64) -> (Option<Ordering>, Flags) {
    let mut flags = Flags::NONE;
    let mut order = |bits: u64| match operand(DOUBLE, bits, &mut flags) {
        Value::Nan { .. } => None,
        Value::Zero { .. } => Some(0),
        Value::Infinity { negative } | Value::Finite(Number { negative, .. }) => {
            let magnitude = (bits & !SIGN) as i64;
            Some(if negative { -magnitude } else { magnitude })
        }
    };
    let (a, b) = (order(a), order(b));
    (a.zip(b).map(|(a, b)| a.cmp(&b)), flags)
}

fn mask(condition: bool) -> u64 {
    u64::from(condition).wrapping_neg()
}

/// All ones if `a == b`.
#[must_use]
pub fn dfceq(a: u64, b: u64) -> (u64, Flags) {
    let (order, flags) = compare(a, b);
    (mask(order == Some(Ordering::Equal)), flags)
}

/// All ones if `a > b`.
#[must_use]
pub fn dfcgt(a: u64, b: u64) -> (u64, Flags) {
    let (order, flags) = compare(a, b);
    (mask(order == Some(Ordering::Greater)), flags)
}

/// All ones if `|a| == |b|`.
#[must_use]
pub fn dfcmeq(a: u64, b: u64) -> (u64, Flags) {
    dfceq(a & !SIGN, b & !SIGN)
}

/// All ones if `|a| > |b|`.
#[must_use]
pub fn dfcmgt(a: u64, b: u64) -> (u64, Flags) {
    dfcgt(a & !SIGN, b & !SIGN)
}

/// All ones if the pattern belongs to a class that `classes` selects: 0x40 NaN, 0x20 and 0x10
/// positive and negative infinity, 0x08 and 0x04 positive and negative zero, 0x02 and 0x01
/// positive and negative denormal. Raises no flags.
#[must_use]
pub fn dftsv(bits: u64, classes: u32) -> u64 {
    let magnitude = bits & !SIGN;
    let positive_class = if magnitude > DOUBLE.infinity(false) {
        return mask(classes & 0x40 != 0);
    } else if magnitude == DOUBLE.infinity(false) {
        0x20
    } else if magnitude == 0 {
        0x08
    } else if magnitude >> DOUBLE.fraction_bits == 0 {
        0x02
    } else {
        0
    };
    let class = positive_class >> (bits >> 63);
    mask(classes & class != 0)
}
