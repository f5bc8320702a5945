//! Contexts: `spu_create`, and what a context holds.

use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, OnceLock, PoisonError, RwLock};

use spu_emulator::engine::Engine;
use spu_emulator::machine::Machine;
use spu_emulator::signal::SignalMode;
use spu_emulator::spe::{Config, Spe, Watcher};

use crate::error::Errno;
use crate::problem_state::{Areas, RunState};
use crate::process_memory::ProcessMemory;
use crate::quick_copy;
use crate::readiness::{Levels, event_descriptor, into_raw};
use crate::table::{Open, table};

pub(crate) const EVENTS_ENABLED: u32 = 0x1;
const GANG: u32 = 0x2;
const NOSCHED: u32 = 0x4;
const ISOLATE: u32 = 0x8;
const AFFINITY: u32 = 0x30;
const KNOWN: u32 = 0x3f;

const ROOT: &str = "/spu";

static CREATED: AtomicUsize = AtomicUsize::new(0);
static MACHINE: OnceLock<Arc<Machine>> = OnceLock::new();

fn machine() -> &'static Arc<Machine> {
    MACHINE.get_or_init(|| Machine::with_engine(Arc::new(ProcessMemory), Engine::default()))
}

pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

pub(crate) struct Context {
    /// How many contexts were created before.
    pub number: usize,
    pub flags: u32,
    modes: Mutex<[SignalMode; 2]>,
    /// Made when it is first used, because signal modes are set before.
    spe: OnceLock<Arc<Spe>>,
    pub levels: Arc<Levels>,
    /// How many threads run the context.
    running: Mutex<usize>,
    runs: Condvar,
    /// Proxy tags that were used and have not been reported.
    pub tags: Mutex<u32>,
    /// Those of them that the MFC was asked for.
    pub asked_tags: Mutex<u32>,
    pub run_state: Arc<RunState>,
    areas: RwLock<Option<Areas>>,
}

impl Context {
    pub fn spe(&self) -> &Arc<Spe> {
        self.spe.get_or_init(|| {
            let config = Config { signal_modes: *lock(&self.modes), ..Config::default() };
            let spe = Spe::new(machine(), config);
            let area = spe.local_store().as_ptr();
            spe.map_local_store(area.expose_provenance() as u64);
            self.levels.spe.get_or_init(|| Arc::downgrade(&spe));
            let watcher: Arc<dyn Watcher> = self.levels.clone();
            spe.watch(Arc::clone(&watcher));
            watcher.changed();
            spe
        })
    }

    /// Sets a signal register's mode. It must happen before the SPE is used.
    pub fn set_mode(&self, register: usize, mode: SignalMode) -> Result<(), Errno> {
        if self.spe.get().is_some() {
            return Err(Errno(libc::EBUSY));
        }
        lock(&self.modes)[register] = mode;
        Ok(())
    }

    /// Calls `body` as the thread that has loaded the context on an SPE.
    pub fn loaded<T>(&self, body: impl FnOnce() -> T) -> T {
        *lock(&self.running) += 1;
        self.runs.notify_all();
        let result = body();
        *lock(&self.running) -= 1;
        result
    }

    /// Waits until the context is loaded on an SPE. Returns `false` if it is not and need not be
    /// waited for.
    pub fn wait_until_loaded(&self, wait: bool) -> bool {
        let mut running = lock(&self.running);
        while *running == 0 {
            if !wait {
                return false;
            }
            running = self.runs.wait(running).unwrap_or_else(PoisonError::into_inner);
        }
        true
    }

    /// The address of the mapped problem state.
    pub fn problem_state(&self) -> Result<usize, Errno> {
        let mut areas = self.areas.write().unwrap_or_else(PoisonError::into_inner);
        if areas.is_none() {
            *areas = Some(Areas::map(self.spe(), &self.run_state)?);
        }
        let first = areas.as_ref().and_then(|areas| areas.area(0));
        first.map(|area| area.expose_provenance()).ok_or(Errno(libc::EINVAL))
    }
}

/// Checks where a context or gang may be created: in the root, or in an existing gang.
fn check_place(path: &str) -> Result<(), Errno> {
    let table = table();
    let (folder, name) = path.rsplit_once('/').ok_or(Errno(libc::EINVAL))?;
    if folder != ROOT && !folder.starts_with(&format!("{ROOT}/")) || name.is_empty() {
        return Err(Errno(libc::EINVAL));
    }
    if folder != ROOT && !table.gangs().any(|gang| gang == folder) {
        return Err(Errno(libc::ENOENT));
    }
    if table.paths().any(|other| other == path) {
        return Err(Errno(libc::EEXIST));
    }
    Ok(())
}

/// `spu_create`: creates a context or a gang and returns the descriptor of its directory.
pub(crate) fn create(path: &str, flags: u32) -> Result<i32, Errno> {
    if flags & !KNOWN != 0 || flags & ISOLATE != 0 && flags & NOSCHED == 0 {
        return Err(Errno(libc::EINVAL));
    }
    check_place(path)?;
    if flags & GANG != 0 {
        let descriptor = into_raw(event_descriptor()?);
        table().insert(descriptor, Open::Gang(path.to_owned()));
        return Ok(descriptor);
    }
    // SAFETY: geteuid can't fail and takes no pointers.
    if flags & NOSCHED != 0 && unsafe { libc::geteuid() } != 0 {
        return Err(Errno(libc::EPERM));
    }
    if flags & ISOLATE != 0 {
        return Err(Errno(libc::ENODEV));
    }
    // A PlayStation 3's kernel has no record of where its SPEs are.
    if flags & AFFINITY != 0 {
        return Err(Errno(libc::EINVAL));
    }
    ProcessMemory::prepare()?;
    quick_copy::prepare()?;
    let context = Context {
        number: CREATED.fetch_add(1, Relaxed),
        flags,
        modes: Mutex::default(),
        spe: OnceLock::new(),
        levels: Arc::new(Levels::new()?),
        running: Mutex::new(0),
        runs: Condvar::new(),
        tags: Mutex::new(0),
        asked_tags: Mutex::new(0),
        run_state: Arc::default(),
        areas: RwLock::new(None),
    };
    let descriptor = into_raw(event_descriptor()?);
    let open = Open::Context(path.to_owned(), Arc::new(context));
    table().insert(descriptor, open);
    Ok(descriptor)
}
