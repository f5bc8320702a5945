//! What is a terminal of this machine's own keyboard and screen: what is typed there is heard of
//! its keyboard, too.

use std::os::fd::{AsRawFd as _, BorrowedFd};

/// Whether a terminal is one of this machine's own keyboard and screen, and not one of a window or
/// over ssh.
#[must_use]
pub fn is_of_console(terminal: BorrowedFd<'_>) -> bool {
    /// KDGKBTYPE.
    const KEYBOARD_TYPE: libc::Ioctl = 0x4B33;
    let mut kind: libc::c_char = 0;
    // SAFETY: the descriptor is open; the call writes one byte.
    unsafe { libc::ioctl(terminal.as_raw_fd(), KEYBOARD_TYPE, &raw mut kind) == 0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use std::os::fd::AsFd as _;

    #[test]
    fn what_is_no_virtual_terminal_has_no_keyboard() {
        let null = fs::File::open("/dev/null").expect("a device");
        assert!(!is_of_console(null.as_fd()));
        // One as of a window or over ssh.
        if let Ok(terminal) = fs::File::open("/dev/ptmx") {
            assert!(!is_of_console(terminal.as_fd()));
        }
    }
}
