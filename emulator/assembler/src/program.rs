//! The result of assembly: sections, symbols, and relocations for a linker.

use spu_isa::Instruction;

use crate::diagnostic::{Diagnostic, Position};

/// An assembled source.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Program {
    /// The source's name, as it was given.
    pub file: String,
    /// In the order in which the source first names them, after `.text`.
    pub sections: Vec<Section>,
    /// Symbols that the source defines or needs, but not its local labels (`1:`, `.Lname`).
    pub symbols: Vec<Symbol>,
    /// The SPU binutils warn of the same places.
    pub warnings: Vec<Diagnostic>,
}

/// A section. Its first byte has no address yet.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Section {
    /// The name, such as `.text`.
    pub name: String,
    /// It takes part in the program's memory (flag `a`).
    pub allocated: bool,
    /// The program may write to it (flag `w`).
    pub writable: bool,
    /// It has code (flag `x`).
    pub executable: bool,
    /// The size of an entry, if a linker may merge equal entries (flag `M`).
    pub merged: Option<u32>,
    /// Its entries are strings that end with a zero (flag `S`).
    pub strings: bool,
    /// The symbol that names its group (flag `G`, with `comdat`): of the groups of all files with
    /// this name, a linker keeps one.
    pub group: Option<String>,
    /// It is zeros, which a file does not have (type `@nobits`).
    pub zeros: bool,
    /// The alignment of its address: a power of two.
    pub alignment: u32,
    /// The contents.
    pub bytes: Vec<u8>,
    /// Sorted by offset.
    pub relocations: Vec<Relocation>,
    /// Where code is from: offsets, ascending, and the places of their statements in the source.
    pub places: Vec<(u32, Position)>,
}

/// A symbol.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// The name.
    pub name: String,
    /// Where it is.
    pub place: Place,
    /// Whether other files may use it.
    pub binding: Binding,
    /// Its `.type`.
    pub kind: SymbolKind,
    /// Its `.size`, or 0.
    pub size: u32,
}

/// Where a symbol is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// In another file.
    Undefined,
    /// Nowhere: the symbol is a number.
    Absolute(u32),
    /// At this offset in the section with this index.
    Section(usize, u32),
    /// In memory that a linker reserves, with this alignment (`.comm`).
    Common(u32),
}

/// Whether other files may use a symbol.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Binding {
    /// No.
    #[default]
    Local,
    /// Yes.
    Global,
    /// Yes, unless another file defines it, too.
    Weak,
}

/// The `.type` of a symbol.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SymbolKind {
    /// None is given.
    #[default]
    None,
    /// Data.
    Object,
    /// A function.
    Function,
}

/// A field that gets its value when sections and symbols have addresses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Relocation {
    /// The offset in the section of the word, or of the data.
    pub offset: u32,
    /// The field, and what goes into it.
    pub kind: RelocationKind,
    /// The address from which it is computed.
    pub target: Target,
    /// A number to add.
    pub addend: i32,
    /// The place in the source.
    pub position: Position,
}

/// The address from which a relocation is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// Address 0.
    Absolute,
    /// That of the symbol with this index.
    Symbol(usize),
    /// That of the section with this index.
    Section(usize),
}

/// The kinds of relocations. Their values are those of ELF's `R_SPU_...`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum RelocationKind {
    /// An address in quadwords, in the ten bits of a displacement.
    Addr10 = 1,
    /// An address in words, in 16 bits.
    Addr16 = 2,
    /// The upper half of an address.
    Addr16High = 3,
    /// The lower half of an address.
    Addr16Low = 4,
    /// An address in 18 bits.
    Addr18 = 5,
    /// A word of data.
    Addr32 = 6,
    /// A distance in words, in 16 bits.
    Rel16 = 7,
    /// The low seven bits of an address.
    Addr7 = 8,
    /// A distance in words, in the nine bits of `hbra` and `hbrr`.
    Rel9 = 9,
    /// A distance in words, in the nine bits of `hbr`.
    Rel9Indirect = 10,
    /// An address in ten bits.
    Addr10Immediate = 11,
    /// An address in 16 bits.
    Addr16Immediate = 12,
    /// A word of data that is a distance.
    Rel32 = 13,
    /// A word of data that is an address of the PPE.
    Ppu32 = 15,
    /// A doubleword of data that is an address of the PPE.
    Ppu64 = 16,
}

impl RelocationKind {
    /// Whether it gets a distance from its own address.
    #[must_use]
    pub const fn is_relative(self) -> bool {
        matches!(self, Self::Rel16 | Self::Rel9 | Self::Rel9Indirect | Self::Rel32)
    }

    /// The smallest and the largest value that the linker of the binutils accepts, if it checks
    /// this kind.
    pub(crate) const fn range(self) -> Option<(i64, i64)> {
        match self {
            Self::Addr10 => Some((-8192, 8191)),
            Self::Addr10Immediate => Some((-512, 511)),
            Self::Addr16Immediate => Some((-32768, 32767)),
            Self::Addr18 => Some((-0x4_0000, 0x3_ffff)),
            Self::Rel9 | Self::Rel9Indirect => Some((-1024, 1023)),
            _ => None,
        }
    }

    /// Puts a value into the field at the start of `bytes`, which are long enough for it.
    pub(crate) fn apply(self, value: i64, bytes: &mut [u8]) {
        match self {
            Self::Addr32 | Self::Rel32 | Self::Ppu32 => {
                bytes[..4].copy_from_slice(&(value as u32).to_be_bytes());
            }
            Self::Ppu64 => bytes[..8].copy_from_slice(&value.to_be_bytes()),
            _ => {
                let word = [bytes[0], bytes[1], bytes[2], bytes[3]];
                if let Some(mut i) = Instruction::decode(u32::from_be_bytes(word)) {
                    self.set(&mut i, value);
                    bytes[..4].copy_from_slice(&i.encode().to_be_bytes());
                }
            }
        }
    }

    /// Puts a value into the instruction's operand. Of too large a value the low bits are used.
    pub(crate) fn set(self, i: &mut Instruction, value: i64) {
        match self {
            Self::Rel9 | Self::Rel9Indirect => i.branch_distance = value as i16,
            Self::Addr16High => i.immediate = (value >> 16) as i32,
            _ => i.immediate = value as i32,
        }
    }
}

impl Section {
    /// The number of bytes.
    #[must_use]
    pub fn size(&self) -> u32 {
        self.bytes.len() as u32
    }
}
