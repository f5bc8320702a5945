//! The run of an SPU in simulated time.

use std::cell::RefCell;

use super::figures::Method;
use super::races::Races;
use super::scheduler::Actor;
use super::spu_clock::{SpuClock, TimedBlock};
use crate::channel::Channels;
use crate::compiled::{Dispatch, Runner};
use crate::interp::{Ended, Observer, Spu, ends_block};
use crate::local_store::LocalStore;
use crate::stop::{Stop, Stopped};
use spu_isa::{Class, Instruction, LIMIT_MASK};

fn requested(pc: u32) -> Stopped {
    Stopped { reason: Stop::Requested, pc, npc: pc }
}

/// Runs an SPU and its clock, block by block.
///
/// First the clock passes the block, then the interpreter runs it. So the clock is correct for a
/// channel instruction, which ends its block. For other instructions the clock is ahead, but they
/// can't observe that: if the local store could change from outside before the block's end, the
/// SPU goes instruction by instruction. It also does so at the start of a run, and while
/// interrupts are enabled, because one may come before any instruction.
///
/// Compiled code runs first, and records which way it went; then the clock passes the same blocks.
/// It contains no channel instructions, and it only runs where nothing reaches the local store
/// from outside.
pub(crate) struct Timed<'a> {
    clock: &'a RefCell<SpuClock>,
    races: &'a RefCell<Races>,
    actor: &'a Actor,
    method: Method,
    /// Runs compiled code, if there may be any.
    runner: Option<&'a mut Runner>,
}

impl<'a> Timed<'a> {
    pub fn new(
        (clock, races): (&'a RefCell<SpuClock>, &'a RefCell<Races>),
        actor: &'a Actor,
        method: Method,
        runner: Option<&'a mut Runner>,
    ) -> Self {
        Self {
            clock,
            races,
            actor,
            method,
            runner: runner.filter(|_| method != Method::ByInstruction),
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
        let stopped = self.run_leaving_untimed(spu, local_store, channels, limit, observer);
        self.clock.borrow_mut().time_by_instruction(spu);
        stopped
    }

    /// The same, which may leave instructions whose time has not passed yet.
    fn run_leaving_untimed<C: Channels, O: Observer>(
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
        let mut next = Dispatch::Any;
        while left > 0 {
            self.learn_from_local_store();
            let may_compile = !by_instruction && !spu.interrupts_enabled();
            if may_compile
                && matches!(next, Dispatch::Any)
                && let Some(runner) = &mut self.runner
                && runner.may_enter(spu.pc())
                && !self.actor.is_serial()
                && self.clock.borrow_mut().may_pass(spu.pc())
            {
                let (start, before) = (spu.pc(), spu.executed());
                next = runner.run_timed(spu, local_store, channels, left, self.clock);
                left -= spu.executed() - before;
                observer.after_compiled();
                if let Dispatch::Stop(stopped) = next {
                    return Some(stopped);
                }
                if self.method == Method::Checked && self.compare(start) {
                    return Some(requested(spu.pc()));
                }
                self.actor.run_up_to(self.clock.borrow().now());
                continue;
            }
            next = Dispatch::Any;
            let block = if may_compile { self.begin(spu, local_store, left) } else { None };
            let Some(block) = block else {
                if let Some(runner) = &mut self.runner {
                    runner.end_recording();
                }
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
            let may_race = self.is_at_channel(block.end.wrapping_sub(4) & LIMIT_MASK);
            let ended = match self.method {
                Method::Checked => self.run_with_check(spu, local_store, channels, block, observer),
                _ if may_race => self.run_watched(spu, local_store, channels, block, observer),
                _ => spu.run_decoded(local_store, channels, block.length, false, observer),
            };
            let ran = spu.executed() - before;
            left -= ran;
            match ended {
                Ended::AtLimit | Ended::Branched => {
                    if let Some(hint) = block.hint {
                        let target = spu.register(hint.ra).preferred();
                        self.clock.borrow_mut().hint_target(target);
                    }
                    self.learn(spu, local_store, block);
                }
                Ended::Stopped(stopped) => {
                    self.compare(start);
                    return Some(stopped);
                }
                Ended::Decoded => self.clock.borrow_mut().cut_short(block, ran),
            }
            if self.method == Method::Checked && self.compare(start) {
                return Some(requested(spu.pc()));
            }
            // Where SPUs run one at a time, `begin` has already checked that this one may
            // continue.
            if !self.actor.is_serial() {
                self.actor.run_up_to(self.clock.borrow().now());
            }
        }
        None
    }

    /// A block was interpreted to its end: adds it to a recording, and counts an entry if it ended
    /// with a taken branch.
    #[inline]
    fn learn(&mut self, spu: &Spu, local_store: &LocalStore, timed: TimedBlock) {
        let Some(runner) = &mut self.runner else {
            return;
        };
        if runner.is_recording() {
            let block = self.clock.borrow().block(timed);
            let instructions = block.instructions().skip(timed.ran as usize);
            runner.record_interpreted(instructions, spu.pc(), local_store);
        }
        if timed.end != spu.pc() {
            runner.start_recording_if_hot(spu.pc(), local_store);
        }
    }

    /// Where local store is accessed from outside, a load of the program may show it that commands
    /// are complete.
    #[inline]
    fn learn_from_local_store(&self) {
        if self.actor.is_serial() {
            let mut races = self.races.borrow_mut();
            if races.are_possible() {
                races.learn(self.clock.borrow().now());
            }
        }
    }

    /// If a channel instruction comes next, it is at this address. Returns whether an instruction
    /// before it may race with a command.
    #[inline]
    fn is_at_channel(&self, pc: u32) -> bool {
        let mut races = self.races.borrow_mut();
        if !races.are_watched() {
            return false;
        }
        races.channel_instruction_at(pc);
        races.are_possible()
    }

    /// Runs a block, and looks for races at each load and store.
    fn run_watched<C: Channels, O: Observer>(
        &self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        timed: TimedBlock,
        observer: &mut O,
    ) -> Ended {
        let block = self.clock.borrow().block(timed);
        let mut count = 0;
        for (_, instruction) in block.instructions().skip(timed.ran as usize) {
            if instruction.op.row().class == Class::Ls {
                match spu.run_decoded(local_store, channels, count, false, observer) {
                    Ended::AtLimit => count = 0,
                    ended => return ended,
                }
                self.races.borrow().look(spu, local_store, instruction);
            }
            count += 1;
        }
        spu.run_decoded(local_store, channels, count, false, observer)
    }

    #[inline]
    fn begin(&self, spu: &mut Spu, local_store: &LocalStore, left: u64) -> Option<TimedBlock> {
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
            if self.is_at_channel(spu.pc()) {
                self.races.borrow().look(spu, local_store, instruction);
            }
            observer.before_instruction(spu, instruction);
        }
        (instruction, spu.step(local_store, channels))
    }

    /// Runs a block, and shows each instruction to the check's model.
    fn run_with_check<C: Channels, O: Observer>(
        &self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        timed: TimedBlock,
        observer: &mut O,
    ) -> Ended {
        self.clock.borrow_mut().issue_ran_in_check(timed);
        for _ in 0..timed.length {
            if spu.is_decoded(local_store)
                && let Some(instruction) = Instruction::decode(local_store.load_word(spu.pc()))
            {
                self.clock.borrow_mut().issue_in_check(spu, instruction);
                self.races.borrow().look(spu, local_store, instruction);
            }
            match spu.run_decoded(local_store, channels, 1, false, observer) {
                Ended::AtLimit | Ended::Branched => {}
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
