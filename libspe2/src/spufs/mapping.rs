//! Mapped files of a context: local store and the problem state.

use std::fs::File;
use std::io;
use std::os::fd::AsRawFd;
use std::ptr::{self, NonNull};
use std::sync::atomic::{Ordering::SeqCst, fence};

use libc::c_void;

/// A shared mapping of a file from its start, which ends when this value is dropped.
pub(super) struct Mapping {
    start: NonNull<u8>,
    size: usize,
}

// SAFETY: the mapping is accessed by single loads and stores of words, or by the program.
unsafe impl Send for Mapping {}
// SAFETY: as above.
unsafe impl Sync for Mapping {}

impl Mapping {
    pub(super) fn new(file: &File, size: usize) -> io::Result<Self> {
        // SAFETY: a new mapping at an address that the kernel chooses overlaps nothing.
        let start = unsafe {
            libc::mmap(
                ptr::null_mut(),
                size,
                libc::PROT_READ | libc::PROT_WRITE,
                libc::MAP_SHARED,
                file.as_raw_fd(),
                0,
            )
        };
        match NonNull::new(start.cast::<u8>()) {
            Some(start) if start.as_ptr().cast() != libc::MAP_FAILED => Ok(Self { start, size }),
            _ => Err(io::Error::last_os_error()),
        }
    }

    pub(super) fn as_ptr(&self) -> *mut u8 {
        self.start.as_ptr()
    }

    fn register(&self, offset: usize) -> *mut u32 {
        assert!(offset + 4 <= self.size && offset.is_multiple_of(4));
        // SAFETY: the register lies in the mapping.
        unsafe { self.start.as_ptr().add(offset) }.cast()
    }

    /// Loads a device register, after all earlier accesses. The load is an instruction of its own,
    /// as registers need it.
    #[inline(never)]
    pub(super) fn load(&self, offset: usize) -> u32 {
        fence(SeqCst);
        // SAFETY: the register lies in the mapping, and nothing in Rust has a reference to it.
        unsafe { self.register(offset).read_volatile() }
    }

    /// Stores to a device register, after all earlier accesses.
    #[inline(never)]
    pub(super) fn store(&self, offset: usize, value: u32) {
        fence(SeqCst);
        // SAFETY: as for a load.
        unsafe { self.register(offset).write_volatile(value) };
    }
}

impl Drop for Mapping {
    fn drop(&mut self) {
        // SAFETY: the mapping belongs to this value and has this size.
        unsafe { libc::munmap(self.start.as_ptr().cast::<c_void>(), self.size) };
    }
}
