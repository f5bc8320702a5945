//! Restores the screen when the program ends without unwinding: at a second signal, at a fault, at
//! `abort`.
//!
//! A [`RestorePromise`] registers the call that restores a [`Place`], for as long as it lives.
//! [`restore_screen`] makes all registered calls, and then that of the armed [`LastResort`], which
//! restores other things that the program has changed. It takes no lock and allocates nothing, so
//! signal handlers may call it. Invariant: only the code that takes a call out of its place makes
//! the call, or frees it.

use super::ioctl::FbVarScreeninfo;
use std::mem::{self, MaybeUninit};
use std::os::fd::{AsRawFd, BorrowedFd, RawFd};
use std::ptr::{self, NonNull};
use std::sync::Once;
use std::sync::atomic::{AtomicPtr, Ordering};

/// The things that can be restored, in the order of restoring. The console is last, because it
/// then redraws the screen.
#[derive(Clone, Copy)]
pub(super) enum Place {
    /// The offset of the screen in a taller picture.
    Offset,
    /// The driver's video mode.
    Mode,
    /// The virtual terminal's mode.
    Console,
}

/// The argument of a restoring ioctl.
pub(super) enum Argument {
    /// Passed by value.
    Value(libc::c_long),
    /// Passed by address.
    Word(u32),
    /// Passed by address.
    Screen(FbVarScreeninfo),
}

struct Call {
    descriptor: RawFd,
    request: u32,
    argument: Argument,
}

static PROMISED: [AtomicPtr<Call>; 3] = [const { AtomicPtr::new(ptr::null_mut()) }; 3];

/// A promise to restore something. It is dropped when the program has restored it itself, or no
/// longer needs to.
pub(super) struct RestorePromise {
    place: Place,
    call: NonNull<Call>,
}

// SAFETY: the call is only read, by the code that took it out of its place.
unsafe impl Send for RestorePromise {}

impl RestorePromise {
    /// Promises to make `request` on `descriptor`, which must stay open while the value lives. An
    /// earlier promise for the same place is forgotten.
    pub(super) fn promise(
        place: Place,
        descriptor: BorrowedFd<'_>,
        request: u32,
        argument: Argument,
    ) -> RestorePromise {
        install_handlers();
        let call = NonNull::from(Box::leak(Box::new(Call {
            descriptor: descriptor.as_raw_fd(),
            request,
            argument,
        })));
        PROMISED[place as usize].store(call.as_ptr(), Ordering::SeqCst);
        RestorePromise { place, call }
    }
}

impl Drop for RestorePromise {
    fn drop(&mut self) {
        let (call, none) = (self.call.as_ptr(), ptr::null_mut());
        let taken = PROMISED[self.place as usize].compare_exchange(
            call,
            none,
            Ordering::SeqCst,
            Ordering::SeqCst,
        );
        // Otherwise a handler of the ending program may be using the call, or a later promise took
        // the place. Then a few bytes stay allocated.
        if taken.is_ok() {
            // SAFETY: `promise` leaked it from a box, and no other code can have found it since.
            drop(unsafe { Box::from_raw(call) });
        }
    }
}

/// Restores things other than the screen that a program has changed, such as the terminal that it
/// was started from.
///
/// Once armed, it is called when the program ends without unwinding: by a fault, by `abort`, by an
/// unhandled signal, or by the second signal of those that [`Interrupted`](super::Interrupted)
/// turns into a request. Ctrl-Z calls it too, and retakes the things when the program continues.
#[derive(Debug)]
pub struct LastResort {
    /// Restores the things, unless they are not taken or are restored already.
    pub restore: fn(),
    /// Takes the things again, if the last stop restored them.
    pub retake: fn(),
}

/// The armed one, or null.
static ARMED: AtomicPtr<LastResort> = AtomicPtr::new(ptr::null_mut());

impl LastResort {
    /// Calls it from now on when the program ends, in place of an earlier one.
    ///
    /// # Safety
    ///
    /// As for [`LastResort::arm`].
    pub(super) unsafe fn take_place(&'static self) {
        ARMED.store(ptr::from_ref(self).cast_mut(), Ordering::SeqCst);
        install_handlers();
    }

    /// The armed one, if there is one.
    pub(super) fn armed() -> Option<&'static LastResort> {
        // SAFETY: only `take_place` sets it, to a value that lives forever.
        unsafe { ARMED.load(Ordering::SeqCst).as_ref() }
    }
}

/// Makes every promised call once, and that of the armed [`LastResort`].
pub(crate) fn restore_screen() {
    for place in &PROMISED {
        let call = place.swap(ptr::null_mut(), Ordering::SeqCst);
        // SAFETY: the calls in places were leaked from boxes, and are not freed after they were
        // taken out.
        let Some(Call { descriptor, request, argument }) = (unsafe { call.as_ref() }) else {
            continue;
        };
        let (descriptor, request) = (*descriptor, *request as libc::Ioctl);
        // SAFETY: the promise's owner keeps the descriptor open, and passed the argument that the
        // request takes. The kernel doesn't write to it (FBIOPAN_DISPLAY does, but to a copy).
        unsafe {
            match argument {
                Argument::Value(value) => libc::ioctl(descriptor, request, *value),
                Argument::Word(word) => libc::ioctl(descriptor, request, word),
                Argument::Screen(screen) => {
                    let mut screen = *screen;
                    libc::ioctl(descriptor, request, &mut screen)
                }
            }
        };
    }
    if let Some(armed) = LastResort::armed() {
        (armed.restore)();
    }
}

/// Faults and other signals that end a program unless it handles them.
const FATAL_SIGNALS: [i32; 15] = [
    libc::SIGSEGV,
    libc::SIGBUS,
    libc::SIGILL,
    libc::SIGFPE,
    libc::SIGTRAP,
    libc::SIGSYS,
    libc::SIGABRT,
    libc::SIGALRM,
    libc::SIGVTALRM,
    libc::SIGPROF,
    libc::SIGUSR1,
    libc::SIGUSR2,
    libc::SIGXCPU,
    libc::SIGXFSZ,
    libc::SIGPWR,
];

/// The number of faults, which are first in [`FATAL_SIGNALS`]. Their instruction is executed again,
/// so they go on to the earlier handler: at a SIGSEGV the Rust runtime reports a stack overflow and
/// ends the program. Other signals that already have a handler are not touched.
const FAULTS: usize = 4;

static BEFORE: [AtomicPtr<libc::sigaction>; FATAL_SIGNALS.len()] =
    [const { AtomicPtr::new(ptr::null_mut()) }; FATAL_SIGNALS.len()];

fn install_handlers() {
    static INSTALLED: Once = Once::new();
    INSTALLED.call_once(install_each_handler);
}

fn install_each_handler() {
    for (index, &signal) in FATAL_SIGNALS.iter().enumerate() {
        let mut before = MaybeUninit::<libc::sigaction>::zeroed();
        // SAFETY: without a new action this only writes the current one.
        let before = unsafe {
            if libc::sigaction(signal, ptr::null(), before.as_mut_ptr()) != 0 {
                continue;
            }
            before.assume_init()
        };
        let handled = before.sa_sigaction != libc::SIG_DFL;
        if before.sa_sigaction == libc::SIG_IGN || (handled && index >= FAULTS) {
            continue;
        }
        BEFORE[index].store(Box::leak(Box::new(before)), Ordering::SeqCst);
        let handler: extern "C" fn(i32, *mut libc::siginfo_t, *mut libc::c_void) = on_fatal_signal;
        // SAFETY: zeros are an action with an empty mask. `on_fatal_signal` has the type that
        // SA_SIGINFO requires, and uses only atomics and calls that handlers may use. SA_ONSTACK is
        // needed for a stack overflow.
        unsafe {
            let mut action: libc::sigaction = mem::zeroed();
            action.sa_sigaction = handler as libc::sighandler_t;
            action.sa_flags = libc::SA_SIGINFO | libc::SA_ONSTACK | libc::SA_RESTART;
            libc::sigaction(signal, &action, ptr::null_mut());
        }
    }
}

extern "C" fn on_fatal_signal(signal: i32, info: *mut libc::siginfo_t, _: *mut libc::c_void) {
    restore_screen();
    let Some(index) = FATAL_SIGNALS.iter().position(|&fatal| fatal == signal) else {
        return;
    };
    // SAFETY: the kernel passes a siginfo_t to a handler with SA_SIGINFO. The earlier action is
    // null or leaked forever. The signal that is raised is valid.
    unsafe {
        if index < FAULTS && (*info).si_code > 0 {
            // A positive code means that the kernel sent it for a fault.
            libc::sigaction(signal, BEFORE[index].load(Ordering::SeqCst), ptr::null_mut());
        } else {
            // The signal was sent, for example by a timer, so it must be sent again. It is pending
            // until this handler has returned. The runtime's handler would take it for a fault
            // that doesn't recur.
            libc::signal(signal, libc::SIG_DFL);
            libc::raise(signal);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::framebuffer::Interrupted;
    use crate::framebuffer::interrupted::tests::in_child;
    use std::io::PipeReader;
    use std::os::fd::AsFd;
    use std::sync::Mutex;
    use std::sync::atomic::AtomicI32;

    /// The pipe that children inherit. They share the mode of its open file with the test.
    static SHARED: AtomicI32 = AtomicI32::new(-1);
    /// Held by the test that uses the pipe.
    static SHARING: Mutex<()> = Mutex::new(());

    fn promise() -> RestorePromise {
        // SAFETY: the test keeps the pipe open.
        let pipe = unsafe { BorrowedFd::borrow_raw(SHARED.load(Ordering::SeqCst)) };
        RestorePromise::promise(Place::Console, pipe, libc::FIONBIO as u32, Argument::Word(1))
    }

    fn was_restored(pipe: &PipeReader) -> bool {
        let descriptor = pipe.as_fd().as_raw_fd();
        // SAFETY: the descriptor is open.
        let flags = unsafe { libc::fcntl(descriptor, libc::F_GETFL) };
        flags & libc::O_NONBLOCK != 0
    }

    #[test]
    fn last_resort_is_called_at_every_fatal_signal() {
        let segv: fn() -> i32 = || {
            let _promise = promise();
            // SAFETY: not sound on purpose: the test is about the fault, in a process of its own.
            unsafe { ptr::without_provenance::<i32>(8).read_volatile() }
        };
        let abort: fn() -> i32 = || {
            let _promise = promise();
            std::process::abort()
        };
        let sent_fault: fn() -> i32 = || {
            let _promise = promise();
            // SAFETY: the test is about the signal, in a process of its own.
            unsafe { libc::raise(libc::SIGSEGV) };
            0
        };
        let timer: fn() -> i32 = || {
            let _promise = promise();
            // SAFETY: the test is about the signal, in a process of its own.
            unsafe {
                libc::alarm(1);
                libc::pause();
            }
            0
        };
        let sent: fn() -> i32 = || {
            let _promise = promise();
            // SAFETY: the test is about the signal, in a process of its own.
            unsafe { libc::raise(libc::SIGUSR1) };
            0
        };
        let done: fn() -> i32 = || {
            drop(promise());
            restore_screen();
            // SAFETY: as above.
            unsafe { libc::raise(libc::SIGUSR1) };
            0
        };
        let cases = [
            (segv, libc::SIGSEGV, true),
            (sent_fault, libc::SIGSEGV, true),
            (abort, libc::SIGABRT, true),
            (timer, libc::SIGALRM, true),
            (sent, libc::SIGUSR1, true),
            (done, libc::SIGUSR1, false),
        ];
        let _sharing = SHARING.lock().unwrap();
        for (scenario, signal, restored) in cases {
            let (pipe, _writer) = std::io::pipe().unwrap();
            SHARED.store(pipe.as_raw_fd(), Ordering::SeqCst);
            let status = in_child(scenario);
            assert!(libc::WIFSIGNALED(status), "{signal}: {status:#x}");
            assert_eq!(libc::WTERMSIG(status), signal);
            assert_eq!(was_restored(&pipe), restored, "{signal}");
        }
    }

    static RESORT: LastResort = LastResort {
        restore: || {
            let on: libc::c_int = 1;
            // SAFETY: the test keeps the pipe open; the request reads one int.
            unsafe { libc::ioctl(SHARED.load(Ordering::SeqCst), libc::FIONBIO, &raw const on) };
        },
        retake: || {},
    };

    fn arm() {
        // SAFETY: an atomic and one system call that only sets a flag.
        unsafe { RESORT.arm() }.unwrap();
    }

    #[test]
    fn last_resort_runs_at_every_fatal_signal() {
        fn raise(signal: i32) {
            // SAFETY: the test is about the signal, in a process of its own.
            unsafe { libc::raise(signal) };
        }
        let alarm: fn() -> i32 = || {
            arm();
            raise(libc::SIGALRM);
            0
        };
        let fault: fn() -> i32 = || {
            arm();
            // SAFETY: not sound on purpose: the test is about the fault, in a process of its own.
            unsafe { ptr::without_provenance::<i32>(8).read_volatile() }
        };
        let unexpected: fn() -> i32 = || {
            arm();
            raise(libc::SIGTERM);
            0
        };
        let second: fn() -> i32 = || {
            arm();
            let _interrupted = Interrupted::install().unwrap();
            raise(libc::SIGHUP);
            raise(libc::SIGTERM);
            0
        };
        let first: fn() -> i32 = || {
            arm();
            let _interrupted = Interrupted::install().unwrap();
            raise(libc::SIGQUIT);
            // The first signal is only a request, so nothing is restored yet.
            // SAFETY: SIGKILL ends the child, and can't be caught.
            unsafe { libc::raise(libc::SIGKILL) }
        };
        let _sharing = SHARING.lock().unwrap();
        for (scenario, signal, restored) in [
            (alarm, libc::SIGALRM, true),
            (fault, libc::SIGSEGV, true),
            (unexpected, libc::SIGTERM, true),
            (second, libc::SIGTERM, true),
            (first, libc::SIGKILL, false),
        ] {
            let (pipe, _writer) = std::io::pipe().unwrap();
            SHARED.store(pipe.as_raw_fd(), Ordering::SeqCst);
            let status = in_child(scenario);
            assert!(libc::WIFSIGNALED(status), "{signal}: {status:#x}");
            assert_eq!(libc::WTERMSIG(status), signal);
            assert_eq!(was_restored(&pipe), restored, "{signal}");
        }
    }

    #[test]
    fn handled_signal_is_left_to_program() {
        let status = in_child(|| {
            extern "C" fn seven(_: i32) {
                // SAFETY: ends the child.
                unsafe { libc::_exit(7) }
            }
            let handler: extern "C" fn(i32) = seven;
            // SAFETY: this process is the test's own.
            unsafe { libc::signal(libc::SIGUSR2, handler as libc::sighandler_t) };
            let (pipe, _writer) = std::io::pipe().unwrap();
            SHARED.store(pipe.as_raw_fd(), Ordering::SeqCst);
            let _promise = promise();
            // SAFETY: as above.
            unsafe { libc::raise(libc::SIGUSR2) };
            0
        });
        assert!(libc::WIFEXITED(status), "{status:#x}");
        assert_eq!(libc::WEXITSTATUS(status), 7);
    }
}
