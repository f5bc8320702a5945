//! The run of an SPU in simulated time.

use std::cell::RefCell;

use super::figures::Method;
use super::scheduler::Actor;
use super::spu_clock::{Begun, SpuClock};
use crate::channel::Channels;
use crate::interp::{Ended, Observer, Spu, ends_block};
use crate::local_store::LocalStore;
use crate::stop::{Stop, Stopped};
use spu_isa::Instruction;

/// Runs an SPU and its clock, block by block.
///
/// First the clock passes the block, then the interpreter runs it. So the clock is correct for a
/// channel instruction, which ends its block. For other instructions the clock is ahead, but they
/// can't observe that: if the local store could change from outside before the block's end, the
/// SPU goes instruction by instruction. It also does so at the start of a run, and while
/// interrupts are enabled, because one may come before any instruction.
pub(crate) struct Timed<'a> {
    clock: &'a RefCell<SpuClock>,
    actor: &'a Actor,
    method: Method,
}

impl<'a> Timed<'a> {
    pub fn new(clock: &'a RefCell<SpuClock>, actor: &'a Actor, method: Method) -> Self {
        Self {
            clock,
            actor,
            method,
        }
    }

    /// Runs at most `limit` instructions, with calls to `observer`. Returns `None` if the SPU can
    /// continue. At an interrupt, the observer sees one instruction that does not run.
    pub fn run<C: Channels, O: Observer>(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        limit: u64,
        observer: &mut O,
    ) -> Option<Stopped> {
        let mut left = limit;
        // The timer decides what the restart costs the first instruction, so time that one by
        // itself.
        let mut by_instruction = true;
        while left > 0 {
            let block = if by_instruction || spu.interrupts_enabled() {
                None
            } else {
                self.begin(spu, local_store, left)
            };
            let Some(block) = block else {
                left -= 1;
                let (instruction, stopped) = self.step(spu, local_store, channels, observer);
                if stopped.is_some() {
                    return stopped;
                }
                by_instruction =
                    self.method == Method::ByInstruction || !instruction.is_some_and(ends_block);
                continue;
            };
            let (start, before) = (spu.pc(), spu.executed());
            let ended = match self.method {
                Method::Checked => {
                    self.run_beside(spu, local_store, channels, block.length, observer)
                }
                _ => spu.run_spell(local_store, channels, block.length, observer),
            };
            let ran = spu.executed() - before;
            left -= ran;
            match ended {
                Ended::AtLimit => {
                    if let Some(hint) = block.hint {
                        self.clock.borrow_mut().hint_target(spu, hint);
                    }
                }
                Ended::Stopped(stopped) => {
                    self.compare(start);
                    return Some(stopped);
                }
                Ended::Decoded => self.clock.borrow_mut().cut_short(block, ran),
            }
            if self.method == Method::Checked && self.compare(start) {
                let pc = spu.pc();
                let reason = Stop::Requested;
                return Some(Stopped {
                    reason,
                    pc,
                    npc: pc,
                });
            }
            // Where SPUs run one at a time, `begin` has already checked that this one may
            // continue.
            if !self.actor.is_serial() {
                self.actor.run_up_to(self.clock.borrow().now());
            }
        }
        None
    }

    #[inline]
    fn begin(&self, spu: &mut Spu, local_store: &LocalStore, left: u64) -> Option<Begun> {
        let may_pass = |clock| !self.actor.is_due(clock) || !self.actor.is_serial();
        let mut clock = self.clock.borrow_mut();
        clock.begin(spu, local_store, left, may_pass)
    }

    /// Shows one instruction to the clock and to `observer`, then runs it.
    fn step<C: Channels, O: Observer>(
        &self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        observer: &mut O,
    ) -> (Option<Instruction>, Option<Stopped>) {
        let word = local_store.load_word(spu.pc());
        let instruction = Instruction::decode(word);
        if let Some(instruction) = instruction {
            let mut clock = self.clock.borrow_mut();
            clock.issue(spu, instruction);
            // The instruction has issued and takes effect next. A load must find the data that has
            // arrived by now.
            self.actor.run_up_to(clock.now());
            drop(clock);
            observer.before_instruction(spu, instruction);
        }
        (instruction, spu.step(local_store, channels))
    }

    /// Runs a block, and shows each instruction to the check's model.
    fn run_beside<C: Channels, O: Observer>(
        &self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        length: u64,
        observer: &mut O,
    ) -> Ended {
        for _ in 0..length {
            if spu.is_decoded(local_store)
                && let Some(instruction) = Instruction::decode(local_store.load_word(spu.pc()))
            {
                self.clock.borrow_mut().issue_beside(spu, instruction);
            }
            match spu.run_spell(local_store, channels, 1, observer) {
                Ended::AtLimit => {}
                ended => return ended,
            }
        }
        Ended::AtLimit
    }

    /// Compares the clock with the check's model. Returns whether they differ.
    fn compare(&self, address: u32) -> bool {
        let mut clock = self.clock.borrow_mut();
        clock.compare(address);
        clock.difference().is_some()
    }
}
