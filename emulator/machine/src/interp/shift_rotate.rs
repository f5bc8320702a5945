//! Shifts and rotates.
//!
//! Every count is masked, never checked. Counts beyond the lane's width give zeros (or signs), and
//! the right shifts take the negated count. Lanes are shifted within a type twice as wide, so no
//! count is too large for the host.

use super::spu::Spu;
use spu_isa::Instruction;

#[inline]
const fn left(a: u32, count: u32) -> u32 {
    ((a as u64) << (count & 63)) as u32
}

#[inline]
const fn left_halfword(a: u16, count: u32) -> u16 {
    ((a as u32) << (count & 31)) as u16
}

#[inline]
const fn rotated(a: u32, count: u32) -> u32 {
    a.rotate_left(count & 31)
}

#[inline]
const fn rotated_halfword(a: u16, count: u32) -> u16 {
    a.rotate_left(count & 15)
}

#[inline]
const fn right(a: u32, negated: u32) -> u32 {
    (a as u64 >> (negated.wrapping_neg() & 63)) as u32
}

#[inline]
const fn right_halfword(a: u16, negated: u32) -> u16 {
    (a as u32 >> (negated.wrapping_neg() & 31)) as u16
}

#[inline]
const fn right_signed(a: u32, negated: u32) -> u32 {
    (a as i32 as i64 >> (negated.wrapping_neg() & 63)) as u32
}

#[inline]
const fn right_signed_halfword(a: u16, negated: u32) -> u16 {
    (a as i16 as i32 >> (negated.wrapping_neg() & 31)) as u16
}

instructions! {
    shl(i): word_binary(left);
    shli(i): word_unary(|a| left(a, i.immediate as u32));
    shlh(i): halfword_binary(|a, b| left_halfword(a, b.into()));
    shlhi(i): halfword_unary(|a| left_halfword(a, i.immediate as u32));
    rot(i): word_binary(rotated);
    roti(i): word_unary(|a| rotated(a, i.immediate as u32));
    roth(i): halfword_binary(|a, b| rotated_halfword(a, b.into()));
    rothi(i): halfword_unary(|a| rotated_halfword(a, i.immediate as u32));
    rotm(i): word_binary(right);
    rotmi(i): word_unary(|a| right(a, i.immediate as u32));
    rothm(i): halfword_binary(|a, b| right_halfword(a, b.into()));
    rothmi(i): halfword_unary(|a| right_halfword(a, i.immediate as u32));
    rotma(i): word_binary(right_signed);
    rotmai(i): word_unary(|a| right_signed(a, i.immediate as u32));
    rotmah(i): halfword_binary(|a, b| right_signed_halfword(a, b.into()));
    rotmahi(i): halfword_unary(|a| right_signed_halfword(a, i.immediate as u32));
}

#[inline]
const fn left_bits(a: u128, count: u32) -> u128 {
    a << (count & 7)
}

/// Shifts by up to 31 bytes, in two halves, because counts of the host's shift must be below 128
/// bits. Shifts of 16 bytes and more leave only zeros.
#[inline]
const fn left_bytes(a: u128, count: u32) -> u128 {
    let half = (count & 31) * 4;
    a << half << half
}

#[inline]
const fn rotated_bits(a: u128, count: u32) -> u128 {
    a.rotate_left(count & 7)
}

#[inline]
const fn rotated_bytes(a: u128, count: u32) -> u128 {
    a.rotate_left((count & 15) * 8)
}

#[inline]
const fn right_bits(a: u128, negated: u32) -> u128 {
    a >> (negated.wrapping_neg() & 7)
}

/// As [`left_bytes`].
#[inline]
const fn right_bytes(a: u128, negated: u32) -> u128 {
    let half = (negated.wrapping_neg() & 31) * 4;
    a >> half >> half
}

/// The whole bytes in a count of bits.
#[inline]
const fn bytes_of(bits: u32) -> u32 {
    bits >> 3
}

instructions! {
    shlqbi(i): quadword_by_scalar(left_bits);
    shlqbii(i): quadword_unary(|a| left_bits(a, i.immediate as u32));
    shlqby(i): quadword_by_scalar(left_bytes);
    shlqbyi(i): quadword_unary(|a| left_bytes(a, i.immediate as u32));
    shlqbybi(i): quadword_by_scalar(|a, b| left_bytes(a, bytes_of(b)));
    rotqbi(i): quadword_by_scalar(rotated_bits);
    rotqbii(i): quadword_unary(|a| rotated_bits(a, i.immediate as u32));
    rotqby(i): quadword_by_scalar(rotated_bytes);
    rotqbyi(i): quadword_unary(|a| rotated_bytes(a, i.immediate as u32));
    rotqbybi(i): quadword_by_scalar(|a, b| rotated_bytes(a, bytes_of(b)));
    rotqmbi(i): quadword_by_scalar(right_bits);
    rotqmbii(i): quadword_unary(|a| right_bits(a, i.immediate as u32));
    rotqmby(i): quadword_by_scalar(right_bytes);
    rotqmbyi(i): quadword_unary(|a| right_bytes(a, i.immediate as u32));
    /// The instruction negates the field of bytes, not the count of bits: -12 bits are 2 bytes, not
    /// 1.
    rotqmbybi(i): quadword_by_scalar(|a, b| right_bytes(a, bytes_of(b)));
}
