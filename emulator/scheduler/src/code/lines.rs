//! The DWARF line table: which source line each address came from.

use std::collections::BTreeMap;
use std::path::PathBuf;

use gimli::{
    AttributeValue, BigEndian, Dwarf, EndianSlice, LineProgramHeader, LineRow, SectionId, Unit,
};

/// A line of a source file.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Source {
    /// The file, under the name that the assembler got.
    pub file: PathBuf,
    /// The line number, from 1. It is 0 where the table ends.
    pub line: u64,
}

type Reader<'a> = EndianSlice<'a, BigEndian>;

/// Reads the table from the sections that `load` returns (empty if the file has none). An entry is
/// valid from its address up to the next.
pub(super) fn read<E: From<gimli::Error>>(
    mut load: impl FnMut(&str) -> Result<Vec<u8>, E>,
) -> Result<BTreeMap<u32, Source>, E> {
    let sections = gimli::DwarfSections::load(|id: SectionId| load(id.name()))?;
    let dwarf = sections.borrow(|bytes| EndianSlice::new(bytes, BigEndian));
    let mut sources = BTreeMap::new();
    let mut units = dwarf.units();
    while let Some(header) = units.next()? {
        let unit = dwarf.unit(header)?;
        let Some(program) = unit.line_program.clone() else {
            continue;
        };
        let mut rows = program.rows();
        while let Some((header, row)) = rows.next_row()? {
            let Ok(address) = u32::try_from(row.address()) else {
                continue;
            };
            if row.end_sequence() {
                // Another sequence may already have started where this one ends.
                sources.entry(address).or_insert(Source { file: PathBuf::new(), line: 0 });
                continue;
            }
            let source = Source {
                file: path(&dwarf, &unit, header, row)?,
                line: row.line().map_or(0, u64::from),
            };
            sources.insert(address, source);
        }
    }
    Ok(sources)
}

fn path(
    dwarf: &Dwarf<Reader<'_>>,
    unit: &Unit<Reader<'_>>,
    header: &LineProgramHeader<Reader<'_>>,
    row: &LineRow,
) -> Result<PathBuf, gimli::Error> {
    let text = |value: AttributeValue<Reader<'_>>| -> Result<String, gimli::Error> {
        let bytes = dwarf.attr_string(unit, value)?;
        Ok(bytes.to_string_lossy().into_owned())
    };
    let mut path = PathBuf::new();
    if let Some(folder) = unit.comp_dir {
        path.push(folder.to_string_lossy().as_ref());
    }
    if let Some(file) = row.file(header) {
        if let Some(folder) = file.directory(header) {
            path.push(text(folder)?);
        }
        path.push(text(file.path_name())?);
    }
    Ok(path)
}
