//! Branches and halts.

use super::flow::{Flow, code_address, next};
use super::quad::Quad;
use super::spu::Spu;
use crate::channel::Channels;
use crate::stop::Stop;
use spu_isa::{Instruction, feature};

#[inline]
fn relative(pc: u32, i: Instruction) -> Flow {
    Flow::Jump(code_address(pc.wrapping_add_signed(i.immediate)))
}

#[inline]
fn absolute(i: Instruction) -> Flow {
    Flow::Jump(code_address(i.immediate as u32))
}

#[inline]
fn relative_if(condition: bool, pc: u32, i: Instruction) -> Flow {
    if condition { relative(pc, i) } else { Flow::Next }
}

/// Branches to `target`, and obeys the d and e bits. The architecture does not define both bits at
/// once; here d wins.
#[inline]
fn indirect(spu: &mut Spu, channels: &mut impl Channels, i: Instruction, target: u32) -> Flow {
    if i.immediate & feature::DISABLE != 0 {
        spu.set_interrupts_enabled(false, channels);
    } else if i.immediate & feature::ENABLE != 0 {
        spu.set_interrupts_enabled(true, channels);
    }
    Flow::Jump(code_address(target))
}

#[inline]
fn indirect_if(
    condition: bool,
    spu: &mut Spu,
    channels: &mut impl Channels,
    i: Instruction,
) -> Flow {
    if condition {
        let target = spu.ra(i).preferred();
        indirect(spu, channels, i, target)
    } else {
        Flow::Next
    }
}

#[inline]
fn set_link(spu: &mut Spu, pc: u32, i: Instruction) {
    spu.set_rt(i, Quad::scalar(next(pc)));
}

#[inline]
fn word(spu: &Spu, i: Instruction) -> u32 {
    spu.rt(i).preferred()
}

#[inline]
fn halfword(spu: &Spu, i: Instruction) -> u16 {
    word(spu, i) as u16
}

#[inline]
pub(super) fn br(_: &mut Spu, _: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    relative(pc, i)
}

#[inline]
pub(super) fn bra(_: &mut Spu, _: &mut impl Channels, _: u32, i: Instruction) -> Flow {
    absolute(i)
}

#[inline]
pub(super) fn brsl(spu: &mut Spu, _: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    set_link(spu, pc, i);
    relative(pc, i)
}

#[inline]
pub(super) fn brasl(spu: &mut Spu, _: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    set_link(spu, pc, i);
    absolute(i)
}

#[inline]
pub(super) fn brz(spu: &mut Spu, _: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    relative_if(word(spu, i) == 0, pc, i)
}

#[inline]
pub(super) fn brnz(spu: &mut Spu, _: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    relative_if(word(spu, i) != 0, pc, i)
}

#[inline]
pub(super) fn brhz(spu: &mut Spu, _: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    relative_if(halfword(spu, i) == 0, pc, i)
}

#[inline]
pub(super) fn brhnz(spu: &mut Spu, _: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    relative_if(halfword(spu, i) != 0, pc, i)
}

#[inline]
pub(super) fn bi(spu: &mut Spu, channels: &mut impl Channels, _: u32, i: Instruction) -> Flow {
    indirect_if(true, spu, channels, i)
}

#[inline]
pub(super) fn bisl(spu: &mut Spu, channels: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    let target = spu.ra(i).preferred();
    set_link(spu, pc, i);
    indirect(spu, channels, i, target)
}

#[inline]
pub(super) fn bisled(spu: &mut Spu, channels: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    let target = spu.ra(i).preferred();
    set_link(spu, pc, i);
    if channels.external_condition() { indirect(spu, channels, i, target) } else { Flow::Next }
}

#[inline]
pub(super) fn iret(spu: &mut Spu, channels: &mut impl Channels, _: u32, i: Instruction) -> Flow {
    let target = channels.srr0();
    indirect(spu, channels, i, target)
}

#[inline]
pub(super) fn biz(spu: &mut Spu, channels: &mut impl Channels, _: u32, i: Instruction) -> Flow {
    indirect_if(word(spu, i) == 0, spu, channels, i)
}

#[inline]
pub(super) fn binz(spu: &mut Spu, channels: &mut impl Channels, _: u32, i: Instruction) -> Flow {
    indirect_if(word(spu, i) != 0, spu, channels, i)
}

#[inline]
pub(super) fn bihz(spu: &mut Spu, channels: &mut impl Channels, _: u32, i: Instruction) -> Flow {
    indirect_if(halfword(spu, i) == 0, spu, channels, i)
}

#[inline]
pub(super) fn bihnz(spu: &mut Spu, channels: &mut impl Channels, _: u32, i: Instruction) -> Flow {
    indirect_if(halfword(spu, i) != 0, spu, channels, i)
}

#[inline]
fn halt_if(condition: bool, pc: u32) -> Flow {
    if condition { Flow::stop_after(pc, Stop::Halt) } else { Flow::Next }
}

#[inline]
fn preferred(spu: &Spu, i: Instruction) -> (u32, u32) {
    (spu.ra(i).preferred(), spu.rb(i).preferred())
}

#[inline]
pub(super) fn heq(spu: &mut Spu, _: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    let (a, b) = preferred(spu, i);
    halt_if(a == b, pc)
}

#[inline]
pub(super) fn heqi(spu: &mut Spu, _: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    halt_if(spu.ra(i).preferred() == i.immediate as u32, pc)
}

#[inline]
pub(super) fn hgt(spu: &mut Spu, _: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    let (a, b) = preferred(spu, i);
    halt_if(a as i32 > b as i32, pc)
}

#[inline]
pub(super) fn hgti(spu: &mut Spu, _: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    halt_if(spu.ra(i).preferred() as i32 > i.immediate, pc)
}

#[inline]
pub(super) fn hlgt(spu: &mut Spu, _: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    let (a, b) = preferred(spu, i);
    halt_if(a > b, pc)
}

#[inline]
pub(super) fn hlgti(spu: &mut Spu, _: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    halt_if(spu.ra(i).preferred() > i.immediate as u32, pc)
}
