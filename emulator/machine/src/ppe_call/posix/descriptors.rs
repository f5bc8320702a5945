//! Calls on file descriptors. The guest's descriptors are the host's.

use super::super::errno::check;
use super::super::guest::{Block, Reply};
use super::super::{Errno, Library};
use super::moved;
use crate::local_store::SIZE;

/// The largest number of pieces in `readv` and `writev`.
const MOST_PIECES: u32 = 1024;

pub(super) fn close(block: Block<'_>) -> Result<i32, Errno> {
    // SAFETY: `close` accepts any number, and no code here relies on a descriptor that it could
    // close.
    check(unsafe { libc::close(block.int(0)) })
}

pub(super) fn read(library: &Library, block: Block<'_>) -> Result<i32, Errno> {
    let mut bytes = vec![0; block.word(2).min(SIZE) as usize];
    let read = library.host.read(block.int(0), &mut bytes)?;
    block.guest.write(block.word(1), &bytes[..read]);
    moved(read)
}

pub(super) fn write(library: &Library, block: Block<'_>) -> Result<i32, Errno> {
    let bytes = block.guest.bytes(block.word(1), block.word(2));
    moved(library.host.write(block.int(0), &bytes)?)
}

pub(super) fn pread(block: Block<'_>) -> Result<i32, Errno> {
    let mut bytes = vec![0; block.word(2).min(SIZE) as usize];
    let offset = block.int(3).into();
    // SAFETY: the buffer is valid for the number of bytes that is passed.
    let read = check(unsafe {
        libc::pread64(block.int(0), bytes.as_mut_ptr().cast(), bytes.len(), offset)
    })?;
    block.guest.write(block.word(1), &bytes[..read as usize]);
    moved(read as usize)
}

pub(super) fn pwrite(block: Block<'_>) -> Result<i32, Errno> {
    let bytes = block.guest.bytes(block.word(1), block.word(2));
    let offset = block.int(3).into();
    // SAFETY: the buffer is valid for the number of bytes that is passed.
    let written =
        check(unsafe { libc::pwrite64(block.int(0), bytes.as_ptr().cast(), bytes.len(), offset) })?;
    moved(written as usize)
}

/// Addresses and lengths of the pieces of a vector. Their total size is at most that of local
/// store.
fn pieces(block: Block<'_>) -> Result<Vec<(u32, u32)>, Errno> {
    const PIECE: u32 = 8;
    let (vector, count) = (block.word(1), block.word(2));
    if count > MOST_PIECES {
        return Err(Errno(libc::EINVAL));
    }
    let mut sum = 0_u64;
    (0..count)
        .map(|n| {
            let at = vector.wrapping_add(n * PIECE);
            let length = block.guest.word(at.wrapping_add(4));
            sum += u64::from(length);
            if sum > i32::MAX as u64 {
                return Err(Errno(libc::EINVAL));
            }
            Ok((block.guest.word(at), length.min(SIZE)))
        })
        .collect()
}

pub(super) fn readv(library: &Library, block: Block<'_>) -> Result<i32, Errno> {
    let pieces = pieces(block)?;
    let length: u32 = pieces.iter().map(|(_, length)| length).sum();
    let mut bytes = vec![0; length as usize];
    let read = library.host.read(block.int(0), &mut bytes)?;
    let mut rest = &bytes[..read];
    for (address, length) in pieces {
        let (now, later) = rest.split_at(rest.len().min(length as usize));
        block.guest.write(address, now);
        rest = later;
    }
    moved(read)
}

pub(super) fn writev(library: &Library, block: Block<'_>) -> Result<i32, Errno> {
    let mut bytes = Vec::new();
    for (address, length) in pieces(block)? {
        bytes.extend(block.guest.bytes(address, length));
    }
    moved(library.host.write(block.int(0), &bytes)?)
}

pub(super) fn lseek(block: Block<'_>) -> Result<i32, Errno> {
    // SAFETY: `lseek` accepts any numbers.
    let at = check(unsafe { libc::lseek64(block.int(0), block.int(1).into(), block.int(2)) })?;
    i32::try_from(at).map_err(|_| Errno(libc::EOVERFLOW))
}

pub(super) fn ftruncate(block: Block<'_>) -> Result<i32, Errno> {
    // SAFETY: `ftruncate` accepts any numbers.
    check(unsafe { libc::ftruncate(block.int(0), block.int(1).into()) })
}

pub(super) fn dup(block: Block<'_>) -> Result<i32, Errno> {
    // SAFETY: `dup` accepts any number.
    check(unsafe { libc::dup(block.int(0)) })
}

pub(super) fn dup2(block: Block<'_>) -> Result<i32, Errno> {
    // SAFETY: `dup2` accepts any numbers, and no code here relies on a descriptor that it could
    // close.
    check(unsafe { libc::dup2(block.int(0), block.int(1)) })
}

pub(super) fn fchdir(block: Block<'_>) -> Result<i32, Errno> {
    // SAFETY: `fchdir` accepts any number.
    check(unsafe { libc::fchdir(block.int(0)) })
}

pub(super) fn fchmod(block: Block<'_>) -> Result<i32, Errno> {
    // SAFETY: `fchmod` accepts any numbers.
    check(unsafe { libc::fchmod(block.int(0), block.word(1)) })
}

pub(super) fn fchown(block: Block<'_>) -> Result<i32, Errno> {
    // SAFETY: `fchown` accepts any numbers.
    check(unsafe { libc::fchown(block.int(0), block.word(1), block.word(2)) })
}

pub(super) fn sync() -> Reply {
    // SAFETY: `sync` has no arguments.
    unsafe { libc::sync() };
    Reply::Nothing
}

pub(super) fn fsync(block: Block<'_>) -> Result<i32, Errno> {
    // SAFETY: `fsync` accepts any number.
    check(unsafe { libc::fsync(block.int(0)) })
}

pub(super) fn fdatasync(block: Block<'_>) -> Result<i32, Errno> {
    // SAFETY: `fdatasync` accepts any number.
    check(unsafe { libc::fdatasync(block.int(0)) })
}

pub(super) fn lockf(block: Block<'_>) -> Result<i32, Errno> {
    // SAFETY: `lockf` accepts any numbers.
    check(unsafe { libc::lockf(block.int(0), block.int(1), block.int(2).into()) })
}
