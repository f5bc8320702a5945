//! A safe interface to SPE contexts. Only this module calls libspe2.
//!
//! Where there are no threads and no libspe2, in a browser, `in_turn` has the same types for
//! emulated SPEs that run in turn while [`Events::wait`] waits.
//!
//! Many threads may use a [`Context`] at the same time, as the library allows. One of them stays
//! in [`Context::run`] while the SPU runs.

#[cfg(unix)]
mod context;
mod elf;
mod ended;
mod error;
#[cfg(unix)]
mod event;
#[cfg(not(unix))]
mod in_turn;
mod program;
#[cfg(unix)]
mod running;
#[cfg(unix)]
mod sys;

#[cfg(unix)]
pub use context::{Context, library_path, usable_spes};
pub use ended::{Ended, Outcome};
pub use error::ProgramError;
#[cfg(unix)]
pub use event::Events;
#[cfg(not(unix))]
pub use in_turn::{Context, Events, Instant, Running, use_machine};
pub use program::{Image, Program};
#[cfg(unix)]
pub use running::Running;
#[cfg(unix)]
pub use std::time::Instant;

/// An event of an SPE.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// Its outbound interrupt mailbox has a word.
    Reply,
    /// Its program ended.
    Stopped,
}

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
    #[cfg(unix)]
    fn last(call: &'static str) -> Self {
        Self { call, source: std::io::Error::last_os_error() }
    }
}

// Links libspe2 into the program if there is no shared library for it.
#[cfg(all(unix, any(not(target_arch = "powerpc64"), target_env = "musl")))]
use spe2 as _;
