//! PPE-assisted library calls: the process-wide table of handlers. Slots 0, 1 and 5 hold the
//! library's own, which a program may replace or call.

use std::sync::{Mutex, MutexGuard, PoisonError};

use libc::{c_int, c_uint, c_void};

use crate::builtin;
use crate::error::{self, Errno, set_errno};
use crate::types::{SPE_CALLBACK_NEW, SPE_CALLBACK_UPDATE};

/// A handler. It receives the base of local store and the local-store address of the word after
/// the stop. If it returns 0, the SPU continues.
pub type Handler = unsafe extern "C" fn(*mut c_void, c_uint) -> c_int;

const SLOTS: usize = 256;
/// The library keeps the slots below this one for itself: a program can neither fill an empty one
/// nor empty a full one.
const FIRST_FREE: c_uint = 4;
/// What a run reports if the call has no handler.
const NO_HANDLER: c_int = -1;

static HANDLERS: Mutex<[Option<Handler>; SLOTS]> = Mutex::new({
    let mut handlers: [Option<Handler>; SLOTS] = [None; SLOTS];
    handlers[0] = Some(builtin::c99);
    handlers[1] = Some(builtin::posix);
    handlers[5] = Some(builtin::libea);
    handlers
});

fn handlers() -> MutexGuard<'static, [Option<Handler>; SLOTS]> {
    HANDLERS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Runs a call's handler on the calling thread.
pub(crate) fn call(number: c_uint, ls_base: *mut c_void, ls_address: c_uint) -> c_int {
    let handler = handlers().get(number as usize).copied().flatten();
    match handler {
        // SAFETY: whoever registered the handler vouched for its type, and local store is mapped.
        Some(handler) => unsafe { handler(ls_base, ls_address) },
        None => NO_HANDLER,
    }
}

fn with_slot<T>(
    number: c_uint,
    body: impl FnOnce(&mut Option<Handler>) -> Result<T, Errno>,
) -> Result<T, Errno> {
    set_errno(0);
    let mut handlers = handlers();
    let slot = handlers.get_mut(number as usize);
    body(slot.ok_or(Errno(libc::EINVAL))?)
}

/// Registers a handler for a class of calls, or replaces the existing one.
///
/// # Safety
/// `handler` is NULL or a function of type [`Handler`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_callback_handler_register(
    handler: *mut c_void,
    callnum: c_uint,
    mode: c_uint,
) -> c_int {
    error::int(|| {
        with_slot(callnum, |slot| {
            match mode {
                SPE_CALLBACK_NEW if callnum < FIRST_FREE || slot.is_some() => {
                    return Err(Errno(libc::EACCES));
                }
                SPE_CALLBACK_UPDATE if slot.is_none() => return Err(Errno(libc::ESRCH)),
                SPE_CALLBACK_NEW | SPE_CALLBACK_UPDATE if !handler.is_null() => {}
                _ => return Err(Errno(libc::EINVAL)),
            }
            // SAFETY: it is not NULL, and the caller vouches for its type.
            *slot = Some(unsafe { std::mem::transmute::<*mut c_void, Handler>(handler) });
            Ok(0)
        })
    })
}

/// Removes a handler.
///
/// # Safety
/// None beyond the C calling convention.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_callback_handler_deregister(callnum: c_uint) -> c_int {
    error::int(|| {
        with_slot(callnum, |slot| {
            if callnum < FIRST_FREE {
                return Err(Errno(libc::EACCES));
            }
            slot.take().map(|_| 0).ok_or(Errno(libc::ESRCH))
        })
    })
}

/// The handler of a class of calls.
///
/// # Safety
/// None beyond the C calling convention.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_callback_handler_query(callnum: c_uint) -> *mut c_void {
    error::pointer(|| {
        with_slot(callnum, |slot| {
            slot.map(|handler| handler as *mut c_void).ok_or(Errno(libc::ESRCH))
        })
    })
}
