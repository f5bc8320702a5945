//! The SPU's state and its run loop.

use super::cache::DecodeCache;
use super::dispatch::execute;
use super::flow::{Flow, code_address, next};
use super::quad::Quad;
use crate::channel::Channels;
use crate::float::fpscr::Fpscr;
use crate::isa::Instruction;
use crate::local_store::LocalStore;
use crate::stop::{Stop, Stopped};

/// Watches a program run: traces, memory logs, timing. The unit type watches nothing, and costs
/// nothing.
pub trait Observer {
    /// The instruction at `spu.pc()` is about to run. Not called for an invalid one.
    #[inline]
    fn before_instruction(&mut self, spu: &Spu, instruction: Instruction) {
        let _ = (spu, instruction);
    }
}

impl Observer for () {}

/// One SPU without what is behind its channels.
///
/// Registers, program counter, FPSCR and interrupt state start as 0.
pub struct Spu {
    /// The general registers.
    pub registers: [Quad; 128],
    /// The floating-point status and control register.
    pub fpscr: Fpscr,
    pc: u32,
    interrupts_enabled: bool,
    executed: u64,
    decoded: DecodeCache,
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

    /// A register's value; only the low seven bits of the number count.
    #[inline]
    #[must_use]
    pub fn register(&self, number: u8) -> Quad {
        self.registers[usize::from(number & 127)]
    }

    /// Sets a register; only the low seven bits of the number count.
    #[inline]
    pub fn set_register(&mut self, number: u8, value: Quad) {
        self.registers[usize::from(number & 127)] = value;
    }

    /// Address of the next instruction.
    #[must_use]
    pub const fn pc(&self) -> u32 {
        self.pc
    }

    /// Sets the address of the next instruction; it wraps at the end of local store, and its two low
    /// bits are dropped.
    pub fn set_pc(&mut self, address: u32) {
        self.pc = code_address(address);
    }

    /// Whether the external condition interrupts the program.
    #[must_use]
    pub const fn interrupts_enabled(&self) -> bool {
        self.interrupts_enabled
    }

    /// Enables or disables interrupts, and tells the channels so.
    pub fn set_interrupts_enabled(&mut self, enabled: bool, channels: &mut impl Channels) {
        self.interrupts_enabled = enabled;
        channels.set_interrupts_enabled(enabled);
    }

    /// How many instructions were run since the SPU was made, the one that stopped it included
    /// unless it was invalid or is to be run again.
    #[must_use]
    pub const fn executed(&self) -> u64 {
        self.executed
    }

    /// Runs until something stops the SPU.
    pub fn run(&mut self, local_store: &LocalStore, channels: &mut impl Channels) -> Stopped {
        loop {
            if let Some(stopped) = self.run_limited(local_store, channels, u64::MAX) {
                return stopped;
            }
        }
    }

    /// Runs one instruction; `None` if the SPU goes on.
    pub fn step(
        &mut self,
        local_store: &LocalStore,
        channels: &mut impl Channels,
    ) -> Option<Stopped> {
        self.run_limited(local_store, channels, 1)
    }

    /// Runs at most `limit` instructions; `None` if the SPU would go on.
    pub fn run_limited(
        &mut self,
        local_store: &LocalStore,
        channels: &mut impl Channels,
        limit: u64,
    ) -> Option<Stopped> {
        self.run_observed(local_store, channels, limit, &mut ())
    }

    /// [`run_limited`](Self::run_limited) under the eyes of `observer`.
    pub fn run_observed<C: Channels, O: Observer>(
        &mut self,
        local_store: &LocalStore,
        channels: &mut C,
        limit: u64,
        observer: &mut O,
    ) -> Option<Stopped> {
        let mut pc = self.pc;
        let mut left = limit;
        let stopped = loop {
            if left == 0 {
                break None;
            }
            if self.interrupts_enabled && channels.external_condition() {
                channels.set_srr0(pc);
                self.set_interrupts_enabled(false, channels);
                pc = 0;
            }
            self.pc = pc;
            let word = local_store.load_word(pc);
            let Some(instruction) = self.decoded.get(pc, word) else {
                let reason = Stop::InvalidInstruction(word);
                break Some(Stopped {
                    reason,
                    pc,
                    npc: pc,
                });
            };
            observer.before_instruction(self, instruction);
            match execute(self, local_store, channels, pc, instruction) {
                Flow::Next => {
                    left -= 1;
                    pc = next(pc);
                    // Code without a branch comes round too.
                    if pc != 0 {
                        continue;
                    }
                }
                Flow::Jump(target) => {
                    left -= 1;
                    pc = target;
                }
                Flow::Stop(stopped) => {
                    left -= u64::from(stopped.npc != pc);
                    break Some(stopped);
                }
            }
            if channels.stop_requested() {
                let reason = Stop::Requested;
                break Some(Stopped {
                    reason,
                    pc,
                    npc: pc,
                });
            }
        };
        self.pc = stopped.as_ref().map_or(pc, |stopped| stopped.npc);
        self.executed += limit - left;
        stopped
    }
}
