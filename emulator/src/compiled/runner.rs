//! The run of one SPU by units and interpreter.

use std::cell::RefCell;
use std::sync::Arc;

use spu_compiler::{Cpu, Exit, MOST_STEPS, Passage, Steps, Storage, Trace, Way};
use spu_isa::{Instruction, LOCAL_STORE_SIZE};

use super::Translations;
use super::check::check;
use super::record::{Recorder, record};
use super::specials::Specials;
use super::turn::Turn;
use crate::channel::Channels;
use crate::float::fpscr::Fpscr;
use crate::interp::{Ended, Observer, Spu};
use crate::local_store::LocalStore;
use crate::simulated::{Path, SpuClock};
use crate::stop::{Stop, Stopped};

/// So often before it is looked whether another SPE has had it compiled.
const WARM: u8 = 8;
/// A place that is never compiled.
const HOPELESS: u8 = u8::MAX;
/// Instructions that run between two looks whether a stop was requested: some microseconds.
const SLICE: u64 = 20_000;
/// The same in simulated time, in which others may wait for this SPU's clock.
const TIMED_SLICE: u64 = 4_000;
/// Failures before a unit's share of them counts.
const SOME_FAILURES: u32 = 16;
/// One in so many runs may fail.
const TOLERATED: u32 = 10;

const PLACES: usize = LOCAL_STORE_SIZE as usize / 4;

/// What is known of the failures of a unit.
#[derive(Clone, Default)]
struct Failures {
    count: u32,
    /// The instructions that singles could not carry out.
    special: Steps,
}

/// Runs one SPU.
pub struct Runner {
    translations: Arc<Translations>,
    cpu: Cpu,
    /// How often the SPU came to each word of local store by a branch that was interpreted.
    heat: Box<[u8]>,
    /// Failures by unit.
    failures: Vec<Failures>,
    /// Looks for what made a unit fail.
    specials: Option<Box<Specials>>,
    /// Instructions that ran compiled.
    compiled: u64,
    /// In simulated time: what is being recorded.
    recorder: Option<Recorder>,
    /// In simulated time: the paths through units by their numbers, each with
    /// [`Spu::rewritings`] when it was last compared.
    paths: Vec<Option<(Arc<Path>, u64)>>,
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
            specials: None,
            compiled: 0,
            recorder: None,
            paths: Vec::new(),
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
                    let (turn, exit) = self.run_units(spu, local_store, channels, left.min(SLICE));
                    let left = end - spu.executed();
                    let turn = match exit {
                        Some(Exit::Left) if !self.cpu.has(spu.pc()) => {
                            self.arrived(spu, local_store, channels, left)
                        }
                        _ => turn,
                    };
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

    /// The SPU has come to a place where a unit may start. Whether its way from here is to be
    /// recorded.
    fn is_hot(&mut self, pc: u32, local_store: &LocalStore) -> bool {
        if self.cpu.has(pc) {
            return false;
        }
        let hot = self.translations.hot();
        let heat = &mut self.heat[pc as usize / 4];
        if *heat == HOPELESS {
            return false;
        }
        *heat = (*heat + 1).min(hot);
        if *heat == WARM
            && let Some(unit) = self.translations.find(pc, local_store)
        {
            self.cpu.install(&unit);
            return false;
        }
        let is_hot = *heat == hot;
        if is_hot {
            *heat = 0;
        }
        is_hot
    }

    /// The interpreter has come to a place where a unit may start.
    fn arrived<C: Channels>(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        left: u64,
    ) -> Turn {
        if left >= MOST_STEPS as u64 && self.is_hot(spu.pc(), local_store) {
            let (stopped, trace) = record(&self.cpu, spu, local_store, channels);
            self.compile(trace);
            if let Some(stopped) = stopped {
                return Turn::Stop(stopped);
            }
        }
        Turn::Any
    }

    fn compile(&mut self, trace: Option<Trace>) {
        let Some(trace) = trace else { return };
        let start = trace.start();
        match self.translations.add(trace, Way::SINGLES) {
            Some(unit) => self.cpu.install(&unit),
            None => self.heat[start as usize / 4] = HOPELESS,
        }
    }

    /// Whether a unit starts at `pc`, and no recording goes on.
    #[inline]
    pub(crate) fn has(&self, pc: u32) -> bool {
        self.recorder.is_none() && self.cpu.has(pc)
    }

    /// In simulated time: runs units from where the SPU is, at most `limit` instructions, and lets
    /// their time pass.
    pub(crate) fn run_timed<C: Channels>(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        limit: u64,
        clock: &RefCell<SpuClock>,
    ) -> Turn {
        let limit = limit.min(TIMED_SLICE);
        let (turn, exit) = self.run_units(spu, local_store, channels, limit);
        let mut words = self.cpu.log().iter().copied();
        let clock = &mut *clock.borrow_mut();
        while let Some(word) = words.next() {
            let Passage { unit, count } = Passage::from_word(word);
            let at = unit as usize;
            if self.paths.len() <= at {
                self.paths.resize(at + 1, None);
            }
            let translations = &self.translations;
            let (path, proven) =
                self.paths[at].get_or_insert_with(|| (translations.path(unit), u64::MAX));
            clock.pass(spu, local_store, (&**path, proven), count, &mut words);
        }
        if let Some(Exit::Left) = exit {
            self.come_to(spu.pc(), local_store);
        }
        turn
    }

    /// In simulated time: the SPU has come to `pc` by a branch.
    pub(crate) fn come_to(&mut self, pc: u32, local_store: &LocalStore) {
        if self.recorder.is_none() && self.is_hot(pc, local_store) {
            self.recorder = Some(Recorder::default());
        }
    }

    /// Whether a recording goes on.
    #[inline]
    pub(crate) fn records(&self) -> bool {
        self.recorder.is_some()
    }

    /// In simulated time: the interpreter has run these instructions, each at its address, and the
    /// SPU is now at `next`.
    #[cold]
    pub(crate) fn interpreted(
        &mut self,
        instructions: impl Iterator<Item = (u32, Instruction)>,
        next: u32,
        local_store: &LocalStore,
    ) {
        let Some(recorder) = &mut self.recorder else {
            return;
        };
        let mut instructions = instructions.peekable();
        while let Some((pc, instruction)) = instructions.next() {
            let next = instructions.peek().map_or(next, |&(next, _)| next);
            let word = local_store.load_word(pc);
            let same = Instruction::decode(word) == Some(instruction);
            if !same || !recorder.add(&self.cpu, pc, word, next) {
                return self.end_recording();
            }
        }
        if !recorder.goes_on(&self.cpu, next) {
            self.end_recording();
        }
    }

    /// In simulated time: what the SPU does next is no part of a recording.
    #[inline]
    pub(crate) fn end_recording(&mut self) {
        if let Some(recorder) = self.recorder.take() {
            self.compile(recorder.trace());
        }
    }

    /// Runs units. Gives what comes next, and why they were left, unless the SPU has stopped.
    fn run_units<C: Channels>(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        left: u64,
    ) -> (Turn, Option<Exit>) {
        let before = spu.executed();
        let exit = if self.translations.checks() {
            match check(&mut self.cpu, spu, local_store, channels, left) {
                Ok(exit) => exit,
                Err(difference) => {
                    self.translations.report(*difference);
                    return (Turn::Stop(requested(spu.pc())), None);
                }
            }
        } else {
            self.enter(spu, local_store, left)
        };
        let ran = spu.executed() - before;
        self.compiled += ran;
        if channels.stop_requested() {
            return (Turn::Stop(requested(spu.pc())), None);
        }
        let turn = match exit {
            // The budget is too small for the next unit.
            Exit::Left if ran == 0 => Turn::Block,
            Exit::Left => Turn::Any,
            Exit::Interpret => Turn::Instruction,
            Exit::Failed(number) => {
                self.failed(number, spu, local_store);
                Turn::Block
            }
            Exit::Stale(number) => {
                self.stale(number, local_store);
                Turn::Any
            }
        };
        (turn, Some(exit))
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

    /// A unit that fails often is to do its arithmetic another way.
    fn failed(&mut self, number: u32, spu: &Spu, local_store: &LocalStore) {
        let at = number as usize;
        if self.failures.len() <= at {
            self.failures.resize(at + 1, Failures::default());
        }
        let failures = &mut self.failures[at];
        failures.count += 1;
        let count = failures.count;
        let often = count.saturating_mul(TOLERATED) > self.cpu.entries(number);
        if count > SOME_FAILURES && !(often && count.is_power_of_two()) {
            return;
        }
        let unit = self.translations.unit(number);
        if !unit.trace().stands_in(|pc| local_store.load_word(pc)) {
            return;
        }
        let seen = self
            .specials
            .get_or_insert_with(|| Box::new(Specials::new()));
        failures.special = failures
            .special
            .with(seen.on(unit.trace(), spu, local_store));
        if count < SOME_FAILURES || !often {
            return;
        }
        let other = unit.way().or_with(failures.special);
        let other = other.filter(|_| unit.floats());
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
