//! The machine that every context of the process is on, as the environment asks for it.
//!
//! Invariant: the environment is read when the first context is created; what it says then holds for
//! the whole process.

use std::env;
use std::ffi::OsString;
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use spu_emulator::mfc::{Interconnect, Policy};
use spu_emulator::simulated::Simulation;

use crate::error::Errno;
use crate::process_memory::ProcessMemory;
use crate::report::ReportFile;

const TIMING: &str = "LIBSPE2_TIMING";
const REPORT: &str = "LIBSPE2_REPORT";
const MFC: &str = "LIBSPE2_MFC";

static MACHINE: OnceLock<Machine> = OnceLock::new();

/// The one machine.
pub(crate) struct Machine {
    pub(crate) interconnect: Arc<Interconnect>,
    report: Option<ReportFile>,
}

/// The machine, made now if there is none.
pub(crate) fn machine() -> Result<&'static Machine, Errno> {
    if let Some(machine) = MACHINE.get() {
        return Ok(machine);
    }
    let made = Machine::from_environment()?;
    let machine = MACHINE.get_or_init(|| made);
    if machine.report.is_some() {
        // SAFETY: the function takes nothing and is there as long as the process is.
        unsafe { libc::atexit(report_at_exit) };
    }
    Ok(machine)
}

extern "C" fn report_at_exit() {
    write_report();
}

/// Writes the report, where one is asked for. A failure is told, and no reason to fail.
pub(crate) fn write_report() {
    if let Some(machine) = MACHINE.get()
        && let (Some(file), Some(simulation)) = (&machine.report, machine.simulation())
        && let Err(error) = file.write(&simulation.report())
    {
        eprintln!("libspe2: {REPORT}: {}: {error}", file.path().display());
    }
}

fn refused(name: &str, expected: &str, value: &OsString) -> Errno {
    eprintln!("libspe2: {name} {expected}, not {value:?}");
    Errno(libc::EINVAL)
}

fn timing() -> Result<bool, Errno> {
    match env::var_os(TIMING) {
        None => Ok(false),
        Some(value) if value == "0" => Ok(false),
        Some(value) if value == "1" => Ok(true),
        Some(value) => Err(refused(TIMING, "is 0 or 1", &value)),
    }
}

/// When contexts carry MFC commands out.
pub(crate) fn policy() -> Result<Policy, Errno> {
    let policy = match env::var_os(MFC) {
        None => Policy::AtOnce,
        Some(name) if name == "at-once" => Policy::AtOnce,
        Some(name) if name == "at-last" => Policy::AtLast,
        Some(name) => return Err(refused(MFC, "is at-once or at-last", &name)),
    };
    if policy == Policy::AtLast && machine()?.simulation().is_some() {
        eprintln!("libspe2: {MFC}=at-last does not go with {TIMING}=1, which times each command");
        return Err(Errno(libc::ENOTSUP));
    }
    Ok(policy)
}

impl Machine {
    fn from_environment() -> Result<Self, Errno> {
        let memory = Arc::new(ProcessMemory);
        let timing = timing()?;
        let report = match env::var_os(REPORT) {
            None => None,
            Some(path) if path.is_empty() => return Err(refused(REPORT, "is a path", &path)),
            Some(_) if !timing => {
                eprintln!("libspe2: {REPORT} reports simulated time: set {TIMING}=1 with it");
                return Err(Errno(libc::EINVAL));
            }
            Some(path) => {
                let path = PathBuf::from(path);
                let told = |error: &std::io::Error| {
                    eprintln!("libspe2: {REPORT}: {}: {error}", path.display());
                };
                Some(ReportFile::new(path.clone()).inspect_err(told)?)
            }
        };
        Ok(Self {
            interconnect: if timing {
                Interconnect::simulated(memory)
            } else {
                Interconnect::new(memory)
            },
            report,
        })
    }

    fn simulation(&self) -> Option<&Arc<Simulation>> {
        self.interconnect.simulation()
    }
}
