//! The border to the host: descriptors, and the memory that the guest's programs get there.
//!
//! Reading and writing descriptors goes through [`Outside`], so that a test can stand in for the
//! standard streams; whatever names files goes to the system.

use super::Errno;
use super::errno::check;

/// Who reads and writes descriptors.
pub trait Outside: Send {
    /// `read(2)`.
    fn read(&mut self, descriptor: i32, into: &mut [u8]) -> Result<usize, Errno> {
        loop {
            // SAFETY: the buffer is valid for as many bytes as are told.
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
            // SAFETY: the buffer is valid for as many bytes as are told.
            let written = unsafe { libc::write(descriptor, from.as_ptr().cast(), from.len()) };
            match check(written) {
                Err(Errno(libc::EINTR)) => {}
                answer => return answer.map(|written| written as usize),
            }
        }
    }

    /// Whether the descriptor is a terminal, so that output to it goes by lines.
    fn is_terminal(&mut self, descriptor: i32) -> bool {
        // SAFETY: it takes any number.
        unsafe { libc::isatty(descriptor) == 1 }
    }
}

/// This process's own descriptors.
#[derive(Clone, Copy, Debug, Default)]
pub struct Process;

impl Outside for Process {}

/// Main memory that guests allocate: for `malloc_ea` and `mmap_ea`.
pub trait Heap: Send {
    /// The effective address of `size` fresh bytes, all 0, or `None` if there is no room. The
    /// alignment is a power of two.
    fn allocate(&mut self, size: u64, alignment: u64) -> Option<u64>;
    /// Gives back what was allocated; `false` if nothing was at this address.
    fn release(&mut self, ea: u64) -> bool;
    /// Bytes allocated at an address.
    fn size_of(&self, ea: u64) -> Option<u64>;
    /// Copies bytes of main memory from an allocation; `false` if it can't be read.
    fn read(&self, ea: u64, into: &mut [u8]) -> bool;
    /// Copies bytes of main memory into an allocation; `false` if it can't be written.
    fn write(&self, ea: u64, from: &[u8]) -> bool;
}
