//! Calls that name files.

use std::ffi::CString;
use std::mem::MaybeUninit;

use super::super::Errno;
use super::super::cpuinfo;
use super::super::errno::check;
use super::super::guest::{Block, Reply};
use super::super::stream::c_path;
use super::{moved, time_at};
use crate::local_store::SIZE;

/// The guest's `open` flags are Linux's access mode and the bits from `O_CREAT` to `O_ASYNC`. The
/// higher bits differ between architectures.
const OPEN_FLAGS: i32 = 0o3 | 0o37700;

fn path(block: Block<'_>, cell: u32) -> Result<CString, Errno> {
    c_path(block.string(cell))
}

pub(super) fn open(block: Block<'_>) -> Result<i32, Errno> {
    let (path, flags, mode) = (path(block, 0)?, block.int(1), block.word(2));
    if flags & !OPEN_FLAGS != 0 {
        return Err(Errno(libc::EINVAL));
    }
    cpuinfo::open(&path, flags, mode)
}

/// Functions of the C library on the path of cell 0, with these further arguments.
macro_rules! on_path {
    ($($name:ident($block:ident $(, $argument:expr)*);)*) => {$(
        pub(super) fn $name($block: Block<'_>) -> Result<i32, Errno> {
            let path = path($block, 0)?;
            // SAFETY: the path ends in 0.
            check(unsafe { libc::$name(path.as_ptr() $(, $argument)*) })
        }
    )*};
}

on_path! {
    creat(block, block.word(1));
    unlink(block);
    access(block, block.int(1));
    chdir(block);
    mkdir(block, block.word(1));
    mknod(block, block.word(1), block.word(2).into());
    rmdir(block);
    chmod(block, block.word(1));
    chown(block, block.word(1), block.word(2));
    lchown(block, block.word(1), block.word(2));
    truncate(block, block.int(1).into());
}

/// Writes a status to local store, if the call that fills it succeeds.
fn status(block: Block<'_>, fill: impl FnOnce(*mut libc::stat) -> i32) -> Result<i32, Errno> {
    let mut status = MaybeUninit::<libc::stat>::zeroed();
    check(fill(status.as_mut_ptr()))?;
    // SAFETY: zeros are a valid status, and the system has filled it.
    let status = unsafe { status.assume_init() };
    let words = [
        status.st_dev as u32,
        status.st_ino as u32,
        status.st_mode,
        status.st_nlink as u32,
        status.st_uid,
        status.st_gid,
        status.st_rdev as u32,
        status.st_size as u32,
        status.st_blksize as u32,
        status.st_blocks as u32,
        status.st_atime as u32,
        status.st_mtime as u32,
        status.st_ctime as u32,
    ];
    block.guest.set_words(block.word(1), &words);
    Ok(0)
}

pub(super) fn stat(block: Block<'_>) -> Result<i32, Errno> {
    let path = path(block, 0)?;
    // SAFETY: the path ends in 0, and the status is writable.
    status(block, |into| unsafe { libc::stat(path.as_ptr(), into) })
}

pub(super) fn lstat(block: Block<'_>) -> Result<i32, Errno> {
    let path = path(block, 0)?;
    // SAFETY: the path ends in 0, and the status is writable.
    status(block, |into| unsafe { libc::lstat(path.as_ptr(), into) })
}

pub(super) fn fstat(block: Block<'_>) -> Result<i32, Errno> {
    // SAFETY: `fstat` accepts any number, and the status is writable.
    status(block, |into| unsafe { libc::fstat(block.int(0), into) })
}

pub(super) fn ftok(block: Block<'_>) -> Result<i32, Errno> {
    let path = path(block, 0)?;
    // SAFETY: the path ends in 0.
    let key = unsafe { libc::ftok(path.as_ptr(), block.int(1)) };
    // Keys may be negative, and only -1 is an error.
    if key == -1 { Err(Errno::last()) } else { Ok(key) }
}

pub(super) fn link(block: Block<'_>) -> Result<i32, Errno> {
    let (from, to) = (path(block, 0)?, path(block, 1)?);
    // SAFETY: the paths end in 0.
    check(unsafe { libc::link(from.as_ptr(), to.as_ptr()) })
}

pub(super) fn symlink(block: Block<'_>) -> Result<i32, Errno> {
    let (from, to) = (path(block, 0)?, path(block, 1)?);
    // SAFETY: the paths end in 0.
    check(unsafe { libc::symlink(from.as_ptr(), to.as_ptr()) })
}

pub(super) fn readlink(block: Block<'_>) -> Result<i32, Errno> {
    let path = path(block, 0)?;
    let mut bytes = vec![0; block.word(2).min(SIZE) as usize];
    // SAFETY: the path ends in 0, and the buffer is valid for the number of bytes that is passed.
    let length =
        check(unsafe { libc::readlink(path.as_ptr(), bytes.as_mut_ptr().cast(), bytes.len()) })?
            as usize;
    block.guest.write(block.word(1), &bytes[..length]);
    moved(length)
}

/// Writes the working directory's path with its terminating 0, if it fits into cell 1's bytes.
pub(super) fn getcwd(block: Block<'_>) -> Reply {
    use std::os::unix::ffi::OsStrExt as _;
    let (address, size) = (block.word(0), block.word(1) as usize);
    if size == 0 {
        return Reply::Word(0, libc::EINVAL);
    }
    match std::env::current_dir() {
        Ok(path) if path.as_os_str().len() < size => {
            block.guest.set_string(address, path.as_os_str().as_bytes());
            Reply::Word(address, 0)
        }
        Ok(_) => Reply::Word(0, libc::ERANGE),
        Err(error) => Reply::Word(0, Errno::from(error).0),
    }
}

/// Makes a name from the template in cell 0, with a call that replaces the template's last
/// characters.
fn from_template(
    block: Block<'_>,
    make: impl FnOnce(*mut libc::c_char) -> Result<i32, Errno>,
) -> Result<i32, Errno> {
    let mut template = path(block, 0)?.into_bytes_with_nul();
    let made = make(template.as_mut_ptr().cast());
    block.guest.write(block.word(0), &template);
    made
}

pub(super) fn mkstemp(block: Block<'_>) -> Result<i32, Errno> {
    // SAFETY: the template ends in 0 and may be written.
    from_template(block, |template| check(unsafe { libc::mkstemp(template) }))
}

/// Returns the template's address in any case. After a failure its text is empty.
pub(super) fn mktemp(block: Block<'_>) -> Reply {
    let made = from_template(block, |template| {
        // SAFETY: the template ends in 0 and may be written.
        let found = check(unsafe { libc::mkstemp(template) });
        match found {
            // Only the name is asked for, so the file is removed again.
            Ok(descriptor) => {
                // SAFETY: the descriptor was just opened, and the name still ends in 0.
                unsafe {
                    libc::close(descriptor);
                    libc::unlink(template);
                }
                Ok(0)
            }
            Err(errno) => {
                // SAFETY: the template contains at least its terminating 0.
                unsafe { template.write(0) };
                Err(errno)
            }
        }
    });
    Reply::Word(block.word(0), made.err().map_or(0, |errno| errno.0))
}

fn set_times(block: Block<'_>, times: [(i32, i32); 2]) -> Result<i32, Errno> {
    let path = path(block, 0)?;
    let times = times.map(|(seconds, microseconds)| libc::timeval {
        tv_sec: seconds.into(),
        tv_usec: microseconds.into(),
    });
    let now = block.word(1) == 0;
    let times = if now { std::ptr::null() } else { times.as_ptr() };
    // SAFETY: the path ends in 0, and there are either no times or two.
    check(unsafe { libc::utimes(path.as_ptr(), times) })
}

pub(super) fn utime(block: Block<'_>) -> Result<i32, Errno> {
    let (access, change) = time_at(block, block.word(1));
    set_times(block, [(access, 0), (change, 0)])
}

pub(super) fn utimes(block: Block<'_>) -> Result<i32, Errno> {
    const TIME: u32 = 8;
    let times = block.word(1);
    let times = [times, times.wrapping_add(TIME)].map(|at| time_at(block, at));
    set_times(block, times)
}
