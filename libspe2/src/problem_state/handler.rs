//! The handler of SIGSEGV.

use std::mem::MaybeUninit;
use std::ptr;
use std::sync::OnceLock;

use libc::{c_int, c_void, sigaction, siginfo_t};

use super::access::{self, Access};
use super::registers_at;
use crate::error::Errno;

/// The program's former action for SIGSEGV.
struct Before(sigaction);

// SAFETY: the structure holds an address of a function and numbers.
unsafe impl Send for Before {}
// SAFETY: as above, and it never changes.
unsafe impl Sync for Before {}

static BEFORE: OnceLock<Result<Before, c_int>> = OnceLock::new();

/// Installs the handler, once in the process.
pub(super) fn install() -> Result<(), Errno> {
    let installed = BEFORE.get_or_init(|| {
        let mut before = MaybeUninit::zeroed();
        // SAFETY: all zeros are a valid sigaction, and the handler has the type that SA_SIGINFO
        // asks for.
        let result = unsafe {
            let mut action: sigaction = MaybeUninit::zeroed().assume_init();
            action.sa_sigaction = on_fault as *const () as usize;
            action.sa_flags = libc::SA_SIGINFO | libc::SA_ONSTACK | libc::SA_NODEFER;
            libc::sigaction(libc::SIGSEGV, &raw const action, before.as_mut_ptr())
        };
        if result != 0 {
            return Err(libc::EFAULT);
        }
        // SAFETY: the call has filled it in.
        Ok(Before(unsafe { before.assume_init() }))
    });
    installed.as_ref().map(|_| ()).map_err(|&errno| Errno(errno))
}

/// Carries out an access to a register, or passes the fault on.
unsafe extern "C" fn on_fault(signal: c_int, info: *mut siginfo_t, context: *mut c_void) {
    // SAFETY: the kernel passes valid structures, and a fault has an address.
    let address = unsafe { (*info).si_addr() }.expose_provenance();
    if let Some((registers, offset)) = registers_at(address) {
        // SAFETY: the errno of this thread can always be accessed.
        let errno = unsafe { *libc::__errno_location() };
        // SAFETY: the kernel passes the context of the thread that made the access.
        let decoded = unsafe { access::decode(context) };
        let Some(decoded) = decoded else {
            messages::print!(
                "libspe2: offset {offset:#x} of a problem-state area is accessed by an instruction \
                 that is no plain 32-bit load or store"
            );
            std::process::abort();
        };
        match decoded.access {
            Access::Load => {
                let value = registers.read(offset);
                // SAFETY: as above.
                unsafe { decoded.set_result(context, value) };
            }
            Access::Store(value) => registers.write(offset, value),
        }
        // SAFETY: as above.
        unsafe { decoded.step(context) };
        // SAFETY: as above.
        unsafe { *libc::__errno_location() = errno };
        return;
    }
    // SAFETY: the kernel's arguments are passed on as they are.
    unsafe { pass_on(signal, info, context) };
}

/// # Safety
/// The arguments are those of a signal handler.
unsafe fn pass_on(signal: c_int, info: *mut siginfo_t, context: *mut c_void) {
    let Some(Ok(Before(before))) = BEFORE.get() else {
        return;
    };
    match before.sa_sigaction {
        libc::SIG_IGN => {}
        libc::SIG_DFL => {
            // SAFETY: without a handler, the signal ends the process when this one returns.
            unsafe {
                libc::sigaction(signal, before, ptr::null_mut());
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
