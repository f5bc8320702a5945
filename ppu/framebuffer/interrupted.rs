//! Turns signals that end the program into a flag for the frame loop, so that the screen and its
//! console are restored on the normal way out.
//!
//! A second signal ends the program immediately, as it would by default, so that a frame loop that
//! hangs can still be stopped. The handler restores the screen first. Invariant: without an
//! [`Interrupted`] alive, the signals have their default effect.

use super::last_resort;
use signal_hook::SigId;
use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM};
use signal_hook::low_level;
use std::io::{self, PipeReader, PipeWriter, Read};
use std::mem::MaybeUninit;
use std::os::fd::{AsFd, AsRawFd, BorrowedFd};
use std::ptr;
use std::sync::atomic::{AtomicI32, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

const SIGNALS: [i32; 4] = [SIGINT, SIGTERM, SIGHUP, SIGQUIT];

/// The number of [`Interrupted`] alive. The handler reads it; [`COUNTING`] guards its changes.
static ALIVE: AtomicUsize = AtomicUsize::new(0);
static COUNTING: Mutex<()> = Mutex::new(());
/// The signal that has arrived; 0 for none.
static SIGNAL: AtomicI32 = AtomicI32::new(0);
/// A pipe that has one byte while [`SIGNAL`] is set, for polling. It is made together with the
/// handlers.
static WAKE: OnceLock<(PipeReader, PipeWriter)> = OnceLock::new();

/// Turns SIGINT, SIGTERM, SIGHUP and SIGQUIT into a request to stop while it lives.
///
/// All values share one state, because signals belong to the process. A signal that was ignored
/// when the program started (nohup) stays ignored. [`AsFd`] returns a descriptor that becomes
/// readable with the signal.
#[derive(Debug)]
pub struct Interrupted {
    wake: &'static PipeReader,
}

impl Interrupted {
    /// Begins to catch the signals.
    ///
    /// # Errors
    /// The system refuses to install the handlers.
    pub fn install() -> io::Result<Interrupted> {
        let _guard = counting();
        let wake = handlers()?;
        ALIVE.fetch_add(1, Ordering::SeqCst);
        Ok(Interrupted { wake })
    }

    /// The signal that asks the program to stop, if one has arrived.
    pub fn signal(&self) -> Option<i32> {
        match SIGNAL.load(Ordering::SeqCst) {
            0 => None,
            signal => Some(signal),
        }
    }
}

impl AsFd for Interrupted {
    fn as_fd(&self) -> BorrowedFd<'_> {
        self.wake.as_fd()
    }
}

impl Drop for Interrupted {
    fn drop(&mut self) {
        let _guard = counting();
        if ALIVE.fetch_sub(1, Ordering::SeqCst) == 1 && SIGNAL.swap(0, Ordering::SeqCst) != 0 {
            // The handler that set the signal writes one byte. A broken pipe has none.
            let _ = self.wake.read(&mut [0]);
        }
    }
}

/// Restores the screen at these signals, even without an [`Interrupted`] alive.
pub(super) fn watch() -> io::Result<()> {
    let _guard = counting();
    handlers().map(drop)
}

/// Whether the program was asked to stop.
pub(super) fn stop_requested() -> bool {
    SIGNAL.load(Ordering::SeqCst) != 0
}

/// A descriptor that becomes readable when the program is asked to stop.
pub(super) fn wake() -> Option<BorrowedFd<'static>> {
    WAKE.get().map(|(wake, _)| wake.as_fd())
}

fn handlers() -> io::Result<&'static PipeReader> {
    if let Some((wake, _)) = WAKE.get() {
        return Ok(wake);
    }
    let pipe = io::pipe()?;
    register()?;
    Ok(&WAKE.get_or_init(|| pipe).0)
}

fn counting() -> MutexGuard<'static, ()> {
    COUNTING.lock().unwrap_or_else(PoisonError::into_inner)
}

fn register() -> io::Result<()> {
    let mut registered: Vec<SigId> = Vec::new();
    for signal in SIGNALS {
        if is_ignored(signal)? {
            continue;
        }
        match catch(signal) {
            Ok(id) => registered.push(id),
            Err(error) => {
                for id in registered {
                    low_level::unregister(id);
                }
                return Err(error);
            }
        }
    }
    Ok(())
}

fn catch(signal: i32) -> io::Result<SigId> {
    // SAFETY: `on_signal` only uses atomics and system calls that signal handlers may use.
    unsafe { low_level::register(signal, move || on_signal(signal)) }
}

/// Whether a signal is ignored, from the program's start or by its own choice.
pub(super) fn is_ignored(signal: i32) -> io::Result<bool> {
    let mut action = MaybeUninit::<libc::sigaction>::uninit();
    // SAFETY: without a new action this only writes the current one.
    if unsafe { libc::sigaction(signal, ptr::null(), action.as_mut_ptr()) } != 0 {
        return Err(io::Error::last_os_error());
    }
    // SAFETY: the call succeeded, so it wrote the action.
    Ok(unsafe { action.assume_init() }.sa_sigaction == libc::SIG_IGN)
}

fn on_signal(signal: i32) {
    let first = || SIGNAL.compare_exchange(0, signal, Ordering::SeqCst, Ordering::SeqCst).is_ok();
    if ALIVE.load(Ordering::SeqCst) == 0 || !first() {
        last_resort::restore_screen();
        // This fails only for signals that can't be caught.
        let _ = low_level::emulate_default_handler(signal);
    } else if let Some((_, wake)) = WAKE.get() {
        // SAFETY: the pipe is never closed, and the call reads one byte of the array.
        unsafe { libc::write(wake.as_raw_fd(), [0u8].as_ptr().cast(), 1) };
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use std::panic::catch_unwind;

    /// Runs `scenario` in a process of its own, and returns its status as waitpid reports it.
    pub(in crate::framebuffer) fn in_child(scenario: fn() -> i32) -> i32 {
        // SAFETY: the child runs only `scenario`, and ends without returning to the test harness.
        // No other test holds the locks of this module or of the signal registry.
        let child = unsafe { libc::fork() };
        assert!(child >= 0);
        if child == 0 {
            // The tests may have been started with ignored signals, as shells do for background
            // commands.
            for signal in SIGNALS {
                if is_ignored(signal).expect("the action of a signal") {
                    // SAFETY: the default action runs no code of this program.
                    unsafe { libc::signal(signal, libc::SIG_DFL) };
                    // Another test has installed the handlers without this one.
                    if WAKE.get().is_some() {
                        catch(signal).expect("a handler");
                    }
                }
            }
            let code = catch_unwind(scenario).unwrap_or(101);
            // SAFETY: ends the child.
            unsafe { libc::_exit(code) };
        }
        let mut status = 0;
        // SAFETY: waits for the child made above; `status` outlives the call.
        assert_eq!(unsafe { libc::waitpid(child, &mut status, 0) }, child);
        status
    }

    fn readable(interrupted: &Interrupted) -> bool {
        let mut poll =
            libc::pollfd { fd: interrupted.as_fd().as_raw_fd(), events: libc::POLLIN, revents: 0 };
        // SAFETY: the call reads and writes one record, and doesn't wait.
        unsafe { libc::poll(&mut poll, 1, 0) == 1 }
    }

    fn raise(signal: i32) {
        low_level::raise(signal).unwrap();
    }

    #[test]
    fn first_signal_is_request() {
        let status = in_child(|| {
            for signal in SIGNALS {
                let interrupted = Interrupted::install().unwrap();
                let other = Interrupted::install().unwrap();
                assert!(interrupted.signal().is_none() && !readable(&interrupted));
                raise(signal);
                assert_eq!((interrupted.signal(), other.signal()), (Some(signal), Some(signal)));
                drop(other);
                assert!(interrupted.signal() == Some(signal) && readable(&interrupted));
            }
            7
        });
        assert!(libc::WIFEXITED(status), "{status:#x}");
        assert_eq!(libc::WEXITSTATUS(status), 7);
    }

    #[test]
    fn second_signal_ends_program() {
        let status = in_child(|| {
            let interrupted = Interrupted::install().unwrap();
            raise(SIGINT);
            assert_eq!(interrupted.signal(), Some(SIGINT));
            raise(SIGTERM);
            0
        });
        assert!(libc::WIFSIGNALED(status), "{status:#x}");
        assert_eq!(libc::WTERMSIG(status), SIGTERM);
    }

    #[test]
    fn without_handle_signals_have_default_action() {
        let status = in_child(|| {
            drop(Interrupted::install().unwrap());
            raise(SIGHUP);
            0
        });
        assert!(libc::WIFSIGNALED(status), "{status:#x}");
        assert_eq!(libc::WTERMSIG(status), SIGHUP);
    }

    #[test]
    fn ignored_signal_stays_ignored() {
        let status = in_child(|| {
            // SAFETY: this process is the test's own.
            unsafe { libc::signal(SIGHUP, libc::SIG_IGN) };
            let interrupted = Interrupted::install().unwrap();
            raise(SIGHUP);
            raise(SIGHUP);
            if interrupted.signal().is_none() { 7 } else { 8 }
        });
        assert!(libc::WIFEXITED(status), "{status:#x}");
        assert_eq!(libc::WEXITSTATUS(status), 7);
    }
}
