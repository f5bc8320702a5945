//! The ELF object of an assembled source, with a line table, as the analyser and the scheduler
//! read one.

use std::collections::BTreeMap;

const MACHINE_SPU: u16 = 23;
const RELOCATABLE: u16 = 1;
const HEADER: usize = 52;
const SECTION_HEADER: usize = 40;

/// Section types.
const PROGBITS: u32 = 1;
const SYMTAB: u32 = 2;
const STRTAB: u32 = 3;
const RELA: u32 = 4;
/// The section index of plain numbers.
const ABSOLUTE: u16 = 0xfff1;

/// A section of the source.
pub struct Section<'a> {
    pub name: &'a str,
    /// ELF's flags: 1 can be written, 2 is loaded, 4 is code.
    pub flags: u32,
    pub align: u32,
    pub bytes: &'a [u8],
    /// The source line of each word, by its offset.
    pub lines: BTreeMap<u32, u32>,
    pub relocations: Vec<Relocation<'a>>,
}

/// A reference that the linker resolves.
pub struct Relocation<'a> {
    pub offset: u32,
    /// ELF's type of it.
    pub kind: u8,
    pub symbol: &'a str,
    pub addend: i32,
}

/// A name and its value.
pub struct Symbol<'a> {
    pub name: &'a str,
    /// The number of its section. `None` is a plain number.
    pub section: Option<usize>,
    pub value: u32,
    pub size: u32,
    /// ELF's binding and type.
    pub info: u8,
}

#[derive(Default)]
struct Bytes(Vec<u8>);

impl Bytes {
    fn byte(&mut self, value: u8) -> &mut Self {
        self.0.push(value);
        self
    }

    fn half(&mut self, value: u16) -> &mut Self {
        self.0.extend(value.to_be_bytes());
        self
    }

    fn words(&mut self, values: &[u32]) -> &mut Self {
        self.0.extend(values.iter().flat_map(|value| value.to_be_bytes()));
        self
    }

    fn text(&mut self, text: &str) -> &mut Self {
        self.0.extend(text.bytes());
        self.byte(0)
    }

    fn unsigned(&mut self, mut value: u32) -> &mut Self {
        while value >= 0x80 {
            self.byte(value as u8 | 0x80);
            value >>= 7;
        }
        self.byte(value as u8)
    }

    fn signed(&mut self, mut value: i32) -> &mut Self {
        while !(-0x40..0x40).contains(&value) {
            self.byte(value as u8 | 0x80);
            value >>= 7;
        }
        self.byte(value as u8 & 0x7f)
    }

    /// The bytes after the word that holds their number, as DWARF's units are.
    fn counted(self) -> Vec<u8> {
        let mut whole = Self::default();
        whole.words(&[self.0.len() as u32]);
        whole.0.extend(self.0);
        whole.0
    }
}

/// The object's bytes. `file` names the source in the line table.
pub fn object(file: &str, sections: &[Section], symbols: &[Symbol]) -> Vec<u8> {
    let mut file_sections = FileSections { names: Bytes(vec![0]), all: Vec::new() };
    let symbol_table = sections.len() + 1;
    for section in sections {
        file_sections.add(section.name, PROGBITS, section.flags, section.bytes.to_vec());
        file_sections.last().align = section.align;
    }
    // Local symbols come before global ones.
    let is_local = |symbol: &&Symbol| symbol.info >> 4 == 0;
    let local = symbols.iter().filter(is_local);
    let ordered: Vec<&Symbol> = local.chain(symbols.iter().filter(|s| !is_local(s))).collect();
    let (mut table, mut names) = (Bytes(vec![0; 16]), Bytes(vec![0]));
    for symbol in &ordered {
        let section = symbol.section.map_or(ABSOLUTE, |section| section as u16 + 1);
        table.words(&[names.0.len() as u32, symbol.value, symbol.size]);
        table.byte(symbol.info).byte(0).half(section);
        names.text(symbol.name);
    }
    let globals_from = 1 + ordered.iter().filter(|symbol| is_local(symbol)).count();
    file_sections.add(".symtab", SYMTAB, 0, table.0);
    *file_sections.last() = FileSection {
        link: symbol_table as u32 + 1,
        info: globals_from as u32,
        entry: 16,
        align: 4,
        ..std::mem::take(file_sections.last())
    };
    file_sections.add(".strtab", STRTAB, 0, names.0);
    for (at, section) in sections.iter().enumerate().filter(|(_, s)| !s.relocations.is_empty()) {
        let mut relocations = Bytes::default();
        for relocation in &section.relocations {
            let symbol = ordered.iter().position(|symbol| symbol.name == relocation.symbol);
            let symbol = symbol.map_or(0, |at| at as u32 + 1);
            let info = symbol << 8 | u32::from(relocation.kind);
            relocations.words(&[relocation.offset, info, relocation.addend as u32]);
        }
        file_sections.add(&format!(".rela{}", section.name), RELA, 0, relocations.0);
        *file_sections.last() = FileSection {
            link: symbol_table as u32,
            info: at as u32 + 1,
            entry: 12,
            align: 4,
            ..std::mem::take(file_sections.last())
        };
    }
    file_sections.add(".debug_abbrev", PROGBITS, 0, abbreviations());
    file_sections.add(".debug_info", PROGBITS, 0, unit(file));
    file_sections.add(".debug_line", PROGBITS, 0, line_table(file, sections));
    file_sections.write()
}

#[derive(Default)]
struct FileSection {
    name: usize,
    kind: u32,
    flags: u32,
    bytes: Vec<u8>,
    link: u32,
    info: u32,
    align: u32,
    entry: u32,
}

struct FileSections {
    names: Bytes,
    all: Vec<FileSection>,
}

impl FileSections {
    fn add(&mut self, name: &str, kind: u32, flags: u32, bytes: Vec<u8>) {
        let at = self.names.0.len();
        self.names.text(name);
        self.all.push(FileSection { name: at, kind, flags, bytes, align: 1, ..Default::default() });
    }

    fn last(&mut self) -> &mut FileSection {
        self.all.last_mut().expect("a section was added")
    }

    fn write(mut self) -> Vec<u8> {
        self.add(".shstrtab", STRTAB, 0, Vec::new());
        self.last().bytes = std::mem::take(&mut self.names.0);
        let (mut body, mut headers) = (Vec::new(), Bytes(vec![0; SECTION_HEADER]));
        for section in &self.all {
            let align = section.align.max(1) as usize;
            body.resize((HEADER + body.len()).next_multiple_of(align) - HEADER, 0);
            headers.words(&[section.name as u32, section.kind, section.flags, 0]);
            headers.words(&[(HEADER + body.len()) as u32, section.bytes.len() as u32]);
            headers.words(&[section.link, section.info, section.align, section.entry]);
            body.extend(&section.bytes);
        }
        let count = self.all.len() as u16;
        let mut whole = Bytes(b"\x7fELF\x01\x02\x01".to_vec());
        whole.0.resize(16, 0);
        whole.half(RELOCATABLE).half(MACHINE_SPU);
        whole.words(&[1, 0, 0, (HEADER + body.len()) as u32, 0]);
        whole.half(HEADER as u16).half(0).half(0);
        whole.half(SECTION_HEADER as u16).half(count + 1).half(count);
        whole.0.extend(body);
        whole.0.extend(headers.0);
        whole.0
    }
}

/// One kind of entry: a unit with the offset of its line table, and a name.
fn abbreviations() -> Vec<u8> {
    vec![1, 0x11, 0, 0x10, 6, 3, 8, 0, 0, 0]
}

fn unit(file: &str) -> Vec<u8> {
    let mut unit = Bytes::default();
    unit.half(3).words(&[0]).byte(4).byte(1).words(&[0]).text(file);
    unit.counted()
}

/// DWARF's line table, version 3, with only the simplest operations. Sections of code have the
/// addresses at which the analyser places them.
fn line_table(file: &str, sections: &[Section]) -> Vec<u8> {
    const OPERATIONS: [u8; 9] = [0, 1, 1, 1, 1, 0, 0, 0, 1];
    let mut header = Bytes::default();
    // Instructions of 1 byte, statements, and a special operation that nothing uses.
    header.byte(1).byte(1).byte(0).byte(1).byte(10);
    header.0.extend(OPERATIONS);
    header.byte(0).text(file).byte(0).byte(0).byte(0).byte(0);
    let mut table = Bytes::default();
    table.half(3);
    table.0.extend(header.counted());
    let mut base = 0_u32;
    for section in sections.iter().filter(|section| section.flags & 4 != 0) {
        if section.bytes.is_empty() {
            continue;
        }
        table.byte(0).byte(5).byte(2).words(&[base]);
        let (mut at, mut line) = (0, 1);
        for (&offset, &new) in &section.lines {
            table.byte(2).unsigned(offset - at).byte(3).signed(new as i32 - line).byte(1);
            (at, line) = (offset, new as i32);
        }
        let size = section.bytes.len() as u32;
        table.byte(2).unsigned(size - at).byte(0).byte(1).byte(1);
        base = (base + size).next_multiple_of(spu_scheduler::code::SECTION_ALIGNMENT);
    }
    table.counted()
}
