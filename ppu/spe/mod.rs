//! SPE contexts, safely: the one place that calls libspe2.
//!
//! A [`Context`] may be used by many threads at once, as the library allows; one of them sits in
//! [`Context::run`] while the SPU runs.

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

/// A call of libspe2 that failed.
#[derive(Debug, thiserror::Error)]
#[error("libspe2: {call}: {source}")]
pub struct SpeError {
    /// The C function.
    pub call: &'static str,
    /// What errno said.
    pub source: std::io::Error,
}

impl SpeError {
    fn last(call: &'static str) -> Self {
        Self {
            call,
            source: std::io::Error::last_os_error(),
        }
    }
}

// Makes libspe2 part of the program where no shared library takes its place.
#[cfg(not(target_arch = "powerpc64"))]
use spe2 as _;
