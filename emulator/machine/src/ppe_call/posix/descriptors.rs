//! Calls on file descriptors. The guest's descriptors are the host's.

use super::super::errno::check;
use super::super::guest::{Block, Reply};
use super::super::{Errno, Library};
use super::moved;
use crate::local_store::SIZE;

/// The largest number of pieces in `readv` and `writev`.
const MOST_PIECES: u32 = 1024;

/// Functions of the C library that get numbers.
macro_rules! with_numbers {
    ($($name:ident($block:ident, $($argument:expr),*);)*) => {$(
        pub(super) fn $name($block: Block<'_>) -> Result<i32, Errno> {
            // SAFETY: it accepts any numbers, and no code here relies on a descriptor that it could
            // close.
            check(unsafe { libc::$name($($argument),*) })
        }
    )*};
}

with_numbers! {
    close(block, block.int(0));
    ftruncate(block, block.int(0), block.int(1).into());
    dup(block, block.int(0));
    dup2(block, block.int(0), block.int(1));
    fchdir(block, block.int(0));
    fchmod(block, block.int(0), block.word(1));
    fchown(block, block.int(0), block.word(1), block.word(2));
    fsync(block, block.int(0));
    fdatasync(block, block.int(0));
    lockf(block, block.int(0), block.int(1), block.int(2).into());
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

pub(super) fn sync() -> Reply {
    // SAFETY: `sync` has no arguments.
    unsafe { libc::sync() };
    Reply::Nothing
}
