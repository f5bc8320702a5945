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

/// Why [`Spu::run_spell`] has ended.
pub(crate) enum Ended {
    /// So many instructions have run.
    AtLimit,
    /// A branch was taken, and this was wanted.
    Branched,
    /// The SPU has stopped.
    Stopped(Stopped),
    /// The instruction at the program counter was decoded, and has not run yet.
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
        let mut left = limit;
        loop {
            let before = self.executed;
            match self.run_spell(local_store, channels, left, false, observer) {
                Ended::AtLimit | Ended::Branched => return None,
                Ended::Stopped(stopped) => return Some(stopped),
                Ended::Decoded => left -= self.executed - before,
            }
        }
    }

    /// Like [`run_observed`](Self::run_observed), but ends when it comes to a word that was not
    /// yet decoded, before it runs, if interrupts are not enabled. Up to there it has run what was
    /// decoded when it began. If so wanted it also ends behind a taken branch.
    ///
    /// This loop is to exist once in a program: beside a second one, for another observer or other
    /// channels, the compiler no longer inlines the arithmetic into either, and without simulated
    /// time the tracer takes 1.4 times as long.
    pub(crate) fn run_spell<C: Channels, O: Observer>(
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
                // With interrupts enabled, whoever came here again would ask for one twice.
                if !self.interrupts_enabled {
                    break Ended::Decoded;
                }
            }
            let Some(instruction) = self.decoded.latest(pc) else {
                let reason = Stop::InvalidInstruction(word);
                break Ended::Stopped(Stopped {
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
                    break Ended::Stopped(stopped);
                }
            }
            if channels.stop_requested() {
                let reason = Stop::Requested;
                break Ended::Stopped(Stopped {
                    reason,
                    pc,
                    npc: pc,
                });
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
