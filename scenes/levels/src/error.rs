//! The errors of WAD files.

use std::io;

use thiserror::Error;

use crate::Name;
use crate::wad::MAX_FILE;

/// Why a level can't be read. The message begins with the file.
#[derive(Debug, Error)]
#[error("{file}: {fault}")]
pub struct Error {
    /// The file.
    pub file: String,
    /// The fault.
    pub fault: Fault,
}

/// A fault of a WAD file.
#[derive(Debug, Error)]
pub enum Fault {
    /// The file could not be opened or read.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The file is too large.
    #[error("the file has {size} bytes or more; the most is {MAX_FILE}")]
    TooLarge {
        /// Bytes, as far as they were counted.
        size: u64,
    },
    /// The file does not begin as a WAD file does.
    #[error("this is no WAD file: it begins with \"{0}\" instead of IWAD or PWAD")]
    NoWad(String),
    /// The directory is not within the file.
    #[error(
        "the directory has {count} lumps from byte {start} on, but the file has only {size} bytes"
    )]
    Directory {
        /// The number of lumps in the header.
        count: u32,
        /// The directory's place in the header.
        start: u32,
        /// Bytes of the file.
        size: usize,
    },
    /// A lump is not within the file.
    #[error(
        "lump {number}, {name}, has {length} bytes from byte {start} on, but the file has only {size} bytes"
    )]
    Outside {
        /// The lump's place in the directory, from 0.
        number: usize,
        /// The lump's name.
        name: Name,
        /// Its bytes by the directory.
        length: u32,
        /// Its beginning by the directory.
        start: u32,
        /// Bytes of the file.
        size: usize,
    },
    /// The file has no map of this name.
    #[error("there is no map {wanted}; {known}")]
    NoMap {
        /// The name that was asked for.
        wanted: String,
        /// The maps that there are, as a sentence.
        known: String,
    },
    /// A map is in another format.
    #[error("map {map} is in {format}, which is not read; only Doom's own format is")]
    Format {
        /// The map.
        map: Name,
        /// The format.
        format: &'static str,
    },
    /// Something in a lump is wrong.
    #[error("lump {lump}: {what}")]
    Lump {
        /// The lump, after the map's name if it is a map's.
        lump: String,
        /// The fault.
        what: String,
    },
}
