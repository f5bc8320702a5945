//! What puts the screen back where nothing unwinds: at a second signal, at a fault, at `abort`.
//!
//! A place is promised the call that restores it for as long as a [`PutBack`] lives. [`put_back`]
//! makes the calls promised, and then those of a [`LastResort`], by which a program restores what
//! else it took: it takes no lock and allocates nothing, so signal handlers may call it.
//! Invariant: whoever takes a promise out of its place makes its call or frees it, and no other
//! does.

use super::ioctl::FbVarScreeninfo;
use std::mem::{self, MaybeUninit};
use std::os::fd::{AsRawFd, BorrowedFd, RawFd};
use std::ptr::{self, NonNull};
use std::sync::Once;
use std::sync::atomic::{AtomicPtr, Ordering};

/// What can be put back, in the order in which it is: the console redraws a screen that is its own
/// again.
#[derive(Clone, Copy)]
pub(super) enum Place {
    /// The part of a taller picture that the screen shows.
    Offset,
    /// The driver's video mode.
    Mode,
    /// The virtual terminal's.
    Console,
}

/// The argument of a restoring ioctl.
pub(super) enum Argument {
    /// Given by value.
    Value(libc::c_long),
    /// Given by address.
    Word(u32),
    /// Given by address.
    Screen(FbVarScreeninfo),
}

struct Call {
    descriptor: RawFd,
    request: u32,
    argument: Argument,
}

static PROMISED: [AtomicPtr<Call>; 3] = [const { AtomicPtr::new(ptr::null_mut()) }; 3];

/// A promise to restore something; when dropped, the program has done it, or need not any more.
pub(super) struct PutBack {
    place: Place,
    call: NonNull<Call>,
}

// SAFETY: the call is only read, by whoever took it out of its place.
unsafe impl Send for PutBack {}

impl PutBack {
    /// Promises that `request` is made on `descriptor`, which must stay open while the value
    /// lives. A promise made before for the same place is forgotten.
    pub(super) fn promise(
        place: Place,
        descriptor: BorrowedFd<'_>,
        request: u32,
        argument: Argument,
    ) -> PutBack {
        catch_ends();
        let call = NonNull::from(Box::leak(Box::new(Call {
            descriptor: descriptor.as_raw_fd(),
            request,
            argument,
        })));
        PROMISED[place as usize].store(call.as_ptr(), Ordering::SeqCst);
        PutBack { place, call }
    }
}

impl Drop for PutBack {
    fn drop(&mut self) {
        let (call, none) = (self.call.as_ptr(), ptr::null_mut());
        let taken = PROMISED[self.place as usize].compare_exchange(
            call,
            none,
            Ordering::SeqCst,
            Ordering::SeqCst,
        );
        // Elsewhere a handler may be at it, in a program that is ending, or a later promise took
        // the place: a few bytes stay allocated.
        if taken.is_ok() {
            // SAFETY: leaked from a box by `promise`, and nobody else can have found it since.
            drop(unsafe { Box::from_raw(call) });
        }
    }
}

/// What a program has changed besides the screen, such as the terminal that it was started from.
///
/// Once armed, it is put back by whatever ends the program without unwinding: a fault, `abort`, a
/// signal that nobody has asked for, or the second of those that
/// [`Interrupted`](super::Interrupted) makes a request of. Ctrl-Z puts it back too, and takes it
/// again when the program goes on.
#[derive(Debug)]
pub struct LastResort {
    /// Puts it back, unless it is not taken or was put back before.
    pub put_back: fn(),
    /// Takes it again, if the last stop put it back.
    pub take_again: fn(),
}

/// The one that is armed.
static ARMED: AtomicPtr<LastResort> = AtomicPtr::new(ptr::null_mut());

impl LastResort {
    /// Has it called by what ends the program, in the place of one that was armed before.
    ///
    /// # Safety
    ///
    /// As [`LastResort::arm`].
    pub(super) unsafe fn take_place(&'static self) {
        ARMED.store(ptr::from_ref(self).cast_mut(), Ordering::SeqCst);
        catch_ends();
    }

    /// The one that is armed, if one is.
    pub(super) fn armed() -> Option<&'static LastResort> {
        // SAFETY: only `take_place` sets it, to what lives for good.
        unsafe { ARMED.load(Ordering::SeqCst).as_ref() }
    }
}

/// Makes every call promised, once, and those of what is armed.
pub(crate) fn put_back() {
    for place in &PROMISED {
        let call = place.swap(ptr::null_mut(), Ordering::SeqCst);
        // SAFETY: what is in a place was leaked from a box, and is not freed once it was taken
        // out.
        let Some(Call {
            descriptor,
            request,
            argument,
        }) = (unsafe { call.as_ref() })
        else {
            continue;
        };
        let (descriptor, request) = (*descriptor, *request as libc::Ioctl);
        // SAFETY: the promise's owner keeps the descriptor open, and gave the argument that the
        // request takes; the kernel writes to none of them (FBIOPAN_DISPLAY does, to a copy).
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
        (armed.put_back)();
    }
}

/// Faults, and what else ends a program that does not expect it.
const ENDS: [i32; 15] = [
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

/// How many of [`ENDS`], from the first, are faults whose instruction is done again, so that they
/// go on to whoever handled them before: the Rust runtime says of a SIGSEGV that a stack is full,
/// and ends the program. The others' handlers are let be.
const FAULTS: usize = 4;

static BEFORE: [AtomicPtr<libc::sigaction>; ENDS.len()] =
    [const { AtomicPtr::new(ptr::null_mut()) }; ENDS.len()];

fn catch_ends() {
    static CATCH: Once = Once::new();
    CATCH.call_once(catch_each_end);
}

fn catch_each_end() {
    for (index, &signal) in ENDS.iter().enumerate() {
        let mut before = MaybeUninit::<libc::sigaction>::zeroed();
        // SAFETY: with no new action this only writes the present one.
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
        let handler: extern "C" fn(i32, *mut libc::siginfo_t, *mut libc::c_void) = on_end;
        // SAFETY: zeros are an action with an empty mask; `on_end` has the type that SA_SIGINFO
        // asks for and uses atomics and calls that handlers may use. A full stack needs
        // SA_ONSTACK.
        unsafe {
            let mut action: libc::sigaction = mem::zeroed();
            action.sa_sigaction = handler as libc::sighandler_t;
            action.sa_flags = libc::SA_SIGINFO | libc::SA_ONSTACK | libc::SA_RESTART;
            libc::sigaction(signal, &action, ptr::null_mut());
        }
    }
}

extern "C" fn on_end(signal: i32, info: *mut libc::siginfo_t, _: *mut libc::c_void) {
    put_back();
    let Some(index) = ENDS.iter().position(|&end| end == signal) else {
        return;
    };
    // SAFETY: the kernel gives a handler with SA_SIGINFO a siginfo_t; the action before is null or
    // leaked for good; a valid signal is raised.
    unsafe {
        if index < FAULTS && (*info).si_code > 0 {
            // The kernel's word that it was one.
            libc::sigaction(
                signal,
                BEFORE[index].load(Ordering::SeqCst),
                ptr::null_mut(),
            );
        } else {
            // Sent, by a timer as it may be, so it has to be sent again, and waits until this
            // handler has returned. The runtime's handler would let it pass for a fault that does
            // not come again.
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

    /// The pipe that children inherit: the mode of its open file is theirs and the test's.
    static SHARED: AtomicI32 = AtomicI32::new(-1);
    /// Whose pipe it is.
    static SHARING: Mutex<()> = Mutex::new(());

    fn promise() -> PutBack {
        // SAFETY: the test keeps the pipe open.
        let pipe = unsafe { BorrowedFd::borrow_raw(SHARED.load(Ordering::SeqCst)) };
        PutBack::promise(
            Place::Console,
            pipe,
            libc::FIONBIO as u32,
            Argument::Word(1),
        )
    }

    fn was_put_back(pipe: &PipeReader) -> bool {
        let descriptor = pipe.as_fd().as_raw_fd();
        // SAFETY: the descriptor is open.
        let flags = unsafe { libc::fcntl(descriptor, libc::F_GETFL) };
        flags & libc::O_NONBLOCK != 0
    }

    #[test]
    fn whatever_ends_the_program_the_promise_is_kept() {
        let segv: fn() -> i32 = || {
            let _promise = promise();
            // SAFETY: none: the fault is what is tested, in a process of its own.
            unsafe { ptr::without_provenance::<i32>(8).read_volatile() }
        };
        let abort: fn() -> i32 = || {
            let _promise = promise();
            std::process::abort()
        };
        let sent_fault: fn() -> i32 = || {
            let _promise = promise();
            // SAFETY: the signal is what is tested, in a process of its own.
            unsafe { libc::raise(libc::SIGSEGV) };
            0
        };
        let timer: fn() -> i32 = || {
            let _promise = promise();
            // SAFETY: the signal is what is tested, in a process of its own.
            unsafe {
                libc::alarm(1);
                libc::pause();
            }
            0
        };
        let sent: fn() -> i32 = || {
            let _promise = promise();
            // SAFETY: the signal is what is tested, in a process of its own.
            unsafe { libc::raise(libc::SIGUSR1) };
            0
        };
        let done: fn() -> i32 = || {
            drop(promise());
            put_back();
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
            assert_eq!(was_put_back(&pipe), restored, "{signal}");
        }
    }

    static RESORT: LastResort = LastResort {
        put_back: || {
            let on: libc::c_int = 1;
            // SAFETY: the test keeps the pipe open; the request reads one int.
            unsafe { libc::ioctl(SHARED.load(Ordering::SeqCst), libc::FIONBIO, &raw const on) };
        },
        take_again: || {},
    };

    fn arm() {
        // SAFETY: an atomic and one system call that only sets a flag.
        unsafe { RESORT.arm() }.unwrap();
    }

    #[test]
    fn what_is_armed_is_put_back_by_all_that_ends_the_program() {
        fn raise(signal: i32) {
            // SAFETY: the signal is what is tested, in a process of its own.
            unsafe { libc::raise(signal) };
        }
        let alarm: fn() -> i32 = || {
            arm();
            raise(libc::SIGALRM);
            0
        };
        let fault: fn() -> i32 = || {
            arm();
            // SAFETY: none: the fault is what is tested, in a process of its own.
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
            // A request alone: nothing is put back yet.
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
            assert_eq!(was_put_back(&pipe), restored, "{signal}");
        }
    }

    #[test]
    fn a_signal_that_the_program_handles_is_left_to_it() {
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
