//! SPU programs: checking an ELF image, loading it, and looking up its symbols.
//!
//! The checks are those of libspe2: the file must be an SPU executable with at most one 16-byte
//! `.toe`, and the only `_EAR_` symbol is the plain one. In addition, nothing is read outside the
//! image or written outside local store.

use std::collections::BTreeMap;

use object::BigEndian;
use object::elf::{
    ELFCLASS32, ELFDATA2MSB, EM_SPU, ET_EXEC, FileHeader32, PT_LOAD, ProgramHeader32,
    RelocationType, SHN_UNDEF, SHT_NOBITS, SHT_SYMTAB, STT_FILE, STT_SECTION, SectionHeader32,
};
use object::pod::{Pod, from_bytes};
use object::read::elf::{FileHeader, ProgramHeader, Rela, SectionHeader, SectionTable, Sym};
use thiserror::Error;

use crate::local_store::{LocalStore, SIZE};

/// Size in bytes of a `.toe` entry, and of the only `.toe` that is allowed.
pub const TOE_SIZE: u32 = 16;

/// The largest length that [`file_length`] accepts, so that a damaged header can't make a caller
/// read gigabytes.
const MAX_FILE: u64 = 64 << 20;

const R_SPU_PPU32: RelocationType = RelocationType(15);
const R_SPU_PPU64: RelocationType = RelocationType(16);

/// Why an image is not an SPU program.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum ElfError {
    /// The magic number is missing.
    #[error("not an ELF file")]
    NotElf,
    /// The class, encoding, version, OS ABI or ABI version is not that of an SPU program.
    #[error("ELF identification byte {index} is {found}, but {expected} in an SPU program")]
    Identification {
        /// Index in `e_ident`.
        index: usize,
        /// The value in an SPU program.
        expected: u8,
        /// The value in this file.
        found: u8,
    },
    /// `e_machine` is not 23.
    #[error("ELF machine {0} is not the SPU (23)")]
    Machine(u16),
    /// `e_type` is not `ET_EXEC`.
    #[error("ELF type {0} is not an executable (2)")]
    Type(u16),
    /// A table or its contents are outside the image, or contradict each other.
    #[error("damaged ELF file: {0}")]
    Malformed(&'static str),
    /// A segment does not fit into local store.
    #[error("segment at {address:#x} with {size:#x} bytes does not fit into local store")]
    OutsideLocalStore {
        /// The segment's address.
        address: u32,
        /// The segment's size in local store, in bytes.
        size: u32,
    },
    /// Effective-address references that libspe2 does not support.
    #[error("effective-address references: {0}")]
    UnsupportedToe(&'static str),
}

impl From<object::read::Error> for ElfError {
    fn from(_: object::read::Error) -> Self {
        Self::Malformed("a table is outside the file")
    }
}

/// A part of the image that is copied to local store.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Segment<'data> {
    /// Local-store address.
    pub address: u32,
    /// The bytes that the file contains.
    pub bytes: &'data [u8],
    /// Size in local store, in bytes. Those after `bytes` are 0.
    pub memory_size: u32,
}

/// A word or doubleword that the loader fills with an address in the image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct ImageReference {
    address: u32,
    wide: bool,
    offset: i32,
}

/// An SPU program that has passed the checks.
#[derive(Clone, Debug)]
pub struct Image<'data> {
    segments: Vec<Segment<'data>>,
    entry: u32,
    toe: Option<u32>,
    references: Vec<ImageReference>,
    by_name: BTreeMap<&'data str, u32>,
    by_address: BTreeMap<u32, &'data str>,
}

type Header = FileHeader32<BigEndian>;

fn check_header(bytes: &[u8]) -> Result<&Header, ElfError> {
    const MAGIC: &[u8] = b"\x7fELF";
    /// Class, encoding, version, OS ABI, ABI version.
    const IDENTIFICATION: [u8; 5] = [ELFCLASS32.0, ELFDATA2MSB.0, 1, 0, 0];
    let identification = bytes.strip_prefix(MAGIC).ok_or(ElfError::NotElf)?;
    for (index, (&found, expected)) in identification.iter().zip(IDENTIFICATION).enumerate() {
        if found != expected {
            return Err(ElfError::Identification { index: index + MAGIC.len(), expected, found });
        }
    }
    let (header, _) = from_bytes::<Header>(bytes)
        .map_err(|()| ElfError::Malformed("the header is incomplete"))?;
    if header.e_machine(BigEndian) != EM_SPU {
        return Err(ElfError::Machine(header.e_machine(BigEndian).0));
    }
    if header.e_type(BigEndian) != ET_EXEC {
        return Err(ElfError::Type(header.e_type(BigEndian).0));
    }
    Ok(header)
}

impl<'data> Image<'data> {
    /// Checks an image, and returns the program.
    pub fn parse(data: &'data [u8]) -> Result<Self, ElfError> {
        let header = check_header(data)?;
        let segments = segments(header, data)?;
        let sections = header.sections(BigEndian, data)?;
        let (by_name, by_address) = symbols(&sections, data)?;
        if by_name.keys().any(|name| name.starts_with("_EAR_") && name.len() > 5) {
            return Err(ElfError::UnsupportedToe("only the symbol _EAR_ itself is supported"));
        }
        Ok(Self {
            segments,
            entry: header.e_entry(BigEndian),
            toe: toe(&sections)?,
            references: references(&sections, data)?,
            by_name,
            by_address,
        })
    }

    /// The address at which the program starts.
    #[must_use]
    pub fn entry(&self) -> u32 {
        self.entry
    }

    /// The segments to load, in the file's order.
    #[must_use]
    pub fn segments(&self) -> &[Segment<'data>] {
        &self.segments
    }

    /// The local-store address of the 16-byte `.toe` section, if there is one.
    #[must_use]
    pub fn toe(&self) -> Option<u32> {
        self.toe
    }

    /// Copies the program into local store and leaves all other bytes as they are. `image_ea` is
    /// the effective address of the image. The program's references to addresses in the image are
    /// set from it.
    pub fn load(&self, store: &LocalStore, image_ea: u64) {
        self.load_with(image_ea, |address, bytes| store.write(address, bytes));
    }

    /// As [`load`](Self::load), into a local store that `write` writes to.
    pub fn load_with(&self, image_ea: u64, mut write: impl FnMut(u32, &[u8])) {
        for segment in &self.segments {
            write(segment.address, segment.bytes);
            let in_file = segment.bytes.len() as u32;
            let zeros = vec![0; (segment.memory_size - in_file) as usize];
            write(segment.address + in_file, &zeros);
        }
        for reference in &self.references {
            let ea = image_ea.wrapping_add_signed(i64::from(reference.offset));
            if reference.wide {
                write(reference.address, &ea.to_be_bytes());
            } else {
                write(reference.address, &(ea as u32).to_be_bytes());
            }
        }
    }

    /// A symbol's value, if the program has the symbol.
    #[must_use]
    pub fn symbol(&self, name: &str) -> Option<u32> {
        self.by_name.get(name).copied()
    }

    /// The names and values of all symbols.
    pub fn symbols(&self) -> impl Iterator<Item = (u32, &'data str)> {
        self.by_name.iter().map(|(&name, &value)| (value, name))
    }

    /// The last symbol at or before `address`, and the distance from it in bytes.
    #[must_use]
    pub fn nearest_symbol(&self, address: u32) -> Option<(&'data str, u32)> {
        let (&at, &name) = self.by_address.range(..=address).next_back()?;
        Some((name, address - at))
    }

    /// `0x00104 <main+0x10>`: an address with its nearest symbol.
    #[must_use]
    pub fn place(&self, address: u32) -> String {
        let name = match self.nearest_symbol(address) {
            Some((name, 0)) => format!(" <{name}>"),
            Some((name, distance)) => format!(" <{name}+{distance:#x}>"),
            None => String::new(),
        };
        format!("{address:#07x}{name}")
    }
}

fn segments<'data>(header: &Header, data: &'data [u8]) -> Result<Vec<Segment<'data>>, ElfError> {
    let mut segments: Vec<Segment<'data>> = Vec::new();
    for program_header in header.program_headers(BigEndian, data)? {
        if program_header.p_type(BigEndian) != PT_LOAD {
            continue;
        }
        let address = program_header.p_vaddr(BigEndian);
        let memory_size = program_header.p_memsz(BigEndian);
        // This is an overlay, which the program itself loads later.
        if let Some(before) = segments.last()
            && (before.address..before.address + before.memory_size).contains(&address)
        {
            continue;
        }
        let bytes = program_header
            .data(BigEndian, data)
            .map_err(|()| ElfError::Malformed("a segment is outside the file"))?;
        if bytes.len() as u64 > u64::from(memory_size) {
            return Err(ElfError::Malformed("a segment has more bytes in the file than in memory"));
        }
        if u64::from(address) + u64::from(memory_size) > u64::from(SIZE) {
            return Err(ElfError::OutsideLocalStore { address, size: memory_size });
        }
        segments.push(Segment { address, bytes, memory_size });
    }
    if segments.is_empty() {
        return Err(ElfError::Malformed("no segment can be loaded"));
    }
    Ok(segments)
}

type Symbols<'data> = (BTreeMap<&'data str, u32>, BTreeMap<u32, &'data str>);

fn symbols<'data>(
    sections: &SectionTable<'data, Header>,
    data: &'data [u8],
) -> Result<Symbols<'data>, ElfError> {
    let table = sections.symbols(BigEndian, data, SHT_SYMTAB)?;
    let mut by_name = BTreeMap::new();
    let mut by_address = BTreeMap::new();
    for symbol in table.iter() {
        if [STT_FILE, STT_SECTION].contains(&symbol.st_type())
            || symbol.st_shndx(BigEndian) == SHN_UNDEF
        {
            continue;
        }
        let name = std::str::from_utf8(symbol.name(BigEndian, table.strings())?)
            .map_err(|_| ElfError::Malformed("a symbol's name is not UTF-8"))?;
        if !name.is_empty() {
            by_name.insert(name, symbol.st_value(BigEndian));
            by_address.entry(symbol.st_value(BigEndian)).or_insert(name);
        }
    }
    Ok((by_name, by_address))
}

fn toe(sections: &SectionTable<'_, Header>) -> Result<Option<u32>, ElfError> {
    let mut toe = None;
    for section in sections.iter() {
        if sections.section_name(BigEndian, section)? != b".toe" {
            continue;
        }
        let address = section.sh_addr(BigEndian);
        if toe.is_some() || section.sh_size(BigEndian) != TOE_SIZE {
            return Err(ElfError::UnsupportedToe(".toe is not 16 bytes"));
        }
        if address > SIZE - TOE_SIZE {
            return Err(ElfError::OutsideLocalStore { address, size: TOE_SIZE });
        }
        toe = Some(address);
    }
    Ok(toe)
}

fn references(
    sections: &SectionTable<'_, Header>,
    data: &[u8],
) -> Result<Vec<ImageReference>, ElfError> {
    let mut references = Vec::new();
    for section in sections.iter() {
        let Some((entries, _)) = section.rela(BigEndian, data)? else {
            continue;
        };
        for entry in entries {
            let kind = entry.r_type(BigEndian);
            let wide = kind == R_SPU_PPU64;
            if (!wide && kind != R_SPU_PPU32) || entry.r_sym(BigEndian) != 0 {
                continue;
            }
            let address = entry.r_offset(BigEndian);
            let size = if wide { 8 } else { 4 };
            if address > SIZE - size {
                return Err(ElfError::OutsideLocalStore { address, size });
            }
            references.push(ImageReference { address, wide, offset: entry.r_addend(BigEndian) });
        }
    }
    Ok(references)
}

/// The length of the ELF file that starts at offset 0, for an image of which only the address is
/// known. `fetch` fills the slice with the bytes at an offset, and returns whether it could.
pub fn file_length(mut fetch: impl FnMut(u64, &mut [u8]) -> bool) -> Result<u64, ElfError> {
    let mut bytes = [0; size_of::<Header>()];
    if !fetch(0, &mut bytes) {
        return Err(ElfError::Malformed("the header is incomplete"));
    }
    let header = check_header(&bytes)?;
    let mut end = bytes.len() as u64;
    let programs = u64::from(header.e_phoff(BigEndian));
    for n in 0..u64::from(header.e_phnum(BigEndian)) {
        let size = size_of::<ProgramHeader32<BigEndian>>() as u64;
        let at = programs + n * size;
        let entry: ProgramHeader32<BigEndian> = fetch_entry(&mut fetch, at)?;
        let offset = u64::from(entry.p_offset(BigEndian));
        let contents = offset + u64::from(entry.p_filesz(BigEndian));
        end = end.max(at + size).max(contents);
    }
    let sections = u64::from(header.e_shoff(BigEndian));
    for n in 0..u64::from(header.e_shnum(BigEndian)) {
        let size = size_of::<SectionHeader32<BigEndian>>() as u64;
        let at = sections + n * size;
        let entry: SectionHeader32<BigEndian> = fetch_entry(&mut fetch, at)?;
        let in_file =
            if entry.sh_type(BigEndian) == SHT_NOBITS { 0 } else { entry.sh_size(BigEndian) };
        let contents = u64::from(entry.sh_offset(BigEndian)) + u64::from(in_file);
        end = end.max(at + size).max(contents);
    }
    if end > MAX_FILE {
        return Err(ElfError::Malformed("the file would be larger than 64 MB"));
    }
    Ok(end)
}

fn fetch_entry<T: Pod>(
    fetch: &mut impl FnMut(u64, &mut [u8]) -> bool,
    at: u64,
) -> Result<T, ElfError> {
    let mut bytes = vec![0; size_of::<T>()];
    if !fetch(at, &mut bytes) {
        return Err(ElfError::Malformed("a table is outside the file"));
    }
    from_bytes::<T>(&bytes)
        .map(|(entry, _)| *entry)
        .map_err(|()| ElfError::Malformed("a table is outside the file"))
}
