//! The interface to the host: file descriptors, and memory that guests allocate.
//!
//! Descriptors are read and written through [`Host`], so that a test can replace the standard
//! streams, and a process can share its own C streams with the guest. Calls that name files go
//! directly to the system.

use super::errno::check;
use super::{Buffering, Errno};

/// Reads and writes descriptors. Several threads may do so at the same time.
pub trait Host: Send + Sync {
    /// `read(2)`.
    fn read(&self, descriptor: i32, into: &mut [u8]) -> Result<usize, Errno> {
        loop {
            // SAFETY: the buffer is valid for the number of bytes that is passed.
            let read = unsafe { libc::read(descriptor, into.as_mut_ptr().cast(), into.len()) };
            match check(read) {
                Err(Errno(libc::EINTR)) => {}
                result => return result.map(|read| read as usize),
            }
        }
    }

    /// `write(2)`.
    fn write(&self, descriptor: i32, from: &[u8]) -> Result<usize, Errno> {
        loop {
            // SAFETY: the buffer is valid for the number of bytes that is passed.
            let written = unsafe { libc::write(descriptor, from.as_ptr().cast(), from.len()) };
            match check(written) {
                Err(Errno(libc::EINTR)) => {}
                result => return result.map(|written| written as usize),
            }
        }
    }

    /// Whether the descriptor is a terminal, so that output to it is line-buffered.
    fn is_terminal(&self, descriptor: i32) -> bool {
        // SAFETY: `isatty` accepts any number.
        unsafe { libc::isatty(descriptor) == 1 }
    }

    /// Reads for a stream. The standard streams may be the process's own.
    fn read_stream(&self, descriptor: i32, into: &mut [u8]) -> Result<usize, Errno> {
        self.read(descriptor, into)
    }

    /// Writes for a stream.
    fn write_stream(&self, descriptor: i32, from: &[u8]) -> Result<usize, Errno> {
        self.write(descriptor, from)
    }

    /// Whether the host itself buffers the streams of this descriptor. The guest's stream then
    /// keeps nothing back, reads nothing ahead, and asks for [`flush`](Self::flush).
    fn buffers(&self, _descriptor: i32) -> bool {
        false
    }

    /// Writes what the host has buffered for the descriptor.
    fn flush(&self, _descriptor: i32) -> Result<(), Errno> {
        Ok(())
    }

    /// Sets how the host buffers the descriptor. The size is in bytes, or 0 for the usual one.
    fn set_buffering(&self, _descriptor: i32, _buffering: Buffering, _size: usize) {}
}

/// The descriptors of this process.
#[derive(Clone, Copy, Debug, Default)]
pub struct Process;

impl Host for Process {}

/// Main memory that guests allocate, for `malloc_ea` and `mmap_ea`.
pub trait Heap: Send {
    /// Whether effective addresses are addresses of this process, so that `mmap` and system calls
    /// can be the system's own.
    fn is_process(&self) -> bool {
        false
    }

    /// The effective address of `size` new bytes, all 0, or `None` if memory is exhausted. The
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
