//! Where the SPU goes after an instruction.

use crate::stop::{Stop, Stopped};

pub(super) enum Flow {
    /// To the next instruction.
    Next,
    /// To another; the address is masked by whoever makes this.
    Jump(u32),
    /// Nowhere.
    Stop(Stopped),
}

impl Flow {
    /// A stop after an instruction that was completed.
    pub fn stop_after(pc: u32, reason: Stop) -> Self {
        let npc = next(pc);
        Self::Stop(Stopped { reason, pc, npc })
    }
}

/// What most instructions give.
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

/// An address as the SPU fetches from it.
#[inline]
pub(super) const fn code_address(address: u32) -> u32 {
    address & spu_isa::LIMIT_MASK & !3
}
