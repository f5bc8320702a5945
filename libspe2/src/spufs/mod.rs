//! Contexts on real SPEs, by the kernel's spufs: the system calls `spu_create` and `spu_run`, and
//! the files of a context's directory, as spufs(7) describes them.
//!
//! spufs exists on PowerPC only, so the words in its files are big-endian here, too.

mod calls;
mod context;
mod directory;
mod epoll;
mod mapping;
mod mfc;
pub(crate) mod processor;
mod run;

use std::fs;
use std::io;

use crate::error::Errno;

pub(crate) use context::{Gang, Spufs};
pub(crate) use epoll::Epoll;

/// Where spufs is mounted, by convention.
const ROOT: &str = "/spu";

/// Whether spufs is mounted and the kernel has its system calls.
pub(crate) fn is_there() -> bool {
    let mounts = fs::read_to_string("/proc/self/mounts");
    mounts.is_ok_and(|mounts| is_mounted(&mounts)) && calls::are_there()
}

/// Whether a table of mounts has spufs in its place.
fn is_mounted(mounts: &str) -> bool {
    mounts.lines().any(|line| {
        let mut fields = line.split(' ').skip(1);
        fields.next() == Some(ROOT) && fields.next() == Some("spufs")
    })
}

/// Fails if the kernel does not have the system calls.
pub(crate) fn check() -> Result<(), Errno> {
    if calls::are_there() {
        return Ok(());
    }
    messages::print!(
        "libspe2: LIBSPE2_BACKEND=spufs: this kernel has no SPEs (spu_run: {})",
        io::Error::from_raw_os_error(libc::ENOSYS)
    );
    Err(Errno(libc::ENOSYS))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spufs_is_found_among_mounts() {
        let with = "proc /proc proc rw 0 0\nnone /spu spufs rw,gid=1001 0 0\n";
        assert!(is_mounted(with));
        for without in ["", "none /spu tmpfs rw 0 0\n", "none /mnt/spu spufs rw 0 0"] {
            assert!(!is_mounted(without), "{without:?}");
        }
    }
}
