//! A decoded instruction.

use super::format::Format;
use super::op::{Field, Op, Operand, Target};
use super::registers::RegisterSet;

/// The feature bits in [`Instruction::immediate`], for the formats
/// [`Flagged`](super::Format::Flagged) and [`Hint`](super::Format::Hint).
pub mod feature {
    /// Bit 11: `sync` waits for channels too (c), `hbr` reserves a slot for prefetch (p).
    pub const CHANNEL_OR_PREFETCH: i32 = 4;
    /// Bit 12: a taken indirect branch disables interrupts (d).
    pub const DISABLE: i32 = 2;
    /// Bit 13: a taken indirect branch enables interrupts (e).
    pub const ENABLE: i32 = 1;
}

/// A decoded instruction. Fields that its format does not have are 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Instruction {
    /// The operation.
    pub op: Op,
    /// Target register, or a third source.
    pub rt: u8,
    /// First source register, or the number of a channel or special-purpose register.
    pub ra: u8,
    /// Second source register.
    pub rb: u8,
    /// Third source register of format RRR.
    pub rc: u8,
    /// In hints, bytes from the hint to the branch.
    pub branch_distance: i16,
    /// The constant as the instruction uses it: sign-extended if it is signed, in bytes if it is
    /// an address or distance, or the scale of a conversion, [`feature`] bits, or a stop code.
    pub immediate: i32,
}

impl Instruction {
    /// An instruction with rt, ra, rb and rc.
    #[must_use]
    pub const fn new(op: Op, [rt, ra, rb, rc]: [u8; 4], immediate: i32) -> Self {
        Self { op, rt, ra, rb, rc, branch_distance: 0, immediate }
    }

    /// The mnemonic, with the letters of the feature bits.
    #[must_use]
    pub fn mnemonic(self) -> String {
        let row = self.op.row();
        let mut mnemonic = row.mnemonic.to_owned();
        if matches!(row.format, Format::Flagged | Format::Hint) {
            let first = if self.op == Op::Sync { 'c' } else { 'p' };
            let letters = [
                (feature::CHANNEL_OR_PREFETCH, first),
                (feature::DISABLE, 'd'),
                (feature::ENABLE, 'e'),
            ];
            let set = letters.iter().filter(|(bit, _)| self.immediate & bit != 0);
            mnemonic.extend(set.map(|(_, letter)| letter));
        }
        mnemonic
    }

    /// The same instruction with 0 in each register field that is not an operand. Only such
    /// instructions can be written in assembly.
    #[must_use]
    pub fn without_reserved(self) -> Self {
        let named =
            |field| self.op.row().operands.iter().any(|operand| operand.field() == Some(field));
        let keep = |field, register| if named(field) { register } else { 0 };
        Self {
            rt: keep(Field::Rt, self.rt),
            ra: keep(Field::Ra, self.ra),
            rb: keep(Field::Rb, self.rb),
            rc: keep(Field::Rc, self.rc),
            ..self
        }
    }

    /// The same instruction with 0 in each field that names a general register.
    #[must_use]
    pub fn without_registers(self) -> Self {
        let operands = self.op.row().operands.iter();
        let registers =
            operands.filter(|operand| !matches!(operand, Operand::Channel | Operand::Special));
        registers.filter_map(|operand| operand.field()).fold(self, |mut i, field| {
            *i.register_mut(field) = 0;
            i
        })
    }

    /// The number in a register field.
    #[inline]
    #[must_use]
    pub const fn register(self, field: Field) -> u8 {
        match field {
            Field::Rt => self.rt,
            Field::Ra => self.ra,
            Field::Rb => self.rb,
            Field::Rc => self.rc,
        }
    }

    /// The number in a register field, for changing it.
    pub const fn register_mut(&mut self, field: Field) -> &mut u8 {
        match field {
            Field::Rt => &mut self.rt,
            Field::Ra => &mut self.ra,
            Field::Rb => &mut self.rb,
            Field::Rc => &mut self.rc,
        }
    }

    /// The registers that the instruction reads.
    #[must_use]
    pub fn reads(self) -> RegisterSet {
        let fields = self.op.row().reads.iter();
        fields.fold(RegisterSet::EMPTY, |set, &field| {
            set.union(RegisterSet::of(self.register(field)))
        })
    }

    /// The register that the instruction writes, as a set.
    #[must_use]
    pub fn writes(self) -> RegisterSet {
        self.target_if(Target::Rt)
    }

    /// The register that is encoded as a target but never written, as a set.
    #[must_use]
    pub fn false_target(self) -> RegisterSet {
        self.target_if(Target::False)
    }

    fn target_if(self, wanted: Target) -> RegisterSet {
        if self.op.row().target == wanted { RegisterSet::of(self.rt) } else { RegisterSet::EMPTY }
    }
}
