//! The report of simulated time, the profile and the timeline, which are JSON files.
//!
//! Invariant: the file at the path is complete at every moment, because each version is written to
//! a file next to it, which is then renamed. It contains nothing about the host, so equal runs
//! produce equal files. Only a timeline has addresses of the process.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use serde::Serialize;
use spu_emulator::decrementer::TICKS_PER_SECOND;
use spu_emulator::profile::SpeProfile;
use spu_emulator::simulated::{CYCLES_PER_SECOND, Simulation, SpeReport, Timeline};
use spu_reports::{Figures, ProfileFile, TimelineFile};

/// The path to which a report, a profile or a timeline is written.
pub(crate) struct ReportFile {
    path: PathBuf,
    /// Held while a version is written.
    beside: Mutex<PathBuf>,
}

impl ReportFile {
    /// Fails if nothing can be written there.
    pub(crate) fn new(path: PathBuf) -> io::Result<Self> {
        let mut name = match path.file_name() {
            Some(name) if !path.is_dir() => name.to_owned(),
            _ => return Err(io::Error::from_raw_os_error(libc::EISDIR)),
        };
        name.push(format!(".{}", std::process::id()));
        let beside = path.with_file_name(name);
        fs::write(&beside, "").and_then(|()| fs::remove_file(&beside))?;
        Ok(Self { path, beside: Mutex::new(beside) })
    }

    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    pub(crate) fn write_report(&self, simulation: &Simulation) -> io::Result<()> {
        self.write(serde_json::to_vec_pretty(&Report::new(simulation))?)
    }

    pub(crate) fn write_profile(&self, spes: &[SpeProfile]) -> io::Result<()> {
        self.write(serde_json::to_vec(&ProfileFile::new(CYCLES_PER_SECOND, spes))?)
    }

    pub(crate) fn write_timeline(&self, spes: &[Timeline]) -> io::Result<()> {
        self.write(serde_json::to_vec(&TimelineFile::new(CYCLES_PER_SECOND, spes))?)
    }

    fn write(&self, mut json: Vec<u8>) -> io::Result<()> {
        json.push(b'\n');
        let beside = self.beside.lock().unwrap_or_else(PoisonError::into_inner);
        fs::write(&*beside, json)?;
        fs::rename(&*beside, &self.path)
    }
}

#[derive(Serialize)]
struct Report {
    cycles_per_second: u64,
    timebase_per_second: u64,
    /// The latest of the SPEs' times.
    cycles: u64,
    seconds: f64,
    /// Times that the SPEs did not wait for the PPE any longer.
    timeouts: u64,
    constants: BTreeMap<&'static str, u64>,
    totals: Figures,
    spes: Vec<Spe>,
}

#[derive(Serialize)]
struct Spe {
    /// The SPE's clock: the sum of `stopped` and of the cycles in its figures.
    clock: u64,
    stopped: u64,
    #[serde(flatten)]
    figures: Figures,
}

impl Report {
    fn new(simulation: &Simulation) -> Self {
        let report = simulation.report();
        let mut totals = Figures::default();
        for spe in &report.spes {
            totals.add(spe);
        }
        let spe = |spe: &SpeReport| {
            let mut figures = Figures::default();
            figures.add(spe);
            Spe { clock: spe.clock, stopped: spe.stopped, figures }
        };
        Self {
            cycles_per_second: CYCLES_PER_SECOND,
            timebase_per_second: TICKS_PER_SECOND,
            cycles: report.clock(),
            seconds: report.clock() as f64 / CYCLES_PER_SECOND as f64,
            timeouts: report.timeouts,
            constants: simulation.timing().named().collect(),
            totals,
            spes: report.spes.iter().map(spe).collect(),
        }
    }
}
