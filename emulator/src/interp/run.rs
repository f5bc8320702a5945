//! The run loop.

use super::dispatch::execute;
use super::flow::{Flow, next};
use super::spu::Spu;
use crate::channel::Channels;
use crate::local_store::LocalStore;
use crate::stop::{Stop, Stopped};
use spu_isa::Instruction;

/// Watches a program run: traces, memory logs, timing. The unit type watches nothing, and costs
/// nothing.
pub trait Observer {
    /// The instruction at `spu.pc()` is about to run. Not called for an invalid one.
    #[inline]
    fn before_instruction(&mut self, spu: &Spu, instruction: Instruction) {
        let _ = (spu, instruction);
    }

    /// Whether it has to be told of every instruction. Else some may run compiled; it is told of
    /// those that use channels in any case, and of others as it comes.
    #[inline]
    fn wants_all(&self) -> bool {
        true
    }

    /// Some instructions have run compiled.
    #[inline]
    fn after_compiled(&mut self) {}
}

impl Observer for () {
    #[inline]
    fn wants_all(&self) -> bool {
        false
    }
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
        self.run_bounded(local_store, channels, limit, false, observer)
    }

    /// [`run_observed`](Self::run_observed), if so wanted only up to a taken branch.
    pub(crate) fn run_bounded<C: Channels, O: Observer>(
        &mut self,
        local_store: &LocalStore,
        channels: &mut C,
        limit: u64,
        to_branch: bool,
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
            if to_branch {
                break None;
            }
        };
        self.pc = stopped.as_ref().map_or(pc, |stopped| stopped.npc);
        self.executed += limit - left;
        stopped
    }
}
