//! Channel instructions.

use super::flow::{Flow, next};
use super::quad::Quad;
use super::spu::Spu;
use crate::channel::Channels;
use crate::stop::{Stop, Stopped};
use spu_isa::Instruction;

/// Stops before an instruction that has had no effect and is to be run again.
#[inline]
fn stop_before(pc: u32, reason: Stop) -> Flow {
    let npc = pc;
    Flow::Stop(Stopped { reason, pc, npc })
}

#[inline]
fn into_rt(spu: &mut Spu, pc: u32, i: Instruction, value: Result<u32, Stop>) -> Flow {
    match value {
        Ok(value) => {
            spu.set_rt(i, Quad::scalar(value));
            Flow::Next
        }
        Err(reason) => stop_before(pc, reason),
    }
}

#[inline]
pub(super) fn rdch(spu: &mut Spu, channels: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    into_rt(spu, pc, i, channels.read(i.ra))
}

#[inline]
pub(super) fn rchcnt(spu: &mut Spu, channels: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    into_rt(spu, pc, i, channels.count(i.ra))
}

#[inline]
pub(super) fn wrch(spu: &mut Spu, channels: &mut impl Channels, pc: u32, i: Instruction) -> Flow {
    match channels.write(i.ra, spu.rt(i).preferred()) {
        Ok(()) => Flow::Next,
        // The MFC checks a command after it was enqueued, so the write itself is complete.
        Err(reason @ Stop::Dma(_)) => {
            let next = next(pc);
            Flow::Stop(Stopped { reason, pc: next, npc: next })
        }
        Err(reason) => stop_before(pc, reason),
    }
}
