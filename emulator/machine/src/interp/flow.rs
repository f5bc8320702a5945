//! Where the SPU continues after an instruction.

use crate::stop::{Stop, Stopped};

pub(super) enum Flow {
    /// Continue with the next instruction.
    Next,
    /// Continue at this address, which is already masked.
    Jump(u32),
    /// The SPU stops.
    Stop(Stopped),
}

impl Flow {
    /// A stop after an instruction that has completed.
    pub fn stop_after(pc: u32, reason: Stop) -> Self {
        let npc = next(pc);
        Self::Stop(Stopped { reason, pc, npc })
    }
}

/// Most instructions continue with the next one.
impl From<()> for Flow {
    #[inline]
    fn from((): ()) -> Self {
        Self::Next
    }
}

/// The address of the instruction after the one at `pc`.
#[inline]
pub(crate) const fn next(pc: u32) -> u32 {
    code_address(pc + 4)
}

/// The address as the SPU uses it for fetching.
#[inline]
pub(super) const fn code_address(address: u32) -> u32 {
    address & spu_isa::LIMIT_MASK & !3
}
