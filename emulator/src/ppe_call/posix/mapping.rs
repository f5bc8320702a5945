//! Mappings of files and of new memory in effective address space.
//!
//! A mapping is an allocation that holds a copy of the file. Writes to it do not reach the file,
//! so a writable shared mapping of a file is refused.

use super::super::errno::check;
use super::super::guest::{Block, Reply};
use super::super::{Errno, Library};
use super::process::page_size;

/// The guest's `mmap` constants are those of Linux for PowerPC, which may differ from the host's.
const PROT_WRITE: u32 = 2;
const MAP_SHARED: u32 = 1;
const MAP_PRIVATE: u32 = 2;
const MAP_FIXED: u32 = 0x10;
const MAP_ANONYMOUS: u32 = 0x20;
const MREMAP_MAYMOVE: u32 = 1;
/// Number of bytes that are copied from a file at a time.
const PIECE: usize = 64 << 10;

/// The address, or all ones and the error number.
fn address(mapped: Result<u64, Errno>) -> Reply {
    match mapped {
        Ok(ea) => Reply::Doubleword(ea, 0),
        Err(errno) => Reply::Doubleword(u64::MAX, errno.0),
    }
}

pub(super) fn mmap(library: &mut Library, block: Block<'_>) -> Reply {
    address(map(library, block))
}

fn map(library: &mut Library, block: Block<'_>) -> Result<u64, Errno> {
    let (length, protection, flags) = (block.word(1), block.word(2), block.word(3));
    let (descriptor, offset) = (block.int(4), block.int(5));
    let page = page_size();
    let kinds = flags & (MAP_SHARED | MAP_PRIVATE);
    if length == 0 || offset < 0 || offset % page != 0 || !kinds.is_power_of_two() {
        return Err(Errno(libc::EINVAL));
    }
    let anonymous = flags & MAP_ANONYMOUS != 0;
    let writes_through = kinds == MAP_SHARED && protection & PROT_WRITE != 0 && !anonymous;
    if writes_through || flags & MAP_FIXED != 0 {
        return Err(Errno(libc::ENOTSUP));
    }
    let ea = library
        .heap
        .allocate(length.into(), page as u64)
        .ok_or(Errno(libc::ENOMEM))?;
    if !anonymous && let Err(errno) = copy_file(library, ea, length, descriptor, offset) {
        library.heap.release(ea);
        return Err(errno);
    }
    Ok(ea)
}

/// Copies a file. The bytes beyond its end stay 0.
fn copy_file(
    library: &mut Library,
    ea: u64,
    length: u32,
    descriptor: i32,
    offset: i32,
) -> Result<(), Errno> {
    let mut piece = vec![0; PIECE];
    let mut done = 0;
    while done < length as usize {
        let most = PIECE.min(length as usize - done);
        let at = i64::from(offset) + done as i64;
        // SAFETY: the buffer is valid for as many bytes as the length says.
        let read = unsafe { libc::pread(descriptor, piece.as_mut_ptr().cast(), most, at) };
        let read = check(read)? as usize;
        if read == 0 {
            break;
        }
        if !library.heap.write(ea + done as u64, &piece[..read]) {
            return Err(Errno(libc::EFAULT));
        }
        done += read;
    }
    Ok(())
}

pub(super) fn munmap(library: &mut Library, block: Block<'_>) -> Result<(), Errno> {
    let released = library.heap.release(block.doubleword(0));
    released.then_some(()).ok_or(Errno(libc::EINVAL))
}

pub(super) fn mremap(library: &mut Library, block: Block<'_>) -> Reply {
    let (ea, size, flags) = (block.doubleword(0), block.word(2), block.word(3));
    if size == 0 || library.heap.size_of(ea).is_none() {
        return address(Err(Errno(libc::EINVAL)));
    }
    if flags & MREMAP_MAYMOVE == 0 {
        return address(Err(Errno(libc::ENOMEM)));
    }
    let moved = library.reallocate(ea, size.into(), page_size() as u64);
    address(moved.ok_or(Errno(libc::ENOMEM)))
}

/// Nothing has to be written back, so only the address is checked.
pub(super) fn msync(library: &mut Library, block: Block<'_>) -> Result<(), Errno> {
    let mapped = library.heap.size_of(block.doubleword(0));
    mapped.map(|_| ()).ok_or(Errno(libc::ENOMEM))
}
