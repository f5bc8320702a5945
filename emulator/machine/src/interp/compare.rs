//! Integer compares. A lane of the result is all ones if true, all zeros if false.

use super::spu::Spu;
use spu_isa::Instruction;

#[inline]
const fn word(condition: bool) -> u32 {
    (condition as u32).wrapping_neg()
}

#[inline]
const fn halfword(condition: bool) -> u16 {
    (condition as u16).wrapping_neg()
}

#[inline]
const fn byte(condition: bool) -> u8 {
    (condition as u8).wrapping_neg()
}

#[inline]
pub(super) fn ceq(spu: &mut Spu, i: Instruction) {
    spu.word_binary(i, |a, b| word(a == b));
}

#[inline]
pub(super) fn ceqh(spu: &mut Spu, i: Instruction) {
    spu.halfword_binary(i, |a, b| halfword(a == b));
}

#[inline]
pub(super) fn ceqb(spu: &mut Spu, i: Instruction) {
    spu.byte_binary(i, |a, b| byte(a == b));
}

#[inline]
pub(super) fn ceqi(spu: &mut Spu, i: Instruction) {
    spu.word_unary(i, |a| word(a == i.immediate as u32));
}

#[inline]
pub(super) fn ceqhi(spu: &mut Spu, i: Instruction) {
    spu.halfword_unary(i, |a| halfword(a == i.immediate as u16));
}

#[inline]
pub(super) fn ceqbi(spu: &mut Spu, i: Instruction) {
    spu.byte_unary(i, |a| byte(a == i.immediate as u8));
}

#[inline]
pub(super) fn cgt(spu: &mut Spu, i: Instruction) {
    spu.word_binary(i, |a, b| word(a as i32 > b as i32));
}

#[inline]
pub(super) fn cgth(spu: &mut Spu, i: Instruction) {
    spu.halfword_binary(i, |a, b| halfword(a as i16 > b as i16));
}

#[inline]
pub(super) fn cgtb(spu: &mut Spu, i: Instruction) {
    spu.byte_binary(i, |a, b| byte(a as i8 > b as i8));
}

#[inline]
pub(super) fn cgti(spu: &mut Spu, i: Instruction) {
    spu.word_unary(i, |a| word(a as i32 > i.immediate));
}

#[inline]
pub(super) fn cgthi(spu: &mut Spu, i: Instruction) {
    spu.halfword_unary(i, |a| halfword(a as i16 > i.immediate as i16));
}

#[inline]
pub(super) fn cgtbi(spu: &mut Spu, i: Instruction) {
    spu.byte_unary(i, |a| byte(a as i8 > i.immediate as i8));
}

#[inline]
pub(super) fn clgt(spu: &mut Spu, i: Instruction) {
    spu.word_binary(i, |a, b| word(a > b));
}

#[inline]
pub(super) fn clgth(spu: &mut Spu, i: Instruction) {
    spu.halfword_binary(i, |a, b| halfword(a > b));
}

#[inline]
pub(super) fn clgtb(spu: &mut Spu, i: Instruction) {
    spu.byte_binary(i, |a, b| byte(a > b));
}

#[inline]
pub(super) fn clgti(spu: &mut Spu, i: Instruction) {
    spu.word_unary(i, |a| word(a > i.immediate as u32));
}

#[inline]
pub(super) fn clgthi(spu: &mut Spu, i: Instruction) {
    spu.halfword_unary(i, |a| halfword(a > i.immediate as u16));
}

#[inline]
pub(super) fn clgtbi(spu: &mut Spu, i: Instruction) {
    spu.byte_unary(i, |a| byte(a > i.immediate as u8));
}
