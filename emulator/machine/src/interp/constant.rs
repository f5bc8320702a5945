//! Constants.

use super::quad::Quad;
use super::spu::Spu;
use spu_isa::Instruction;

/// The low half of the immediate, in both halves of a word.
#[inline]
const fn both_halves(i: Instruction) -> u32 {
    (i.immediate as u32 & 0xffff) * 0x0001_0001
}

#[inline]
pub(super) fn il(spu: &mut Spu, i: Instruction) {
    spu.set_rt(i, Quad::splat(i.immediate as u32));
}

#[inline]
pub(super) fn ilh(spu: &mut Spu, i: Instruction) {
    spu.set_rt(i, Quad::splat(both_halves(i)));
}

#[inline]
pub(super) fn ilhu(spu: &mut Spu, i: Instruction) {
    spu.set_rt(i, Quad::splat((i.immediate as u32) << 16));
}

#[inline]
pub(super) fn iohl(spu: &mut Spu, i: Instruction) {
    let lower = i.immediate as u32 & 0xffff;
    spu.set_rt(i, Quad(spu.rt(i).0.map(|word| word | lower)));
}

#[inline]
pub(super) fn ila(spu: &mut Spu, i: Instruction) {
    spu.set_rt(i, Quad::splat(i.immediate as u32));
}

#[inline]
pub(super) fn fsmbi(spu: &mut Spu, i: Instruction) {
    spu.set_rt(i, super::integer::spread_over_bytes(i.immediate as u32));
}
