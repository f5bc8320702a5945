//! The run of one SPU by units and interpreter.

use std::sync::Arc;

use spu_compiler::{Cpu, Exit, MOST_STEPS, Storage, Way};
use spu_isa::LOCAL_STORE_SIZE;

use super::Translations;
use super::check::check;
use super::record::record;
use crate::channel::Channels;
use crate::float::fpscr::Fpscr;
use crate::interp::{Ended, Observer, Spu};
use crate::local_store::LocalStore;
use crate::stop::{Stop, Stopped};

/// So often before it is looked whether another SPE has had it compiled.
const WARM: u8 = 8;
/// A place that is never compiled.
const HOPELESS: u8 = u8::MAX;
/// Instructions that run between two looks whether a stop was requested: some microseconds.
const SLICE: u64 = 20_000;
/// Failures before a unit's share of them counts.
const SOME_FAILURES: u32 = 16;
/// One in so many runs may fail.
const TOLERATED: u32 = 10;

const PLACES: usize = LOCAL_STORE_SIZE as usize / 4;

/// Runs one SPU.
pub struct Runner {
    translations: Arc<Translations>,
    cpu: Cpu,
    /// How often the SPU came to each word of local store by a branch that was interpreted.
    heat: Box<[u8]>,
    /// Failures by unit.
    failures: Vec<u32>,
    /// Instructions that ran compiled.
    compiled: u64,
}

/// What comes next.
enum Turn {
    /// Units, if there is one, else the interpreter.
    Any,
    /// The interpreter, for one instruction.
    Instruction,
    /// The interpreter, up to a taken branch.
    Block,
    Stop(Stopped),
}

fn requested(pc: u32) -> Stopped {
    Stopped {
        reason: Stop::Requested,
        pc,
        npc: pc,
    }
}

/// Interprets at most `limit` instructions, up to a taken branch.
fn interpret<C: Channels, O: Observer>(
    spu: &mut Spu,
    local_store: &LocalStore,
    channels: &mut C,
    limit: u64,
    observer: &mut O,
) -> Option<Stopped> {
    let end = spu.executed().saturating_add(limit);
    loop {
        let left = end - spu.executed();
        match spu.run_spell(local_store, channels, left, true, observer) {
            Ended::AtLimit | Ended::Branched => return None,
            Ended::Stopped(stopped) => return Some(stopped),
            Ended::Decoded => {}
        }
    }
}

impl Runner {
    /// An SPU of the machine that these translations are of.
    #[must_use]
    pub fn new(translations: &Arc<Translations>) -> Self {
        Self {
            cpu: translations.new_cpu(),
            translations: Arc::clone(translations),
            heat: vec![0; PLACES].into_boxed_slice(),
            failures: Vec::new(),
            compiled: 0,
        }
    }

    /// How many instructions have run compiled, and not by the interpreter.
    #[must_use]
    pub fn compiled(&self) -> u64 {
        self.compiled
    }

    /// Runs at most `limit` instructions; `None` if the SPU would go on. It is to be the same
    /// `spu` each time, without the double-precision extension.
    pub fn run<C: Channels>(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        limit: u64,
    ) -> Option<Stopped> {
        self.run_observed(spu, local_store, channels, limit, &mut ())
    }

    /// [`run`](Self::run) under the eyes of an `observer` that does not want all instructions.
    pub fn run_observed<C: Channels, O: Observer>(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        limit: u64,
        observer: &mut O,
    ) -> Option<Stopped> {
        let end = spu.executed().saturating_add(limit);
        let mut turn = Turn::Any;
        loop {
            if let Turn::Stop(stopped) = turn {
                return Some(stopped);
            }
            let left = end - spu.executed();
            if left == 0 {
                return None;
            }
            let compiled = !spu.interrupts_enabled() && self.cpu.has(spu.pc());
            turn = match turn {
                Turn::Any if compiled => {
                    let turn = self.run_compiled(spu, local_store, channels, left);
                    observer.after_compiled();
                    turn
                }
                _ => {
                    let limit = if let Turn::Instruction = turn {
                        1
                    } else {
                        left
                    };
                    let stopped = interpret(spu, local_store, channels, limit, observer);
                    let left = end - spu.executed();
                    match stopped {
                        Some(stopped) => Turn::Stop(stopped),
                        None => self.arrived(spu, local_store, channels, left),
                    }
                }
            };
        }
    }

    /// The interpreter has come to a place where a unit may start.
    fn arrived<C: Channels>(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        left: u64,
    ) -> Turn {
        let pc = spu.pc();
        if self.cpu.has(pc) {
            return Turn::Any;
        }
        let hot = self.translations.hot();
        let heat = &mut self.heat[pc as usize / 4];
        if *heat == HOPELESS {
            return Turn::Any;
        }
        *heat = (*heat + 1).min(hot);
        if *heat == WARM {
            if let Some(unit) = self.translations.find(pc, local_store) {
                self.cpu.install(&unit);
            }
        } else if *heat == hot && left >= MOST_STEPS as u64 {
            *heat = 0;
            let (stopped, trace) = record(&self.cpu, spu, local_store, channels);
            match trace.map(|trace| self.translations.add(trace, Way::Singles)) {
                Some(Some(unit)) => self.cpu.install(&unit),
                Some(None) => self.heat[pc as usize / 4] = HOPELESS,
                None => {}
            }
            if let Some(stopped) = stopped {
                return Turn::Stop(stopped);
            }
        }
        Turn::Any
    }

    fn run_compiled<C: Channels>(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        left: u64,
    ) -> Turn {
        let before = spu.executed();
        let exit = if self.translations.checks() {
            match check(&mut self.cpu, spu, local_store, channels, left) {
                Ok(exit) => exit,
                Err(difference) => {
                    self.translations.report(*difference);
                    return Turn::Stop(requested(spu.pc()));
                }
            }
        } else {
            self.enter(spu, local_store, left.min(SLICE))
        };
        self.compiled += spu.executed() - before;
        if channels.stop_requested() {
            return Turn::Stop(requested(spu.pc()));
        }
        match exit {
            // Either the budget is used up, or it does not suffice for the next unit.
            Exit::Left if self.cpu.has(spu.pc()) && left >= SLICE => Turn::Any,
            Exit::Left if self.cpu.has(spu.pc()) => Turn::Block,
            Exit::Left => {
                let left = left - (spu.executed() - before);
                self.arrived(spu, local_store, channels, left)
            }
            Exit::Interpret => Turn::Instruction,
            Exit::Failed(number) => {
                self.failed(number, local_store);
                Turn::Block
            }
            Exit::Stale(number) => {
                self.stale(number, local_store);
                Turn::Any
            }
        }
    }

    fn enter(&mut self, spu: &mut Spu, local_store: &LocalStore, budget: u64) -> Exit {
        let storage = Storage {
            registers: spu.registers.as_mut_ptr().cast(),
            local_store: local_store.as_ptr(),
        };
        let mut fpscr = spu.fpscr.words();
        // SAFETY: the registers are 128 aligned quadwords that this thread alone reaches, and local
        // store is as large and aligned as it has to be, and may be written as the PPE writes.
        let (exit, pc, executed) =
            unsafe { self.cpu.enter(storage, &mut fpscr, spu.pc(), budget as u32) };
        spu.fpscr = Fpscr::from_words(fpscr);
        spu.set_pc(pc);
        spu.executed += u64::from(executed);
        exit
    }

    /// A unit that fails often is to do its arithmetic the other way.
    fn failed(&mut self, number: u32, local_store: &LocalStore) {
        let at = number as usize;
        if self.failures.len() <= at {
            self.failures.resize(at + 1, 0);
        }
        self.failures[at] += 1;
        let failures = self.failures[at];
        let often = failures.saturating_mul(TOLERATED) > self.cpu.entries(number);
        if failures < SOME_FAILURES || !often {
            return;
        }
        let unit = self.translations.unit(number);
        if !unit.trace().stands_in(|pc| local_store.load_word(pc)) {
            return;
        }
        let other = unit.way().other().filter(|_| unit.floats());
        let other = other.and_then(|way| self.translations.add(unit.trace().clone(), way));
        match other {
            Some(unit) => self.cpu.install(&unit),
            None => self.give_up(unit.start()),
        }
    }

    fn give_up(&mut self, pc: u32) {
        self.cpu.remove(pc);
        self.heat[pc as usize / 4] = HOPELESS;
    }

    /// A unit whose code has changed.
    fn stale(&mut self, number: u32, local_store: &LocalStore) {
        let pc = self.translations.unit(number).start();
        match self.translations.find(pc, local_store) {
            Some(unit) => self.cpu.install(&unit),
            None => {
                self.cpu.remove(pc);
                self.heat[pc as usize / 4] = 0;
            }
        }
    }
}
