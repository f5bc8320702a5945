//! Mappings of files and of new memory in effective address space.
//!
//! A mapping is an allocation that holds a copy of the file. Writes to it do not reach the file,
//! so a writable shared mapping of a file is refused. Where effective addresses are addresses of
//! the process, the calls are the system's own instead.

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

pub(super) fn mmap(library: &Library, block: Block<'_>) -> Reply {
    address(map(library, block))
}

fn map(library: &Library, block: Block<'_>) -> Result<u64, Errno> {
    let (length, protection, flags) = (block.word(1), block.word(2), block.word(3));
    let (descriptor, offset) = (block.int(4), block.int(5));
    if library.heap().is_process() {
        return system::map(block.doubleword(0), length, protection, flags, descriptor, offset);
    }
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
    let ea = library.heap().allocate(length.into(), page as u64).ok_or(Errno(libc::ENOMEM))?;
    if !anonymous && let Err(errno) = copy_file(library, ea, length, descriptor, offset) {
        library.heap().release(ea);
        return Err(errno);
    }
    Ok(ea)
}

/// Copies a file. The bytes beyond its end stay 0.
fn copy_file(
    library: &Library,
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
        // SAFETY: the buffer is valid for the number of bytes that is passed.
        let read = unsafe { libc::pread64(descriptor, piece.as_mut_ptr().cast(), most, at) };
        let read = check(read)? as usize;
        if read == 0 {
            break;
        }
        if !library.heap().write(ea + done as u64, &piece[..read]) {
            return Err(Errno(libc::EFAULT));
        }
        done += read;
    }
    Ok(())
}

pub(super) fn munmap(library: &Library, block: Block<'_>) -> Result<(), Errno> {
    if library.heap().is_process() {
        return system::unmap(block.doubleword(0), block.word(1));
    }
    let released = library.heap().release(block.doubleword(0));
    released.then_some(()).ok_or(Errno(libc::EINVAL))
}

pub(super) fn mremap(library: &Library, block: Block<'_>) -> Reply {
    let (ea, size, flags) = (block.doubleword(0), block.word(2), block.word(3));
    if library.heap().is_process() {
        return address(system::remap(ea, block.word(1), size, flags));
    }
    if size == 0 || library.heap().size_of(ea).is_none() {
        return address(Err(Errno(libc::EINVAL)));
    }
    if flags & MREMAP_MAYMOVE == 0 {
        return address(Err(Errno(libc::ENOMEM)));
    }
    let moved = library.reallocate(ea, size.into(), page_size() as u64);
    address(moved.ok_or(Errno(libc::ENOMEM)))
}

/// Nothing has to be written back from a copy, so only its address is checked.
pub(super) fn msync(library: &Library, block: Block<'_>) -> Result<(), Errno> {
    if library.heap().is_process() {
        return system::sync(block.doubleword(0), block.word(1), block.int(2));
    }
    let mapped = library.heap().size_of(block.doubleword(0));
    mapped.map(|_| ()).ok_or(Errno(libc::ENOMEM))
}

/// The system's own calls. The guest may change its process's mappings as the process may.
mod system {
    use std::ptr;

    use libc::c_void;

    use super::super::super::errno::check;
    use super::{Errno, MAP_ANONYMOUS, MAP_FIXED, MAP_PRIVATE, MAP_SHARED, MREMAP_MAYMOVE};

    /// The flags whose values are the same on all architectures.
    const FLAGS: u32 = MAP_SHARED | MAP_PRIVATE | MAP_FIXED | MAP_ANONYMOUS;

    fn pointer(ea: u64) -> *mut c_void {
        ptr::with_exposed_provenance_mut(ea as usize)
    }

    fn mapped(at: *mut c_void) -> Result<u64, Errno> {
        if at == libc::MAP_FAILED {
            return Err(Errno::last());
        }
        Ok(at.expose_provenance() as u64)
    }

    pub fn map(
        ea: u64,
        length: u32,
        protection: u32,
        flags: u32,
        descriptor: i32,
        offset: i32,
    ) -> Result<u64, Errno> {
        let (protection, flags) = (protection as i32, (flags & FLAGS) as i32);
        // SAFETY: the guest is part of the process and vouches for a fixed address.
        mapped(unsafe {
            libc::mmap(pointer(ea), length as usize, protection, flags, descriptor, offset.into())
        })
    }

    pub fn unmap(ea: u64, length: u32) -> Result<(), Errno> {
        // SAFETY: the guest is part of the process and vouches for the range.
        check(unsafe { libc::munmap(pointer(ea), length as usize) }).map(|_| ())
    }

    pub fn remap(ea: u64, before: u32, after: u32, flags: u32) -> Result<u64, Errno> {
        let flags = (flags & MREMAP_MAYMOVE) as i32;
        // SAFETY: the guest is part of the process and vouches for the range.
        mapped(unsafe { libc::mremap(pointer(ea), before as usize, after as usize, flags) })
    }

    pub fn sync(ea: u64, length: u32, flags: i32) -> Result<(), Errno> {
        // SAFETY: `msync` changes no memory.
        check(unsafe { libc::msync(pointer(ea), length as usize, flags) }).map(|_| ())
    }
}
