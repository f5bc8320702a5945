//! Constants.

use super::quad::Quad;
use super::spu::Spu;
use spu_isa::Instruction;

/// The low half of the immediate, in both halves of a word.
#[inline]
const fn both_halves(i: Instruction) -> u32 {
    (i.immediate as u32 & 0xffff) * 0x0001_0001
}

instructions! {
    il(i): set_rt(Quad::splat(i.immediate as u32));
    ilh(i): set_rt(Quad::splat(both_halves(i)));
    ilhu(i): set_rt(Quad::splat((i.immediate as u32) << 16));
}

#[inline]
pub(super) fn iohl(spu: &mut Spu, i: Instruction) {
    let lower = i.immediate as u32 & 0xffff;
    spu.set_rt(i, Quad(spu.rt(i).0.map(|word| word | lower)));
}

instructions! {
    ila(i): set_rt(Quad::splat(i.immediate as u32));
    fsmbi(i): set_rt(super::integer::spread_over_bytes(i.immediate as u32));
}
