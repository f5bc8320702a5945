//! Prints where segments and sections are in local store, what is free, and the notes.

use std::fmt::Write as _;

use object::read::elf::{
    ElfFile32, FileHeader as _, NoteIterator, ProgramHeader as _, SectionHeader as _,
};
use object::{BigEndian, elf};
use spu_emulator::elf::ElfError;
use spu_emulator::local_store::SIZE;

type Header = elf::FileHeader32<BigEndian>;

/// Alignment of a note. The linker aligns the whole section to 16, but the entries in it only to
/// 4.
const NOTE_ALIGNMENT: u32 = 4;

/// A named range of bytes at an address. The first `file` bytes of it are in the file.
struct Area {
    name: String,
    start: u32,
    size: u32,
    file: u32,
}

impl Area {
    fn end(&self) -> u64 {
        u64::from(self.start) + u64::from(self.size)
    }
}

pub struct Map {
    segments: Vec<Area>,
    sections: Vec<Area>,
    notes: Vec<String>,
}

impl Map {
    pub fn of(bytes: &[u8]) -> Result<Self, ElfError> {
        let file = ElfFile32::<BigEndian>::parse(bytes)?;
        let header: &Header = file.elf_header();
        let mut segments = Vec::new();
        for segment in header.program_headers(BigEndian, bytes)? {
            if segment.p_type(BigEndian) == elf::PT_LOAD {
                segments.push(Area {
                    name: access(segment.p_flags(BigEndian).0),
                    start: segment.p_vaddr(BigEndian),
                    size: segment.p_memsz(BigEndian),
                    file: segment.p_filesz(BigEndian),
                });
            }
        }
        segments.sort_by_key(|area| area.start);
        let table = file.elf_section_table();
        let mut sections = Vec::new();
        let mut notes = Vec::new();
        for section in table.iter() {
            let name = String::from_utf8_lossy(table.section_name(BigEndian, section)?);
            if section.sh_type(BigEndian) == elf::SHT_NOTE {
                let contents = section.data(BigEndian, bytes)?;
                let mut found = NoteIterator::<Header>::new(BigEndian, NOTE_ALIGNMENT, contents)?;
                while let Some(note) = found.next()? {
                    let owner = String::from_utf8_lossy(note.name());
                    let kind = note.n_type(BigEndian).0;
                    let text = note_text(&owner, note.desc());
                    notes.push(format!("{name}  {owner} type {kind}: {text}"));
                }
            }
            let loaded = section.sh_flags(BigEndian).0 & elf::SHF_ALLOC.0 != 0;
            let size = section.sh_size(BigEndian);
            if loaded && size > 0 {
                let in_file = section.sh_type(BigEndian) != elf::SHT_NOBITS;
                sections.push(Area {
                    name: name.into_owned(),
                    start: section.sh_addr(BigEndian),
                    size,
                    file: if in_file { size } else { 0 },
                });
            }
        }
        sections.sort_by_key(|area| area.start);
        Ok(Self { segments, sections, notes })
    }

    pub fn write(&self, text: &mut String) {
        let _ = writeln!(text, "\nlocal store: {SIZE} bytes");
        let mut line = |start: u64, end: u64, indent: &str, what: &str| {
            let last = end.saturating_sub(1);
            let size = end.saturating_sub(start);
            let _ = writeln!(text, "  {start:#07x}-{last:#07x} {size:>7}  {indent}{what}");
        };
        let mut at = 0;
        for segment in &self.segments {
            let start = u64::from(segment.start);
            if start > at {
                line(at, start, "", "free");
            }
            let zeros = segment.size.saturating_sub(segment.file);
            let what = match zeros {
                0 => format!("segment {}", segment.name),
                zeros => format!("segment {}, {zeros} of its bytes are zeros", segment.name),
            };
            line(start, segment.end(), "", &what);
            for section in &self.sections {
                let inside = start <= section.start.into() && section.end() <= segment.end();
                if inside {
                    line(section.start.into(), section.end(), "  ", &section.name);
                }
            }
            at = at.max(segment.end());
        }
        if at < u64::from(SIZE) {
            line(at, SIZE.into(), "", "free, stack from the top");
        }
        if !self.notes.is_empty() {
            text.push_str("\nnotes\n");
            for note in &self.notes {
                let _ = writeln!(text, "  {note}");
            }
        }
    }
}

fn access(flags: u32) -> String {
    let letters = [(elf::PF_R.0, 'r'), (elf::PF_W.0, 'w'), (elf::PF_X.0, 'x')];
    letters.iter().map(|&(bit, letter)| if flags & bit == 0 { '-' } else { letter }).collect()
}

/// The SPU's notes contain a name, or these words: revision, local-store size, stack size, flags.
fn note_text(owner: &str, contents: &[u8]) -> String {
    if owner == "SPUNAME" {
        let name = contents.split(|&byte| byte == 0).next().unwrap_or_default();
        return String::from_utf8_lossy(name).into_owned();
    }
    let (words, rest) = contents.as_chunks::<4>();
    let words = words.iter().map(|&word| format!("{:#x}", u32::from_be_bytes(word)));
    let rest = rest.iter().map(|byte| format!("{byte:#04x}"));
    words.chain(rest).collect::<Vec<_>>().join(" ")
}
