//! Places a program that needs no other files in local store.

use spu_isa::LOCAL_STORE_SIZE;

use crate::diagnostic::{Diagnostic, Errors, Position, advice};
use crate::program::{
    Binding, Place, Program, Relocation, RelocationKind, Section, SymbolKind, Target,
};

/// The alignment of what may be written, so that it is in other lines of local store than code.
const LINE: u32 = 128;
/// The start of the stack that the linker of the SPU binutils gives a program.
const STACK: u32 = 0x3_fff0;

/// A program with addresses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Linked {
    /// The address of the first byte.
    pub base: u32,
    /// The contents of local store from there on: code, constants, data and zeros.
    pub bytes: Vec<u8>,
    /// The address of `_start`, or else of the first section.
    pub entry: u32,
    /// The symbols and their addresses, in the order of the program's.
    pub symbols: Vec<LinkedSymbol>,
    /// The parts of `bytes` that are code: addresses of their first bytes, and sizes.
    pub code: Vec<(u32, u32)>,
}

/// A symbol with an address.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LinkedSymbol {
    /// The name.
    pub name: String,
    /// The address, or the number that it was set to.
    pub address: u32,
    /// Its `.size`, or 0.
    pub size: u32,
    /// Its `.type`.
    pub kind: SymbolKind,
    /// Whether other files may use it.
    pub binding: Binding,
    /// Whether it is a number, and not an address.
    pub absolute: bool,
}

impl Program {
    /// Places the sections one after the other, as the linker of the SPU binutils does: code from
    /// address `base` on, then constants, and from the next multiple of 128 on data and zeros.
    ///
    /// # Errors
    ///
    /// A symbol is not defined, an address does not fit into its field, or the program does not fit
    /// into local store.
    pub fn link(&self, base: u32) -> Result<Linked, Errors> {
        let (addresses, common, end) = self.layout(base).ok_or_else(|| self.too_large(base))?;
        let of_symbol = |index: usize| {
            let symbol = &self.symbols[index];
            match symbol.place {
                Place::Absolute(number) => Some(number),
                Place::Section(section, offset) => Some(addresses[section]?.wrapping_add(offset)),
                Place::Common(_) => common[index],
                Place::Undefined => match symbol.name.as_str() {
                    "_end" => Some(end),
                    "__stack" => Some(STACK),
                    _ if symbol.binding == Binding::Weak => Some(0),
                    _ => None,
                },
            }
        };
        let mut bytes = vec![0; (end - base) as usize];
        let mut errors = Vec::new();
        let mut code = Vec::new();
        for (section, address) in self.sections.iter().zip(&addresses) {
            let Some(address) = *address else { continue };
            let start = (address - base) as usize;
            let mut placed = section.bytes.clone();
            for relocation in &section.relocations {
                let target = match relocation.target {
                    Target::Absolute => Ok(0),
                    Target::Section(index) => addresses[index].ok_or_else(|| {
                        format!("section {} is not in local store", self.sections[index].name)
                    }),
                    Target::Symbol(index) => of_symbol(index).ok_or_else(|| {
                        let name = &self.symbols[index].name;
                        let known =
                            (0..self.symbols.len()).filter(|&other| of_symbol(other).is_some());
                        let known = known.map(|other| self.symbols[other].name.as_str());
                        format!("{name} is not defined{}", advice(name, known))
                    }),
                };
                if let Err(message) =
                    target.and_then(|to| apply(relocation, to, address, &mut placed))
                {
                    errors.push(self.diagnostic(relocation.position, message));
                }
            }
            if section.executable && !placed.is_empty() {
                code.push((address, section.size()));
            }
            bytes[start..start + placed.len()].copy_from_slice(&placed);
        }
        if !errors.is_empty() {
            errors.sort_by_key(|error| error.position);
            return Err(Errors { errors, uses_macros: false });
        }
        let symbols: Vec<LinkedSymbol> = (0..self.symbols.len())
            .filter_map(|index| {
                let symbol = &self.symbols[index];
                Some(LinkedSymbol {
                    name: symbol.name.clone(),
                    address: of_symbol(index)?,
                    size: symbol.size,
                    kind: symbol.kind,
                    binding: symbol.binding,
                    absolute: matches!(symbol.place, Place::Absolute(_)),
                })
            })
            .collect();
        let start = symbols.iter().find(|symbol| symbol.name == "_start");
        let first = code.iter().map(|&(address, _)| address).min();
        let entry = start.map(|symbol| symbol.address).or(first).unwrap_or(base);
        Ok(Linked { base, bytes, entry, symbols, code })
    }

    /// Addresses of sections and of common symbols, and the end of the program; nothing if it does
    /// not fit.
    #[expect(clippy::type_complexity, reason = "two tables and a number, for one caller")]
    fn layout(&self, base: u32) -> Option<(Vec<Option<u32>>, Vec<Option<u32>>, u32)> {
        let mut addresses = vec![None; self.sections.len()];
        let mut common = vec![None; self.symbols.len()];
        let mut next = base;
        let mut place = |size: u32, alignment: u32| {
            let address = next.checked_next_multiple_of(alignment.max(1))?;
            next = address.checked_add(size).filter(|&end| end <= LOCAL_STORE_SIZE)?;
            Some(address)
        };
        let rank = |section: &Section| match section {
            Section { writable: true, zeros: true, .. } => 3,
            Section { writable: true, .. } => 2,
            Section { executable: true, .. } => 0,
            _ => 1,
        };
        for wanted in 0..4 {
            if wanted == 2 {
                place(0, LINE)?;
            }
            let sections = self.sections.iter().enumerate();
            for (index, section) in sections.filter(|(_, section)| section.allocated) {
                if rank(section) == wanted {
                    addresses[index] = Some(place(section.size(), section.alignment)?);
                }
            }
        }
        for (index, symbol) in self.symbols.iter().enumerate() {
            if let Place::Common(alignment) = symbol.place {
                common[index] = Some(place(symbol.size, alignment)?);
            }
        }
        let end = place(0, 16)?;
        Some((addresses, common, end))
    }

    fn too_large(&self, base: u32) -> Errors {
        let message = format!("from {base:#x} on, the program does not fit into local store");
        let position = Position { line: 1, column: 1 };
        Errors { errors: vec![self.diagnostic(position, message)], uses_macros: false }
    }

    fn diagnostic(&self, position: Position, message: String) -> Diagnostic {
        Diagnostic { file: self.file.clone(), position, message }
    }
}

/// Puts the value of a relocation into its field. `target` and `section` are addresses.
fn apply(
    relocation: &Relocation,
    target: u32,
    section: u32,
    bytes: &mut [u8],
) -> Result<(), String> {
    let &Relocation { offset, kind, addend, .. } = relocation;
    if matches!(kind, RelocationKind::Ppu32 | RelocationKind::Ppu64) {
        return Err("an address of the PPE is known only to the linker of its program".to_owned());
    }
    let mut value = i64::from(target) + i64::from(addend);
    if kind.is_relative() {
        value -= i64::from(section) + i64::from(offset);
    }
    if let Some((minimum, maximum)) = kind.range()
        && !(minimum..=maximum).contains(&value)
    {
        return Err(format!("{value:#x} does not fit into this operand"));
    }
    kind.apply(value, &mut bytes[offset as usize..]);
    Ok(())
}
