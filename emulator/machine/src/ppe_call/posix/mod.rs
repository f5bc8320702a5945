//! Class 0x2101: POSIX.1.
//!
//! Structures in local store consist of 32-bit fields. As with libspe2, values that don't fit lose
//! their upper bits. Shared memory, which libspe2 does not serve either, and `adjtimex`, because
//! the clock belongs to the host, fail with `ENOSYS`. A guest can send signals only to its own
//! process.

mod descriptors;
mod directories;
mod mapping;
mod paths;
mod process;

pub(super) use directories::Directories;

use super::guest::{Block, Reply};
use super::{Call, Errno, calls};

pub(super) const CALLS: &[Call] = calls! {
    adjtimex => |_, _| not_served(),
    close => |_, block| descriptors::close(block).into(),
    creat => |_, block| paths::creat(block).into(),
    fstat => |_, block| paths::fstat(block).into(),
    ftok => |_, block| paths::ftok(block).into(),
    getpagesize => |_, _| process::page_size().into(),
    gettimeofday => |_, block| process::gettimeofday(block).into(),
    kill => |_, block| process::kill(block).into(),
    lseek => |_, block| descriptors::lseek(block).into(),
    lstat => |_, block| paths::lstat(block).into(),
    mmap => |library, block| mapping::mmap(library, block),
    mremap => |library, block| mapping::mremap(library, block),
    msync => |library, block| mapping::msync(library, block).into(),
    munmap => |library, block| mapping::munmap(library, block).into(),
    open => |_, block| paths::open(block).into(),
    read => |library, block| descriptors::read(library, block).into(),
    shmat => |_, _| not_served(),
    shmctl => |_, _| not_served(),
    shmdt => |_, _| not_served(),
    shmget => |_, _| not_served(),
    shm_open => |_, _| not_served(),
    shm_unlink => |_, _| not_served(),
    stat => |_, block| paths::stat(block).into(),
    unlink => |_, block| paths::unlink(block).into(),
    wait => |_, block| process::wait(block, -1, block.word(0), 0).into(),
    waitpid => |_, block| process::wait(block, block.int(0), block.word(1), block.int(2)).into(),
    write => |library, block| descriptors::write(library, block).into(),
    ftruncate => |_, block| descriptors::ftruncate(block).into(),
    access => |_, block| paths::access(block).into(),
    dup => |_, block| descriptors::dup(block).into(),
    time => |_, block| process::time(block).into(),
    nanosleep => |_, block| process::nanosleep(block).into(),
    chdir => |_, block| paths::chdir(block).into(),
    fchdir => |_, block| descriptors::fchdir(block).into(),
    mkdir => |_, block| paths::mkdir(block).into(),
    mknod => |_, block| paths::mknod(block).into(),
    rmdir => |_, block| paths::rmdir(block).into(),
    chmod => |_, block| paths::chmod(block).into(),
    fchmod => |_, block| descriptors::fchmod(block).into(),
    chown => |_, block| paths::chown(block).into(),
    fchown => |_, block| descriptors::fchown(block).into(),
    lchown => |_, block| paths::lchown(block).into(),
    getcwd => |_, block| paths::getcwd(block),
    link => |_, block| paths::link(block).into(),
    symlink => |_, block| paths::symlink(block).into(),
    readlink => |_, block| paths::readlink(block).into(),
    sync => |_, _| descriptors::sync(),
    fsync => |_, block| descriptors::fsync(block).into(),
    fdatasync => |_, block| descriptors::fdatasync(block).into(),
    dup2 => |_, block| descriptors::dup2(block).into(),
    lockf => |_, block| descriptors::lockf(block).into(),
    truncate => |_, block| paths::truncate(block).into(),
    mkstemp => |_, block| paths::mkstemp(block).into(),
    mktemp => |_, block| paths::mktemp(block),
    opendir => |library, block| directories::opendir(library, block),
    closedir => |library, block| library.directories().close(block.doubleword(0)).into(),
    readdir => |library, block| directories::readdir(library, block),
    rewinddir => |library, block| library.directories().rewind(block.doubleword(0)).into(),
    seekdir => |library, block| library.directories().seek(block.doubleword(0), block.word(1)).into(),
    telldir => |library, block| library.directories().position(block.doubleword(0)).into(),
    // The kernel yields by itself.
    sched_yield => |_, _| 0.into(),
    umask => |_, block| process::umask(block).into(),
    utime => |_, block| paths::utime(block).into(),
    utimes => |_, block| paths::utimes(block).into(),
    pread => |_, block| descriptors::pread(block).into(),
    pwrite => |_, block| descriptors::pwrite(block).into(),
    readv => |library, block| descriptors::readv(library, block).into(),
    writev => |library, block| descriptors::writev(library, block).into(),
};

fn not_served() -> Reply {
    Err::<i32, _>(Errno(libc::ENOSYS)).into()
}

/// The result of a call that moves bytes.
fn moved(count: usize) -> Result<i32, Errno> {
    i32::try_from(count).map_err(|_| Errno(libc::EOVERFLOW))
}

/// The two words of a time structure: seconds, and a fraction.
fn time_at(block: Block<'_>, address: u32) -> (i32, i32) {
    let word = |n: u32| block.guest.word(address.wrapping_add(4 * n)) as i32;
    (word(0), word(1))
}
