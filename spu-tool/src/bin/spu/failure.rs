//! How a verb ends when it can't do its work: messages and exit statuses.

use std::error::Error;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use spu_emulator::elf::ElfError;
use thiserror::Error;

/// The file is no SPU program.
pub const BAD_ELF: u8 = 126;
/// Wrong usage, or a file that can't be used.
pub const USAGE: u8 = 127;

/// Why a verb could not do its work.
#[derive(Debug, Error)]
pub enum Failure {
    #[error("{path}: {error}")]
    File { path: PathBuf, error: io::Error },
    #[error("{path}: {error}")]
    Elf { path: PathBuf, error: ElfError },
    #[error("{path}: {what}")]
    Contents { path: PathBuf, what: String },
    #[error("standard output: {0}")]
    Output(io::Error),
    /// What only one verb knows.
    #[error(transparent)]
    Verb(Box<dyn Error>),
}

impl Failure {
    pub fn verb(error: impl Error + 'static) -> Self {
        Self::Verb(Box::new(error))
    }

    pub fn file(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_path_buf();
        |error| Self::File { path, error }
    }
}

/// Tells of a failure; the status to exit with.
pub fn fail(failure: &Failure) -> ExitCode {
    // Who closed standard error sees the status.
    let _ = writeln!(io::stderr(), "spu: {failure}");
    let status = match failure {
        Failure::Elf { .. } => BAD_ELF,
        _ => USAGE,
    };
    status.into()
}
