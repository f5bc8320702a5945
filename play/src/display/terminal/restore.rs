//! The terminal's state, taken over and put back.
//!
//! Invariant: it is put back when a [`Taken`] is dropped, before a panic is told, and by a signal that ends the
//! program outright. The last is done in a signal handler: by system calls alone.

use std::io;
use std::panic;
use std::sync::Once;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

use signal_hook::consts::{SIGINT, SIGQUIT, SIGTERM};
use signal_hook::low_level;

/// Other screen, no cursor, no line wrap; focus and mouse are told; keys with their releases, where that is known.
const BEGIN: &str = "\x1b[?1049h\x1b[?25l\x1b[?7l\x1b[2J\x1b[?1004h\x1b[?1002h\x1b[?1006h\x1b[>11u";
const END: &str = "\x1b[<u\x1b[?1006l\x1b[?1002l\x1b[?1004l\x1b[0m\x1b[?7h\x1b[?25h\x1b[?1049l";

/// How the terminal was found.
static FOUND: OnceLock<libc::termios> = OnceLock::new();
static IS_TAKEN: AtomicBool = AtomicBool::new(false);
static HAS_PICTURES: AtomicBool = AtomicBool::new(false);
/// Signals that came: the first is a request, the second ends the program.
static SIGNALS: AtomicU32 = AtomicU32::new(0);

/// The terminal, while it is ours.
pub struct Taken(());

impl Taken {
    /// Takes the terminal over: keys come one by one, and no one else's text is shown if pictures are.
    pub fn take(has_pictures: bool) -> io::Result<Self> {
        let mut found = std::mem::MaybeUninit::<libc::termios>::uninit();
        // SAFETY: the call writes a termios or fails.
        if unsafe { libc::tcgetattr(libc::STDIN_FILENO, found.as_mut_ptr()) } != 0 {
            return Err(io::Error::last_os_error());
        }
        // SAFETY: the call succeeded, so it wrote it.
        let found = unsafe { found.assume_init() };
        let found = *FOUND.get_or_init(|| found);
        install()?;
        let mut raw = found;
        // SAFETY: `raw` is a termios of its own.
        unsafe { libc::cfmakeraw(&raw mut raw) };
        if !has_pictures {
            // Messages go on, and Ctrl-C is the system's.
            raw.c_oflag = found.c_oflag;
            raw.c_lflag |= libc::ISIG;
        }
        HAS_PICTURES.store(has_pictures, Ordering::SeqCst);
        IS_TAKEN.store(true, Ordering::SeqCst);
        let taken = Self(());
        // SAFETY: `raw` is a valid termios.
        if unsafe { libc::tcsetattr(libc::STDIN_FILENO, libc::TCSANOW, &raw const raw) } != 0 {
            return Err(io::Error::last_os_error());
        }
        if has_pictures {
            write(BEGIN);
        }
        Ok(taken)
    }
}

impl Drop for Taken {
    fn drop(&mut self) {
        put_back();
    }
}

/// Puts the terminal back, once. May be called from a signal handler.
fn put_back() {
    if !IS_TAKEN.swap(false, Ordering::SeqCst) {
        return;
    }
    if HAS_PICTURES.load(Ordering::SeqCst) {
        write(END);
    }
    if let Some(found) = FOUND.get() {
        // What was typed and not read was for us, not for the shell.
        // SAFETY: both calls take a descriptor, and the second a valid termios, which is not changed any more.
        unsafe {
            libc::tcflush(libc::STDIN_FILENO, libc::TCIFLUSH);
            libc::tcsetattr(libc::STDIN_FILENO, libc::TCSANOW, found);
        }
    }
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

fn install() -> io::Result<()> {
    static PANICS: Once = Once::new();
    static HANDLERS: OnceLock<()> = OnceLock::new();
    PANICS.call_once(|| {
        let tell = panic::take_hook();
        panic::set_hook(Box::new(move |what| {
            put_back();
            tell(what);
        }));
    });
    if HANDLERS.set(()).is_ok() {
        for signal in [SIGINT, SIGTERM] {
            // SAFETY: `on_signal` uses atomics and system calls that signal handlers may use.
            unsafe { low_level::register(signal, on_signal)? };
        }
        // SAFETY: as above; the default action takes a signal handler's calls alone, too.
        unsafe {
            low_level::register(SIGQUIT, || {
                put_back();
                // It only fails for signals that can't be caught.
                let _ = low_level::emulate_default_handler(SIGQUIT);
            })?;
        }
    }
    Ok(())
}

/// Runs before the handler that makes a request of the first signal and ends the program at the second.
fn on_signal() {
    if SIGNALS.fetch_add(1, Ordering::SeqCst) > 0 {
        put_back();
    }
}
