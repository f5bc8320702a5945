//! [`Op`], its rows, and the decode table: the expansions of the instruction table.

use super::class::Class;
use super::format::Format;
use crate::for_each_instruction;

/// A register field of the instruction word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Field {
    /// Bits 25-31, but bits 4-10 in format RRR.
    Rt,
    /// Bits 18-24.
    Ra,
    /// Bits 11-17.
    Rb,
    /// Bits 25-31, in format RRR only.
    Rc,
}

/// What an instruction does with the register named by its rt field, besides reading it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// It is written.
    Rt,
    /// It is encoded as a target but never written.
    False,
    /// Nothing.
    None,
}

/// Which machines have the instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Machine {
    /// Every SPU.
    Every,
    /// Those with the enhanced double-precision unit (PowerXCell 8i), not the Cell.
    DoubleExtension,
}

/// An operand as the assembler writes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operand {
    /// Register rt.
    Rt,
    /// Register ra.
    Ra,
    /// Register rb.
    Rb,
    /// Register rc.
    Rc,
    /// Signed 7-bit constant.
    Immediate7,
    /// Signed 10-bit constant.
    Signed10,
    /// Signed 16-bit constant.
    Signed16,
    /// Unsigned 16-bit constant.
    Unsigned16,
    /// Unsigned 18-bit constant.
    Unsigned18,
    /// Signed 7-bit displacement and, in parentheses, ra.
    Displacement7,
    /// Signed 14-bit displacement of whole quadwords and, in parentheses, ra.
    Displacement14,
    /// Address of a word of local store.
    Absolute,
    /// Address given as a distance from the instruction.
    Relative,
    /// Address of the branch that a hint is for.
    HintedBranch,
    /// Power of two by which a conversion scales.
    Scale,
    /// Channel numbered by the ra field.
    Channel,
    /// Special-purpose register numbered by the ra field.
    Special,
    /// Code of a stop.
    Code,
}

impl Operand {
    /// The field of seven bits whose number it shows, or a part of it does.
    #[must_use]
    pub const fn field(self) -> Option<Field> {
        match self {
            Self::Rt => Some(Field::Rt),
            Self::Ra
            | Self::Displacement7
            | Self::Displacement14
            | Self::Channel
            | Self::Special => Some(Field::Ra),
            Self::Rb => Some(Field::Rb),
            Self::Rc => Some(Field::Rc),
            _ => None,
        }
    }
}

/// What the table says about one instruction.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The instruction.
    pub op: Op,
    /// Its name in assembly, without the letters of feature bits.
    pub mnemonic: &'static str,
    /// Its opcode bits, left-aligned in eleven bits.
    pub opcode: u16,
    /// Where its fields lie.
    pub format: Format,
    /// Operands in the assembler's order.
    pub operands: &'static [Operand],
    /// Fields that name source registers.
    pub reads: &'static [Field],
    /// What becomes of register rt.
    pub target: Target,
    /// Execution class.
    pub class: Class,
    /// Who has it.
    pub machine: Machine,
    /// What it does, in a line.
    pub summary: &'static str,
}

macro_rules! define_ops {
    (() $($variant:ident $mnemonic:ident $opcode:literal $format:ident ($($operand:ident),*)
        [$($read:ident)*] $target:ident $class:ident $part:ident $machine:ident $summary:literal;)*) => {
        /// An instruction of the SPU.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[repr(u8)]
        pub enum Op {
            $(#[doc = concat!("`", stringify!($mnemonic), "`: ", $summary, ".")] $variant,)*
        }

        /// The rows, in the order of `Op`.
        static ROWS: &[Row] = &[$(Row {
            op: Op::$variant,
            mnemonic: stringify!($mnemonic),
            opcode: $opcode,
            format: Format::$format,
            operands: &[$(Operand::$operand),*],
            reads: &[$(Field::$read),*],
            target: Target::$target,
            class: Class::$class,
            machine: Machine::$machine,
            summary: $summary,
        }),*];

        const CLAIMS: &[(Op, u16, Format)] = &[$((Op::$variant, $opcode, Format::$format)),*];
    };
}

for_each_instruction!(define_ops!());

/// Instructions by the first eleven bits of the word.
static BY_OPCODE: [Option<Op>; 2048] = index_by_opcode();

const fn index_by_opcode() -> [Option<Op>; 2048] {
    let mut table = [None; 2048];
    let mut row = 0;
    while row < CLAIMS.len() {
        let (op, opcode, format) = CLAIMS[row];
        let span = 1 << (11 - format.opcode_bits());
        assert!(
            opcode & (span - 1) == 0,
            "opcode has bits outside its format"
        );
        let mut value = opcode;
        while value < opcode + span {
            assert!(table[value as usize].is_none(), "opcode assigned twice");
            table[value as usize] = Some(op);
            value += 1;
        }
        row += 1;
    }
    table
}

impl Op {
    /// All rows of the table, in the order of `Op`.
    #[must_use]
    pub fn rows() -> &'static [Row] {
        ROWS
    }

    /// This instruction's row.
    #[inline]
    #[must_use]
    pub fn row(self) -> &'static Row {
        &ROWS[self as usize]
    }

    /// The instruction with these first eleven bits of a word, if there is one.
    #[inline]
    #[must_use]
    pub fn of_word(word: u32) -> Option<Self> {
        BY_OPCODE[(word >> 21) as usize]
    }

    /// The instruction of this name, without letters of feature bits and without synonyms.
    #[must_use]
    pub fn of_mnemonic(mnemonic: &str) -> Option<Self> {
        ROWS.iter()
            .find(|row| row.mnemonic == mnemonic)
            .map(|row| row.op)
    }
}
