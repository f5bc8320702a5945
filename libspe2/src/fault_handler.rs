//! The handler of the signals of faults: SIGSEGV and SIGBUS. It serves [quick
//! copies](crate::quick_copy) and [problem-state areas](crate::problem_state), and passes all other
//! faults on to the handler that the program had before.

use std::mem::MaybeUninit;
use std::ptr;
use std::sync::OnceLock;

use libc::{c_int, c_void, sigaction, siginfo_t};

use crate::error::Errno;
use crate::{problem_state, quick_copy};

const SIGNALS: [c_int; 2] = [libc::SIGSEGV, libc::SIGBUS];

/// The program's former actions for the signals.
struct Before([sigaction; SIGNALS.len()]);

// SAFETY: the structure holds addresses of functions and numbers.
unsafe impl Send for Before {}
// SAFETY: as above, and it never changes.
unsafe impl Sync for Before {}

static BEFORE: OnceLock<Result<Before, c_int>> = OnceLock::new();

/// Installs the handler, once in the process.
pub(crate) fn install() -> Result<(), Errno> {
    let installed = BEFORE.get_or_init(|| {
        // SAFETY: all zeros are a valid sigaction.
        let none: sigaction = unsafe { MaybeUninit::zeroed().assume_init() };
        let mut before = [none; SIGNALS.len()];
        for (signal, before) in SIGNALS.into_iter().zip(&mut before) {
            let mut action = none;
            action.sa_sigaction = address();
            action.sa_flags = libc::SA_SIGINFO | libc::SA_ONSTACK | libc::SA_NODEFER;
            // SAFETY: the handler has the type that SA_SIGINFO asks for.
            if unsafe { libc::sigaction(signal, &raw const action, before) } != 0 {
                return Err(libc::EFAULT);
            }
        }
        Ok(Before(before))
    });
    installed.as_ref().map(|_| ()).map_err(|&errno| Errno(errno))
}

fn address() -> usize {
    on_fault as *const () as usize
}

/// The action for a signal, which may be this handler.
fn current(signal: c_int) -> sigaction {
    // SAFETY: all zeros are a valid sigaction, and the signal's number is valid.
    unsafe {
        let mut action = MaybeUninit::zeroed().assume_init();
        libc::sigaction(signal, ptr::null(), &raw mut action);
        action
    }
}

/// The program's action for a signal.
pub(crate) fn of_program(signal: c_int) -> sigaction {
    let action = current(signal);
    before(signal).filter(|_| action.sa_sigaction == address()).copied().unwrap_or(action)
}

fn before(signal: c_int) -> Option<&'static sigaction> {
    let Some(Ok(Before(before))) = BEFORE.get() else {
        return None;
    };
    SIGNALS.iter().zip(before).find(|(of, _)| **of == signal).map(|(_, before)| before)
}

/// Whether the handler is called if this thread faults.
pub(crate) fn is_reached() -> bool {
    // SAFETY: all zeros are a valid set, which the call fills in, and the numbers are valid.
    let may_arrive = unsafe {
        let mut blocked: libc::sigset_t = MaybeUninit::zeroed().assume_init();
        libc::pthread_sigmask(libc::SIG_BLOCK, ptr::null(), &raw mut blocked);
        SIGNALS.iter().all(|&signal| libc::sigismember(&raw const blocked, signal) == 0)
    };
    may_arrive && SIGNALS.iter().all(|&signal| current(signal).sa_sigaction == address())
}

/// Serves a fault, or passes it on.
unsafe extern "C" fn on_fault(signal: c_int, info: *mut siginfo_t, context: *mut c_void) {
    // SAFETY: the kernel passes valid structures, a fault has an address, and the kernel's
    // arguments are passed on as they are.
    unsafe {
        // Another program may send the same signal, which has no such code, during a copy.
        if (*info).si_code > 0 && quick_copy::end_after_fault(context) {
            return;
        }
        let address = (*info).si_addr().expose_provenance();
        if !problem_state::serve(address, context) {
            pass_on(signal, info, context);
        }
    }
}

/// # Safety
/// The arguments are those of a signal handler.
unsafe fn pass_on(signal: c_int, info: *mut siginfo_t, context: *mut c_void) {
    let Some(before) = before(signal) else {
        return;
    };
    // SAFETY: the caller vouches for the arguments. A fault can't be ignored, unlike a signal that
    // a program sends.
    let is_sent = unsafe { (*info).si_code } <= 0;
    match before.sa_sigaction {
        libc::SIG_IGN if is_sent => {}
        libc::SIG_DFL | libc::SIG_IGN => {
            // SAFETY: without a handler, the signal ends the process when this one returns.
            unsafe {
                libc::signal(signal, libc::SIG_DFL);
                libc::raise(signal);
            }
        }
        handler if before.sa_flags & libc::SA_SIGINFO != 0 => {
            type WithInfo = unsafe extern "C" fn(c_int, *mut siginfo_t, *mut c_void);
            let handler: *const () = ptr::with_exposed_provenance(handler);
            // SAFETY: the flag means that the program's handler has this type.
            unsafe { std::mem::transmute::<*const (), WithInfo>(handler)(signal, info, context) };
        }
        handler => {
            type Plain = unsafe extern "C" fn(c_int);
            let handler: *const () = ptr::with_exposed_provenance(handler);
            // SAFETY: without the flag, the program's handler has this type.
            unsafe { std::mem::transmute::<*const (), Plain>(handler)(signal) };
        }
    }
}
