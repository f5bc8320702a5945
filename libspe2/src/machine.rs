//! The machine that all contexts of the process share, as the environment configures it.
//!
//! Invariant: the environment is read when the first context is created, and its settings hold for
//! the whole process.

use std::collections::HashMap;
use std::env;
use std::ffi::OsString;
use std::io;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use spu_debugger::Debugger;
use spu_emulator::elf::Image;
use spu_emulator::engine::Engine;
use spu_emulator::machine;
use spu_emulator::mfc::Policy;
use spu_emulator::profile::ProgramId;
use spu_emulator::simulated::{Method, SimulationOptions, Timing};
use spu_emulator::spe::Spe;

use crate::error::Errno;
use crate::process_memory::ProcessMemory;
use crate::report::ReportFile;

const TIMING: &str = "LIBSPE2_TIMING";
const REPORT: &str = "LIBSPE2_REPORT";
const PROFILE: &str = "LIBSPE2_PROFILE";
const TIMELINE: &str = "LIBSPE2_TIMELINE";
const MFC: &str = "LIBSPE2_MFC";
const ENGINE: &str = "LIBSPE2_ENGINE";
const CHECK: &str = "LIBSPE2_CHECK";
const DESCRIPTION: &str = "LIBSPE2_MACHINE";
const GDB: &str = "LIBSPE2_GDB";

static MACHINE: OnceLock<Machine> = OnceLock::new();

pub(crate) struct Machine {
    pub(crate) emulated: Arc<machine::Machine>,
    report: Option<ReportFile>,
    profile: Option<ReportFile>,
    timeline: Option<ReportFile>,
    programs: Arc<Programs>,
    /// Obeys a debugger, if the environment asks for one.
    pub(crate) debugger: Option<Arc<Debugger>>,
}

/// Returns the machine, creating it on the first call.
pub(crate) fn machine() -> Result<&'static Machine, Errno> {
    // One thread makes the machine, because the debugger's port is to be had only once.
    static MAKING: Mutex<()> = Mutex::new(());
    let _making = lock(&MAKING);
    if let Some(machine) = MACHINE.get() {
        return Ok(machine);
    }
    let made = Machine::from_environment()?;
    let machine = MACHINE.get_or_init(|| made);
    let files = [&machine.report, &machine.profile, &machine.timeline];
    if files.iter().any(|file| file.is_some()) {
        // SAFETY: the function takes no arguments and exists as long as the process.
        unsafe { libc::atexit(report_at_exit) };
    }
    Ok(machine)
}

extern "C" fn report_at_exit() {
    write_reports();
}

/// Writes the report, the profile and the timeline if the environment asks for them. An error goes
/// to standard error and does not fail the call.
pub(crate) fn write_reports() {
    let Some(machine) = MACHINE.get() else {
        return;
    };
    let Some(simulation) = machine.emulated.simulation() else {
        return;
    };
    if let Some(file) = &machine.report {
        report_failure(REPORT, file, file.write_report(simulation));
    }
    if let (Some(file), Some(profile)) = (&machine.profile, simulation.profile()) {
        report_failure(PROFILE, file, file.write_profile(&profile));
    }
    if let (Some(file), Some(timeline)) = (&machine.timeline, simulation.timeline()) {
        report_failure(TIMELINE, file, file.write_timeline(&timeline));
    }
}

fn report_failure(name: &str, file: &ReportFile, written: io::Result<()>) {
    if let Err(error) = written {
        messages::print!("libspe2: {name}: {}: {error}", file.path().display());
    }
}

fn refused(name: &str, expected: &str, value: &OsString) -> Errno {
    messages::print!("libspe2: {name} {expected}, not {value:?}");
    Errno(libc::EINVAL)
}

/// Whether the environment variable switches the feature on.
fn switch(name: &str) -> Result<bool, Errno> {
    match env::var_os(name) {
        None => Ok(false),
        Some(value) if value == "0" => Ok(false),
        Some(value) if value == "1" => Ok(true),
        Some(value) => Err(refused(name, "is 0 or 1", &value)),
    }
}

/// Whether the environment asks for simulated time.
pub(crate) fn timing() -> Result<bool, Errno> {
    switch(TIMING)
}

/// The port for a debugger, if the environment asks for one.
pub(crate) fn debugger_port() -> Result<Option<u16>, Errno> {
    let Some(value) = env::var_os(GDB) else {
        return Ok(None);
    };
    let port = value.to_str().and_then(|value| value.parse().ok());
    port.map(Some).ok_or_else(|| refused(GDB, "is a port, or 0 for any free one", &value))
}

/// Waits for a debugger, if the environment asks for one.
fn debugger() -> Result<Option<Arc<Debugger>>, Errno> {
    let Some(port) = debugger_port()? else {
        return Ok(None);
    };
    let debugger = Debugger::new(kill_this_process);
    match debugger.listen(port) {
        Ok(address) => messages::print!("libspe2: waiting for a debugger: target remote {address}"),
        Err(error) => {
            messages::print!("libspe2: {GDB}={port}: {error}");
            return Err(Errno(error.raw_os_error().unwrap_or(libc::EIO)));
        }
    }
    Ok(Some(debugger))
}

fn kill_this_process() {
    // SAFETY: the function takes no pointers.
    unsafe { libc::raise(libc::SIGKILL) };
}

/// What runs the SPUs' instructions.
fn engine(timing: bool) -> Result<Engine, Errno> {
    let engine = match env::var_os(ENGINE) {
        None => Engine::default(),
        Some(name) if name == "compiler" => Engine::Compiler,
        Some(name) if name == "interpreter" => Engine::Interpreter,
        Some(name) => return Err(refused(ENGINE, "is interpreter or compiler", &name)),
    };
    match (timing, switch(CHECK)?) {
        (false, true) if engine == Engine::Interpreter => {
            messages::print!(
                "libspe2: {CHECK}=1 does not go with {ENGINE}=interpreter: it compares both"
            );
            Err(Errno(libc::EINVAL))
        }
        (_, true) if engine == Engine::Compiler => Ok(Engine::Check),
        _ => Ok(engine),
    }
}

/// How cycles are counted in simulated time.
fn method() -> Result<Method, Errno> {
    Ok(match switch(CHECK)? {
        false => Method::Memoised,
        true => Method::Checked,
    })
}

/// When contexts carry out MFC commands.
pub(crate) fn policy() -> Result<Policy, Errno> {
    let policy = match env::var_os(MFC) {
        None => Policy::AtOnce,
        Some(name) if name == "at-once" => Policy::AtOnce,
        Some(name) if name == "at-last" => Policy::AtLast,
        Some(name) => return Err(refused(MFC, "is at-once or at-last", &name)),
    };
    if policy == Policy::AtLast && machine()?.emulated.simulation().is_some() {
        messages::print!(
            "libspe2: {MFC}=at-last does not go with {TIMING}=1, which times each command"
        );
        return Err(Errno(libc::ENOTSUP));
    }
    Ok(policy)
}

/// The file that this variable asks for.
fn place(name: &str, timing: bool) -> Result<Option<ReportFile>, Errno> {
    let Some(path) = path(name, timing)? else {
        return Ok(None);
    };
    let print =
        |error: &io::Error| messages::print!("libspe2: {name}: {}: {error}", path.display());
    Ok(Some(ReportFile::new(path.clone()).inspect_err(print)?))
}

/// The path in this variable, which needs simulated time.
fn path(name: &str, timing: bool) -> Result<Option<PathBuf>, Errno> {
    let Some(path) = env::var_os(name) else {
        return Ok(None);
    };
    if path.is_empty() {
        return Err(refused(name, "is a path", &path));
    }
    if !timing {
        messages::print!("libspe2: {name} is about simulated time: set {TIMING}=1 with it");
        return Err(Errno(libc::EINVAL));
    }
    Ok(Some(path.into()))
}

/// The latencies and rates of the machine in simulated time.
fn description(timing: bool) -> Result<Timing, Errno> {
    let Some(path) = path(DESCRIPTION, timing)? else {
        return Ok(Timing::default());
    };
    Timing::read(&path).map_err(|error| {
        messages::print!("libspe2: {DESCRIPTION}: {error}");
        Errno(libc::EINVAL)
    })
}

/// The files of the programs that were loaded, which name the places of a race.
type Programs = Mutex<HashMap<ProgramId, Box<[u8]>>>;

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Machine {
    /// A program is loaded onto an SPE. In simulated time its file is kept.
    pub(crate) fn loaded(&self, spe: &Spe, image: &[u8]) {
        let program = ProgramId::of(image);
        spe.profile_as(program);
        if self.emulated.simulation().is_some() {
            let mut programs = lock(&self.programs);
            programs.entry(program).or_insert_with(|| image.into());
        }
    }

    fn from_environment() -> Result<Self, Errno> {
        let memory = Arc::new(ProcessMemory);
        let timing = timing()?;
        let engine = engine(timing)?;
        let report = place(REPORT, timing)?;
        let profile = place(PROFILE, timing)?;
        let timeline = place(TIMELINE, timing)?;
        let description = description(timing)?;
        let options = SimulationOptions {
            profile: profile.is_some(),
            timeline: timeline.is_some(),
            races: timing,
            method: method()?,
            engine,
        };
        let emulated = if timing {
            machine::Machine::simulated_with(memory, description, options)
        } else {
            machine::Machine::with_engine(memory, engine)
        };
        emulated.optimize_in_background();
        let programs: Arc<Programs> = Arc::default();
        if let Some(simulation) = emulated.simulation() {
            let programs = Arc::clone(&programs);
            simulation.on_race(move |race| {
                let programs = lock(&programs);
                let bytes = race.program.and_then(|program| programs.get(&program));
                let image = bytes.and_then(|bytes| Image::parse(bytes).ok());
                let place = |address| match &image {
                    Some(image) => image.place(address),
                    None => format!("{address:#07x}"),
                };
                messages::print!("libspe2: warning: DMA race: {}", race.describe(place));
            });
        }
        Ok(Self { emulated, programs, debugger: debugger()?, report, profile, timeline })
    }
}
