//! Error numbers, as they go back to the guest.
//!
//! They are the host's: newlib's numbers and Linux's agree in what these calls can give.

use std::io;

/// Why a call failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Errno(pub i32);

impl Errno {
    /// What the last system call of this thread left.
    pub(super) fn last() -> Self {
        io::Error::last_os_error().into()
    }

    /// The system's text for it, as `perror` prints it.
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

/// A system call's answer, of which a negative one means that it failed.
pub(super) fn check<T: Copy + PartialOrd + From<i8>>(answer: T) -> Result<T, Errno> {
    if answer < T::from(0) {
        Err(Errno::last())
    } else {
        Ok(answer)
    }
}
