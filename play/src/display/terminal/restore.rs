//! The terminal's state, taken over and put back.
//!
//! Invariant: it is put back when a [`Taken`] is dropped, before a panic is told, by whatever else
//! ends the program or stops it, as far as the library's [`LastResort`] hears of it, and taken
//! again when the program goes on. Those run in signal handlers: by system calls alone. SIGKILL
//! and SIGSTOP can't be heard of.

use std::io;
use std::mem::MaybeUninit;
use std::panic;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

use cellray::framebuffer::LastResort;

/// Other screen, no cursor, no line wrap; focus and mouse are told, where that is known also
/// without a button held; keys with their releases, where that is.
const BEGIN: &str =
    "\x1b[?1049h\x1b[?25l\x1b[?7l\x1b[2J\x1b[?1004h\x1b[?1002h\x1b[?1003h\x1b[?1006h\x1b[>11u";
const END: &str =
    "\x1b[<u\x1b[?1006l\x1b[?1003l\x1b[?1002l\x1b[?1004l\x1b[0m\x1b[?7h\x1b[?25h\x1b[?1049l";

/// The terminal as it was found and as it is ours; of the program, so it is set once.
static STATES: OnceLock<States> = OnceLock::new();
static IS_TAKEN: AtomicBool = AtomicBool::new(false);
/// A stop has put it back.
static IS_TO_TAKE: AtomicBool = AtomicBool::new(false);
/// Taken again, and nobody has been told.
static IS_BACK: AtomicBool = AtomicBool::new(false);

static LAST_RESORT: LastResort = LastResort {
    restore: || {
        if put_back() {
            IS_TO_TAKE.store(true, Ordering::SeqCst);
        }
    },
    retake: || {
        if IS_TO_TAKE.swap(false, Ordering::SeqCst) {
            // Nobody is there to be told of an error.
            let _ = take();
            IS_BACK.store(true, Ordering::SeqCst);
        }
    },
};

struct States {
    found: libc::termios,
    ours: libc::termios,
    has_pictures: bool,
}

/// The terminal, while it is ours.
pub struct Taken(());

impl Taken {
    /// Takes the terminal over: keys come one by one, and no one else's text is shown if pictures
    /// are.
    pub fn take(has_pictures: bool) -> io::Result<Self> {
        let found = modes()?;
        STATES.get_or_init(|| {
            let mut ours = found;
            // SAFETY: `ours` is a termios of its own.
            unsafe { libc::cfmakeraw(&raw mut ours) };
            if !has_pictures {
                // Messages go on, and Ctrl-C is the system's.
                ours.c_oflag = found.c_oflag;
                ours.c_lflag |= libc::ISIG;
            }
            let tell = panic::take_hook();
            panic::set_hook(Box::new(move |what| {
                put_back();
                tell(what);
            }));
            States {
                found,
                ours,
                has_pictures,
            }
        });
        // SAFETY: both functions use atomics, a cell that is set by now, and calls that handlers
        // may make.
        unsafe { LAST_RESORT.arm()? };
        let taken = Self(());
        take()?;
        Ok(taken)
    }

    /// Whether it was put back and taken again since the last call: nothing that was shown is
    /// there any more.
    pub fn is_back(&self) -> bool {
        IS_BACK.swap(false, Ordering::SeqCst)
    }
}

impl Drop for Taken {
    fn drop(&mut self) {
        put_back();
    }
}

fn modes() -> io::Result<libc::termios> {
    let mut found = MaybeUninit::<libc::termios>::uninit();
    // SAFETY: the call writes a termios or fails.
    if unsafe { libc::tcgetattr(libc::STDIN_FILENO, found.as_mut_ptr()) } != 0 {
        return Err(io::Error::last_os_error());
    }
    // SAFETY: the call succeeded, so it wrote it.
    Ok(unsafe { found.assume_init() })
}

/// Takes the terminal. May be called from a signal handler.
fn take() -> io::Result<()> {
    let Some(states) = STATES.get() else {
        return Ok(());
    };
    IS_TAKEN.store(true, Ordering::SeqCst);
    // SAFETY: a valid termios, which is not changed any more.
    if unsafe { libc::tcsetattr(libc::STDIN_FILENO, libc::TCSANOW, &raw const states.ours) } != 0 {
        return Err(io::Error::last_os_error());
    }
    if states.has_pictures {
        write(BEGIN);
    }
    Ok(())
}

/// Puts the terminal back, once, and says whether it was taken. May be called from a signal
/// handler.
fn put_back() -> bool {
    let was_taken = IS_TAKEN.swap(false, Ordering::SeqCst);
    if let Some(states) = STATES.get().filter(|_| was_taken) {
        if states.has_pictures {
            write(END);
        }
        // What was typed and not read was for us, not for the shell. SAFETY: both calls take a
        // descriptor, and the second a valid termios, which is not changed any more.
        unsafe {
            libc::tcflush(libc::STDIN_FILENO, libc::TCIFLUSH);
            libc::tcsetattr(libc::STDIN_FILENO, libc::TCSANOW, &raw const states.found);
        }
    }
    was_taken
}

/// Writes to the terminal, past all buffers. If it can't be, there is nobody to see it.
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

    const NAME: &str =
        "display::terminal::restore::tests::a_panic_is_told_on_the_terminal_as_it_was";
    /// Set in the process that panics.
    const PANICS: &str = "CELLRAY_TEST_PANICS";

    #[test]
    fn a_panic_is_told_on_the_terminal_as_it_was() {
        if std::env::var_os(PANICS).is_some() && io::stdin().is_terminal() {
            let _taken = Taken::take(true).expect("a terminal");
            panic!("as a game does");
        }
        let (mut ours, mut theirs) = (-1, -1);
        let none = std::ptr::null_mut();
        // SAFETY: the call writes two descriptors.
        let opened = unsafe {
            libc::openpty(
                &raw mut ours,
                &raw mut theirs,
                none,
                none.cast(),
                none.cast(),
            )
        };
        assert_eq!(opened, 0);
        // SAFETY: both were just opened, and are nobody else's.
        let (mut ours, theirs) = unsafe { (File::from_raw_fd(ours), OwnedFd::from_raw_fd(theirs)) };
        let stdio = || Stdio::from(theirs.try_clone().expect("a descriptor"));
        let mut command = Command::new(std::env::current_exe().expect("this program"));
        command
            .args(["--exact", NAME, "--nocapture"])
            .env(PANICS, "1");
        command.stdin(stdio()).stdout(stdio()).stderr(stdio());
        let mut child = command.spawn().expect("this program");
        // Its end, however early, ends the reading.
        drop((command, theirs));
        let mut seen = String::new();
        let mut bytes = [0; 4096];
        while !seen.contains("as a game does") {
            let count = ours.read(&mut bytes).expect("what is said");
            seen += &String::from_utf8_lossy(&bytes[..count]);
        }
        let told = seen.find("as a game does");
        let (begin, end) = (seen.find(BEGIN), seen.find(END));
        assert!(begin.is_some() && begin < end && end < told, "{seen:?}");
        // Lines begin at the left: the terminal's own modes are back.
        let line = seen[told.unwrap_or_default()..].trim_start_matches("as a game does");
        assert!(line.is_empty() || line.starts_with("\r\n"), "{seen:?}");
        child.kill().expect("a child");
        child.wait().expect("its end");
    }
}
