//! Loads, stores, and the instructions that generate controls for insertion by `shufb`.
//!
//! Local store masks addresses to its size and to whole quadwords.

use super::quad::Quad;
use super::spu::Spu;
use crate::local_store::LocalStore;
use spu_isa::Instruction;

#[inline]
fn displaced(spu: &Spu, i: Instruction) -> u32 {
    spu.ra(i).preferred().wrapping_add_signed(i.immediate)
}

#[inline]
fn indexed(spu: &Spu, i: Instruction) -> u32 {
    let (a, b) = (spu.ra(i), spu.rb(i));
    a.preferred().wrapping_add(b.preferred())
}

#[inline]
fn relative(pc: u32, i: Instruction) -> u32 {
    pc.wrapping_add_signed(i.immediate)
}

#[inline]
fn load(spu: &mut Spu, ls: &LocalStore, i: Instruction, address: u32) {
    spu.set_rt(i, Quad(ls.load_quadword(address)));
}

#[inline]
fn store(spu: &Spu, ls: &LocalStore, i: Instruction, address: u32) {
    ls.store_quadword(address, spu.rt(i).0);
}

/// Defines instructions, one a line.
macro_rules! accesses {
    ($($name:ident($spu:ident, $ls:ident, $pc:ident, $i:ident) => $effect:expr;)*) => {$(
        #[inline]
        pub(super) fn $name($spu: &mut Spu, $ls: &LocalStore, $pc: u32, $i: Instruction) {
            $effect;
        }
    )*};
}

accesses! {
    lqd(spu, ls, _pc, i) => { let address = displaced(spu, i); load(spu, ls, i, address); };
    lqx(spu, ls, _pc, i) => { let address = indexed(spu, i); load(spu, ls, i, address); };
    lqa(spu, ls, _pc, i) => load(spu, ls, i, i.immediate as u32);
    lqr(spu, ls, pc, i) => load(spu, ls, i, relative(pc, i));
    stqd(spu, ls, _pc, i) => store(spu, ls, i, displaced(spu, i));
    stqx(spu, ls, _pc, i) => store(spu, ls, i, indexed(spu, i));
    stqa(spu, ls, _pc, i) => store(spu, ls, i, i.immediate as u32);
    stqr(spu, ls, pc, i) => store(spu, ls, i, relative(pc, i));
}

/// A `shufb` control that keeps rb's bytes except the `size` bytes at `address`. Those come from
/// the position in ra where a scalar of that size is kept.
#[inline]
fn insertion(address: u32, size: u32) -> Quad {
    const KEEP: u128 = 0x1011_1213_1415_1617_1819_1a1b_1c1d_1e1f;
    const SCALAR: u64 = 0x0001_0203_0405_0607;
    // A doubleword scalar is in bytes 0-7 of its register. A smaller scalar ends at byte 3.
    let (scalar, ones) = match size {
        8 => (SCALAR, u64::MAX),
        _ => {
            let ones = u64::MAX >> (64 - 8 * size);
            (SCALAR >> 32 & ones, ones)
        }
    };
    let first = address & (16 - size);
    let shift = 8 * (16 - size - first);
    Quad::from_u128(KEEP & !(u128::from(ones) << shift) | u128::from(scalar) << shift)
}

accesses! {
    cbd(spu, _ls, _pc, i) => spu.set_rt(i, insertion(displaced(spu, i), 1));
    chd(spu, _ls, _pc, i) => spu.set_rt(i, insertion(displaced(spu, i), 2));
    cwd(spu, _ls, _pc, i) => spu.set_rt(i, insertion(displaced(spu, i), 4));
    cdd(spu, _ls, _pc, i) => spu.set_rt(i, insertion(displaced(spu, i), 8));
    cbx(spu, _ls, _pc, i) => spu.set_rt(i, insertion(indexed(spu, i), 1));
    chx(spu, _ls, _pc, i) => spu.set_rt(i, insertion(indexed(spu, i), 2));
    cwx(spu, _ls, _pc, i) => spu.set_rt(i, insertion(indexed(spu, i), 4));
    cdx(spu, _ls, _pc, i) => spu.set_rt(i, insertion(indexed(spu, i), 8));
}
