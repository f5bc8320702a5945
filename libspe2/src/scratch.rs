//! Buffers through which the kernel copies to and from addresses that may be invalid.
//!
//! A scratch buffer is a mapped in-memory file. `pwrite` from an address to the file and `pread`
//! from the file to an address make the kernel check the address, so an invalid address is an
//! error instead of a signal. This also works under QEMU's user emulation.

use std::io;
use std::os::fd::{AsRawFd, FromRawFd, OwnedFd};
use std::ptr::{self, NonNull};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// Size of a scratch buffer in bytes: the largest transfer of an MFC.
pub(crate) const SCRATCH: usize = 16 * 1024;

/// The most pieces of one system call.
const MAX_PIECES: usize = 64;

pub(crate) struct Scratch {
    file: OwnedFd,
    mapping: NonNull<u8>,
}

// SAFETY: the mapping belongs to this value alone and is accessed only through `&mut self`.
unsafe impl Send for Scratch {}

impl Scratch {
    fn new() -> io::Result<Self> {
        // A direct system call, because glibc has a function for it only from 2.27 on.
        // SAFETY: the name is a C string, and the flag is valid.
        let raw = unsafe {
            libc::syscall(libc::SYS_memfd_create, c"libspe2".as_ptr(), libc::MFD_CLOEXEC)
        };
        if raw < 0 {
            return Err(io::Error::last_os_error());
        }
        let raw = raw as std::os::fd::RawFd;
        // SAFETY: the descriptor was just created, and nothing else owns it.
        let file = unsafe { OwnedFd::from_raw_fd(raw) };
        // SAFETY: the descriptor is open.
        if unsafe { libc::ftruncate(raw, SCRATCH as libc::off_t) } != 0 {
            return Err(io::Error::last_os_error());
        }
        // SAFETY: a new mapping at an address that the kernel chooses overlaps nothing.
        let mapping = unsafe {
            libc::mmap(
                ptr::null_mut(),
                SCRATCH,
                libc::PROT_READ | libc::PROT_WRITE,
                libc::MAP_SHARED,
                raw,
                0,
            )
        };
        match NonNull::new(mapping.cast::<u8>()) {
            Some(mapping) if mapping.as_ptr().cast() != libc::MAP_FAILED => {
                Ok(Self { file, mapping })
            }
            _ => Err(io::Error::last_os_error()),
        }
    }

    /// Copies from `ea`. The error is the first address that can't be read, as far as it is known.
    pub(crate) fn fetch(&mut self, ea: u64, into: &mut [u8]) -> Result<(), u64> {
        for (at, piece) in pieces(ea, into.len()) {
            let part = &mut into[piece];
            self.move_all(at, part.len(), |file, address, n, offset| {
                // SAFETY: the kernel checks the range at `address` and fails if it can't be read.
                unsafe { libc::pwrite(file, address, n, offset) }
            })?;
            // SAFETY: the mapping has SCRATCH bytes, a piece has no more, and `part` does not
            // overlap it.
            unsafe {
                ptr::copy_nonoverlapping(self.mapping.as_ptr(), part.as_mut_ptr(), part.len());
            }
        }
        Ok(())
    }

    /// Copies to `ea`. The error is the first address that can't be written, as far as it is
    /// known.
    pub(crate) fn store(&mut self, ea: u64, from: &[u8]) -> Result<(), u64> {
        for (at, piece) in pieces(ea, from.len()) {
            let part = &from[piece];
            // SAFETY: the mapping has SCRATCH bytes, a piece has no more, and `part` does not
            // overlap it.
            unsafe {
                ptr::copy_nonoverlapping(part.as_ptr(), self.mapping.as_ptr(), part.len());
            }
            self.move_all(at, part.len(), |file, address, n, offset| {
                // SAFETY: the kernel checks the range at `address` and fails if it can't be
                // written. The program asked its MFC to write there.
                unsafe { libc::pread(file, address.cast_mut(), n, offset) }
            })?;
        }
        Ok(())
    }

    /// Copies to the pieces of `into`, each from its address, with as few system calls as possible.
    /// The error is the first address that can't be read, as far as it is known.
    pub(crate) fn fetch_pieces(
        &mut self,
        pieces: &[(u64, usize)],
        into: &mut [u8],
    ) -> Result<(), u64> {
        let mut rest = into;
        for pieces in pieces.chunks(MAX_PIECES) {
            let length = pieces.iter().map(|(_, length)| length).sum();
            let (mut part, others) = rest.split_at_mut(length);
            rest = others;
            if self.fetch_at_once(pieces, part) {
                continue;
            }
            // They are tried again piece by piece, to find the piece that fails.
            for &(ea, length) in pieces {
                let (piece, others) = part.split_at_mut(length);
                self.fetch(ea, piece)?;
                part = others;
            }
        }
        Ok(())
    }

    /// Copies to the pieces of `into` with one system call. Returns whether that was possible.
    fn fetch_at_once(&mut self, pieces: &[(u64, usize)], into: &mut [u8]) -> bool {
        if into.len() > SCRATCH {
            return false;
        }
        let sources = vectors(pieces);
        // SAFETY: the kernel checks the range of each source and ends at the first that can't be
        // read. There are at least `sources` of them.
        let read = unsafe {
            libc::pwritev(self.file.as_raw_fd(), sources.as_ptr(), pieces.len() as i32, 0)
        };
        if usize::try_from(read) != Ok(into.len()) {
            return false;
        }
        // SAFETY: the mapping has SCRATCH bytes, `into` has no more and does not overlap it.
        unsafe {
            ptr::copy_nonoverlapping(self.mapping.as_ptr(), into.as_mut_ptr(), into.len());
        }
        true
    }

    /// Copies the pieces of `from`, each to its address, with as few system calls as possible. The
    /// error is the first address that can't be written, as far as it is known.
    pub(crate) fn store_pieces(&mut self, pieces: &[(u64, usize)], from: &[u8]) -> Result<(), u64> {
        let mut done = self.store_at_once(pieces, from);
        // The rest is tried again piece by piece, to find the piece that fails.
        let mut rest = from;
        for &(ea, length) in pieces {
            let (piece, others) = rest.split_at(length);
            if done < length {
                self.store(ea, piece)?;
            }
            done = done.saturating_sub(length);
            rest = others;
        }
        Ok(())
    }

    /// Copies the pieces of `from` with one system call. Returns how many bytes it has copied: none
    /// if there are too many for one.
    fn store_at_once(&mut self, pieces: &[(u64, usize)], from: &[u8]) -> usize {
        if pieces.len() > MAX_PIECES || from.len() > SCRATCH {
            return 0;
        }
        // SAFETY: the mapping has SCRATCH bytes, `from` has no more and does not overlap it.
        unsafe {
            ptr::copy_nonoverlapping(from.as_ptr(), self.mapping.as_ptr(), from.len());
        }
        let targets = vectors(pieces);
        // SAFETY: the kernel checks the range of each target and ends at the first that can't be
        // written. The program asked its MFC to write there. There are at least `targets` of them.
        let written = unsafe {
            libc::preadv(self.file.as_raw_fd(), targets.as_ptr(), pieces.len() as i32, 0)
        };
        usize::try_from(written).unwrap_or(0)
    }

    fn move_all(
        &self,
        ea: u64,
        length: usize,
        step: impl Fn(i32, *const libc::c_void, usize, libc::off_t) -> isize,
    ) -> Result<(), u64> {
        let mut done = 0;
        while done < length {
            let at = ea.wrapping_add(done as u64);
            let address = ptr::with_exposed_provenance(at as usize);
            let file = self.file.as_raw_fd();
            match step(file, address, length - done, done as libc::off_t) {
                n if n > 0 => done += n as usize,
                0 => return Err(at),
                _ if io::Error::last_os_error().kind() == io::ErrorKind::Interrupted => {}
                _ => return Err(at),
            }
        }
        Ok(())
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // SAFETY: the mapping belongs to this value and has SCRATCH bytes.
        unsafe { libc::munmap(self.mapping.as_ptr().cast(), SCRATCH) };
    }
}

/// The addresses and lengths of at most [`MAX_PIECES`] pieces for a system call.
fn vectors(pieces: &[(u64, usize)]) -> [libc::iovec; MAX_PIECES] {
    let nowhere = libc::iovec { iov_base: ptr::null_mut(), iov_len: 0 };
    let mut vectors = [nowhere; MAX_PIECES];
    for (vector, &(ea, length)) in vectors.iter_mut().zip(pieces) {
        vector.iov_base = ptr::with_exposed_provenance_mut(ea as usize);
        vector.iov_len = length;
    }
    vectors
}

/// Splits `length` bytes at `ea` into pieces that fit a scratch buffer, each with its range in the
/// caller's slice. The part that would pass the end of the address space is one last piece, which
/// the kernel refuses.
fn pieces(ea: u64, length: usize) -> impl Iterator<Item = (u64, std::ops::Range<usize>)> {
    (0..length).step_by(SCRATCH).map(move |start| {
        let end = length.min(start + SCRATCH);
        (ea.saturating_add(start as u64), start..end)
    })
}

/// The scratch buffers that are free.
pub(crate) struct Pool {
    shelf: Mutex<Shelf>,
    returned: Condvar,
}

struct Shelf {
    free: Vec<Scratch>,
    /// Threads that wait for a buffer. While none does, returning one needs no system call.
    waiting: usize,
}

impl Pool {
    pub(crate) const fn new() -> Self {
        Self { shelf: Mutex::new(Shelf { free: Vec::new(), waiting: 0 }), returned: Condvar::new() }
    }

    fn shelf(&self) -> MutexGuard<'_, Shelf> {
        self.shelf.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Ensures that at least one scratch buffer exists. From then on, [`with`](Self::with)
    /// succeeds.
    pub(crate) fn prepare(&self) -> io::Result<()> {
        let mut shelf = self.shelf();
        if shelf.free.is_empty() {
            shelf.free.push(Scratch::new()?);
        }
        Ok(())
    }

    /// Lends a scratch buffer: a free one, or else a new one, or else the first that is returned.
    pub(crate) fn with<T>(&self, body: impl FnOnce(&mut Scratch) -> T) -> T {
        let mut shelf = self.shelf();
        let mut scratch = loop {
            if let Some(scratch) = shelf.free.pop() {
                break scratch;
            }
            if let Ok(scratch) = Scratch::new() {
                break scratch;
            }
            shelf.waiting += 1;
            shelf = self.returned.wait(shelf).unwrap_or_else(PoisonError::into_inner);
            shelf.waiting -= 1;
        };
        drop(shelf);
        let result = body(&mut scratch);
        let mut shelf = self.shelf();
        shelf.free.push(scratch);
        if shelf.waiting > 0 {
            self.returned.notify_one();
        }
        result
    }
}
