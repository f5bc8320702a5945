//! WAD files: a header, lumps of data, and a directory with the lumps' names.

use std::fmt;
use std::fs::File;
use std::io::Read as _;
use std::ops::Range;
use std::path::Path;

use zerocopy::little_endian::U32;
use zerocopy::{FromBytes, Immutable, KnownLayout, Unaligned};

use crate::{Error, Fault};

/// The size in bytes of the largest file that is read.
pub(crate) const MAX_FILE: u64 = 1 << 30;

/// The name of a lump or a texture: up to eight letters, in capitals.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Name([u8; 8]);

impl Name {
    /// A name as a file has it: it ends at the first zero.
    #[must_use]
    pub fn of(bytes: [u8; 8]) -> Self {
        let end = bytes.iter().position(|byte| *byte == 0).unwrap_or(8);
        let letter = |at: usize| if at < end { bytes[at].to_ascii_uppercase() } else { 0 };
        Self(std::array::from_fn(letter))
    }

    /// A name as a program or a user writes it; longer ones are cut off.
    #[must_use]
    pub fn new(text: &str) -> Self {
        Self::of(std::array::from_fn(|at| text.as_bytes().get(at).copied().unwrap_or(0)))
    }

    /// The name's letters.
    fn letters(&self) -> &[u8] {
        self.0.split(|byte| *byte == 0).next().unwrap_or_default()
    }

    /// Whether it is the name that stands for no texture.
    #[must_use]
    pub fn is_nothing(&self) -> bool {
        matches!(self.letters(), b"" | b"-")
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.letters().escape_ascii().to_string())
    }
}

impl fmt::Debug for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}")
    }
}

#[derive(FromBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
struct Header {
    mark: [u8; 4],
    count: U32,
    directory: U32,
}

#[derive(FromBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
struct Entry {
    start: U32,
    length: U32,
    name: [u8; 8],
}

/// A WAD file in memory. Of lumps with the same name, the last one counts.
pub struct Wad {
    file: String,
    bytes: Vec<u8>,
    lumps: Vec<(Name, Range<usize>)>,
}

impl Wad {
    /// Reads a file.
    ///
    /// # Errors
    /// The file can't be read, is too large, or is no WAD file.
    pub fn open(path: &Path) -> Result<Self, Error> {
        let file = path.display().to_string();
        let read = || -> Result<Vec<u8>, Fault> {
            let mut bytes = Vec::new();
            // A device or a pipe has no size, and may have no end.
            File::open(path)?.take(MAX_FILE + 1).read_to_end(&mut bytes)?;
            match bytes.len() as u64 {
                size if size > MAX_FILE => Err(Fault::TooLarge { size }),
                _ => Ok(bytes),
            }
        };
        match read() {
            Ok(bytes) => Self::parse(&file, bytes),
            Err(fault) => Err(Error { file, fault }),
        }
    }

    /// Takes the bytes of a file; errors name it.
    ///
    /// # Errors
    /// It is no WAD file, or its directory or one of its lumps is not within it.
    pub fn parse(file: &str, bytes: Vec<u8>) -> Result<Self, Error> {
        let file = file.to_owned();
        match directory(&bytes) {
            Ok(lumps) => Ok(Self { file, bytes, lumps }),
            Err(fault) => Err(Error { file, fault }),
        }
    }

    /// The maps' names, in the file's order.
    #[must_use]
    pub fn maps(&self) -> Vec<Name> {
        let follows = |pair: &[(Name, Range<usize>)]| {
            pair[1].0 == Name::new("THINGS") || pair[1].0 == Name::new("TEXTMAP")
        };
        self.lumps.windows(2).filter(|pair| follows(pair)).map(|pair| pair[0].0).collect()
    }

    /// An error of this file.
    pub(crate) fn wrong(&self, fault: Fault) -> Error {
        Error { file: self.file.clone(), fault }
    }

    /// An error of a lump of this file.
    pub(crate) fn wrong_lump(&self, lump: impl fmt::Display, what: String) -> Error {
        self.wrong(Fault::Lump { lump: lump.to_string(), what })
    }

    /// The last lump of this name.
    pub(crate) fn lump(&self, name: Name) -> Option<&[u8]> {
        self.last(&self.lumps, name)
    }

    /// The last lump of this name between two markers, or anywhere if the file lacks the markers.
    pub(crate) fn lump_between(&self, name: Name, markers: [&str; 2]) -> Option<&[u8]> {
        let [start, end] = markers.map(|marker| {
            let is_it = |(name, _): &(Name, Range<usize>)| *name == Name::new(marker);
            self.lumps.iter().position(is_it)
        });
        match (start, end) {
            (Some(start), Some(end)) if start < end => self.last(&self.lumps[start..end], name),
            _ => self.lump(name),
        }
    }

    fn last(&self, among: &[(Name, Range<usize>)], name: Name) -> Option<&[u8]> {
        let found = among.iter().rev().find(|lump| lump.0 == name && !lump.1.is_empty());
        found.map(|lump| &self.bytes[lump.1.clone()])
    }

    /// The lumps that follow a map's marker.
    pub(crate) fn after(&self, map: Name) -> Option<impl Iterator<Item = (Name, &[u8])>> {
        self.maps().contains(&map).then(|| {
            let at = self.lumps.iter().rposition(|lump| lump.0 == map).unwrap_or_default();
            self.lumps[at + 1..].iter().map(|lump| (lump.0, &self.bytes[lump.1.clone()]))
        })
    }
}

/// The lumps of a file by its directory.
fn directory(bytes: &[u8]) -> Result<Vec<(Name, Range<usize>)>, Fault> {
    let size = bytes.len();
    let is_wad = |header: &Header| matches!(&header.mark, b"IWAD" | b"PWAD");
    let Some((header, _)) = Header::ref_from_prefix(bytes).ok().filter(|(it, _)| is_wad(it)) else {
        return Err(Fault::NoWad(bytes[..size.min(4)].escape_ascii().to_string()));
    };
    let (count, start) = (header.count.get(), header.directory.get());
    let entries = bytes
        .get(start as usize..)
        .and_then(|rest| <[Entry]>::ref_from_prefix_with_elems(rest, count as usize).ok());
    let Some((entries, _)) = entries else {
        return Err(Fault::Directory { count, start, size });
    };
    let lump = |(number, entry): (usize, &Entry)| {
        let (start, length) = (entry.start.get(), entry.length.get());
        let name = Name::of(entry.name);
        let end = (start as usize).checked_add(length as usize);
        match end {
            // Markers have no bytes, and files give them any place.
            _ if length == 0 => Ok((name, 0..0)),
            Some(end) if end <= size => Ok((name, start as usize..end)),
            _ => Err(Fault::Outside { number, name, length, start, size }),
        }
    };
    entries.iter().enumerate().map(lump).collect()
}
