//! The code of an SPU program or an object: words, functions, labels and source lines.
//!
//! The sections of an object have no addresses yet. They are placed one after the other, each at a
//! multiple of 128. References within the file that the analyser needs (branches, the line table)
//! are resolved. Invariant: every address that this module returns is the address of a word in
//! [`Code::words`].

mod lines;

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet, HashMap};

use object::read::elf::ElfFile32;
use object::{
    BigEndian, Object, ObjectKind, ObjectSection, ObjectSymbol, RelocationFlags, RelocationTarget,
    SectionFlags, SectionIndex, SymbolKind, elf,
};
use thiserror::Error;

pub use lines::Source;
use spu_isa::{Class, Instruction, LOCAL_STORE_SIZE};

/// Alignment of an object's sections: a line of local store, so that instructions pair as in a
/// linked program.
const SECTION_ALIGNMENT: u32 = 128;

/// Relocation of a word: the symbol's address plus the addend.
const R_SPU_ADDR32: u32 = 6;
/// Relocation of a branch: the distance in words from the instruction, in the 16 bits above the
/// target register.
const R_SPU_REL16: u32 = 7;

/// Why a file can't be analysed.
#[derive(Debug, Error)]
pub enum CodeError {
    /// Not an ELF file, or a damaged one.
    #[error("not an ELF file, or a damaged one: {0}")]
    Elf(#[from] object::read::Error),
    /// An ELF file for another machine.
    #[error("ELF machine {0} is not the SPU (23)")]
    Machine(u16),
    /// Neither a program nor an object.
    #[error("neither a program nor an object")]
    Kind,
    /// Code that does not fit into local store.
    #[error("section {section} with {size:#x} bytes at {address:#x} does not fit into local store")]
    OutsideLocalStore {
        /// The section's name.
        section: String,
        /// The section's address.
        address: u64,
        /// The section's size in bytes.
        size: u64,
    },
    /// No executable section.
    #[error("the file contains no code")]
    Empty,
    /// The line table is damaged.
    #[error("damaged line table: {0}")]
    Lines(#[from] gimli::Error),
}

/// A named range of code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Function {
    /// The function's symbol. Code without one is named by its section and an offset.
    pub name: String,
    /// Address of the first word.
    pub start: u32,
    /// Address after the last word.
    pub end: u32,
}

/// The analysis of a file.
#[derive(Clone, Debug)]
pub struct Code {
    words: BTreeMap<u32, u32>,
    functions: Vec<Function>,
    labels: BTreeMap<u32, String>,
    sources: BTreeMap<u32, Source>,
}

type File<'data> = ElfFile32<'data, BigEndian>;

/// A section of code at the address where it was placed.
struct Placed {
    index: SectionIndex,
    name: String,
    start: u32,
    end: u32,
}

impl Code {
    /// Reads a program or an object.
    pub fn parse(data: &[u8]) -> Result<Self, CodeError> {
        let file = File::parse(data)?;
        let machine = file.elf_header().e_machine.get(BigEndian);
        if machine != elf::EM_SPU {
            return Err(CodeError::Machine(machine.0));
        }
        let relocatable = match file.kind() {
            ObjectKind::Relocatable => true,
            ObjectKind::Executable => false,
            _ => return Err(CodeError::Kind),
        };
        let sections = place(&file, relocatable)?;
        let bases: HashMap<_, _> =
            sections.iter().map(|section| (section.index, section.start)).collect();
        let base_of = |index: Option<SectionIndex>| {
            let base = relocatable.then(|| index.and_then(|index| bases.get(&index).copied()));
            base.flatten().unwrap_or(0)
        };

        let mut words = BTreeMap::new();
        for placed in &sections {
            let section = file.section_by_index(placed.index)?;
            let mut bytes = Cow::Borrowed(section.data()?);
            if relocatable {
                relocate(&file, &section, placed.start, &base_of, bytes.to_mut());
            }
            let (chunks, _) = bytes.as_chunks();
            let addresses = (placed.start..).step_by(4);
            words.extend(addresses.zip(chunks.iter().map(|&chunk| u32::from_be_bytes(chunk))));
        }

        let mut labels = BTreeMap::new();
        let mut globals = BTreeSet::new();
        let mut ranges = Vec::new();
        for symbol in file.symbols() {
            let section = symbol.section_index();
            if !section.is_some_and(|index| bases.contains_key(&index)) {
                continue;
            }
            let (Ok(name), Ok(value)) = (symbol.name(), u32::try_from(symbol.address())) else {
                continue;
            };
            let address = value.wrapping_add(base_of(section));
            if name.is_empty() || symbol.kind() == SymbolKind::Section {
                continue;
            }
            labels.entry(address).or_insert_with(|| name.to_owned());
            if symbol.is_global() {
                globals.insert(address);
            }
            if symbol.kind() == SymbolKind::Text && symbol.size() > 0 {
                let size =
                    u32::try_from(symbol.size()).unwrap_or(LOCAL_STORE_SIZE).min(LOCAL_STORE_SIZE);
                ranges.push((address, address.saturating_add(size), name.to_owned()));
            }
        }
        let functions = functions(&sections, ranges, &globals, &labels, &words);

        let load = |name: &str| -> Result<Vec<u8>, CodeError> {
            let Some(section) = file.section_by_name(name) else {
                return Ok(Vec::new());
            };
            let mut bytes = section.data()?.to_vec();
            if relocatable {
                relocate(&file, &section, 0, &base_of, &mut bytes);
            }
            Ok(bytes)
        };
        Ok(Self { words, functions, labels, sources: lines::read(load)? })
    }

    /// All ranges of code by address: those that function symbols cover, and those between them.
    #[must_use]
    pub fn functions(&self) -> &[Function] {
        &self.functions
    }

    /// The words from `start` up to `end`, with their addresses.
    #[must_use]
    pub fn words(&self, start: u32, end: u32) -> Vec<(u32, u32)> {
        if start >= end {
            return Vec::new();
        }
        let range = self.words.range(start..end);
        range.map(|(&address, &word)| (address, word)).collect()
    }

    /// Whether the word at an address is padding or data. The line table counts such words to the
    /// line before them.
    #[must_use]
    pub fn is_filler(&self, address: u32) -> bool {
        let word = self.words.get(&address);
        word.is_none_or(|&word| is_padding(word) || Instruction::decode(word).is_none())
    }

    /// The symbol at an address.
    #[must_use]
    pub fn label(&self, address: u32) -> Option<&str> {
        self.labels.get(&address).map(String::as_str)
    }

    /// Addresses that have a symbol.
    pub fn labels(&self) -> impl Iterator<Item = u32> {
        self.labels.keys().copied()
    }

    /// The source line of each word that the line table covers.
    #[must_use]
    pub fn sources(&self) -> Vec<(u32, &Source)> {
        let known = self.words.keys().filter_map(|&address| {
            let (_, source) = self.sources.range(..=address).next_back()?;
            Some((address, source))
        });
        known.filter(|(_, source)| source.line != 0).collect()
    }
}

fn place(file: &File<'_>, relocatable: bool) -> Result<Vec<Placed>, CodeError> {
    let mut placed: Vec<Placed> = Vec::new();
    for section in file.sections() {
        let SectionFlags::Elf { sh_flags, .. } = section.flags() else {
            continue;
        };
        if !is_code(sh_flags) || section.size() == 0 {
            continue;
        }
        let name = section.name()?.to_owned();
        let address = match placed.last() {
            _ if !relocatable => section.address(),
            Some(before) => before.end.next_multiple_of(SECTION_ALIGNMENT).into(),
            None => 0,
        };
        let size = section.size();
        let end = address.checked_add(size).filter(|&end| end <= LOCAL_STORE_SIZE.into());
        let Some(end) = end.filter(|_| address % 4 == 0) else {
            return Err(CodeError::OutsideLocalStore { section: name, address, size });
        };
        placed.push(Placed {
            index: section.index(),
            name,
            start: address as u32,
            end: end as u32 & !3,
        });
    }
    if placed.is_empty() {
        return Err(CodeError::Empty);
    }
    Ok(placed)
}

fn is_code(flags: elf::SectionFlags) -> bool {
    flags.contains(elf::SHF_EXECINSTR) && flags.contains(elf::SHF_ALLOC)
}

/// Resolves those references in a section's bytes that the analyser needs. The section is at
/// `start`.
fn relocate<'data>(
    file: &File<'data>,
    section: &impl ObjectSection<'data>,
    start: u32,
    base_of: &impl Fn(Option<SectionIndex>) -> u32,
    bytes: &mut [u8],
) {
    for (offset, relocation) in section.relocations() {
        let RelocationTarget::Symbol(index) = relocation.target() else {
            continue;
        };
        let RelocationFlags::Elf { r_type } = relocation.flags() else {
            continue;
        };
        let Ok(symbol) = file.symbol_by_index(index) else {
            continue;
        };
        if symbol.section_index().is_none() {
            continue;
        }
        let value = (symbol.address() as u32)
            .wrapping_add(base_of(symbol.section_index()))
            .wrapping_add(relocation.addend() as u32);
        let slot = usize::try_from(offset)
            .ok()
            .and_then(|offset| bytes.get_mut(offset..)?.first_chunk_mut::<4>());
        let Some(slot) = slot else { continue };
        let word = u32::from_be_bytes(*slot);
        let resolved = match r_type.0 {
            R_SPU_ADDR32 => value,
            R_SPU_REL16 => {
                let distance = value.wrapping_sub(start.wrapping_add(offset as u32));
                word & !(0xffff << 7) | (distance >> 2 & 0xffff) << 7
            }
            _ => continue,
        };
        *slot = resolved.to_be_bytes();
    }
}

/// Functions and the code between them by their addresses, without ranges that are only padding.
fn functions(
    sections: &[Placed],
    mut ranges: Vec<(u32, u32, String)>,
    globals: &BTreeSet<u32>,
    labels: &BTreeMap<u32, String>,
    words: &BTreeMap<u32, u32>,
) -> Vec<Function> {
    ranges.sort();
    let mut functions = Vec::new();
    for section in sections {
        let mut at = section.start;
        let inside = ranges.iter().filter(|range| (section.start..section.end).contains(&range.0));
        let end = (section.end, section.end, String::new());
        for (start, end, name) in inside.chain([&end]) {
            // A global symbol between functions may start a function without a size.
            while at < *start {
                let next = globals.range(at + 1..*start).next().unwrap_or(start);
                if words.range(at..*next).any(|(_, &word)| !is_padding(word)) {
                    let unnamed = || format!("{}+{:#x}", section.name, at - section.start);
                    functions.push(Function {
                        name: labels.get(&at).cloned().unwrap_or_else(unnamed),
                        start: at,
                        end: *next,
                    });
                }
                at = *next;
            }
            // An alias, or a function within another one, is shown as part of the first.
            if at <= *start && start < end {
                functions.push(Function {
                    name: name.clone(),
                    start: *start,
                    end: (*end).min(section.end),
                });
            }
            at = at.max(*end);
        }
    }
    // Sections come in the file's order.
    functions.sort_by_key(|function| function.start);
    functions
}

/// Whether the assembler and linker fill gaps with this word.
fn is_padding(word: u32) -> bool {
    let no_operation = |i: Instruction| matches!(i.op.row().class, Class::Nop | Class::Lnop);
    word == 0 || Instruction::decode(word).is_some_and(no_operation)
}
