//! Error messages and exit statuses of the subcommands.

use std::error::Error;
use std::fmt::Display;
use std::path::Path;
use std::process::ExitCode;

/// The file is not an SPU program.
pub const BAD_ELF: u8 = 126;
/// Wrong usage, or a file that can't be used.
pub const USAGE: u8 = 127;

/// Why a subcommand could not do its work.
#[derive(Debug)]
pub struct Failure {
    message: String,
    status: u8,
}

impl Failure {
    pub fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), status: USAGE }
    }

    /// The file is not an SPU program.
    pub fn bad_elf(message: String) -> Self {
        Self { message, status: BAD_ELF }
    }

    /// An error in a file.
    pub fn file<E: Display>(path: &Path) -> impl FnOnce(E) -> Self {
        Self::of(path.display())
    }

    /// An error in something with this name.
    pub fn of<E: Display>(what: impl Display) -> impl FnOnce(E) -> Self {
        let what = what.to_string();
        move |error| Self::new(format!("{what}: {error}"))
    }
}

impl<E: Error> From<E> for Failure {
    fn from(error: E) -> Self {
        Self::new(error.to_string())
    }
}

/// Prints a failure and returns the exit status.
pub fn fail(failure: &Failure) -> ExitCode {
    messages::print!("spu: {}", failure.message);
    failure.status.into()
}
