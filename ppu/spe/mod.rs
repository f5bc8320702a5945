//! A safe interface to SPE contexts. Only this module calls libspe2.
//!
//! Many threads may use a [`Context`] at the same time, as the library allows. One of them stays
//! in [`Context::run`] while the SPU runs.

mod context;
mod elf;
mod error;
mod event;
mod program;
mod sys;

pub use context::{Context, Ended, Outcome, library_path, usable_spes};
pub use error::ProgramError;
pub use event::{Event, Events};
pub use program::{Image, Program};

/// A failed call of libspe2.
#[derive(Debug, thiserror::Error)]
#[error("libspe2: {call}: {source}")]
pub struct SpeError {
    /// The name of the C function.
    pub call: &'static str,
    /// The error from errno.
    pub source: std::io::Error,
}

impl SpeError {
    fn last(call: &'static str) -> Self {
        Self { call, source: std::io::Error::last_os_error() }
    }
}

// Links libspe2 into the program if there is no shared library for it.
#[cfg(any(not(target_arch = "powerpc64"), target_env = "musl"))]
use spe2 as _;
