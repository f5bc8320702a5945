//! Instructions as text, exactly as `spu-elf-objdump -d` prints them for a file without symbols.
//!
//! That includes objdump's conventions: a tab after the mnemonic, `lr` as `ori`, `stop` without
//! its code, seven-bit constants as signed, and a comment that repeats the last constant in
//! hexadecimal if it is above 16.

use super::instruction::Instruction;
use super::op::Operand;
use crate::address::LIMIT_MASK;
use std::fmt;

/// The text of a word at an address. See [`disassemble`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Disassembly {
    word: u32,
    pc: u32,
}

/// The text of `word`, fetched from `pc`. An unassigned opcode becomes a `.long`.
#[must_use]
pub const fn disassemble(word: u32, pc: u32) -> Disassembly {
    Disassembly { word, pc }
}

impl fmt::Display for Disassembly {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(instruction) = Instruction::decode(self.word) else {
            return write!(f, ".long 0x{:x}", self.word);
        };
        let row = instruction.op.row();
        write!(f, "{}", instruction.mnemonic())?;
        let mut separator = '\t';
        let mut comment = 0;
        for &operand in row.operands {
            if operand == Operand::Code {
                continue;
            }
            write!(f, "{separator}")?;
            separator = ',';
            if let Some(constant) = write_operand(f, instruction, operand, self.pc)? {
                comment = constant;
            }
        }
        if comment > 16 {
            write!(f, "\t# {comment:x}")?;
        }
        Ok(())
    }
}

/// Writes one operand. Returns the constant that objdump repeats in hexadecimal, if it does so for
/// this kind of operand.
fn write_operand(
    f: &mut fmt::Formatter<'_>,
    i: Instruction,
    operand: Operand,
    pc: u32,
) -> Result<Option<i32>, fmt::Error> {
    let immediate = i.immediate;
    match operand {
        Operand::Rt => write!(f, "${}", i.rt)?,
        Operand::Ra => write!(f, "${}", i.ra)?,
        Operand::Rb => write!(f, "${}", i.rb)?,
        Operand::Rc => write!(f, "${}", i.rc)?,
        Operand::Channel => write!(f, "$ch{}", i.ra)?,
        Operand::Special => write!(f, "$sp{}", i.ra)?,
        Operand::Scale => write!(f, "{immediate}")?,
        Operand::Code => {}
        Operand::Immediate7 | Operand::Signed10 | Operand::Signed16 | Operand::Unsigned18 => {
            write!(f, "{immediate}")?;
            return Ok(Some(immediate));
        }
        Operand::Unsigned16 => {
            let constant = immediate & 0xffff;
            write!(f, "{constant}")?;
            return Ok(Some(constant));
        }
        Operand::Displacement7 | Operand::Displacement14 => {
            write!(f, "{immediate}(${})", i.ra)?;
            return Ok(Some(immediate));
        }
        Operand::Absolute if immediate == 0 => f.write_str("0")?,
        Operand::Absolute => write!(f, "{immediate:#x}")?,
        Operand::Relative if immediate == 0 => f.write_str("0")?,
        Operand::Relative => {
            let address = pc.wrapping_add_signed(immediate);
            write!(f, "{:#x}", address & LIMIT_MASK)?;
            // objdump's comment shows the address before it wraps.
            return Ok(Some(address as i32));
        }
        Operand::HintedBranch => {
            let address = pc.wrapping_add_signed(i32::from(i.branch_distance));
            // objdump does not wrap this address.
            write!(f, "{address:#x}")?;
        }
    }
    Ok(None)
}
