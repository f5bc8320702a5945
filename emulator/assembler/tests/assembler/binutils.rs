//! Assembles a source with the SPU binutils and with this crate, and compares the objects.
//!
//! Provenance: the binutils, run during the test. Without them these tests fail, because nothing
//! else shows that our bytes are the assembler's.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

use object::read::elf::ElfFile32;
use object::{
    BigEndian, Object as _, ObjectSection as _, ObjectSymbol as _, RelocationFlags,
    RelocationTarget, SectionFlags, SymbolFlags,
};
use spu_build::Tools;

/// What linkers and loaders see of a file.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Contents {
    /// Flags, alignment, size and bytes of each section that is not empty.
    pub sections: BTreeMap<String, (u64, u64, u64, Vec<u8>)>,
    /// Section, offset, type, symbol and addend of each relocation.
    pub relocations: Vec<(String, u64, u8, String, i64)>,
    /// Section, value, size, and type with binding, of each named symbol.
    pub symbols: BTreeSet<(String, String, u64, u64, u8)>,
}

/// Reads an object. Line tables are left out.
pub fn contents(file: &[u8]) -> Contents {
    let file = ElfFile32::<BigEndian>::parse(file).unwrap();
    let mut contents = Contents::default();
    let tables = [".symtab", ".strtab", ".shstrtab"];
    let section_of = |index| file.section_by_index(index).unwrap().name().unwrap().to_owned();
    for section in file.sections() {
        let name = section.name().unwrap().to_owned();
        // A group has the index of a section, which is the assembler's choice.
        let skipped = [".debug", ".rela", ".group"].iter().any(|start| name.starts_with(start));
        if skipped || tables.contains(&name.as_str()) || section.size() == 0 {
            continue;
        }
        let SectionFlags::Elf { sh_flags, .. } = section.flags() else { panic!("{name}") };
        for (offset, relocation) in section.relocations() {
            let RelocationFlags::Elf { r_type } = relocation.flags() else { panic!("{name}") };
            let target = match relocation.target() {
                RelocationTarget::Symbol(index) => {
                    let symbol = file.symbol_by_index(index).unwrap();
                    match symbol.name().unwrap() {
                        "" => section_of(symbol.section_index().unwrap()),
                        // A section's symbol is named like the section.
                        named => named.to_owned(),
                    }
                }
                _ => String::new(),
            };
            let (kind, addend) = (r_type.0 as u8, relocation.addend());
            contents.relocations.push((name.clone(), offset, kind, target, addend));
        }
        let (align, size) = (section.align(), section.size());
        let data = section.data().unwrap().to_vec();
        contents.sections.insert(name, (sh_flags.0, align, size, data));
    }
    for symbol in file.symbols() {
        let name = symbol.name().unwrap().to_owned();
        let SymbolFlags::Elf { st_info, .. } = symbol.flags() else { panic!("{name}") };
        // Symbols of sections and files, labels that only a line table uses, and the registers of
        // `nop`, of which the GNU assembler makes symbols without a use.
        let skipped = name.is_empty()
            || [3, 4].contains(&(st_info.0 & 15))
            || name.starts_with(".L")
            || name.starts_with('$');
        if !skipped {
            let section = match symbol.section_index() {
                Some(index) => section_of(index),
                None => format!("{:?}", symbol.section()),
            };
            contents.symbols.insert((name, section, symbol.address(), symbol.size(), st_info.0));
        }
    }
    contents
}

/// A source in a folder of its own, and the assembler of the binutils.
pub struct Bench {
    pub folder: tempfile::TempDir,
    pub tools: Tools,
}

impl Bench {
    pub fn new() -> Self {
        let tools = Tools::find();
        let tools =
            tools.unwrap_or_else(|error| panic!("{error}\n(ci/setup installs the SPU binutils)"));
        Self { folder: tempfile::tempdir().unwrap(), tools }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// The object that the binutils make of a source.
    pub fn assemble(&self, source: &str) -> Vec<u8> {
        let (input, object) = (self.path("source.s"), self.path("source.o"));
        fs::write(&input, source).unwrap();
        let made = self.tools.assemble(&[], &[], &object, &input);
        made.unwrap_or_else(|error| panic!("{error}\n{source}"));
        fs::read(object).unwrap()
    }

    /// A source without macros, conditions, repetitions and includes: the assembler's listing
    /// shows what they expand to.
    pub fn expand(&self, source: &std::path::Path, includes: &[PathBuf]) -> String {
        let listing = self.path("listing");
        let list = format!("-alcmn={}", listing.display());
        let widths = ["--listing-rhs-width=4000", "--listing-cont-lines=0"];
        let made =
            self.tools.assemble(includes, &[&list, widths[0], widths[1]], &self.path("o"), source);
        made.unwrap_or_else(|error| panic!("{error}"));
        expanded(&fs::read_to_string(listing).unwrap())
    }

    /// Compares the two assemblers' objects of a source without macros.
    pub fn compare(&self, name: &str, source: &str) {
        let ours = spu_assembler::assemble(name, source);
        let ours = ours.unwrap_or_else(|errors| panic!("{name}:\n{errors}"));
        let (ours, theirs) = (contents(&ours.elf()), contents(&self.assemble(source)));
        for (section, their) in &theirs.sections {
            let our = ours.sections.get(section).unwrap_or_else(|| panic!("{name}: no {section}"));
            let differs = |at: &usize| our.3[*at] != their.3[*at];
            let first = (0..our.3.len().min(their.3.len())).find(differs);
            assert_eq!(first, None, "{name}: the first byte of {section} that differs");
            assert_eq!(our, their, "{name}: {section}");
        }
        assert_eq!(ours.relocations, theirs.relocations, "{name}");
        assert_eq!(ours.symbols, theirs.symbols, "{name}");
        assert_eq!(ours, theirs, "{name}");
    }
}

/// The statements of a listing that are left when all macros are expanded.
fn expanded(listing: &str) -> String {
    let mut macros = BTreeSet::new();
    let mut text = String::new();
    // The directive whose end is looked for, and how deep it is.
    let mut skipped: Option<(&str, u32)> = None;
    for line in listing.lines() {
        let Some((_, statement)) = line.split_once('\t') else { continue };
        let statement = statement.trim_start_matches('>');
        let is_expansion = line.contains("\t>");
        let code = statement.split('#').next().unwrap_or("").trim();
        // A label may be before a repetition.
        let (label, head) = match code.split_once(':') {
            Some((label, rest)) if !label.contains([' ', '"']) => (label, rest.trim()),
            _ => ("", code),
        };
        let word = head.split_whitespace().next().unwrap_or("");
        let opens = |end: &str| match end {
            ".endm" => word == ".macro",
            _ => [".irp", ".irpc", ".rept"].contains(&word),
        };
        if let Some((end, depth)) = skipped {
            skipped = match () {
                () if word == end && depth == 0 => None,
                () if word == end => Some((end, depth - 1)),
                () if opens(end) => Some((end, depth + 1)),
                () => Some((end, depth)),
            };
            continue;
        }
        if !label.is_empty() && (word.starts_with(".rept") || word.starts_with(".irp")) {
            text.push_str(label);
            text.push_str(":\n");
        }
        match word {
            ".macro" => {
                let name = head.split_whitespace().nth(1).unwrap().trim_end_matches(',');
                macros.insert(name.to_owned());
                skipped = Some((".endm", 0));
            }
            // The lines of a repetition in a macro are not listed, only what they expand to.
            ".irp" | ".irpc" | ".rept" if !is_expansion => skipped = Some((".endr", 0)),
            ".irp" | ".irpc" | ".rept" | ".endr" | ".endm" | ".include" | ".altmacro"
            | ".noaltmacro" | ".error" => {}
            _ if word.starts_with(".if") || word.starts_with(".else") || word == ".endif" => {}
            _ if macros.contains(word) => {
                if !label.is_empty() {
                    text.push_str(label);
                    text.push_str(":\n");
                }
            }
            _ => {
                text.push_str(statement);
                text.push('\n');
            }
        }
    }
    text
}
