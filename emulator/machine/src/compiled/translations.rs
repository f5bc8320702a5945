//! The units that the SPEs of a machine share.

use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering::Relaxed};
use std::sync::mpsc::{SyncSender, TrySendError, sync_channel};
use std::sync::{Arc, Mutex, OnceLock};
use std::thread;
use std::time::{Duration, Instant};

use spu_jit::{Compiler, Cpu, Estimates, FloatMode, Trace, Unit, UnitOptions};

use super::check::Difference;
use crate::float::estimate::{reciprocal_root_words, reciprocal_words};
use crate::local_store::LocalStore;
use crate::lock::lock;
use crate::simulated::{HelperThread, Path};

/// The most units that may start at one address. Code that is rewritten again and again is not
/// worth more.
const MAX_UNITS_PER_ADDRESS: usize = 16;

/// The number of entries after which code is hot. Compiling code takes some hundred times as long
/// as interpreting it once.
const COMPILE_THRESHOLD: u8 = 100;

/// How long after the first request only the background thread compiles. Later the SPUs' threads
/// compile, too, because a program that runs longer gains more from compiled code than it loses by
/// waiting for it.
const ONLY_IN_BACKGROUND: Duration = Duration::from_millis(250);

/// The most traces that wait for the background thread. Others are recorded again later.
const MAX_REQUESTS: usize = 256;

/// The translations of a machine, which its SPEs share.
pub struct Translations {
    shared: Arc<Shared>,
    /// If set, another thread compiles, too.
    background: OnceLock<Background>,
    compile_threshold: AtomicU8,
    check: bool,
    difference: Mutex<Option<Difference>>,
}

/// What the thread that compiles needs, too. Compiling takes milliseconds, so the units have a
/// lock of their own: SPEs can look for a unit while another is compiled.
struct Shared {
    /// Locked before `units` by those that need both.
    compiler: Mutex<Compiler>,
    units: Mutex<Units>,
    /// Whether the code cache was too full for a unit.
    full: AtomicBool,
}

/// The background thread, which compiles.
struct Background {
    requests: SyncSender<Request>,
    /// The time of the first request.
    first: OnceLock<Instant>,
}

/// A trace to be compiled, and how.
type Request = (Trace, FloatMode);

/// The result of a request for a unit.
pub(super) enum Added {
    /// The unit can be used.
    Ready(Arc<Unit>),
    /// Another thread compiles it. Later it can be [found](Translations::find).
    Later,
    /// The code cache is full.
    CacheFull,
}

#[derive(Default)]
struct Units {
    /// The units by start address. The newest is last, and is tried first.
    by_address: HashMap<u32, Vec<Arc<Unit>>>,
    by_number: Vec<Arc<Unit>>,
    paths: Vec<Option<Arc<Path>>>,
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
        let compiler = Compiler::new(estimates, options)?;
        Some(Arc::new(Self {
            shared: Arc::new(Shared {
                compiler: Mutex::new(compiler),
                units: Mutex::default(),
                full: AtomicBool::new(false),
            }),
            background: OnceLock::new(),
            compile_threshold: AtomicU8::new(COMPILE_THRESHOLD),
            check,
            difference: Mutex::default(),
        }))
    }

    /// From now on a thread of its own compiles, and SPUs interpret until it is done. So the first
    /// instructions of a program don't wait for the compiler. If the host gives no thread, the
    /// SPUs' threads compile as before.
    pub fn compile_in_background(&self) {
        let (sender, requests) = sync_channel::<Request>(MAX_REQUESTS);
        let shared = Arc::clone(&self.shared);
        // The thread ends when the translations, and with them the sender, are dropped.
        let compile = move || {
            let _helper = HelperThread::current();
            for (trace, mode) in requests {
                shared.compile(trace, mode);
            }
        };
        let thread = thread::Builder::new().name("SPU compiler".into());
        if self.background.get().is_none() && thread.spawn(compile).is_ok() {
            // If another caller was faster, this thread ends at once.
            self.background.get_or_init(|| Background { requests: sender, first: OnceLock::new() });
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
        lock(&self.shared.compiler).new_cpu()
    }

    pub(super) fn unit(&self, number: u32) -> Arc<Unit> {
        Arc::clone(&lock(&self.shared.units).by_number[number as usize])
    }

    /// The path through the unit with this number.
    pub(super) fn path(&self, number: u32) -> Arc<Path> {
        let units = &mut *lock(&self.shared.units);
        let at = number as usize;
        if units.paths.len() <= at {
            units.paths.resize(at + 1, None);
        }
        let steps = units.by_number[at].trace().steps().iter();
        let path = || Path::new(steps.map(|s| (s.pc, s.word, s.instruction, s.next)));
        Arc::clone(units.paths[at].get_or_insert_with(|| Arc::new(path())))
    }

    /// The newest unit that starts at `pc` and whose code is in local store.
    pub(super) fn find(&self, pc: u32, local_store: &LocalStore) -> Option<Arc<Unit>> {
        lock(&self.shared.units).find(pc, local_store).cloned()
    }

    /// Returns the unit of a trace, or has it compiled if there is none yet.
    pub(super) fn add(&self, trace: Trace, mode: FloatMode) -> Added {
        let background = self.background.get();
        let Some(background) = background.filter(|background| background.compiles_alone()) else {
            return match self.shared.compile(trace, mode) {
                Some(unit) => Added::Ready(unit),
                None => Added::CacheFull,
            };
        };
        {
            let units = lock(&self.shared.units);
            if let Some(unit) = units.same(&trace, mode) {
                return Added::Ready(Arc::clone(unit));
            }
            if units.are_full_at(trace.start()) || self.shared.full.load(Relaxed) {
                return Added::CacheFull;
            }
        }
        match background.requests.try_send((trace, mode)) {
            Ok(()) | Err(TrySendError::Full(_)) => Added::Later,
            // The thread has ended, which it does before the sender only by a panic.
            Err(TrySendError::Disconnected(_)) => Added::CacheFull,
        }
    }
}

impl Background {
    /// Whether only this thread compiles now.
    fn compiles_alone(&self) -> bool {
        self.first.get_or_init(Instant::now).elapsed() < ONLY_IN_BACKGROUND
    }
}

impl Shared {
    /// Returns the unit of a trace, and compiles it if there is none yet. Returns `None` if
    /// the code cache is full.
    fn compile(&self, trace: Trace, mode: FloatMode) -> Option<Arc<Unit>> {
        let mut compiler = lock(&self.compiler);
        {
            let units = lock(&self.units);
            if let Some(unit) = units.same(&trace, mode) {
                return Some(Arc::clone(unit));
            }
            if units.are_full_at(trace.start()) {
                return None;
            }
        }
        let Some(unit) = compiler.compile(trace, mode).map(Arc::new) else {
            self.full.store(true, Relaxed);
            return None;
        };
        // The compiler is still locked, so units are added in the order of their numbers.
        lock(&self.units).push(&unit);
        Some(unit)
    }
}

impl Units {
    fn same(&self, trace: &Trace, mode: FloatMode) -> Option<&Arc<Unit>> {
        let mut here = self.by_address.get(&trace.start())?.iter();
        here.find(|unit| unit.mode() == mode && unit.trace() == trace)
    }

    fn are_full_at(&self, pc: u32) -> bool {
        let here = self.by_address.get(&pc);
        here.is_some_and(|here| here.len() >= MAX_UNITS_PER_ADDRESS)
    }

    fn push(&mut self, unit: &Arc<Unit>) {
        let here = self.by_address.entry(unit.start()).or_default();
        here.push(Arc::clone(unit));
        self.by_number.push(Arc::clone(unit));
    }

    fn find(&self, pc: u32, local_store: &LocalStore) -> Option<&Arc<Unit>> {
        let here = self.by_address.get(&pc)?;
        here.iter().rev().find(|unit| unit.trace().matches(|pc| local_store.load_word(pc)))
    }
}
