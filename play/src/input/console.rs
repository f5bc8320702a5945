//! Detects terminals of this machine's own keyboard and screen. Keys typed there are also reported
//! by the keyboard device.

use std::os::fd::{AsRawFd as _, BorrowedFd};

/// Whether a terminal belongs to this machine's own keyboard and screen, and not to a window or to
/// ssh.
#[must_use]
pub fn is_of_console(terminal: BorrowedFd<'_>) -> bool {
    /// KDGKBTYPE.
    const KEYBOARD_TYPE: libc::Ioctl = 0x4B33;
    let mut kind: libc::c_char = 0;
    // SAFETY: the descriptor is open, and the call writes one byte.
    unsafe { libc::ioctl(terminal.as_raw_fd(), KEYBOARD_TYPE, &raw mut kind) == 0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use std::os::fd::AsFd as _;

    #[test]
    fn other_device_has_no_console_keyboard() {
        let null = fs::File::open("/dev/null").expect("a device");
        assert!(!is_of_console(null.as_fd()));
        // A terminal like that of a window or of ssh.
        if let Ok(terminal) = fs::File::open("/dev/ptmx") {
            assert!(!is_of_console(terminal.as_fd()));
        }
    }
}
