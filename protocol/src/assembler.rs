//! Prints the work-unit layout for the assembler, as `work_unit.inc`.
//!
//! Owns the layout's names in assembly.

use std::fmt::Write as _;

use crate::layout::{self, Field};

/// The name of the file that sources include.
pub const FILE: &str = "work_unit.inc";

/// The text of the file: all sizes, offsets and constants of the layout, as assembler symbols.
#[must_use]
pub fn constants() -> String {
    let mut text = String::from("# Generated from protocol/src/layout.\n");
    for (name, value, doc) in layout::CONSTANTS {
        let _ = writeln!(text, ".set {name},{value:#x} #{doc}");
    }
    for record in layout::RECORDS {
        let _ = writeln!(text, "\n#{}\n.set {}_SIZE,{}", record.doc, record.name, record.size);
        for field in record.fields {
            let Field { name, kind, offset, size, doc } = field;
            let _ =
                writeln!(text, ".set {}_{name},{offset} # {kind}, {size} bytes:{doc}", record.name);
        }
    }
    for (name, status, field, doc) in layout::Status::ALL {
        let _ = writeln!(text, ".set STATUS_{name},{} # {field}:{doc}", *status as u32);
    }
    text
}
