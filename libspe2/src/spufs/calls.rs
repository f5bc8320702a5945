//! The system calls of spufs, for which the C library has no functions.

use std::ffi::CStr;
use std::io;
use std::os::fd::{AsRawFd, BorrowedFd, FromRawFd, OwnedFd, RawFd};
use std::ptr;

use libc::{c_int, c_long, c_uint};

/// Creation flag: DMA errors are reported by `spu_run` instead of by signals.
pub(super) const EVENTS_ENABLED: c_uint = 0x1;
/// Creation flag: a gang instead of a context.
pub(super) const GANG: c_uint = 0x2;
/// Creation flag: the context is never scheduled out.
pub(super) const NOSCHED: c_uint = 0x4;
/// Creation flag: near to another context.
pub(super) const AFFINITY_SPU: c_uint = 0x10;
/// Creation flag: near to memory.
pub(super) const AFFINITY_MEMORY: c_uint = 0x20;

/// The number of a system call. Other processors have none for it, and their kernels refuse a
/// negative one; a stand-in for the kernel can serve it there.
const fn number(powerpc: c_long) -> c_long {
    if cfg!(any(target_arch = "powerpc", target_arch = "powerpc64")) { powerpc } else { -powerpc }
}

const SPU_RUN: c_long = number(278);
const SPU_CREATE: c_long = number(279);

/// The owner may do everything in a context's directory.
const MODE: c_long = 0o700;
const NO_DESCRIPTOR: RawFd = -1;

/// Whether the kernel has the calls.
pub(super) fn are_there() -> bool {
    // SAFETY: the kernel looks at the descriptor first, and refuses it.
    let result = unsafe {
        libc::syscall(
            SPU_RUN,
            c_long::from(NO_DESCRIPTOR),
            ptr::null_mut::<u32>(),
            ptr::null_mut::<u32>(),
        )
    };
    result >= 0 || io::Error::last_os_error().raw_os_error() != Some(libc::ENOSYS)
}

/// Creates a context or a gang, and returns the descriptor of its directory.
pub(super) fn create(path: &CStr, flags: c_uint, neighbor: Option<RawFd>) -> io::Result<OwnedFd> {
    let neighbor = neighbor.unwrap_or(NO_DESCRIPTOR);
    // SAFETY: the path is a C string; the kernel checks the other arguments.
    let result = unsafe {
        libc::syscall(SPU_CREATE, path.as_ptr(), flags as c_long, MODE, c_long::from(neighbor))
    };
    match RawFd::try_from(result) {
        Ok(raw) if raw >= 0 => {
            // SAFETY: the descriptor was just created, and nothing else owns it.
            let directory = unsafe { OwnedFd::from_raw_fd(raw) };
            // A program that this one executes must not keep the context. If it fails, it does.
            // SAFETY: the call takes no pointers.
            unsafe { libc::fcntl(raw, libc::F_SETFD, libc::FD_CLOEXEC) };
            Ok(directory)
        }
        _ => Err(io::Error::last_os_error()),
    }
}

/// Runs a context on the calling thread until its SPU stops. `npc` is the address to start at, and
/// afterwards the address to continue at. Returns the SPU's status.
pub(super) fn run(
    directory: BorrowedFd,
    npc: &mut u32,
    events: Option<&mut u32>,
) -> io::Result<c_int> {
    let events: *mut u32 = events.map_or(ptr::null_mut(), |events| events);
    // SAFETY: the pointers are to words of the caller, and the second may be NULL. The memory that
    // the SPU program itself accesses is the program's responsibility.
    let status = unsafe {
        libc::syscall(SPU_RUN, c_long::from(directory.as_raw_fd()), ptr::from_mut(npc), events)
    };
    if status < 0 {
        return Err(io::Error::last_os_error());
    }
    Ok(status as c_int)
}
