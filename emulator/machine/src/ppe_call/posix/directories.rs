//! Directory streams.
//!
//! A directory is read when it is opened or rewound. A position is the number of entries before
//! it. The guest's `DIR *` is a counter's value, never a pointer of the host.

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::ffi::{OsStrExt as _, OsStringExt as _};
use std::os::unix::fs::{DirEntryExt as _, MetadataExt as _};
use std::path::{Path, PathBuf};

use super::super::guest::{Block, Reply};
use super::super::{Errno, Library};

/// Size in bytes of a name with its terminating 0 in the guest's structure.
const NAME: usize = 256;
/// The largest number of open directories, as if they were descriptors.
const MOST: usize = 1024;

struct Directory {
    path: PathBuf,
    entries: Vec<(u32, Vec<u8>)>,
    next: usize,
}

impl Directory {
    fn open(path: PathBuf) -> Result<Self, Errno> {
        let entries = entries(&path)?;
        Ok(Self { path, entries, next: 0 })
    }
}

fn entries(path: &Path) -> Result<Vec<(u32, Vec<u8>)>, Errno> {
    let mut entries = Vec::new();
    for itself in [".", ".."] {
        let number = fs::metadata(path.join(itself))?.ino();
        entries.push((number as u32, itself.as_bytes().to_vec()));
    }
    for entry in fs::read_dir(path)? {
        let entry = entry?;
        entries.push((entry.ino() as u32, entry.file_name().into_vec()));
    }
    Ok(entries)
}

/// The open directories.
#[derive(Default)]
pub(in super::super) struct Directories {
    open: BTreeMap<u64, Directory>,
    last: u64,
}

impl Directories {
    fn find(&mut self, handle: u64) -> Result<&mut Directory, Errno> {
        self.open.get_mut(&handle).ok_or(Errno(libc::EBADF))
    }

    pub(super) fn close(&mut self, handle: u64) -> Result<(), Errno> {
        let closed = self.open.remove(&handle);
        closed.map(|_| ()).ok_or(Errno(libc::EBADF))
    }

    pub(super) fn rewind(&mut self, handle: u64) -> Result<(), Errno> {
        let directory = self.find(handle)?;
        directory.entries = entries(&directory.path)?;
        directory.next = 0;
        Ok(())
    }

    pub(super) fn seek(&mut self, handle: u64, position: u32) -> Result<(), Errno> {
        let directory = self.find(handle)?;
        directory.next = (position as usize).min(directory.entries.len());
        Ok(())
    }

    pub(super) fn position(&mut self, handle: u64) -> Result<i32, Errno> {
        Ok(self.find(handle)?.next as i32)
    }
}

pub(super) fn opendir(library: &Library, block: Block<'_>) -> Reply {
    let mut directories = library.directories();
    if directories.open.len() >= MOST {
        return Reply::Doubleword(0, libc::EMFILE);
    }
    let path = std::ffi::OsStr::from_bytes(&block.string(0)).into();
    match Directory::open(path) {
        Ok(directory) => {
            let handle = directories.last + 1;
            directories.last = handle;
            directories.open.insert(handle, directory);
            Reply::Doubleword(handle, 0)
        }
        Err(errno) => Reply::Doubleword(0, errno.0),
    }
}

/// Writes the number and the name of the next entry, with a terminating 0, to the structure of
/// cell 1.
pub(super) fn readdir(library: &Library, block: Block<'_>) -> Reply {
    let mut directories = library.directories();
    let directory = match directories.find(block.doubleword(0)) {
        Ok(directory) => directory,
        Err(errno) => return Reply::Word(0, errno.0),
    };
    let Some((number, name)) = directory.entries.get(directory.next) else {
        return Reply::Word(0, 0);
    };
    directory.next += 1;
    let address = block.word(1);
    block.guest.set_word(address, *number);
    let name = &name[..name.len().min(NAME - 1)];
    block.guest.set_string(address.wrapping_add(4), name);
    Reply::Word(address, 0)
}
