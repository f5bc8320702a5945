//! The C library's functions that a preloaded object takes the place of.
//!
//! Invariant: calls that are not for a stand-in reach the next object that has the function.

use libc::{c_char, c_int, c_ulong, c_void, mode_t};
use std::ffi::CStr;
use std::mem;

/// The function called `name` of the object after this one.
///
/// # Safety
/// `F` must be the type of a function pointer that fits it.
unsafe fn next<F: Copy>(name: &CStr) -> F {
    // SAFETY: the name is a zero-terminated string.
    let address = unsafe { libc::dlsym(libc::RTLD_NEXT, name.as_ptr()) };
    assert!(!address.is_null(), "no {name:?} behind this object");
    // SAFETY: the caller's promise; function pointers have the size of an address.
    unsafe { mem::transmute_copy(&address) }
}

type Open = unsafe extern "C" fn(*const c_char, c_int, mode_t) -> c_int;

/// # Safety
/// As the C library's `open64`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn open64(path: *const c_char, flags: c_int, mode: mode_t) -> c_int {
    // SAFETY: the caller's promise; variable arguments that are integers are passed as others are.
    unsafe {
        super::open(CStr::from_ptr(path))
            .unwrap_or_else(|| next::<Open>(c"open64")(path, flags, mode))
    }
}

type Ioctl = unsafe extern "C" fn(c_int, c_ulong, *mut c_void) -> c_int;

/// # Safety
/// As the C library's `ioctl`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ioctl(
    descriptor: c_int,
    request: c_ulong,
    argument: *mut c_void,
) -> c_int {
    // SAFETY: the caller's promise; variable arguments that are addresses are passed as others
    // are.
    match unsafe { super::ioctl(descriptor, request as u32, argument) } {
        Some(Ok(())) => 0,
        Some(Err(errno)) => {
            // SAFETY: the address is this thread's errno.
            unsafe { *libc::__errno_location() = errno };
            -1
        }
        // SAFETY: as above.
        None => unsafe { next::<Ioctl>(c"ioctl")(descriptor, request, argument) },
    }
}

type Close = unsafe extern "C" fn(c_int) -> c_int;

/// # Safety
/// As the C library's `close`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn close(descriptor: c_int) -> c_int {
    super::close(descriptor);
    // SAFETY: the caller's promise.
    unsafe { next::<Close>(c"close")(descriptor) }
}
