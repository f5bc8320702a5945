//! Takes over the terminal's state and restores it.
//!
//! Invariant: the state is restored when a [`TerminalGuard`] is dropped, before a panic is
//! reported, and when the program ends or stops in any other way that the library's [`LastResort`]
//! catches. It is taken again when the program continues. Signal handlers do this with system
//! calls only. SIGKILL and SIGSTOP can't be caught.

use std::io;
use std::mem::MaybeUninit;
use std::panic;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

use cellray::framebuffer::LastResort;

/// Switches to the alternate screen, hides the cursor, disables line wrapping, and requests
/// reports of the focus and the mouse. If the terminal supports it, the mouse is also reported
/// without a button held, and keys are reported with their releases.
const BEGIN: &str =
    "\x1b[?1049h\x1b[?25l\x1b[?7l\x1b[2J\x1b[?1004h\x1b[?1002h\x1b[?1003h\x1b[?1006h\x1b[>11u";
const END: &str =
    "\x1b[<u\x1b[?1006l\x1b[?1003l\x1b[?1002l\x1b[?1004l\x1b[0m\x1b[?7h\x1b[?25h\x1b[?1049l";

/// The terminal's original and new settings. They are the program's, so they are set once.
static STATES: OnceLock<States> = OnceLock::new();
static IS_TAKEN: AtomicBool = AtomicBool::new(false);
/// Whether a stop has restored the terminal, so that it must be taken again.
static RETAKE_PENDING: AtomicBool = AtomicBool::new(false);
/// Whether the terminal was taken again since the last [`TerminalGuard::was_retaken`].
static WAS_RETAKEN: AtomicBool = AtomicBool::new(false);

static LAST_RESORT: LastResort = LastResort {
    restore: || {
        if restore() {
            RETAKE_PENDING.store(true, Ordering::SeqCst);
        }
    },
    retake: || {
        if RETAKE_PENDING.swap(false, Ordering::SeqCst) {
            // An error can't be reported here.
            let _ = take();
            WAS_RETAKEN.store(true, Ordering::SeqCst);
        }
    },
};

struct States {
    found: libc::termios,
    raw: libc::termios,
    has_pictures: bool,
}

/// Holds the terminal. Dropping it restores the terminal.
pub struct TerminalGuard(());

impl TerminalGuard {
    /// Takes over the terminal: keys arrive one by one, and with pictures it shows no other text.
    ///
    /// # Errors
    /// Standard input isn't a terminal, or its settings can't be changed.
    pub fn take(has_pictures: bool) -> io::Result<Self> {
        let found = modes()?;
        STATES.get_or_init(|| {
            let mut raw = found;
            // SAFETY: `raw` is a termios of its own.
            unsafe { libc::cfmakeraw(&raw mut raw) };
            if !has_pictures {
                // Messages are still printed, and the system handles Ctrl-C.
                raw.c_oflag = found.c_oflag;
                raw.c_lflag |= libc::ISIG;
            }
            let print = panic::take_hook();
            panic::set_hook(Box::new(move |what| {
                restore();
                print(what);
            }));
            States { found, raw, has_pictures }
        });
        // SAFETY: both functions only use atomics, a cell that is already set, and calls that
        // handlers may make.
        unsafe { LAST_RESORT.arm()? };
        let taken = Self(());
        take()?;
        Ok(taken)
    }

    /// Whether the terminal was restored and taken again since the last call, which loses its
    /// contents.
    pub fn was_retaken(&self) -> bool {
        WAS_RETAKEN.swap(false, Ordering::SeqCst)
    }
}

impl Drop for TerminalGuard {
    fn drop(&mut self) {
        restore();
    }
}

fn modes() -> io::Result<libc::termios> {
    let mut found = MaybeUninit::<libc::termios>::uninit();
    // SAFETY: the call writes a termios or fails.
    if unsafe { libc::tcgetattr(libc::STDIN_FILENO, found.as_mut_ptr()) } != 0 {
        return Err(io::Error::last_os_error());
    }
    // SAFETY: the call succeeded, so it wrote the termios.
    Ok(unsafe { found.assume_init() })
}

/// Takes the terminal. Signal handlers may call it.
fn take() -> io::Result<()> {
    let Some(states) = STATES.get() else {
        return Ok(());
    };
    IS_TAKEN.store(true, Ordering::SeqCst);
    // SAFETY: a valid termios, which is not changed any more.
    if unsafe { libc::tcsetattr(libc::STDIN_FILENO, libc::TCSANOW, &raw const states.raw) } != 0 {
        return Err(io::Error::last_os_error());
    }
    if states.has_pictures {
        write(BEGIN);
    }
    Ok(())
}

/// Restores the terminal if it is taken, and returns whether it was. Signal handlers may call it.
fn restore() -> bool {
    let was_taken = IS_TAKEN.swap(false, Ordering::SeqCst);
    if let Some(states) = STATES.get().filter(|_| was_taken) {
        if states.has_pictures {
            write(END);
        }
        // Unread input was meant for this program, not for the shell. SAFETY: both calls take a
        // descriptor, and the second one a valid termios, which is not changed any more.
        unsafe {
            libc::tcflush(libc::STDIN_FILENO, libc::TCIFLUSH);
            libc::tcsetattr(libc::STDIN_FILENO, libc::TCSANOW, &raw const states.found);
        }
    }
    was_taken
}

/// Writes to the terminal without any buffer. Errors are ignored, because nobody could see them.
fn write(text: &str) {
    let mut rest = text.as_bytes();
    while !rest.is_empty() {
        // SAFETY: the bytes are those of a slice.
        let written = unsafe { libc::write(libc::STDOUT_FILENO, rest.as_ptr().cast(), rest.len()) };
        match usize::try_from(written) {
            Ok(written @ 1..) => rest = &rest[written..],
            _ => return,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs::File;
    use std::io::{IsTerminal as _, Read as _};
    use std::os::fd::{FromRawFd as _, OwnedFd};
    use std::process::{Command, Stdio};

    const NAME: &str = "display::terminal::restore::tests::panic_is_reported_on_restored_terminal";
    /// Set in the process that panics.
    const PANICS: &str = "CELLRAY_TEST_PANICS";

    #[test]
    fn panic_is_reported_on_restored_terminal() {
        if std::env::var_os(PANICS).is_some() && io::stdin().is_terminal() {
            let _taken = TerminalGuard::take(true).expect("a terminal");
            panic!("as a game does");
        }
        let (mut ours, mut theirs) = (-1, -1);
        let none = std::ptr::null_mut();
        // SAFETY: the call writes two descriptors.
        let opened = unsafe {
            libc::openpty(&raw mut ours, &raw mut theirs, none, none.cast(), none.cast())
        };
        assert_eq!(opened, 0);
        // SAFETY: both were just opened, and have no other owner.
        let (mut ours, theirs) = unsafe { (File::from_raw_fd(ours), OwnedFd::from_raw_fd(theirs)) };
        let stdio = || Stdio::from(theirs.try_clone().expect("a descriptor"));
        let mut command = Command::new(std::env::current_exe().expect("this program"));
        command.args(["--exact", NAME, "--nocapture"]).env(PANICS, "1");
        command.stdin(stdio()).stdout(stdio()).stderr(stdio());
        let mut child = command.spawn().expect("this program");
        // If the child ends early, reading ends too.
        drop((command, theirs));
        let mut seen = String::new();
        let mut bytes = [0; 4096];
        while !seen.contains("as a game does") {
            let count = ours.read(&mut bytes).expect("what is said");
            seen += &String::from_utf8_lossy(&bytes[..count]);
        }
        let message = seen.find("as a game does");
        let (begin, end) = (seen.find(BEGIN), seen.find(END));
        assert!(begin.is_some() && begin < end && end < message, "{seen:?}");
        // Lines begin at the left, so the terminal's modes are restored.
        let line = seen[message.unwrap_or_default()..].trim_start_matches("as a game does");
        assert!(line.is_empty() || line.starts_with("\r\n"), "{seen:?}");
        child.kill().expect("a child");
        child.wait().expect("its end");
    }
}
