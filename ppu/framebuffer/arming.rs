//! Arms a last resort: catches all signals that end the program, ask it to end, or stop it.

use super::last_resort::LastResort;
use super::{interrupted, switching};
use std::io;

impl LastResort {
    /// Calls its functions from now on, in place of those of an earlier one.
    ///
    /// # Errors
    /// The system refuses to install the signal handlers.
    ///
    /// # Safety
    ///
    /// Signal handlers call both functions, on any thread, at any time. The functions may use
    /// atomics and the system calls that POSIX permits in handlers. They must not allocate, take a
    /// lock, or panic.
    pub unsafe fn arm(&'static self) -> io::Result<()> {
        // SAFETY: the caller's promise.
        unsafe { self.take_place() };
        interrupted::watch()?;
        switching::watch()
    }
}
