//! Which bytes of this process have several addresses: those of mappings that are shared.
//!
//! From Linux 6.11 on, the kernel is asked about each address. Older kernels, and QEMU's
//! user emulation, only have a text of all mappings, which takes a hundred times as long. So it is
//! kept for some milliseconds, and a program that unmaps a page and maps another one there in
//! less time may have a reservation on it that a write by another address does not end.
//!
//! Private mappings of a file count as having one address, although they show what others write to
//! it until they are written themselves.

use std::fs::{self, File};
use std::mem::MaybeUninit;
use std::os::fd::AsRawFd;
use std::sync::{Mutex, OnceLock, PoisonError};
use std::time::{Duration, Instant};

use spu_emulator::memory::Place;

/// How long the text of all mappings is kept.
const KEPT: Duration = Duration::from_millis(10);

const MAPS: &str = "/proc/self/maps";

/// Where the byte at this address is, if it is in a shared mapping.
pub(crate) fn place(ea: u64) -> Option<Place> {
    match Query::of(ea) {
        Ok(mapping) => mapping?.place(ea),
        Err(NoQuery) => Text::place(ea),
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Mapping {
    start: u64,
    end: u64,
    /// That of the first byte.
    place: Place,
}

impl Mapping {
    fn place(&self, ea: u64) -> Option<Place> {
        (self.start..self.end)
            .contains(&ea)
            .then(|| Place { offset: self.place.offset + (ea - self.start), ..self.place })
    }
}

/// The kernel can't be asked about an address.
struct NoQuery;

/// `struct procmap_query` of Linux.
#[repr(C)]
struct Query {
    size: u64,
    flags: u64,
    address: u64,
    start: u64,
    end: u64,
    mapping_flags: u64,
    page_size: u64,
    offset: u64,
    inode: u64,
    major: u32,
    minor: u32,
    name_size: u32,
    build_id_size: u32,
    name_address: u64,
    build_id_address: u64,
}

impl Query {
    /// The shared mapping that has this address.
    fn of(ea: u64) -> Result<Option<Mapping>, NoQuery> {
        const SHARED: u64 = 8;
        static FILE: OnceLock<Option<File>> = OnceLock::new();
        let file = FILE.get_or_init(|| File::open(MAPS).ok());
        let file = file.as_ref().ok_or(NoQuery)?;
        // SAFETY: all zeros are a valid query.
        let mut query: Self = unsafe { MaybeUninit::zeroed().assume_init() };
        query.size = size_of::<Self>() as u64;
        query.address = ea;
        // SAFETY: the descriptor is open, and the kernel writes no more than the query's size.
        let found = unsafe { libc::ioctl(file.as_raw_fd(), REQUEST, &raw mut query) };
        if found != 0 {
            let error = std::io::Error::last_os_error();
            return match error.raw_os_error() {
                Some(libc::ENOENT) => Ok(None),
                _ => Err(NoQuery),
            };
        }
        let file = (u64::from(query.major) << 32 | u64::from(query.minor), query.inode);
        let offset = query.offset;
        let mapping = Mapping { start: query.start, end: query.end, place: Place { file, offset } };
        Ok((query.mapping_flags & SHARED != 0).then_some(mapping))
    }
}

/// `PROCMAP_QUERY`, whose argument is read and written.
const REQUEST: libc::Ioctl = {
    const READ_AND_WRITE: u32 = 3 << 30;
    (READ_AND_WRITE | (size_of::<Query>() as u32) << 16 | (b'f' as u32) << 8 | 17) as libc::Ioctl
};

/// The shared mappings, as the text of all mappings has them.
struct Text {
    read: Instant,
    mappings: Vec<Mapping>,
}

impl Text {
    fn place(ea: u64) -> Option<Place> {
        static LAST: Mutex<Option<Text>> = Mutex::new(None);
        let mut last = LAST.lock().unwrap_or_else(PoisonError::into_inner);
        let now = Instant::now();
        let text = match last.take() {
            Some(text) if now.duration_since(text.read) < KEPT => text,
            _ => Self { read: now, mappings: read_mappings() },
        };
        let found = text.mappings.iter().find_map(|mapping| mapping.place(ea));
        *last = Some(text);
        found
    }
}

/// The shared mappings of this process. None if the text can't be read.
fn read_mappings() -> Vec<Mapping> {
    // The names in it are those of files, which need not be UTF-8.
    let text = fs::read(MAPS).unwrap_or_default();
    let text = String::from_utf8_lossy(&text);
    text.lines().filter_map(mapping).collect()
}

/// A line such as `7f00-7f01 rw-s 00001000 00:01 42 /memfd:name (deleted)`, if it is of a shared
/// mapping.
fn mapping(line: &str) -> Option<Mapping> {
    let mut fields = line.split_ascii_whitespace();
    let (start, end) = fields.next()?.split_once('-')?;
    let is_shared = fields.next()?.ends_with('s');
    let offset = fields.next()?;
    let (major, minor) = fields.next()?.split_once(':')?;
    let inode = fields.next()?.parse().ok()?;
    let hexadecimal = |text| u64::from_str_radix(text, 16).ok();
    let file = (hexadecimal(major)? << 32 | hexadecimal(minor)?, inode);
    let mapping = Mapping {
        start: hexadecimal(start)?,
        end: hexadecimal(end)?,
        place: Place { file, offset: hexadecimal(offset)? },
    };
    is_shared.then_some(mapping)
}

#[cfg(test)]
mod tests {
    use std::os::fd::{FromRawFd, OwnedFd};
    use std::ptr;

    use super::*;

    /// A mapping that stays until the test ends.
    fn mapped(flags: i32, file: i32, offset: libc::off_t) -> u64 {
        let access = libc::PROT_READ | libc::PROT_WRITE;
        // SAFETY: a new mapping at an address that the kernel chooses overlaps nothing.
        let start = unsafe { libc::mmap(ptr::null_mut(), 8192, access, flags, file, offset) };
        assert_ne!(start, libc::MAP_FAILED);
        start.expose_provenance() as u64
    }

    fn file() -> OwnedFd {
        // SAFETY: the name is a C string. The descriptor is new, and nothing else owns it.
        unsafe {
            let raw = libc::syscall(libc::SYS_memfd_create, c"twice mapped".as_ptr(), 0) as i32;
            assert_eq!(libc::ftruncate(raw, 16384), 0);
            OwnedFd::from_raw_fd(raw)
        }
    }

    #[test]
    fn aliased_addresses_have_one_place() {
        let (one, other) = (file(), file());
        let first = mapped(libc::MAP_SHARED, one.as_raw_fd(), 0);
        let second = mapped(libc::MAP_SHARED, one.as_raw_fd(), 4096);
        let strange = mapped(libc::MAP_SHARED, other.as_raw_fd(), 0);
        let shared = mapped(libc::MAP_SHARED | libc::MAP_ANONYMOUS, -1, 0);
        let private = mapped(libc::MAP_PRIVATE | libc::MAP_ANONYMOUS, -1, 0);
        let of_file = mapped(libc::MAP_PRIVATE, one.as_raw_fd(), 0);
        // Each of the two ways to ask, of which a kernel may have only the second.
        let asked = |ea| Query::of(ea).ok().map(|found| found?.place(ea));
        for way in [place, Text::place] {
            let found = way(first + 4096 + 640).unwrap();
            assert_eq!(found.offset, 4096 + 640);
            assert_eq!(way(second + 640), Some(found));
            assert_ne!(way(second), Some(found));
            assert_ne!(way(strange + 4096 + 640), Some(found));
            assert!(way(strange).is_some() && way(shared).is_some());
            for private in [private, of_file, 0, u64::MAX] {
                assert_eq!(way(private), None, "{private:#x}");
            }
        }
        for ea in [first, second + 8191, strange, shared, private, of_file, 0] {
            assert!(asked(ea).is_none_or(|found| found == Text::place(ea)), "{ea:#x}");
        }
    }

    #[test]
    fn lines_of_the_text() {
        let line = "7f12000-7f14000 rw-s 00003000 fd:10 42    /tmp/a b-c (deleted)";
        let found = mapping(line).unwrap();
        assert_eq!((found.start, found.end), (0x7f1_2000, 0x7f1_4000));
        let place = found.place(0x7f1_3008).unwrap();
        assert_eq!(place.file, (0xfd_0000_0010, 42));
        assert_eq!(place.offset, 0x4008);
        assert_eq!(found.place(0x7f1_4000), None);
        for other in ["7f12000-7f14000 rw-p 00003000 fd:10 42", "", "1-2 rw-s", "x-y s 0 0:0 1"] {
            assert_eq!(mapping(other), None, "{other}");
        }
    }
}
