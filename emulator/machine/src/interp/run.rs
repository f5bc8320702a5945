//! The run loop.

use super::dispatch::execute;
use super::flow::{Flow, next};
use super::spu::Spu;
use crate::channel::Channels;
use crate::local_store::LocalStore;
use crate::stop::{Stop, Stopped};
use spu_isa::Instruction;

/// Observes a program as it runs: traces, memory logs, timing. The unit type observes nothing and
/// costs nothing.
pub trait Observer {
    /// The instruction at `spu.pc()` is about to run. Not called for an invalid instruction.
    #[inline]
    fn before_instruction(&mut self, spu: &Spu, instruction: Instruction) {
        let _ = (spu, instruction);
    }

    /// Whether it must see every instruction. Otherwise some may run in compiled code, without
    /// [`before_instruction`](Self::before_instruction). It always sees those that use channels,
    /// and those that happen to be interpreted.
    #[inline]
    fn wants_all(&self) -> bool {
        true
    }

    /// Some instructions have run in compiled code.
    #[inline]
    fn after_compiled(&mut self) {}
}

impl Observer for () {
    #[inline]
    fn wants_all(&self) -> bool {
        false
    }
}

/// Why [`Spu::run_decoded`] returned.
pub(crate) enum Ended {
    /// The given number of instructions has run.
    AtLimit,
    /// A branch was taken, and the caller asked to return then.
    Branched,
    /// The SPU has stopped.
    Stopped(Stopped),
    /// The instruction at the program counter was just decoded, and has not run yet.
    Decoded,
}

impl Spu {
    /// Runs until something stops the SPU.
    pub fn run(&mut self, local_store: &LocalStore, channels: &mut impl Channels) -> Stopped {
        loop {
            if let Some(stopped) = self.run_limited(local_store, channels, u64::MAX) {
                return stopped;
            }
        }
    }

    /// Runs one instruction. Returns `None` if the SPU can continue.
    pub fn step(
        &mut self,
        local_store: &LocalStore,
        channels: &mut impl Channels,
    ) -> Option<Stopped> {
        self.run_limited(local_store, channels, 1)
    }

    /// Runs at most `limit` instructions. Returns `None` if the SPU can continue.
    pub fn run_limited(
        &mut self,
        local_store: &LocalStore,
        channels: &mut impl Channels,
        limit: u64,
    ) -> Option<Stopped> {
        self.run_observed(local_store, channels, limit, &mut ())
    }

    /// As [`run_limited`](Self::run_limited), with calls to `observer`.
    pub fn run_observed<C: Channels, O: Observer>(
        &mut self,
        local_store: &LocalStore,
        channels: &mut C,
        limit: u64,
        observer: &mut O,
    ) -> Option<Stopped> {
        let mut left = limit;
        loop {
            let before = self.executed;
            match self.run_decoded(local_store, channels, left, false, observer) {
                Ended::AtLimit | Ended::Branched => return None,
                Ended::Stopped(stopped) => return Some(stopped),
                Ended::Decoded => left -= self.executed - before,
            }
        }
    }

    /// As [`run_observed`](Self::run_observed), but while interrupts are disabled, it returns
    /// before it runs a word that was not decoded yet. Until then it has run only instructions
    /// that were decoded when it began. With `to_branch` it also returns after a taken branch.
    ///
    /// A program should contain only one instance of this loop. With a second one, for another
    /// observer or other channels, the compiler no longer inlines the arithmetic into either, and
    /// the ray tracer takes 1.4 times as long without simulated time.
    pub(crate) fn run_decoded<C: Channels, O: Observer>(
        &mut self,
        local_store: &LocalStore,
        channels: &mut C,
        limit: u64,
        to_branch: bool,
        observer: &mut O,
    ) -> Ended {
        let mut pc = self.pc;
        let mut left = limit;
        let ended = loop {
            if left == 0 {
                break Ended::AtLimit;
            }
            if self.interrupts_enabled && channels.external_condition() {
                channels.set_srr0(pc);
                self.set_interrupts_enabled(false, channels);
                pc = 0;
            }
            self.pc = pc;
            let word = local_store.load_word(pc);
            if !self.decoded.is_current(pc, word) {
                self.decoded.decode(pc, word);
                // With interrupts enabled, a caller that comes back here would request an
                // interrupt twice.
                if !self.interrupts_enabled {
                    break Ended::Decoded;
                }
            }
            let Some(instruction) = self.decoded.latest(pc) else {
                let reason = Stop::InvalidInstruction(word);
                break Ended::Stopped(Stopped { reason, pc, npc: pc });
            };
            observer.before_instruction(self, instruction);
            match execute(self, local_store, channels, pc, instruction) {
                Flow::Next => {
                    left -= 1;
                    pc = next(pc);
                    // At address 0 straight-line code has wrapped around, so it must look for a
                    // stop request too.
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
                    break Ended::Stopped(stopped);
                }
            }
            if channels.stop_requested() {
                let reason = Stop::Requested;
                break Ended::Stopped(Stopped { reason, pc, npc: pc });
            }
            if to_branch {
                break Ended::Branched;
            }
        };
        self.pc = match &ended {
            Ended::Stopped(stopped) => stopped.npc,
            Ended::AtLimit | Ended::Branched | Ended::Decoded => pc,
        };
        self.executed += limit - left;
        ended
    }
}
