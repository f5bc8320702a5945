//! Switching between terminals: requests for the frame loop when the kernel wants the screen for
//! another terminal, returns it, or when the user types Ctrl-Z.
//!
//! Invariant: handlers only set flags and wake [`wait_until_back`]. Without a [`Switching`] alive
//! the kernel's two signals have no effect, and Ctrl-Z stops the program as by default. An armed
//! [`LastResort`] is called before the program stops.

use super::interrupted;
use super::last_resort::LastResort;
use signal_hook::consts::SIGTSTP;
use signal_hook::low_level;
use std::io::{self, PipeReader, PipeWriter, Read};
use std::os::fd::{AsFd, AsRawFd};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

static ALIVE: AtomicUsize = AtomicUsize::new(0);
static LEAVE: AtomicBool = AtomicBool::new(false);
static BACK: AtomicBool = AtomicBool::new(false);
static STOP: AtomicBool = AtomicBool::new(false);
/// Holds a byte for each time that [`BACK`] was set. Set before the handlers are in place.
static WAKE: OnceLock<(PipeReader, PipeWriter)> = OnceLock::new();

/// A request to release the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ScreenRequest {
    /// Let another terminal have the screen.
    Leave,
    /// Restore the terminal's text, and stop the program.
    Stop,
}

/// The signal with which the kernel requests the screen.
pub(super) fn leave_signal() -> i32 {
    libc::SIGRTMIN()
}

/// The signal with which the kernel returns the screen.
pub(super) fn back_signal() -> i32 {
    libc::SIGRTMIN() + 1
}

/// Catches the signals while it lives.
#[derive(Debug)]
pub(super) struct Switching(());

impl Switching {
    pub(super) fn catch() -> io::Result<Switching> {
        watch()?;
        for flag in [&LEAVE, &BACK, &STOP] {
            flag.store(false, Ordering::SeqCst);
        }
        ALIVE.fetch_add(1, Ordering::SeqCst);
        Ok(Switching(()))
    }

    pub(super) fn take_request(&self) -> Option<ScreenRequest> {
        if LEAVE.swap(false, Ordering::SeqCst) {
            Some(ScreenRequest::Leave)
        } else if STOP.swap(false, Ordering::SeqCst) {
            Some(ScreenRequest::Stop)
        } else {
            None
        }
    }

    /// Forgets that the screen was returned, because it is about to be released.
    pub(super) fn leave(&self) {
        BACK.store(false, Ordering::SeqCst);
    }

    /// Sleeps until the screen is returned; `false` if the program is asked to end meanwhile.
    pub(super) fn wait_until_back(&self) -> bool {
        loop {
            if BACK.swap(false, Ordering::SeqCst) {
                return true;
            }
            if interrupted::stop_requested() {
                return false;
            }
            sleep();
        }
    }
}

impl Drop for Switching {
    fn drop(&mut self) {
        ALIVE.fetch_sub(1, Ordering::SeqCst);
    }
}

/// Stops the program as Ctrl-Z does, and returns when it is continued. Signal handlers may call
/// it.
pub(super) fn stop() {
    let armed = LastResort::armed();
    if let Some(armed) = armed {
        (armed.restore)();
    }
    // SIGSTOP can't be refused.
    let _ = low_level::raise(libc::SIGSTOP);
    // A program that is continued only to end doesn't need the things again.
    if let Some(armed) = armed.filter(|_| !interrupted::stop_requested()) {
        (armed.retake)();
    }
}

/// Makes Ctrl-Z stop the program through [`stop`], even if no screen is taken.
pub(super) fn watch() -> io::Result<()> {
    if WAKE.get().is_none() {
        let pipe = io::pipe()?;
        if WAKE.set(pipe).is_ok() {
            register()?;
        }
    }
    Ok(())
}

fn register() -> io::Result<()> {
    let flags =
        [(leave_signal(), &LEAVE as &'static AtomicBool), (back_signal(), &BACK), (SIGTSTP, &STOP)];
    for (signal, flag) in flags {
        if interrupted::is_ignored(signal)? {
            continue;
        }
        // SAFETY: `on_signal` only uses atomics and system calls that signal handlers may use.
        unsafe { low_level::register(signal, move || on_signal(signal, flag)) }?;
    }
    Ok(())
}

fn on_signal(signal: i32, flag: &AtomicBool) {
    if ALIVE.load(Ordering::SeqCst) > 0 {
        flag.store(true, Ordering::SeqCst);
        if let Some((_, wake)) = WAKE.get().filter(|_| signal == back_signal()) {
            // SAFETY: the pipe is never closed, and the call reads one byte of the array.
            unsafe { libc::write(wake.as_raw_fd(), [0u8].as_ptr().cast(), 1) };
        }
    } else if signal == SIGTSTP {
        stop();
    }
}

/// Sleeps until a signal of this module or one that ends the program has come.
fn sleep() {
    let Some((wake, _)) = WAKE.get() else { return };
    let readable = |descriptor| libc::pollfd { fd: descriptor, events: libc::POLLIN, revents: 0 };
    // poll ignores a negative descriptor.
    let ending = interrupted::wake().map_or(-1, |wake| wake.as_raw_fd());
    let mut polls = [readable(wake.as_fd().as_raw_fd()), readable(ending)];
    // SAFETY: two records, which outlive the call.
    let ready = unsafe { libc::poll(polls.as_mut_ptr(), polls.len() as libc::nfds_t, -1) };
    if ready > 0 && polls[0].revents != 0 {
        // A broken pipe has no byte to take, and the flag is set anyway.
        let _ = (&mut &*wake).read(&mut [0; 64]);
    }
}
