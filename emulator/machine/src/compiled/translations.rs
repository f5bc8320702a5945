//! The units that the SPEs of a machine share.

use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, AtomicU16, Ordering::Relaxed};
use std::sync::mpsc::{SyncSender, sync_channel};
use std::sync::{Arc, Mutex, OnceLock};
use std::thread;

use spu_jit::{CodeCache, Compiler, Cpu, Estimates, FloatMode, Tier, Trace, Unit, UnitOptions};

use super::check::Difference;
#[cfg(target_arch = "wasm32")]
use super::interpret::interpret;
use crate::float::estimate::{reciprocal_root_words, reciprocal_words};
use crate::local_store::LocalStore;
use crate::lock::lock;
use crate::simulated::{HelperThread, Path};

/// The most units that may start at one address. Code that is rewritten again and again is not
/// worth more.
const MAX_UNITS_PER_ADDRESS: usize = 16;

/// The number of entries after which code is hot. Compiling code takes about a thousand times as
/// long as interpreting it once.
const COMPILE_THRESHOLD: u16 = 200;

/// The most units that wait for the background thread. Others ask again later.
const MAX_REQUESTS: usize = 256;

/// The translations of a machine, which its SPEs share.
pub struct Translations {
    shared: Arc<Shared>,
    /// If set, another thread optimizes. It takes baseline units.
    background: OnceLock<SyncSender<Arc<Unit>>>,
    compile_threshold: AtomicU16,
    optimize_at_once: AtomicBool,
    check: bool,
    difference: Mutex<Option<Difference>>,
}

/// What the thread that optimizes needs, too. Compiling takes milliseconds, so the units have a
/// lock of their own: SPEs can look for a unit while another is compiled.
struct Shared {
    code: Arc<CodeCache>,
    /// By tiers. Locked before `units` by those that need both.
    compilers: [Mutex<Compiler>; 2],
    units: Mutex<Units>,
}

#[derive(Default)]
struct Units {
    /// The units by start address. The newest is last, and is tried first.
    by_address: HashMap<u32, Vec<Arc<Unit>>>,
    by_number: HashMap<u32, Arc<Unit>>,
    paths: HashMap<u32, Arc<Path>>,
}

impl Translations {
    /// Creates an empty set of translations. Returns `None` if there is no compiler for this host.
    /// With `check`, compiled code is compared with the interpreter as it runs. `timed` means that
    /// the machine runs in simulated time.
    #[must_use]
    pub fn new(check: bool, timed: bool) -> Option<Arc<Self>> {
        Self::with(check, timed, false)
    }

    /// As [`new`](Self::new). With `watches`, compiled code leaves accesses to the quadwords that
    /// are [marked](crate::simulated::Marks) to the interpreter.
    pub(crate) fn with(check: bool, timed: bool, watches: bool) -> Option<Arc<Self>> {
        let options = UnitOptions { logs: timed, watches };
        let estimates =
            Estimates { reciprocal: reciprocal_words(), reciprocal_root: reciprocal_root_words() };
        #[cfg(target_arch = "wasm32")]
        let code = CodeCache::new(estimates, interpret, options).filter(|_| !check)?;
        #[cfg(not(target_arch = "wasm32"))]
        let code = CodeCache::new(estimates, options)?;
        let compilers = [Tier::Baseline, Tier::Optimized].map(|tier| Compiler::new(&code, tier));
        Some(Arc::new(Self {
            shared: Arc::new(Shared {
                code,
                compilers: compilers.map(Mutex::new),
                units: Mutex::default(),
            }),
            background: OnceLock::new(),
            compile_threshold: AtomicU16::new(COMPILE_THRESHOLD),
            optimize_at_once: AtomicBool::new(false),
            check,
            difference: Mutex::default(),
        }))
    }

    /// From now on a thread of its own optimizes units that are entered often, and SPUs run the
    /// baseline units until it is done. If the host gives no thread, the SPUs' threads optimize as
    /// before.
    pub fn optimize_in_background(&self) {
        let (sender, requests) = sync_channel::<Arc<Unit>>(MAX_REQUESTS);
        let shared = Arc::clone(&self.shared);
        // The thread ends when the translations, and with them the sender, are dropped.
        let optimize = move || {
            let _helper = HelperThread::current();
            for unit in requests {
                shared.compile(unit.trace().clone(), unit.mode(), Tier::Optimized);
            }
        };
        let thread = thread::Builder::new().name("SPU compiler".into());
        if self.background.get().is_none() && thread.spawn(optimize).is_ok() {
            // If another caller was faster, this thread ends at once.
            self.background.get_or_init(|| sender);
        }
    }

    /// The number of units that were compiled.
    #[must_use]
    pub fn units(&self) -> usize {
        lock(&self.shared.units).by_number.len()
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
    pub(super) fn compile_threshold(&self) -> u16 {
        self.compile_threshold.load(Relaxed)
    }

    /// Sets the number of entries after which code is compiled.
    pub fn compile_after(&self, times: u16) {
        self.compile_threshold.store(times, Relaxed);
    }

    /// From now on all code is optimized as soon as it is compiled.
    pub fn optimize_at_once(&self) {
        self.optimize_at_once.store(true, Relaxed);
    }

    pub(super) fn checks(&self) -> bool {
        self.check
    }

    pub(super) fn new_cpu(&self) -> Cpu {
        self.shared.code.new_cpu()
    }

    pub(super) fn unit(&self, number: u32) -> Arc<Unit> {
        Arc::clone(&lock(&self.shared.units).by_number[&number])
    }

    /// The path through the unit with this number.
    pub(super) fn path(&self, number: u32) -> Arc<Path> {
        let units = &mut *lock(&self.shared.units);
        let steps = units.by_number[&number].trace().steps().iter();
        let path = || Path::new(steps.map(|s| (s.pc, s.word, s.instruction, s.next)));
        Arc::clone(units.paths.entry(number).or_insert_with(|| Arc::new(path())))
    }

    /// The newest unit that starts at `pc` and whose code is in local store.
    pub(super) fn find(&self, pc: u32, local_store: &LocalStore) -> Option<Arc<Unit>> {
        lock(&self.shared.units).find(pc, local_store).cloned()
    }

    /// Returns the unit of a trace, and compiles it if there is none yet. Returns `None` if the
    /// code cache is full.
    pub(super) fn add(&self, trace: Trace, mode: FloatMode) -> Option<Arc<Unit>> {
        let at_once = self.optimize_at_once.load(Relaxed);
        let tier = if at_once { Tier::Optimized } else { Tier::Baseline };
        self.shared.compile(trace, mode, tier)
    }

    /// Returns a unit of the same trace in a slower mode. Those who look for a unit still find this
    /// one.
    pub(super) fn stand_in(&self, unit: &Unit, mode: FloatMode) -> Option<Arc<Unit>> {
        let slower = self.add(unit.trace().clone(), mode);
        lock(&self.shared.units).prefer(unit);
        slower
    }

    /// Returns the optimized unit in place of this one, or has it compiled if there is none yet.
    pub(super) fn optimized(&self, number: u32) -> Option<Arc<Unit>> {
        let unit = self.unit(number);
        let (trace, mode) = (unit.trace(), unit.mode());
        let Some(background) = self.background.get() else {
            return self.shared.compile(trace.clone(), mode, Tier::Optimized);
        };
        let ready = lock(&self.shared.units).same(trace, mode, Tier::Optimized).cloned();
        if ready.is_none() {
            // If too many wait, the unit will report again that it is hot.
            let _ = background.try_send(unit);
        }
        ready
    }
}

impl Shared {
    /// Returns the unit of a trace in this tier or a higher one, and compiles it if there is none
    /// yet. Returns `None` if the code cache is full.
    fn compile(&self, trace: Trace, mode: FloatMode, tier: Tier) -> Option<Arc<Unit>> {
        let mut compiler = lock(&self.compilers[tier as usize]);
        {
            let units = lock(&self.units);
            if let Some(unit) = units.same(&trace, mode, tier) {
                return Some(Arc::clone(unit));
            }
            if tier == Tier::Baseline && units.are_full_at(trace.start()) {
                return None;
            }
        }
        let unit = Arc::new(compiler.compile(trace, mode)?);
        lock(&self.units).add(&unit);
        Some(unit)
    }
}

impl Units {
    fn same(&self, trace: &Trace, mode: FloatMode, tier: Tier) -> Option<&Arc<Unit>> {
        let mut here = self.by_address.get(&trace.start())?.iter();
        here.find(|unit| unit.tier() >= tier && unit.mode() == mode && unit.trace() == trace)
    }

    fn are_full_at(&self, pc: u32) -> bool {
        let here = self.by_address.get(&pc);
        here.is_some_and(|here| here.len() >= MAX_UNITS_PER_ADDRESS)
    }

    /// Adds a unit. An optimized one takes the place of its baseline unit.
    fn add(&mut self, unit: &Arc<Unit>) {
        let here = self.by_address.entry(unit.start()).or_default();
        let same = |old: &&mut Arc<Unit>| old.mode() == unit.mode() && old.trace() == unit.trace();
        match here.iter_mut().find(same) {
            Some(old) => *old = Arc::clone(unit),
            None => here.push(Arc::clone(unit)),
        }
        self.by_number.insert(unit.number(), Arc::clone(unit));
    }

    /// Makes this unit, or the optimized one in its place, the newest at its address.
    fn prefer(&mut self, unit: &Unit) {
        let Some(here) = self.by_address.get_mut(&unit.start()) else { return };
        let same = |other: &Arc<Unit>| other.mode() == unit.mode() && other.trace() == unit.trace();
        if let Some(at) = here.iter().position(same) {
            here[at..].rotate_left(1);
        }
    }

    fn find(&self, pc: u32, local_store: &LocalStore) -> Option<&Arc<Unit>> {
        let here = self.by_address.get(&pc)?;
        here.iter().rev().find(|unit| unit.trace().matches(|pc| local_store.load_word(pc)))
    }
}
