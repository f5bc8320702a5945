//! Files in ELF's format for the SPU: objects for a linker, and programs.

use crate::link::Linked;
use crate::program::{Binding, Place, Program, Relocation, SymbolKind, Target};

const HEADER: u32 = 52;
const PROGRAM_HEADER: u32 = 32;
const SECTION_HEADER: u16 = 40;
const SPU: u16 = 23;
const OBJECT: u16 = 1;
const EXECUTABLE: u16 = 2;

const PROGBITS: u32 = 1;
const SYMTAB: u32 = 2;
const STRTAB: u32 = 3;
const RELA: u32 = 4;
const NOBITS: u32 = 8;
const GROUP: u32 = 17;

const WRITE: u32 = 1;
const ALLOC: u32 = 2;
const EXECUTE: u32 = 4;
const MERGE: u32 = 0x10;
const STRINGS: u32 = 0x20;
const INFO_LINK: u32 = 0x40;
const GROUPED: u32 = 0x200;

/// Section indices with a meaning of their own.
const ABSOLUTE: u16 = 0xfff1;
const COMMON: u16 = 0xfff2;

#[derive(Default)]
struct Header {
    name: String,
    kind: u32,
    flags: u32,
    address: u32,
    size: u32,
    link: u32,
    info: u32,
    alignment: u32,
    entry_size: u32,
    contents: Vec<u8>,
}

/// A table of strings, in which each ends with a zero.
struct Strings(Vec<u8>);

impl Strings {
    const fn new() -> Self {
        Self(Vec::new())
    }

    fn add(&mut self, text: &str) -> u32 {
        if self.0.is_empty() {
            self.0.push(0);
        }
        if text.is_empty() {
            return 0;
        }
        let at = self.0.len() as u32;
        self.0.extend(text.bytes().chain([0]));
        at
    }
}

/// An entry of the symbol table.
struct Entry {
    name: String,
    value: u32,
    size: u32,
    binding: Binding,
    kind: u8,
    section: u16,
}

const fn kind(kind: SymbolKind) -> u8 {
    match kind {
        SymbolKind::None => 0,
        SymbolKind::Object => 1,
        SymbolKind::Function => 2,
    }
}

/// The symbol table with its strings, and the index of each entry in it: local ones are first.
fn symbol_table(entries: &[Entry], strings_at: u32) -> (Header, Header, Vec<u32>) {
    let mut strings = Strings::new();
    strings.add("");
    let mut contents = vec![0; 16];
    let mut order: Vec<usize> = (0..entries.len()).collect();
    order.sort_by_key(|&index| entries[index].binding != Binding::Local);
    let mut indices = vec![0; entries.len()];
    for (number, &index) in (1..).zip(&order) {
        let entry = &entries[index];
        indices[index] = number;
        let binding = match entry.binding {
            Binding::Local => 0,
            Binding::Global => 1,
            Binding::Weak => 2,
        };
        for word in [strings.add(&entry.name), entry.value, entry.size] {
            contents.extend(word.to_be_bytes());
        }
        contents.extend([binding << 4 | entry.kind, 0]);
        contents.extend(entry.section.to_be_bytes());
    }
    let locals = entries.iter().filter(|entry| entry.binding == Binding::Local).count() as u32;
    let table = Header {
        name: ".symtab".to_owned(),
        kind: SYMTAB,
        link: strings_at,
        info: 1 + locals,
        alignment: 4,
        entry_size: 16,
        contents,
        ..Header::default()
    };
    let strings = Header {
        name: ".strtab".to_owned(),
        kind: STRTAB,
        alignment: 1,
        contents: strings.0,
        ..Header::default()
    };
    (table, strings, indices)
}

/// A file with these sections. A program has a segment: its address and contents are those of all
/// sections with addresses together.
fn file(
    kind: u16,
    entry: u32,
    segment: Option<(u32, &[u8])>,
    mut sections: Vec<Header>,
) -> Vec<u8> {
    let mut names = Strings::new();
    names.add("");
    sections.push(Header {
        name: ".shstrtab".to_owned(),
        kind: STRTAB,
        alignment: 1,
        ..Header::default()
    });
    let name_offsets: Vec<u32> = sections.iter().map(|section| names.add(&section.name)).collect();
    if let Some(last) = sections.last_mut() {
        last.contents = names.0;
    }
    let mut data = vec![0; (HEADER + PROGRAM_HEADER * u32::from(segment.is_some())) as usize];
    let mut loaded = 0;
    if let Some((address, bytes)) = segment {
        // The loader copies from a place in the file with the alignment of the address.
        data.resize(data.len().next_multiple_of(128) + address as usize % 128, 0);
        loaded = data.len() as u32;
        data.extend(bytes);
    }
    let mut headers = vec![0; SECTION_HEADER.into()];
    for (section, name) in sections.iter().zip(name_offsets) {
        let at = match segment {
            Some((start, _)) if section.flags & ALLOC != 0 => loaded + (section.address - start),
            _ => {
                data.resize(
                    data.len().next_multiple_of(section.alignment.clamp(1, 128) as usize),
                    0,
                );
                data.len() as u32
            }
        };
        let size = section.size.max(section.contents.len() as u32);
        data.extend(&section.contents);
        let fields = [
            name,
            section.kind,
            section.flags,
            section.address,
            at,
            size,
            section.link,
            section.info,
            section.alignment,
            section.entry_size,
        ];
        headers.extend(fields.iter().flat_map(|field| field.to_be_bytes()));
    }
    data.resize(data.len().next_multiple_of(4), 0);
    let table = data.len() as u32;
    data.extend(&headers);
    let count = sections.len() as u16 + 1;
    let segments = u16::from(segment.is_some());

    let mut head = b"\x7fELF\x01\x02\x01\0\0\0\0\0\0\0\0\0".to_vec();
    head.extend([kind, SPU].iter().flat_map(|field| field.to_be_bytes()));
    let first_segment = HEADER * u32::from(segments);
    head.extend([1, entry, first_segment, table, 0].iter().flat_map(|field| field.to_be_bytes()));
    let sizes = [HEADER as u16, PROGRAM_HEADER as u16, segments, SECTION_HEADER, count, count - 1];
    head.extend(sizes.iter().flat_map(|field| field.to_be_bytes()));
    if let Some((address, bytes)) = segment {
        let size = bytes.len() as u32;
        // A loaded segment (1) that may be read, written and executed (7).
        let fields = [1, loaded, address, address, size, size, 7, 128];
        head.extend(fields.iter().flat_map(|field: &u32| field.to_be_bytes()));
    }
    data[..head.len()].copy_from_slice(&head);
    data
}

impl Program {
    /// The program as an object: a relocatable ELF file for a linker, or for `spu time`.
    #[must_use]
    pub fn elf(&self) -> Vec<u8> {
        let with_relocations =
            self.sections.iter().filter(|section| !section.relocations.is_empty());
        // Groups are before their sections.
        let groups = self.sections.iter().filter(|section| section.group.is_some()).count();
        let first = 1 + groups as u16;
        let symbols_at = (1 + groups + self.sections.len() + with_relocations.count()) as u32;
        let own = self.sections.iter().zip(first..).map(|(_, index)| Entry {
            name: String::new(),
            value: 0,
            size: 0,
            binding: Binding::Local,
            kind: 3,
            section: index,
        });
        let named = self.symbols.iter().map(|symbol| {
            let (section, value) = match symbol.place {
                Place::Undefined => (0, 0),
                Place::Absolute(number) => (ABSOLUTE, number),
                Place::Section(index, offset) => (index as u16 + first, offset),
                Place::Common(alignment) => (COMMON, alignment),
            };
            Entry {
                name: symbol.name.clone(),
                value,
                size: symbol.size,
                binding: symbol.binding,
                kind: kind(symbol.kind),
                section,
            }
        });
        let entries: Vec<Entry> = own.chain(named).collect();
        let (table, strings, indices) = symbol_table(&entries, symbols_at + 1);
        let flag = |set, flag| if set { flag } else { 0 };
        let mut headers: Vec<Header> = Vec::new();
        for (section, index) in self.sections.iter().zip(u32::from(first)..) {
            let Some(group) = &section.group else { continue };
            let named = self.symbols.iter().position(|symbol| symbol.name == *group);
            headers.push(Header {
                name: ".group".to_owned(),
                kind: GROUP,
                link: symbols_at,
                info: named.map_or(0, |symbol| indices[self.sections.len() + symbol]),
                alignment: 4,
                entry_size: 4,
                // With a 1, a linker keeps one of equal groups.
                contents: [1, index].map(u32::to_be_bytes).concat(),
                ..Header::default()
            });
        }
        for section in &self.sections {
            headers.push(Header {
                name: section.name.clone(),
                kind: if section.zeros { NOBITS } else { PROGBITS },
                flags: flag(section.allocated, ALLOC)
                    | flag(section.writable, WRITE)
                    | flag(section.executable, EXECUTE)
                    | flag(section.merged.is_some(), MERGE)
                    | flag(section.strings, STRINGS)
                    | flag(section.group.is_some(), GROUPED),
                size: section.size(),
                alignment: section.alignment,
                entry_size: section.merged.unwrap_or(0),
                contents: if section.zeros { Vec::new() } else { section.bytes.clone() },
                ..Header::default()
            });
        }
        let relocations = |name: &str, all: &[Relocation], section| {
            let mut contents = Vec::new();
            for relocation in all {
                let symbol = match relocation.target {
                    Target::Absolute => 0,
                    Target::Section(section) => indices[section],
                    Target::Symbol(symbol) => indices[self.sections.len() + symbol],
                };
                contents.extend(relocation.offset.to_be_bytes());
                contents.extend((symbol << 8 | relocation.kind as u32).to_be_bytes());
                contents.extend(relocation.addend.to_be_bytes());
            }
            (!all.is_empty()).then(|| Header {
                name: format!(".rela{name}"),
                kind: RELA,
                flags: INFO_LINK,
                link: symbols_at,
                info: section,
                alignment: 4,
                entry_size: 12,
                contents,
                ..Header::default()
            })
        };
        for (section, index) in self.sections.iter().zip(first.into()..) {
            headers.extend(relocations(&section.name, &section.relocations, index));
        }
        headers.extend([table, strings]);
        let (lines, addresses) = self.line_sections();
        headers.extend(lines.map(|(name, contents)| Header {
            name: name.to_owned(),
            kind: PROGBITS,
            alignment: 1,
            contents,
            ..Header::default()
        }));
        headers.extend(relocations(".debug_line", &addresses, headers.len() as u32));
        file(OBJECT, 0, None, headers)
    }
}

impl Linked {
    /// The program as an ELF file that a loader of SPU programs takes.
    #[must_use]
    pub fn elf(&self) -> Vec<u8> {
        let mut headers: Vec<Header> = Vec::new();
        for &(address, size) in &self.code {
            headers.push(Header {
                name: ".text".to_owned(),
                kind: PROGBITS,
                flags: ALLOC | EXECUTE,
                address,
                size,
                alignment: 4,
                ..Header::default()
            });
        }
        let section_of = |address: u32| {
            let inside = |&(start, size): &(u32, u32)| (start..=start + size).contains(&address);
            self.code.iter().position(inside).map_or(ABSOLUTE, |index| index as u16 + 1)
        };
        let entries = self.symbols.iter().map(|symbol| Entry {
            name: symbol.name.clone(),
            value: symbol.address,
            size: symbol.size,
            binding: symbol.binding,
            kind: kind(symbol.kind),
            section: if symbol.absolute { ABSOLUTE } else { section_of(symbol.address) },
        });
        let entries: Vec<Entry> = entries.collect();
        let (table, strings, _) = symbol_table(&entries, headers.len() as u32 + 2);
        headers.extend([table, strings]);
        file(EXECUTABLE, self.entry, Some((self.base, &self.bytes)), headers)
    }
}
