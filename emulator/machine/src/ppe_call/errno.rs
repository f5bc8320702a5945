//! Error numbers that are returned to the guest.
//!
//! They are the host's numbers. newlib's and Linux's numbers agree for all errors that these calls
//! can return.

use std::io;

/// Why a call failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Errno(pub i32);

impl Errno {
    /// The error number of this thread's last system call.
    pub(super) fn last() -> Self {
        io::Error::last_os_error().into()
    }

    /// The system's text for the error, as `perror` prints it.
    pub(super) fn text(self) -> String {
        let text = io::Error::from_raw_os_error(self.0).to_string();
        // The standard library appends the number, which C does not.
        match text.rfind(" (os error ") {
            Some(end) => text[..end].to_owned(),
            None => text,
        }
    }
}

impl From<io::Error> for Errno {
    fn from(error: io::Error) -> Self {
        Self(error.raw_os_error().unwrap_or(libc::EIO))
    }
}

/// The result of a system call. A negative one means that the call failed.
pub(super) fn check<T: Copy + PartialOrd + From<i8>>(result: T) -> Result<T, Errno> {
    if result < T::from(0) { Err(Errno::last()) } else { Ok(result) }
}
