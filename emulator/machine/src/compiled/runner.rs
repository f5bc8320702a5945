//! Runs one SPU on compiled units and the interpreter.

use std::cell::RefCell;
use std::sync::Arc;

use spu_isa::{Instruction, LOCAL_STORE_SIZE};
use spu_jit::{Cpu, Exit, FloatMode, MAX_STEPS, Passage, Steps, Storage, Trace, Unit};

use super::check::{Copies, check};
use super::dispatch::Dispatch;
use super::record::{Recorder, record};
use super::specials::Specials;
use super::translations::Translations;
use crate::channel::Channels;
use crate::float::fpscr::Fpscr;
use crate::interp::{Ended, Observer, Spu};
use crate::local_store::LocalStore;
use crate::simulated::{Marks, Path, SpuClock};
use crate::stop::{Stop, Stopped};

/// The number of entries after which the runner looks for a unit that another SPE had compiled.
const LOOKUP_THRESHOLD: u16 = 8;
/// The entry count of an address that is never compiled.
const NEVER: u16 = u16::MAX;
/// The most instructions between two checks for a stop request. They take some microseconds.
const SLICE: u64 = 20_000;
/// The same in simulated time. It is smaller because others may wait for this SPU's clock.
const TIMED_SLICE: u64 = 4_000;
/// The number of failures from which on a unit's failure rate matters.
const MIN_FAILURES: u32 = 16;
/// A unit fails too often if it fails in more than one of this many entries.
const ENTRIES_PER_FAILURE: u32 = 10;

const LOCAL_STORE_WORDS: usize = LOCAL_STORE_SIZE as usize / 4;

/// The failures of a unit.
#[derive(Clone, Default)]
struct Failures {
    count: u32,
    /// The instructions that the host's singles could not compute.
    special: Steps,
    /// The unit that runs once in its place after a failure.
    stand_in: Option<Arc<Unit>>,
}

/// A slower unit that runs once in place of one that has just failed.
struct StandIn {
    /// The unit that has failed, which is put back afterwards.
    failed: Arc<Unit>,
    slower: Arc<Unit>,
}

/// Runs one SPU on compiled code and the interpreter.
pub struct Runner {
    translations: Arc<Translations>,
    cpu: Cpu,
    /// For each word of local store, how often the SPU entered it without a unit there.
    entry_counts: Box<[u16]>,
    failures: Vec<Failures>,
    /// The current stand-in.
    stand_in: Option<StandIn>,
    /// Finds the instructions that made a unit fail.
    specials: Option<Box<Specials>>,
    /// With the check mode.
    copies: Option<Box<Copies>>,
    /// The number of instructions that ran in compiled code.
    compiled: u64,
    /// In simulated time: the current recording.
    recorder: Option<Recorder>,
    /// In simulated time: the paths through units by their numbers, each with the value of
    /// [`Spu::code_changes`] at its last comparison.
    paths: Vec<Option<(Arc<Path>, u64)>>,
    /// The quadwords whose accesses are left to the interpreter, if the units look for that.
    marks: Arc<Marks>,
}

fn requested(pc: u32) -> Stopped {
    Stopped { reason: Stop::Requested, pc, npc: pc }
}

/// What to compile instead of a unit that fails too often.
fn slower(unit: &Unit, special: Steps) -> Option<(Trace, FloatMode)> {
    let mode = unit.mode().fallback(special);
    match mode.filter(|_| unit.has_fallback()) {
        Some(mode) => Some((unit.trace().clone(), mode)),
        // Singles fail in no other mode, so what fails now is double precision.
        None => {
            let trace = unit.trace().before_double_precision()?;
            Some((trace, FloatMode::SINGLES))
        }
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
        match spu.run_decoded(local_store, channels, left, true, observer) {
            Ended::AtLimit | Ended::Branched => return None,
            Ended::Stopped(stopped) => return Some(stopped),
            Ended::Decoded => {}
        }
    }
}

impl Runner {
    /// Creates the runner of an SPU of the machine to which these translations belong.
    #[must_use]
    pub fn new(translations: &Arc<Translations>) -> Self {
        Self {
            cpu: translations.new_cpu(),
            translations: Arc::clone(translations),
            entry_counts: vec![0; LOCAL_STORE_WORDS].into_boxed_slice(),
            failures: Vec::new(),
            stand_in: None,
            specials: None,
            copies: None,
            compiled: 0,
            recorder: None,
            paths: Vec::new(),
            marks: Arc::default(),
        }
    }

    /// From now on compiled code leaves accesses to these quadwords to the interpreter.
    pub(crate) fn watch(&mut self, marks: &Arc<Marks>) {
        self.marks = Arc::clone(marks);
    }

    /// The number of instructions that ran in compiled code.
    #[must_use]
    pub fn compiled(&self) -> u64 {
        self.compiled
    }

    /// Runs at most `limit` instructions. Returns `None` if the SPU can continue. Every call must
    /// pass the same `spu`, which must not have the double-precision extension.
    pub fn run<C: Channels>(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        limit: u64,
    ) -> Option<Stopped> {
        self.run_observed(spu, local_store, channels, limit, &mut ())
    }

    /// As [`run`](Self::run), with calls to an `observer` that does not need every instruction.
    pub fn run_observed<C: Channels, O: Observer>(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        limit: u64,
        observer: &mut O,
    ) -> Option<Stopped> {
        let end = spu.executed().saturating_add(limit);
        let mut next = Dispatch::Any;
        loop {
            if let Dispatch::Stop(stopped) = next {
                return Some(stopped);
            }
            let left = end - spu.executed();
            if left == 0 {
                return None;
            }
            let compiled = !spu.interrupts_enabled() && self.cpu.has_unit(spu.pc());
            next = match next {
                Dispatch::Any if compiled => {
                    let (next, exit) = self.run_units(spu, local_store, channels, left.min(SLICE));
                    let left = end - spu.executed();
                    let next = match exit {
                        Some(Exit::Left) if !self.cpu.has_unit(spu.pc()) => {
                            self.record_if_hot(spu, local_store, channels, left)
                        }
                        _ => next,
                    };
                    observer.after_compiled();
                    next
                }
                _ => {
                    let limit = if let Dispatch::InterpretOne = next { 1 } else { left };
                    let stopped = interpret(spu, local_store, channels, limit, observer);
                    let left = end - spu.executed();
                    match stopped {
                        Some(stopped) => Dispatch::Stop(stopped),
                        None => self.record_if_hot(spu, local_store, channels, left),
                    }
                }
            };
        }
    }

    /// Counts an entry at `pc`, where a unit may start. Returns whether the address is hot, so
    /// that a trace should be recorded.
    fn count_entry(&mut self, pc: u32, local_store: &LocalStore) -> bool {
        if self.cpu.has_unit(pc) {
            return false;
        }
        let threshold = self.translations.compile_threshold();
        let count = &mut self.entry_counts[pc as usize / 4];
        if *count == NEVER {
            return false;
        }
        *count = (*count + 1).min(threshold);
        if (*count == LOOKUP_THRESHOLD || *count == threshold)
            && let Some(unit) = self.translations.find(pc, local_store)
        {
            self.cpu.install(&unit);
            return false;
        }
        let is_hot = *count == threshold;
        if is_hot {
            *count = 0;
        }
        is_hot
    }

    /// Counts an entry at the program counter, and records and compiles a trace if it is hot.
    fn record_if_hot<C: Channels>(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        left: u64,
    ) -> Dispatch {
        if left >= MAX_STEPS as u64 && self.count_entry(spu.pc(), local_store) {
            let (stopped, trace) = record(&self.cpu, spu, local_store, channels);
            self.compile(trace);
            if let Some(stopped) = stopped {
                return Dispatch::Stop(stopped);
            }
        }
        Dispatch::Any
    }

    fn compile(&mut self, trace: Option<Trace>) {
        let Some(trace) = trace else { return };
        let start = trace.start();
        match self.translations.add(trace, FloatMode::SINGLES) {
            Some(unit) => self.cpu.install(&unit),
            None => self.entry_counts[start as usize / 4] = NEVER,
        }
    }

    /// Whether a unit starts at `pc`, and no trace is being recorded.
    #[inline]
    pub(crate) fn may_enter(&self, pc: u32) -> bool {
        self.recorder.is_none() && self.cpu.has_unit(pc)
    }

    /// In simulated time: runs units from the program counter on, at most `limit` instructions,
    /// and advances the clock.
    pub(crate) fn run_timed<C: Channels>(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        limit: u64,
        clock: &RefCell<SpuClock>,
    ) -> Dispatch {
        let limit = limit.min(TIMED_SLICE);
        let (next, exit) = self.run_units(spu, local_store, channels, limit);
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
            clock.advance_along(spu, local_store, (&**path, proven), count, &mut words);
        }
        if let Some(Exit::Left) = exit {
            self.start_recording_if_hot(spu.pc(), local_store);
        }
        next
    }

    /// In simulated time: counts an entry at `pc`, and starts to record if it is hot.
    pub(crate) fn start_recording_if_hot(&mut self, pc: u32, local_store: &LocalStore) {
        if self.recorder.is_none() && self.count_entry(pc, local_store) {
            self.recorder = Some(Recorder::default());
        }
    }

    /// Whether a trace is being recorded.
    #[inline]
    pub(crate) fn is_recording(&self) -> bool {
        self.recorder.is_some()
    }

    /// In simulated time: adds these instructions and their addresses to the recording. The
    /// interpreter has run them, and the program counter is now `next`.
    #[cold]
    pub(crate) fn record_interpreted(
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
        if !recorder.can_extend(&self.cpu, next) {
            self.end_recording();
        }
    }

    /// In simulated time: ends the recording, if there is one, and compiles its trace.
    #[inline]
    pub(crate) fn end_recording(&mut self) {
        if let Some(recorder) = self.recorder.take() {
            self.compile(recorder.trace());
        }
    }

    /// Runs units. Returns how to continue, and why the units ended, unless the SPU has stopped.
    fn run_units<C: Channels>(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        left: u64,
    ) -> (Dispatch, Option<Exit>) {
        let before = spu.executed();
        let exit = if self.translations.checks() {
            let copies = self.copies.get_or_insert_with(|| Box::new(Copies::new()));
            let cpu = (&mut self.cpu, &*self.marks);
            match check(cpu, spu, local_store, copies, channels, left) {
                Ok(exit) => exit,
                Err(difference) => {
                    self.translations.report(*difference);
                    return (Dispatch::Stop(requested(spu.pc())), None);
                }
            }
        } else {
            self.enter(spu, local_store, left)
        };
        let stood_in = self.stand_in.take();
        if let Some(StandIn { failed, .. }) = &stood_in {
            self.cpu.install(failed);
        }
        let ran = spu.executed() - before;
        self.compiled += ran;
        if channels.stop_requested() {
            return (Dispatch::Stop(requested(spu.pc())), None);
        }
        let next = match exit {
            // The budget is too small for the next unit.
            Exit::Left if ran == 0 => Dispatch::InterpretBlock,
            Exit::Left => Dispatch::Any,
            Exit::Interpret => Dispatch::InterpretOne,
            Exit::Failed(number) => match &stood_in {
                Some(stand_in) if stand_in.slower.number() == number => {
                    self.failed(stand_in.failed.number(), spu, local_store);
                    Dispatch::InterpretBlock
                }
                _ => {
                    self.failed(number, spu, local_store);
                    self.stand_in_for(number, spu.pc())
                }
            },
            Exit::Watched => Dispatch::InterpretBlock,
            Exit::Stale(number) => {
                self.stale(number, local_store);
                Dispatch::Any
            }
            Exit::Hot(number) => {
                if let Some(unit) = self.translations.optimized(number) {
                    match &stood_in {
                        Some(stand_in) if stand_in.slower.number() == number => {
                            let failed = stand_in.failed.number() as usize;
                            self.failures[failed].stand_in = Some(unit);
                        }
                        _ => self.cpu.install(&unit),
                    }
                }
                Dispatch::Any
            }
        };
        (next, Some(exit))
    }

    fn enter(&mut self, spu: &mut Spu, local_store: &LocalStore, budget: u64) -> Exit {
        let storage = Storage {
            registers: spu.registers.as_mut_ptr().cast(),
            local_store: local_store.as_ptr(),
            watched: self.marks.as_ptr(),
        };
        let mut fpscr = spu.fpscr.words();
        // SAFETY: the registers are 128 aligned quadwords that only this thread accesses. Local
        // store has the required size and alignment, and others may write to it as the PPE does.
        // The marks have a byte for each of its quadwords.
        let (exit, pc, executed) =
            unsafe { self.cpu.enter(storage, &mut fpscr, spu.pc(), budget as u32) };
        spu.fpscr = Fpscr::from_words(fpscr);
        spu.set_pc(pc);
        spu.executed += u64::from(executed);
        exit
    }

    /// A unit has failed. If it does so now and then, it gets a stand-in for these cases. If it
    /// fails often, it is replaced: by one iteration of an unrolled loop, by a unit with a slower
    /// [`FloatMode`], or by one that ends before its double precision. If there can't be one, the
    /// address is never compiled again.
    fn failed(&mut self, number: u32, spu: &Spu, local_store: &LocalStore) {
        let at = number as usize;
        if self.failures.len() <= at {
            self.failures.resize(at + 1, Failures::default());
        }
        let failures = &mut self.failures[at];
        failures.count += 1;
        let count = failures.count;
        if count > MIN_FAILURES && !count.is_power_of_two() {
            return;
        }
        let unit = self.translations.unit(number);
        if !unit.trace().matches(|pc| local_store.load_word(pc)) {
            return;
        }
        let specials = self.specials.get_or_insert_with(|| Box::new(Specials::new()));
        failures.special = failures.special.with(specials.find(unit.trace(), spu, local_store));
        if count < MIN_FAILURES {
            return;
        }
        let special = failures.special;
        if count.saturating_mul(ENTRIES_PER_FAILURE) <= self.cpu.entries(number) {
            let mode = unit.mode().fallback(special).filter(|_| unit.has_fallback());
            if let Some(slower) = mode.and_then(|mode| self.translations.stand_in(&unit, mode)) {
                failures.stand_in = Some(slower);
            }
            return;
        }
        failures.stand_in = None;
        let mostly = count.saturating_mul(2) > self.cpu.entries(number);
        let other = match unit.trace().rolled() {
            // The failure of one iteration discards several.
            Some(trace) if !mostly || special == Steps::NONE => Some((trace, unit.mode())),
            _ => slower(&unit, special),
        };
        match other.and_then(|(trace, mode)| self.translations.add(trace, mode)) {
            Some(unit) => self.cpu.install(&unit),
            None => {
                self.cpu.remove(unit.start());
                self.entry_counts[unit.start() as usize / 4] = NEVER;
            }
        }
    }

    /// Has the stand-in of a unit that has failed run in its place, or else the interpreter.
    fn stand_in_for(&mut self, number: u32, pc: u32) -> Dispatch {
        let slower = self.failures[number as usize].stand_in.clone();
        match slower {
            Some(slower) if slower.start() == pc => {
                let failed = self.translations.unit(number);
                self.cpu.install(&slower);
                self.stand_in = Some(StandIn { failed, slower });
                Dispatch::Any
            }
            _ => Dispatch::InterpretBlock,
        }
    }

    /// A unit's code in local store has changed: replaces it by one that matches, or removes it.
    fn stale(&mut self, number: u32, local_store: &LocalStore) {
        let pc = self.translations.unit(number).start();
        match self.translations.find(pc, local_store) {
            Some(unit) => self.cpu.install(&unit),
            None => {
                self.cpu.remove(pc);
                self.entry_counts[pc as usize / 4] = 0;
            }
        }
    }
}
