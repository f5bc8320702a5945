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

/// Unpacks the operands, and raises the flags that they raise in every operation.
fn operand(format: Format, bits: u64, flags: &mut Flags) -> Value {
    let value = unpack(format, bits, flags);
    if let Value::Nan { signalling } = value {
        *flags |= Flags::DOUBLE_NAN | Flags::DOUBLE_INVALID.when(signalling);
    }
    value
}

const fn infinity(negative: bool) -> (u64, Flags) {
    (DOUBLE.infinity(negative), Flags::NONE)
}

const fn zero(negative: bool) -> (u64, Flags) {
    (DOUBLE.signed(negative, 0), Flags::NONE)
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

/// `x + y`, rounded once.
fn sum(x: Value, y: Value, rounding: Rounding) -> (u64, Flags) {
    use Value::{Finite, Infinity, Nan, Zero};
    // An exact zero is negative only if both terms are, or if the mode rounds down.
    let cancelled = zero(rounding == Rounding::Down);
    match (x, y) {
        (Nan { .. }, _) | (_, Nan { .. }) => (DEFAULT_NAN, Flags::NONE),
        (Infinity { negative: x }, Infinity { negative: y }) if x != y => INVALID,
        (Infinity { negative }, _) | (_, Infinity { negative }) => infinity(negative),
        (Zero { negative: x }, Zero { negative: y }) if x == y => zero(x),
        (Zero { .. }, Zero { .. }) => cancelled,
        (Zero { .. }, Finite(number)) | (Finite(number), Zero { .. }) => {
            number.round(DOUBLE, rounding)
        }
        (Finite(x), Finite(y)) => match x.plus(y) {
            Some(sum) => sum.round(DOUBLE, rounding),
            None => cancelled,
        },
    }
}

fn negated(value: u64) -> u64 {
    if value == DEFAULT_NAN { value } else { value ^ SIGN }
}

fn raise((value, raised): (u64, Flags), flags: Flags) -> (u64, Flags) {
    (value, raised | flags)
}

/// `a + b`
#[must_use]
pub fn dfa(a: u64, b: u64, rounding: Rounding) -> (u64, Flags) {
    if rounding == Rounding::NearestEven
        && let Some(sum) = host_double::sum(a, b)
    {
        return sum;
    }
    let mut flags = Flags::NONE;
    let a = operand(DOUBLE, a, &mut flags);
    let b = operand(DOUBLE, b, &mut flags);
    raise(sum(a, b, rounding), flags)
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
    let mut flags = Flags::NONE;
    let a = operand(DOUBLE, a, &mut flags);
    let b = operand(DOUBLE, b, &mut flags);
    let result = match product(a, b) {
        None => INVALID,
        Some(Value::Nan { .. }) => (DEFAULT_NAN, Flags::NONE),
        Some(Value::Infinity { negative }) => infinity(negative),
        Some(Value::Zero { negative }) => zero(negative),
        Some(Value::Finite(number)) => number.round(DOUBLE, rounding),
    };
    raise(result, flags)
}

/// `a * b + t`
#[must_use]
pub fn dfma(a: u64, b: u64, t: u64, rounding: Rounding) -> (u64, Flags) {
    if rounding == Rounding::NearestEven
        && let Some(fused) = host_double::fused(a, b, t)
    {
        return fused;
    }
    let mut flags = Flags::NONE;
    let a = operand(DOUBLE, a, &mut flags);
    let b = operand(DOUBLE, b, &mut flags);
    let t = operand(DOUBLE, t, &mut flags);
    let result = match product(a, b) {
        None => INVALID,
        Some(product) => sum(product, t, rounding),
    };
    raise(result, flags)
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
    let mut flags = Flags::NONE;
    let result = match operand(SINGLE, u64::from(single), &mut flags) {
        Value::Nan { .. } => (DEFAULT_NAN, Flags::NONE),
        Value::Infinity { negative } => infinity(negative),
        Value::Zero { negative } => zero(negative),
        // A double can represent every single, so the rounding mode has no effect.
        Value::Finite(number) => number.round(DOUBLE, Rounding::NearestEven),
    };
    raise(result, flags)
}

/// A double as an IEEE single.
#[must_use]
pub fn frds(double: u64, rounding: Rounding) -> (u32, Flags) {
    let mut flags = Flags::NONE;
    let result = match operand(DOUBLE, double, &mut flags) {
        Value::Nan { .. } => (SINGLE.default_nan(), Flags::NONE),
        Value::Infinity { negative } => (SINGLE.infinity(negative), Flags::NONE),
        Value::Zero { negative } => (SINGLE.signed(negative, 0), Flags::NONE),
        Value::Finite(number) => number.round(SINGLE, rounding),
    };
    let (bits, flags) = raise(result, flags);
    (bits as u32, flags)
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
