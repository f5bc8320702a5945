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

#[inline]
pub(super) fn shl(spu: &mut Spu, i: Instruction) {
    spu.word_binary(i, left);
}

#[inline]
pub(super) fn shli(spu: &mut Spu, i: Instruction) {
    spu.word_unary(i, |a| left(a, i.immediate as u32));
}

#[inline]
pub(super) fn shlh(spu: &mut Spu, i: Instruction) {
    spu.halfword_binary(i, |a, b| left_halfword(a, b.into()));
}

#[inline]
pub(super) fn shlhi(spu: &mut Spu, i: Instruction) {
    spu.halfword_unary(i, |a| left_halfword(a, i.immediate as u32));
}

#[inline]
pub(super) fn rot(spu: &mut Spu, i: Instruction) {
    spu.word_binary(i, rotated);
}

#[inline]
pub(super) fn roti(spu: &mut Spu, i: Instruction) {
    spu.word_unary(i, |a| rotated(a, i.immediate as u32));
}

#[inline]
pub(super) fn roth(spu: &mut Spu, i: Instruction) {
    spu.halfword_binary(i, |a, b| rotated_halfword(a, b.into()));
}

#[inline]
pub(super) fn rothi(spu: &mut Spu, i: Instruction) {
    spu.halfword_unary(i, |a| rotated_halfword(a, i.immediate as u32));
}

#[inline]
pub(super) fn rotm(spu: &mut Spu, i: Instruction) {
    spu.word_binary(i, right);
}

#[inline]
pub(super) fn rotmi(spu: &mut Spu, i: Instruction) {
    spu.word_unary(i, |a| right(a, i.immediate as u32));
}

#[inline]
pub(super) fn rothm(spu: &mut Spu, i: Instruction) {
    spu.halfword_binary(i, |a, b| right_halfword(a, b.into()));
}

#[inline]
pub(super) fn rothmi(spu: &mut Spu, i: Instruction) {
    spu.halfword_unary(i, |a| right_halfword(a, i.immediate as u32));
}

#[inline]
pub(super) fn rotma(spu: &mut Spu, i: Instruction) {
    spu.word_binary(i, right_signed);
}

#[inline]
pub(super) fn rotmai(spu: &mut Spu, i: Instruction) {
    spu.word_unary(i, |a| right_signed(a, i.immediate as u32));
}

#[inline]
pub(super) fn rotmah(spu: &mut Spu, i: Instruction) {
    spu.halfword_binary(i, |a, b| right_signed_halfword(a, b.into()));
}

#[inline]
pub(super) fn rotmahi(spu: &mut Spu, i: Instruction) {
    spu.halfword_unary(i, |a| right_signed_halfword(a, i.immediate as u32));
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

#[inline]
pub(super) fn shlqbi(spu: &mut Spu, i: Instruction) {
    spu.quadword_by_scalar(i, left_bits);
}

#[inline]
pub(super) fn shlqbii(spu: &mut Spu, i: Instruction) {
    spu.quadword_unary(i, |a| left_bits(a, i.immediate as u32));
}

#[inline]
pub(super) fn shlqby(spu: &mut Spu, i: Instruction) {
    spu.quadword_by_scalar(i, left_bytes);
}

#[inline]
pub(super) fn shlqbyi(spu: &mut Spu, i: Instruction) {
    spu.quadword_unary(i, |a| left_bytes(a, i.immediate as u32));
}

#[inline]
pub(super) fn shlqbybi(spu: &mut Spu, i: Instruction) {
    spu.quadword_by_scalar(i, |a, b| left_bytes(a, bytes_of(b)));
}

#[inline]
pub(super) fn rotqbi(spu: &mut Spu, i: Instruction) {
    spu.quadword_by_scalar(i, rotated_bits);
}

#[inline]
pub(super) fn rotqbii(spu: &mut Spu, i: Instruction) {
    spu.quadword_unary(i, |a| rotated_bits(a, i.immediate as u32));
}

#[inline]
pub(super) fn rotqby(spu: &mut Spu, i: Instruction) {
    spu.quadword_by_scalar(i, rotated_bytes);
}

#[inline]
pub(super) fn rotqbyi(spu: &mut Spu, i: Instruction) {
    spu.quadword_unary(i, |a| rotated_bytes(a, i.immediate as u32));
}

#[inline]
pub(super) fn rotqbybi(spu: &mut Spu, i: Instruction) {
    spu.quadword_by_scalar(i, |a, b| rotated_bytes(a, bytes_of(b)));
}

#[inline]
pub(super) fn rotqmbi(spu: &mut Spu, i: Instruction) {
    spu.quadword_by_scalar(i, right_bits);
}

#[inline]
pub(super) fn rotqmbii(spu: &mut Spu, i: Instruction) {
    spu.quadword_unary(i, |a| right_bits(a, i.immediate as u32));
}

#[inline]
pub(super) fn rotqmby(spu: &mut Spu, i: Instruction) {
    spu.quadword_by_scalar(i, right_bytes);
}

#[inline]
pub(super) fn rotqmbyi(spu: &mut Spu, i: Instruction) {
    spu.quadword_unary(i, |a| right_bytes(a, i.immediate as u32));
}

/// The instruction negates the field of bytes, not the count of bits: -12 bits are 2 bytes, not 1.
#[inline]
pub(super) fn rotqmbybi(spu: &mut Spu, i: Instruction) {
    spu.quadword_by_scalar(i, |a, b| right_bytes(a, bytes_of(b)));
}
