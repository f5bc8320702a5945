//! The units that the SPEs of a machine share.

use std::collections::HashMap;
use std::sync::atomic::{AtomicU8, Ordering::Relaxed};
use std::sync::{Arc, Mutex};

use spu_compiler::{Compiler, Cpu, Estimates, FloatMode, Trace, Unit};

use super::check::Difference;
use crate::float::estimate::{reciprocal_root_words, reciprocal_words};
use crate::local_store::LocalStore;
use crate::lock::lock;
use crate::simulated::Path;

/// The most units that may start at one address. Code that is rewritten again and again is not
/// worth more.
const MAX_UNITS_PER_ADDRESS: usize = 16;

/// The number of entries after which code is hot. Compiling code takes some hundred times as long
/// as interpreting it once.
const COMPILE_THRESHOLD: u8 = 100;

/// The translations of a machine, which its SPEs share.
pub struct Translations {
    state: Mutex<State>,
    compile_threshold: AtomicU8,
    check: bool,
    difference: Mutex<Option<Difference>>,
}

struct State {
    compiler: Compiler,
    /// The units by start address. The newest is last, and is tried first.
    units: HashMap<u32, Vec<Arc<Unit>>>,
    by_number: Vec<Arc<Unit>>,
    /// By the units' numbers.
    paths: Vec<Option<Arc<Path>>>,
}

impl Translations {
    /// Creates an empty set of translations. Returns `None` if there is no compiler for this host.
    /// With `check`, compiled code is compared with the interpreter as it runs. `timed` says that
    /// the machine runs in simulated time.
    #[must_use]
    pub fn new(check: bool, timed: bool) -> Option<Arc<Self>> {
        let estimates = Estimates {
            reciprocal: reciprocal_words(),
            reciprocal_root: reciprocal_root_words(),
        };
        let compiler = Compiler::new(estimates, timed)?;
        Some(Arc::new(Self {
            state: Mutex::new(State {
                compiler,
                units: HashMap::new(),
                by_number: Vec::new(),
                paths: Vec::new(),
            }),
            compile_threshold: AtomicU8::new(COMPILE_THRESHOLD),
            check,
            difference: Mutex::default(),
        }))
    }

    /// The number of units that were compiled.
    #[must_use]
    pub fn units(&self) -> usize {
        lock(&self.state).by_number.len()
    }

    /// The first difference that was found between compiled and interpreted code.
    #[must_use]
    pub fn difference(&self) -> Option<Difference> {
        lock(&self.difference).clone()
    }

    pub(super) fn report(&self, difference: Difference) {
        lock(&self.difference).get_or_insert(difference);
    }

    /// The number of entries after which code is compiled.
    pub(super) fn compile_threshold(&self) -> u8 {
        self.compile_threshold.load(Relaxed)
    }

    /// Sets the number of entries after which code is compiled.
    pub fn compile_after(&self, times: u8) {
        self.compile_threshold.store(times, Relaxed);
    }

    pub(super) fn checks(&self) -> bool {
        self.check
    }

    pub(super) fn new_cpu(&self) -> Cpu {
        lock(&self.state).compiler.new_cpu()
    }

    pub(super) fn unit(&self, number: u32) -> Arc<Unit> {
        Arc::clone(&lock(&self.state).by_number[number as usize])
    }

    /// The path through the unit with this number.
    pub(super) fn path(&self, number: u32) -> Arc<Path> {
        let state = &mut *lock(&self.state);
        let at = number as usize;
        if state.paths.len() <= at {
            state.paths.resize(at + 1, None);
        }
        let steps = state.by_number[at].trace().steps().iter();
        let path = || Path::new(steps.map(|s| (s.pc, s.word, s.instruction, s.next)));
        Arc::clone(state.paths[at].get_or_insert_with(|| Arc::new(path())))
    }

    /// The newest unit that starts at `pc` and whose code is in local store.
    pub(super) fn find(&self, pc: u32, local_store: &LocalStore) -> Option<Arc<Unit>> {
        lock(&self.state).find(pc, local_store).cloned()
    }

    /// Returns the unit of a trace, and compiles it if there is none yet. Returns `None` if there
    /// is no room for it.
    pub(super) fn add(&self, trace: Trace, mode: FloatMode) -> Option<Arc<Unit>> {
        let state = &mut *lock(&self.state);
        let here = state.units.entry(trace.start()).or_default();
        let same = |unit: &&Arc<Unit>| unit.mode() == mode && unit.trace() == &trace;
        if let Some(unit) = here.iter().find(same) {
            return Some(Arc::clone(unit));
        }
        if here.len() >= MAX_UNITS_PER_ADDRESS {
            return None;
        }
        let unit = Arc::new(state.compiler.compile(trace, mode)?);
        here.push(Arc::clone(&unit));
        state.by_number.push(Arc::clone(&unit));
        Some(unit)
    }
}

impl State {
    fn find(&self, pc: u32, local_store: &LocalStore) -> Option<&Arc<Unit>> {
        let here = self.units.get(&pc)?;
        here.iter()
            .rev()
            .find(|unit| unit.trace().matches(|pc| local_store.load_word(pc)))
    }
}
