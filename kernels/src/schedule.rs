//! The scheduled versions of the kernels: made of the plain ones, compared with them, and held to
//! the model.
//!
//! Invariant: a scheduled file that is not stale is what the scheduler makes of the plain one, byte
//! for byte.

use std::fs;
use std::path::{Path, PathBuf};

use spu_build::Tools;
use spu_isa::timing::Rules;
use spu_scheduler::Scheduled;
use spu_scheduler::check::{self, CheckError};
use spu_scheduler::code::{Code, CodeError};
use tempfile::TempDir;
use thiserror::Error;

use crate::source::Source;

/// The constants that the build generates from the layouts of records.
const WORK_UNIT: &str = include_str!(concat!(env!("OUT_DIR"), "/include/work_unit.inc"));

/// Why there is no schedule, or it could not be checked.
#[derive(Debug, Error)]
pub enum ScheduleError {
    /// A source is not assembled.
    #[error(transparent)]
    Assembler(#[from] spu_build::Error),
    /// A file can't be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// The system's error.
        source: std::io::Error,
    },
    /// The scheduler refuses a plain source.
    #[error("{}: {source}", path.display())]
    Scheduler {
        /// The source.
        path: PathBuf,
        /// Why.
        source: spu_scheduler::ScheduleError,
    },
    /// An object has no code.
    #[error("{}: {source}", path.display())]
    Code {
        /// The source.
        path: PathBuf,
        /// Why.
        source: CodeError,
    },
    /// The notes of a scheduled version can't be checked.
    #[error("{}: {source}", path.display())]
    Check {
        /// The source.
        path: PathBuf,
        /// Why.
        source: CheckError,
    },
    /// Scheduled files are missing or not what the scheduler makes now.
    #[error("stale: {}; write them anew with --schedule", .0.join(", "))]
    Stale(Vec<String>),
}

/// Makes scheduled versions in the repository.
#[derive(Debug)]
pub struct Workshop {
    root: PathBuf,
    tools: Tools,
    includes: Vec<PathBuf>,
    work: TempDir,
}

impl Workshop {
    /// For the sources of the repository in this folder.
    pub fn new(root: &Path) -> Result<Self, ScheduleError> {
        let failed = |path: &Path| {
            let path = path.to_path_buf();
            |source| ScheduleError::File { path, source }
        };
        let work = tempfile::tempdir().map_err(failed(&std::env::temp_dir()))?;
        let generated = work.path().join("work_unit.inc");
        fs::write(&generated, WORK_UNIT).map_err(failed(&generated))?;
        let includes = vec![root.join("spu/include"), work.path().to_path_buf()];
        Ok(Self {
            root: root.to_path_buf(),
            tools: Tools::find()?,
            includes,
            work,
        })
    }

    /// For the sources of this repository.
    pub fn here() -> Result<Self, ScheduleError> {
        Self::new(&Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
    }

    /// The kernel's schedule, made anew from its plain file.
    pub fn schedule(&self, kernel: &Source) -> Result<Scheduled, ScheduleError> {
        let path = self.root.join(kernel.file);
        let text = read(&path)?;
        let object = self.assemble(kernel, &path)?;
        let assemble = |text: &str| {
            let path = self.work.path().join(format!("{}.s", kernel.name));
            match fs::write(&path, text) {
                Ok(()) => self.assemble(kernel, &path),
                Err(source) => Err(ScheduleError::File { path, source }),
            }
        };
        spu_scheduler::schedule(&object, &path.to_string_lossy(), &text, assemble)
            .map_err(|source| ScheduleError::Scheduler { path, source })
    }

    /// Writes the scheduled versions of kernels.
    pub fn write(&self, kernels: &[Source]) -> Result<(), ScheduleError> {
        for kernel in kernels {
            let scheduled = self.schedule(kernel)?;
            let path = self.root.join(kernel.scheduled_file());
            fs::write(&path, scheduled.text)
                .map_err(|source| ScheduleError::File { path, source })?;
        }
        Ok(())
    }

    /// Compares the scheduled versions of kernels with what the scheduler makes now; the error names all that
    /// are stale.
    pub fn check(&self, kernels: &[Source]) -> Result<(), ScheduleError> {
        let mut stale = Vec::new();
        for kernel in kernels {
            let file = kernel.scheduled_file();
            let path = self.root.join(&file);
            let found = match fs::read_to_string(&path) {
                Ok(text) => Some(text),
                Err(error) if error.kind() == std::io::ErrorKind::NotFound => None,
                Err(source) => return Err(ScheduleError::File { path, source }),
            };
            if found != Some(self.schedule(kernel)?.text) {
                stale.push(file);
            }
        }
        if stale.is_empty() {
            Ok(())
        } else {
            Err(ScheduleError::Stale(stale))
        }
    }

    /// Compares the notes of the kernel's scheduled version with the model, as `spu time --check`.
    pub fn notes(&self, kernel: &Source) -> Result<check::Outcome, ScheduleError> {
        let path = self.root.join(kernel.scheduled_file());
        let text = read(&path)?;
        let object = self.assemble(kernel, &path)?;
        let code = Code::parse(&object).map_err(|source| ScheduleError::Code {
            path: path.clone(),
            source,
        })?;
        check::check(&code, &[(path.clone(), text)], Rules::default())
            .map_err(|source| ScheduleError::Check { path, source })
    }

    fn assemble(&self, kernel: &Source, path: &Path) -> Result<Vec<u8>, ScheduleError> {
        let object = self.work.path().join(format!("{}.o", kernel.name));
        // The scheduler needs the names of registers, which an image leaves out.
        self.tools.assemble(&self.includes, &[], &object, path)?;
        fs::read(&object).map_err(|source| ScheduleError::File {
            path: object,
            source,
        })
    }
}

fn read(path: &Path) -> Result<String, ScheduleError> {
    fs::read_to_string(path).map_err(|source| ScheduleError::File {
        path: path.to_path_buf(),
        source,
    })
}
