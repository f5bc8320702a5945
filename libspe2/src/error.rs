//! Turns Rust results into the C convention: -1 or NULL, with errno set. No panic leaves the
//! library.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;

use libc::c_int;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Errno(pub c_int);

impl From<std::io::Error> for Errno {
    fn from(error: std::io::Error) -> Self {
        Self(error.raw_os_error().unwrap_or(libc::EFAULT))
    }
}

pub(crate) fn set_errno(value: c_int) {
    // SAFETY: the calling thread's errno can always be written.
    unsafe { *libc::__errno_location() = value };
}

fn guarded<T>(failure: T, body: impl FnOnce() -> Result<T, Errno>) -> T {
    let result = catch_unwind(AssertUnwindSafe(body)).unwrap_or(Err(Errno(libc::EFAULT)));
    result.unwrap_or_else(|Errno(value)| {
        set_errno(value);
        failure
    })
}

/// Runs the body of a function that returns int.
pub(crate) fn int(body: impl FnOnce() -> Result<c_int, Errno>) -> c_int {
    guarded(-1, body)
}

/// Runs the body of a function that returns a pointer.
pub(crate) fn pointer<T>(body: impl FnOnce() -> Result<*mut T, Errno>) -> *mut T {
    guarded(ptr::null_mut(), body)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panic_becomes_efault() {
        set_errno(0);
        assert_eq!(int(|| panic!("expected by this test")), -1);
        assert_eq!(std::io::Error::last_os_error().raw_os_error(), Some(libc::EFAULT));
        assert!(pointer::<u8>(|| Err(Errno(libc::ENOMEM))).is_null());
        assert_eq!(std::io::Error::last_os_error().raw_os_error(), Some(libc::ENOMEM));
    }
}
