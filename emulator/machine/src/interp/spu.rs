//! The SPU's state.

use super::cache::DecodeCache;
use super::flow::code_address;
use super::quad::Quad;
use crate::channel::Channels;
use crate::float::fpscr::Fpscr;
use crate::local_store::SIZE;
use spu_isa::{Instruction, Op};

const QUADWORD: u32 = 16;

/// A load or store of an instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QuadwordAccess {
    /// The quadword's address in local store.
    pub address: u32,
    /// Whether it is stored.
    pub is_store: bool,
}

/// One SPU, without the units that serve its channels.
///
/// Registers, program counter, FPSCR and interrupt state start as 0.
pub struct Spu {
    /// The general registers.
    pub registers: [Quad; 128],
    /// The floating-point status and control register.
    pub fpscr: Fpscr,
    pub(super) pc: u32,
    pub(super) interrupts_enabled: bool,
    pub(crate) executed: u64,
    pub(super) decoded: DecodeCache,
}

impl Default for Spu {
    fn default() -> Self {
        Self::new()
    }
}

impl Spu {
    /// The SPU of the Cell.
    #[must_use]
    pub fn new() -> Self {
        Self::with_cache(DecodeCache::new(false))
    }

    /// An SPU that also has the instructions of the double-precision extension.
    #[must_use]
    pub fn with_double_extension() -> Self {
        Self::with_cache(DecodeCache::new(true))
    }

    fn with_cache(decoded: DecodeCache) -> Self {
        Self {
            registers: [Quad::ZERO; 128],
            fpscr: Fpscr::default(),
            pc: 0,
            interrupts_enabled: false,
            executed: 0,
            decoded,
        }
    }

    /// A register's value. Only the low seven bits of the number are used.
    #[inline]
    #[must_use]
    pub fn register(&self, number: u8) -> Quad {
        self.registers[usize::from(number & 127)]
    }

    /// Sets a register. Only the low seven bits of the number are used.
    #[inline]
    pub fn set_register(&mut self, number: u8, value: Quad) {
        self.registers[usize::from(number & 127)] = value;
    }

    /// Address of the next instruction.
    #[must_use]
    pub const fn pc(&self) -> u32 {
        self.pc
    }

    /// Sets the address of the next instruction. The address wraps at the end of local store, and
    /// its two low bits are dropped.
    pub fn set_pc(&mut self, address: u32) {
        self.pc = code_address(address);
    }

    /// Whether the external condition can interrupt the program.
    #[must_use]
    pub const fn interrupts_enabled(&self) -> bool {
        self.interrupts_enabled
    }

    /// Enables or disables interrupts, and informs the channels.
    pub fn set_interrupts_enabled(&mut self, enabled: bool, channels: &mut impl Channels) {
        self.interrupts_enabled = enabled;
        channels.set_interrupts_enabled(enabled);
    }

    /// The quadword of local store that this instruction, at the program counter, loads or stores.
    #[inline]
    #[must_use]
    pub fn access(&self, i: Instruction) -> Option<QuadwordAccess> {
        let preferred = |register| self.register(register).preferred();
        let (address, is_store) = match i.op {
            Op::Lqd | Op::Stqd => {
                (preferred(i.ra).wrapping_add_signed(i.immediate), i.op == Op::Stqd)
            }
            Op::Lqx | Op::Stqx => (preferred(i.ra).wrapping_add(preferred(i.rb)), i.op == Op::Stqx),
            Op::Lqr | Op::Stqr => (self.pc.wrapping_add_signed(i.immediate), i.op == Op::Stqr),
            Op::Lqa | Op::Stqa => (i.immediate as u32, i.op == Op::Stqa),
            _ => return None,
        };
        let address = address & (SIZE - QUADWORD);
        Some(QuadwordAccess { address, is_store })
    }

    /// How many instructions have run since the SPU was created. The instruction that stopped the
    /// SPU counts too, unless it was invalid or is to be run again.
    #[must_use]
    pub const fn executed(&self) -> u64 {
        self.executed
    }
}
