//! Stops, synchronisation, special-purpose registers.

use super::flow::Flow;
use super::quad::Quad;
use super::spu::Spu;
use crate::stop::Stop;
use spu_isa::Instruction;
use std::sync::atomic::{Ordering, fence};

/// The code that `stopd` reports.
const STOPD_CODE: u16 = 0x3fff;

#[inline]
pub(super) fn stop(_: &mut Spu, pc: u32, i: Instruction) -> Flow {
    Flow::stop_after(pc, Stop::Signal(i.immediate as u16))
}

#[inline]
pub(super) fn stopd(_: &mut Spu, pc: u32, _: Instruction) -> Flow {
    Flow::stop_after(pc, Stop::Signal(STOPD_CODE))
}

/// Fetches always see the newest code, so only the order of memory accesses remains to be kept.
#[inline]
pub(super) fn sync(_: &mut Spu, _: u32, _: Instruction) {
    fence(Ordering::SeqCst);
}

#[inline]
pub(super) fn dsync(_: &mut Spu, _: u32, _: Instruction) {
    fence(Ordering::SeqCst);
}

/// The architecture defines no special-purpose registers. Undefined ones read as 0.
#[inline]
pub(super) fn mfspr(spu: &mut Spu, _: u32, i: Instruction) {
    spu.set_rt(i, Quad::ZERO);
}
