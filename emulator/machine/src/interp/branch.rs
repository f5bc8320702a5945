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

/// Defines instructions, one a line.
macro_rules! branches {
    ($($name:ident($spu:ident, $channels:ident, $pc:ident, $i:ident) => $flow:expr;)*) => {$(
        #[inline]
        pub(super) fn $name(
            $spu: &mut Spu,
            $channels: &mut impl Channels,
            $pc: u32,
            $i: Instruction,
        ) -> Flow {
            $flow
        }
    )*};
}

branches! {
    br(_spu, _channels, pc, i) => relative(pc, i);
    bra(_spu, _channels, _pc, i) => absolute(i);
    brsl(spu, _channels, pc, i) => { set_link(spu, pc, i); relative(pc, i) };
    brasl(spu, _channels, pc, i) => { set_link(spu, pc, i); absolute(i) };
    brz(spu, _channels, pc, i) => relative_if(word(spu, i) == 0, pc, i);
    brnz(spu, _channels, pc, i) => relative_if(word(spu, i) != 0, pc, i);
    brhz(spu, _channels, pc, i) => relative_if(halfword(spu, i) == 0, pc, i);
    brhnz(spu, _channels, pc, i) => relative_if(halfword(spu, i) != 0, pc, i);
    bi(spu, channels, _pc, i) => indirect_if(true, spu, channels, i);
    bisl(spu, channels, pc, i) => {
        let target = spu.ra(i).preferred();
        set_link(spu, pc, i);
        indirect(spu, channels, i, target)
    };
    bisled(spu, channels, pc, i) => {
        let target = spu.ra(i).preferred();
        set_link(spu, pc, i);
        if channels.external_condition() { indirect(spu, channels, i, target) } else { Flow::Next }
    };
    iret(spu, channels, _pc, i) => {
        let target = channels.srr0();
        indirect(spu, channels, i, target)
    };
    biz(spu, channels, _pc, i) => indirect_if(word(spu, i) == 0, spu, channels, i);
    binz(spu, channels, _pc, i) => indirect_if(word(spu, i) != 0, spu, channels, i);
    bihz(spu, channels, _pc, i) => indirect_if(halfword(spu, i) == 0, spu, channels, i);
    bihnz(spu, channels, _pc, i) => indirect_if(halfword(spu, i) != 0, spu, channels, i);
}

#[inline]
fn halt_if(condition: bool, pc: u32) -> Flow {
    if condition { Flow::stop_after(pc, Stop::Halt) } else { Flow::Next }
}

#[inline]
fn compare(spu: &Spu, i: Instruction, compare: impl Fn(u32, u32) -> bool) -> bool {
    compare(spu.ra(i).preferred(), spu.rb(i).preferred())
}

branches! {
    heq(spu, _channels, pc, i) => halt_if(compare(spu, i, |a, b| a == b), pc);
    heqi(spu, _channels, pc, i) => halt_if(spu.ra(i).preferred() == i.immediate as u32, pc);
    hgt(spu, _channels, pc, i) => halt_if(compare(spu, i, |a, b| a as i32 > b as i32), pc);
    hgti(spu, _channels, pc, i) => halt_if(spu.ra(i).preferred() as i32 > i.immediate, pc);
    hlgt(spu, _channels, pc, i) => halt_if(compare(spu, i, |a, b| a > b), pc);
    hlgti(spu, _channels, pc, i) => halt_if(spu.ra(i).preferred() > i.immediate as u32, pc);
}
