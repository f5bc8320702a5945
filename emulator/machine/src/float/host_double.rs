//! Double precision by the host's arithmetic, where that gives an SPU's bits and flags: both round
//! to nearest, operands are normal numbers or zeros, and nothing is too large or too small for its
//! rounding error to be a double, too. So the result is inexact unless the error is 0. Functions
//! return `None` for all else.

use super::fpscr::Flags;

/// The exponent fields of operands whose sums are finite.
const LARGEST: u64 = 0x7fd;
/// The smallest exponent field of a product whose error is a double: its last bit is at least
/// 2^-1074.
const SMALLEST_PRODUCT: u64 = 110;

fn field(bits: u64) -> u64 {
    bits >> 52 & 0x7ff
}

fn is_zero(bits: u64) -> bool {
    bits << 1 == 0
}

/// The operand, if it is zero or a normal number that isn't among the largest.
fn ordinary(bits: u64) -> Option<f64> {
    let is_ordinary = (1..=LARGEST).contains(&field(bits)) || is_zero(bits);
    is_ordinary.then(|| f64::from_bits(bits))
}

/// The rounded sum, and its error, exactly.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    let of_a = sum - of_b;
    (sum, (a - of_a) + (b - of_b))
}

/// The rounded product, and its error, exactly.
fn two_product(a: u64, b: u64) -> Option<(f64, f64)> {
    let (x, y) = (ordinary(a)?, ordinary(b)?);
    let product = x * y;
    if is_zero(a) || is_zero(b) {
        return Some((product, 0.0));
    }
    let is_exact = (SMALLEST_PRODUCT..=LARGEST).contains(&field(product.to_bits()));
    is_exact.then(|| (product, x.mul_add(y, -product)))
}

fn result(value: f64, inexact: bool) -> (u64, Flags) {
    (value.to_bits(), Flags::DOUBLE_INEXACT.when(inexact))
}

pub(super) fn sum(a: u64, b: u64) -> Option<(u64, Flags)> {
    let (sum, error) = two_sum(ordinary(a)?, ordinary(b)?);
    Some(result(sum, error != 0.0))
}

pub(super) fn product(a: u64, b: u64) -> Option<(u64, Flags)> {
    let (product, error) = two_product(a, b)?;
    Some(result(product, error != 0.0))
}

/// `a * b + t`
pub(super) fn fused(a: u64, b: u64, t: u64) -> Option<(u64, Flags)> {
    let (product, product_error) = two_product(a, b)?;
    let t = ordinary(t)?;
    let fused = f64::from_bits(a).mul_add(f64::from_bits(b), t);
    // The exact value less the result is rest + sum_error + product_error.
    let (sum, sum_error) = two_sum(product, t);
    let (rest, lost) = two_sum(sum, -fused);
    if lost != 0.0 {
        return None;
    }
    let (rest, error) = two_sum(rest, sum_error);
    let (rest, last) = two_sum(rest, product_error);
    // If `last` isn't zero, rest + last is no double, so it isn't -error.
    Some(result(fused, last != 0.0 || rest != -error))
}
