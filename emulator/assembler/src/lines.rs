//! The table of source lines in an object, as DWARF has it (version 3), with only the simplest
//! operations.

use crate::diagnostic::Position;
use crate::program::{Program, Relocation, RelocationKind, Section, Target};

/// The bytes after a word with their number.
fn counted(bytes: &[u8]) -> Vec<u8> {
    [&(bytes.len() as u32).to_be_bytes(), bytes].concat()
}

fn unsigned(bytes: &mut Vec<u8>, mut value: u32) {
    while value >= 0x80 {
        bytes.push(value as u8 | 0x80);
        value >>= 7;
    }
    bytes.push(value as u8);
}

fn signed(bytes: &mut Vec<u8>, mut value: i32) {
    while !(-0x40..0x40).contains(&value) {
        bytes.push(value as u8 | 0x80);
        value >>= 7;
    }
    bytes.push(value as u8 & 0x7f);
}

impl Program {
    /// The sections that hold the table, by name, and the relocations of the last one.
    pub(crate) fn line_sections(&self) -> ([(&'static str, Vec<u8>); 3], Vec<Relocation>) {
        // One kind of entry: a compilation unit without children, with the offset of its table as a
        // word, and its name as a string.
        let kinds = vec![1, 0x11, 0, 0x10, 6, 3, 8, 0, 0, 0];
        let name = [self.file.as_bytes(), &[0]].concat();
        // The version, the kinds' offset, bytes of an address, the kind, the table's offset.
        let unit = [&[0, 3, 0, 0, 0, 0, 4, 1, 0, 0, 0, 0], name.as_slice()].concat();
        // Steps of one byte; each row begins a statement; one line a special operation, of which
        // there are none: operations end at 9. Then the number of operands of each.
        let steps = [1, 1, 0, 1, 10, 0, 1, 1, 1, 1, 0, 0, 0, 1];
        // No folder, and one file in none, of unknown time and length.
        let header = [&steps, [0].as_slice(), &name, &[0, 0, 0, 0]].concat();
        let mut table = [[0, 3].as_slice(), &counted(&header)].concat();
        let mut relocations = Vec::new();
        let is_code = |(_, section): &(usize, &Section)| section.executable && section.size() > 0;
        for (index, section) in self.sections.iter().enumerate().filter(is_code) {
            // Sets the address, to the section's.
            table.extend([0, 5, 2]);
            relocations.push(Relocation {
                // The table's length comes before it.
                offset: 4 + table.len() as u32,
                kind: RelocationKind::Addr32,
                target: Target::Section(index),
                addend: 0,
                position: Position { line: 0, column: 0 },
            });
            table.extend([0; 4]);
            let (mut at, mut line) = (0, 1);
            for &(offset, position) in &section.places {
                // Advances the address and the line, and makes a row.
                table.push(2);
                unsigned(&mut table, offset - at);
                table.push(3);
                signed(&mut table, position.line as i32 - line);
                table.push(1);
                (at, line) = (offset, position.line as i32);
            }
            // Ends after the last byte.
            table.push(2);
            unsigned(&mut table, section.size() - at);
            table.extend([0, 1, 1]);
        }
        let sections = [
            (".debug_abbrev", kinds),
            (".debug_info", counted(&unit)),
            (".debug_line", counted(&table)),
        ];
        (sections, relocations)
    }
}
