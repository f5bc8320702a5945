//! The directories of contexts and gangs, and the files of a context.

use std::ffi::{CStr, CString};
use std::fs::File;
use std::io::{self, Read, Write};
use std::os::fd::{AsFd, AsRawFd, BorrowedFd, FromRawFd, OwnedFd, RawFd};
use std::sync::OnceLock;

use libc::{c_int, c_uint};

use super::calls;
use crate::error::Errno;

/// The directory of a context or a gang, which exists as long as this value.
pub(super) struct Directory {
    descriptor: OwnedFd,
    path: String,
}

impl Directory {
    /// Creates a directory and what it stands for. A refusal goes to standard error.
    pub(super) fn create(
        path: String,
        flags: c_uint,
        neighbor: Option<RawFd>,
    ) -> Result<Self, Errno> {
        let name = CString::new(path.as_str()).map_err(|_| Errno(libc::EINVAL))?;
        match calls::create(&name, flags, neighbor) {
            Ok(descriptor) => Ok(Self { descriptor, path }),
            Err(error) => {
                messages::print!("libspe2: spu_create {path}: {error}");
                Err(refusal(&error))
            }
        }
    }

    pub(super) fn path(&self) -> &str {
        &self.path
    }

    pub(super) fn descriptor(&self) -> BorrowedFd<'_> {
        self.descriptor.as_fd()
    }

    pub(super) fn open(&self, name: &CStr, flags: c_int) -> io::Result<File> {
        let directory = self.descriptor.as_raw_fd();
        // SAFETY: the descriptor is open, and the name is a C string.
        let raw = unsafe { libc::openat(directory, name.as_ptr(), flags | libc::O_CLOEXEC) };
        if raw < 0 {
            return Err(io::Error::last_os_error());
        }
        // SAFETY: the descriptor was just created, and nothing else owns it.
        Ok(unsafe { File::from_raw_fd(raw) })
    }
}

/// What the library reports if the kernel refuses to create a context.
fn refusal(error: &io::Error) -> Errno {
    const PASSED_ON: [c_int; 6] =
        [libc::ENOTSUP, libc::EEXIST, libc::EINVAL, libc::EBUSY, libc::ENODEV, libc::EPERM];
    let errno = error.raw_os_error().filter(|errno| PASSED_ON.contains(errno));
    Errno(errno.unwrap_or(libc::EFAULT))
}

/// A file of words, which is opened when it is first used.
pub(super) struct Words {
    name: &'static CStr,
    flags: c_int,
    file: OnceLock<File>,
}

impl Words {
    pub(super) const fn new(name: &'static CStr, flags: c_int) -> Self {
        Self { name, flags, file: OnceLock::new() }
    }

    pub(super) fn file(&self, directory: &Directory) -> io::Result<&File> {
        if let Some(file) = self.file.get() {
            return Ok(file);
        }
        let opened = directory.open(self.name, self.flags)?;
        Ok(self.file.get_or_init(|| opened))
    }

    /// Reads a word. Returns `None` if there is none and the file does not wait for one.
    pub(super) fn read(&self, directory: &Directory) -> io::Result<Option<u32>> {
        let mut bytes = [0; 4];
        let mut file = self.file(directory)?;
        let read = self.moved(|| file.read(&mut bytes));
        Ok(whole(read)?.then(|| u32::from_be_bytes(bytes)))
    }

    /// Whether a word can be read at once.
    pub(super) fn is_readable(&self, directory: &Directory) -> io::Result<bool> {
        let fd = self.file(directory)?.as_raw_fd();
        let mut poll = libc::pollfd { fd, events: libc::POLLIN, revents: 0 };
        // SAFETY: the structure is valid, and there is one.
        match self.moved(|| match unsafe { libc::poll(&raw mut poll, 1, 0) } {
            -1 => Err(io::Error::last_os_error()),
            ready => Ok(ready as usize),
        })? {
            0 => Ok(false),
            _ => Ok(poll.revents & libc::POLLIN != 0),
        }
    }

    /// Writes a word. Returns `false` if the mailbox is full and the file does not wait.
    pub(super) fn write(&self, directory: &Directory, word: u32) -> io::Result<bool> {
        let bytes = word.to_be_bytes();
        let mut file = self.file(directory)?;
        whole(self.moved(|| file.write(&bytes)))
    }

    /// Reads or writes, and again if a signal ends the call of a file that does not wait: the
    /// kernel does that, whatever the signal's flags, while it moves the context to or from an SPE.
    fn moved(&self, mut call: impl FnMut() -> io::Result<usize>) -> io::Result<usize> {
        let may_wait = matches!(self.name.to_bytes(), b"ibox" | b"wbox" | b"mfc")
            && self.flags & libc::O_NONBLOCK == 0;
        loop {
            match call() {
                Err(error) if error.kind() == io::ErrorKind::Interrupted && !may_wait => {}
                moved => return moved,
            }
        }
    }
}

/// Whether a word was moved.
fn whole(moved: io::Result<usize>) -> io::Result<bool> {
    match moved {
        Ok(4) => Ok(true),
        Ok(_) => Err(io::ErrorKind::UnexpectedEof.into()),
        Err(error) if error.kind() == io::ErrorKind::WouldBlock => Ok(false),
        Err(error) => Err(error),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kernel_errors_are_mapped() {
        let refused = |errno| refusal(&io::Error::from_raw_os_error(errno));
        for errno in [libc::EEXIST, libc::ENODEV, libc::EPERM, libc::EBUSY] {
            assert_eq!(refused(errno), Errno(errno));
        }
        for errno in [libc::EACCES, libc::ENOENT, libc::ENOSPC, libc::EMFILE] {
            assert_eq!(refused(errno), Errno(libc::EFAULT), "{errno}");
        }
    }
}
