//! [`Op`], its rows, and the decode table, which are all expansions of the instruction table.

use super::class::Class;
use super::format::Format;
use crate::for_each_instruction;

/// A register field of the instruction word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Field {
    /// Bits 25-31, except in format RRR, where it is bits 4-10.
    Rt,
    /// Bits 18-24.
    Ra,
    /// Bits 11-17.
    Rb,
    /// Bits 25-31, in format RRR only.
    Rc,
}

/// How an instruction uses the register in its rt field, apart from reading it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// The register is written.
    Rt,
    /// The register is encoded as a target but never written.
    False,
    /// The register is not a target.
    None,
}

/// The machines that have an instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Machine {
    /// Every SPU.
    Every,
    /// SPUs with the enhanced double-precision unit (PowerXCell 8i), not the Cell's.
    DoubleExtension,
}

/// An operand in assembly syntax.
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
    /// Signed 7-bit displacement, followed by ra in parentheses.
    Displacement7,
    /// Signed 14-bit displacement of whole quadwords, followed by ra in parentheses.
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
    /// The seven-bit field whose number is the operand or a part of it.
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

/// An instruction's row of the table.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The instruction.
    pub op: Op,
    /// The mnemonic, without the letters of feature bits.
    pub mnemonic: &'static str,
    /// The opcode bits, left-aligned in eleven bits.
    pub opcode: u16,
    /// The positions of the fields.
    pub format: Format,
    /// Operands in the assembler's order.
    pub operands: &'static [Operand],
    /// Fields that name source registers.
    pub reads: &'static [Field],
    /// How the register rt is used.
    pub target: Target,
    /// The execution class.
    pub class: Class,
    /// The machines that have the instruction.
    pub machine: Machine,
    /// A one-line description.
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
        assert!(opcode & (span - 1) == 0, "opcode has bits outside its format");
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

    /// The instruction whose opcode is in the first eleven bits of this word, if there is one.
    #[inline]
    #[must_use]
    pub fn of_word(word: u32) -> Option<Self> {
        BY_OPCODE[(word >> 21) as usize]
    }

    /// The instruction with this mnemonic. Letters of feature bits and synonyms are not
    /// recognised.
    #[must_use]
    pub fn of_mnemonic(mnemonic: &str) -> Option<Self> {
        ROWS.iter().find(|row| row.mnemonic == mnemonic).map(|row| row.op)
    }
}
