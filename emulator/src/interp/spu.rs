//! The SPU's state.

use super::cache::DecodeCache;
use super::flow::code_address;
use super::quad::Quad;
use crate::channel::Channels;
use crate::float::fpscr::Fpscr;

/// One SPU, without the units behind its channels.
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

    /// How many instructions have run since the SPU was created. The instruction that stopped the
    /// SPU counts too, unless it was invalid or is to be run again.
    #[must_use]
    pub const fn executed(&self) -> u64 {
        self.executed
    }
}
