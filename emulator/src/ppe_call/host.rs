//! The interface to the host: file descriptors, and memory that guests allocate.
//!
//! Descriptors are read and written through [`Host`], so that a test can replace the standard
//! streams. Calls that name files go directly to the system.

use super::Errno;
use super::errno::check;

/// Reads and writes descriptors.
pub trait Host: Send {
    /// `read(2)`.
    fn read(&mut self, descriptor: i32, into: &mut [u8]) -> Result<usize, Errno> {
        loop {
            // SAFETY: the buffer is valid for as many bytes as the length says.
            let read = unsafe { libc::read(descriptor, into.as_mut_ptr().cast(), into.len()) };
            match check(read) {
                Err(Errno(libc::EINTR)) => {}
                answer => return answer.map(|read| read as usize),
            }
        }
    }

    /// `write(2)`.
    fn write(&mut self, descriptor: i32, from: &[u8]) -> Result<usize, Errno> {
        loop {
            // SAFETY: the buffer is valid for as many bytes as the length says.
            let written = unsafe { libc::write(descriptor, from.as_ptr().cast(), from.len()) };
            match check(written) {
                Err(Errno(libc::EINTR)) => {}
                answer => return answer.map(|written| written as usize),
            }
        }
    }

    /// Whether the descriptor is a terminal, so that output to it is line-buffered.
    fn is_terminal(&mut self, descriptor: i32) -> bool {
        // SAFETY: `isatty` accepts any number.
        unsafe { libc::isatty(descriptor) == 1 }
    }
}

/// The descriptors of this process.
#[derive(Clone, Copy, Debug, Default)]
pub struct Process;

impl Host for Process {}

/// Main memory that guests allocate, for `malloc_ea` and `mmap_ea`.
pub trait Heap: Send {
    /// The effective address of `size` new bytes, all 0, or `None` if there is no room. The
    /// alignment must be a power of two.
    fn allocate(&mut self, size: u64, alignment: u64) -> Option<u64>;
    /// Frees an allocation. Returns `false` if there is none at this address.
    fn release(&mut self, ea: u64) -> bool;
    /// Size in bytes of the allocation at an address.
    fn size_of(&self, ea: u64) -> Option<u64>;
    /// Copies bytes out of an allocation. Returns `false` if it can't be read.
    fn read(&self, ea: u64, into: &mut [u8]) -> bool;
    /// Copies bytes into an allocation. Returns `false` if it can't be written.
    fn write(&self, ea: u64, from: &[u8]) -> bool;
}
