//! The C library's functions that the stand-in takes the place of.
//!
//! Invariant: calls that are not for spufs reach the C library.

use std::ffi::CStr;
use std::slice;

use libc::{
    c_char, c_int, c_long, c_void, mode_t, nfds_t, off_t, off64_t, pollfd, size_t, ssize_t,
};

use crate::context;
use crate::error::Errno;
use crate::fault;
use crate::file::{self, File};
use crate::next;
use crate::run;
use crate::table::{self, Open, table};

/// The library's numbers of the calls: the kernel's, negative where no kernel has them.
const SIGN: c_long =
    if cfg!(any(target_arch = "powerpc", target_arch = "powerpc64")) { 1 } else { -1 };
const SPU_RUN: c_long = SIGN * 278;
const SPU_CREATE: c_long = SIGN * 279;

/// A result in the C convention.
fn c_result<T: From<i8>>(result: Result<T, Errno>) -> T {
    result.unwrap_or_else(|Errno(errno)| {
        // SAFETY: the address is this thread's errno.
        unsafe { *libc::__errno_location() = errno };
        T::from(-1)
    })
}

/// Calls `body` with an open file of spufs.
fn with_file<T>(descriptor: c_int, body: impl FnOnce(&File) -> T) -> Option<T> {
    let Some(Open::File { context, kind, waits }) = table::find(descriptor) else {
        return None;
    };
    Some(body(&File { descriptor, context: &context, kind, waits }))
}

/// # Safety
/// The arguments are those of `spu_create`.
unsafe fn spu_create(path: *const c_char, flags: c_long) -> Result<c_long, Errno> {
    fault::check_calls()?;
    fault::check_rights()?;
    // SAFETY: the caller's promise.
    let path = unsafe { CStr::from_ptr(path) };
    let path = path.to_str().map_err(|_| Errno(libc::EINVAL))?;
    context::create(path, flags as u32).map(c_long::from)
}

/// # Safety
/// The arguments are those of `spu_run`.
unsafe fn spu_run(descriptor: c_long, npc: *mut u32, event: *mut u32) -> Result<c_long, Errno> {
    fault::check_calls()?;
    let context = match table::find(descriptor as c_int) {
        Some(Open::Context(_, context)) => context,
        Some(_) => return Err(Errno(libc::EINVAL)),
        None => return Err(Errno(libc::EBADF)),
    };
    // SAFETY: the caller's promise.
    unsafe {
        let mut at = npc.read();
        let result = run::run(&context, &mut at);
        npc.write(at);
        let (status, events) = result?;
        if !event.is_null() {
            event.write(events);
        }
        Ok(status.into())
    }
}

/// # Safety
/// As the C library's `syscall`. Its arguments are taken as a fixed number of words, of which a
/// caller may leave out the last: those are never looked at.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn syscall(
    number: c_long,
    a: c_long,
    b: c_long,
    c: c_long,
    d: c_long,
    e: c_long,
    f: c_long,
) -> c_long {
    // SAFETY: the caller's promise.
    unsafe {
        match number {
            SPU_CREATE => c_result(spu_create(a as *const c_char, b)),
            SPU_RUN => c_result(spu_run(a, b as *mut u32, c as *mut u32)),
            _ => next::syscall(number, a, b, c, d, e, f),
        }
    }
}

/// # Safety
/// As the C library's `openat`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn openat(
    directory: c_int,
    path: *const c_char,
    flags: c_int,
    mode: mode_t,
) -> c_int {
    // SAFETY: the caller's promise; variable arguments that are integers are passed as others are.
    unsafe {
        match table::find(directory) {
            Some(Open::Context(_, context)) => {
                let name = CStr::from_ptr(path).to_string_lossy();
                c_result(file::open(&context, &name, flags))
            }
            _ => next::openat(directory, path, flags, mode),
        }
    }
}

/// # Safety
/// As the C library's `close`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn close(descriptor: c_int) -> c_int {
    table::close(descriptor);
    // SAFETY: the caller's promise.
    unsafe { next::close(descriptor) }
}

/// # Safety
/// As the C library's `read`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn read(descriptor: c_int, into: *mut c_void, size: size_t) -> ssize_t {
    // SAFETY: the caller's promise.
    unsafe {
        let read =
            with_file(descriptor, |file| file.read(slice::from_raw_parts_mut(into.cast(), size)));
        match read {
            Some(result) => c_result(result.map(|size| size as ssize_t)),
            None => next::read(descriptor, into, size),
        }
    }
}

/// # Safety
/// As the C library's `write`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn write(descriptor: c_int, from: *const c_void, size: size_t) -> ssize_t {
    // SAFETY: the caller's promise.
    unsafe {
        let written =
            with_file(descriptor, |file| file.write(slice::from_raw_parts(from.cast(), size)));
        match written {
            Some(result) => c_result(result.map(|size| size as ssize_t)),
            None => next::write(descriptor, from, size),
        }
    }
}

/// # Safety
/// As the C library's `pwrite64`, which has another name in musl.
#[cfg_attr(not(target_env = "musl"), unsafe(no_mangle))]
#[cfg_attr(target_env = "musl", unsafe(export_name = "pwrite"))]
pub unsafe extern "C" fn pwrite64(
    descriptor: c_int,
    from: *const c_void,
    size: size_t,
    offset: off64_t,
) -> ssize_t {
    // SAFETY: the caller's promise.
    unsafe {
        let written = with_file(descriptor, |file| {
            file.write_at(slice::from_raw_parts(from.cast(), size), offset as u64)
        });
        match written {
            Some(result) => c_result(result.map(|size| size as ssize_t)),
            None => next::pwrite64(descriptor, from, size, offset),
        }
    }
}

/// # Safety
/// As the C library's `mmap`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mmap(
    address: *mut c_void,
    size: size_t,
    protection: c_int,
    flags: c_int,
    descriptor: c_int,
    offset: off_t,
) -> *mut c_void {
    let Some(Open::File { context, kind, waits }) = table::find(descriptor) else {
        // SAFETY: the caller's promise.
        return unsafe { next::mmap(address, size, protection, flags, descriptor, offset) };
    };
    let file = File { descriptor, context: &context, kind, waits };
    let mapped = match offset {
        0 => file.map(size, flags),
        _ => Err(Errno(libc::EINVAL)),
    };
    match mapped {
        Ok(address) => {
            table().map(address, context);
            std::ptr::with_exposed_provenance_mut(address)
        }
        Err(Errno(errno)) => {
            // SAFETY: the address is this thread's errno.
            unsafe { *libc::__errno_location() = errno };
            libc::MAP_FAILED
        }
    }
}

/// # Safety
/// As the C library's `munmap`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn munmap(address: *mut c_void, size: size_t) -> c_int {
    if table::unmap(address.addr()) {
        return 0;
    }
    // SAFETY: the caller's promise.
    unsafe { next::munmap(address, size) }
}

/// # Safety
/// As the C library's `poll`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn poll(files: *mut pollfd, count: nfds_t, milliseconds: c_int) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        for at in 0..count as usize {
            with_file((*files.add(at)).fd, |file| file.ask_for_tags());
        }
        next::poll(files, count, milliseconds)
    }
}

/// The addresses of the functions. A program that links the stand-in calls this, so that the linker
/// takes these functions and not the C library's.
#[must_use]
pub fn linked() -> [*const (); 9] {
    [
        syscall as *const (),
        openat as *const (),
        close as *const (),
        read as *const (),
        write as *const (),
        pwrite64 as *const (),
        mmap as *const (),
        munmap as *const (),
        poll as *const (),
    ]
}
