//! Arming a last resort: every signal that it is for is caught from then on, those that end the
//! program, ask it to end or stop it.

use super::last_resort::LastResort;
use super::{interrupted, switching};
use std::io;

impl LastResort {
    /// Has it called from now on, in the place of one that was armed before.
    ///
    /// # Safety
    ///
    /// Both functions are called in signal handlers, on any thread, at any moment: they may use
    /// atomics and the system calls that POSIX lets handlers make, and neither allocate, nor take
    /// a lock, nor panic.
    pub unsafe fn arm(&'static self) -> io::Result<()> {
        // SAFETY: the caller's promise.
        unsafe { self.take_place() };
        interrupted::watch()?;
        switching::watch()
    }
}
