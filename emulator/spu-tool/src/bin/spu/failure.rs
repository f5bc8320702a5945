//! Error messages and exit statuses of the subcommands.

use std::error::Error;
use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use spu_emulator::elf::ElfError;
use thiserror::Error;

/// The file is not an SPU program.
pub const BAD_ELF: u8 = 126;
/// Wrong usage, or a file that can't be used.
pub const USAGE: u8 = 127;

/// Why a subcommand could not do its work.
#[derive(Debug, Error)]
pub enum Failure {
    #[error("{path}: {error}")]
    File { path: PathBuf, error: io::Error },
    #[error("{path}: {error}{advice}")]
    Elf {
        path: PathBuf,
        error: ElfError,
        /// A remedy, or empty.
        advice: String,
    },
    #[error("{path}: {what}")]
    Contents { path: PathBuf, what: String },
    #[error(transparent)]
    Output(io::Error),
    /// A mistake in the command line, and its correction.
    #[error("{0}")]
    Usage(String),
    /// An error that only one subcommand has.
    #[error(transparent)]
    Command(Box<dyn Error>),
}

impl Failure {
    pub fn command(error: impl Error + 'static) -> Self {
        Self::Command(Box::new(error))
    }

    pub fn file(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_path_buf();
        |error| Self::File { path, error }
    }
}

/// Prints a failure and returns the exit status.
pub fn fail(failure: &Failure) -> ExitCode {
    messages::print!("spu: {failure}");
    let status = match failure {
        Failure::Elf { .. } => BAD_ELF,
        _ => USAGE,
    };
    status.into()
}
