//! Basic blocks of decoded instructions.
//!
//! A block begins wherever the SPU branches to. It ends with the first instruction after which
//! execution depends on more than the code: a branch, a stop or halt, a channel instruction, or a
//! hint whose target is in a register. It also ends at the end of local store and after
//! [`LONGEST`] instructions.

use super::flow::next;
use super::spu::Spu;
use crate::local_store::LocalStore;
use spu_isa::timing::hints_by_register;
use spu_isa::{Class, Instruction, Op};

/// The largest number of instructions in a block.
pub(crate) const LONGEST: usize = 64;

/// A basic block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Block {
    /// Address of its first instruction.
    pub start: u32,
    /// The instructions, at least one.
    pub instructions: Box<[Instruction]>,
}

/// Whether the instruction stops the SPU if a condition holds.
fn halts(i: Instruction) -> bool {
    use Op::{Heq, Heqi, Hgt, Hgti, Hlgt, Hlgti};
    matches!(i.op, Heq | Heqi | Hgt | Hgti | Hlgt | Hlgti)
}

/// Whether a block ends with the instruction.
pub(crate) fn ends_block(i: Instruction) -> bool {
    matches!(i.op.row().class, Class::Br | Class::Spr) || halts(i) || hints_by_register(i)
}

impl Block {
    /// The instructions with their addresses.
    pub fn instructions(&self) -> impl Iterator<Item = (u32, Instruction)> {
        let addresses = (self.start..).step_by(4);
        addresses.zip(self.instructions.iter().copied())
    }

    /// One of the instructions with its address.
    pub fn instruction(&self, at: usize) -> (u32, Instruction) {
        (self.start + 4 * at as u32, self.instructions[at])
    }

    /// The last instruction.
    pub fn last(&self) -> Instruction {
        self.instructions[self.instructions.len() - 1]
    }
}

impl Spu {
    /// The block at `start`, of which `ran` instructions have run: these as they were decoded, the
    /// others as they are in local store now. `None` if this machine has no such instruction as the
    /// first one.
    ///
    /// From now on [`code_changes`](Self::code_changes) counts changes of this block.
    pub(crate) fn block(
        &mut self,
        start: u32,
        ran: u32,
        local_store: &LocalStore,
    ) -> Option<Block> {
        let mut instructions = Vec::new();
        let mut pc = start;
        while instructions.len() < LONGEST {
            let found = if instructions.len() < ran as usize {
                self.decoded.latest_for_block(pc)
            } else {
                self.decoded.get_for_block(pc, local_store.load_word(pc))
            };
            let Some(instruction) = found else {
                break;
            };
            instructions.push(instruction);
            pc = next(pc);
            if ends_block(instruction) || pc == 0 {
                break;
            }
        }
        (!instructions.is_empty()).then(|| Block { start, instructions: instructions.into() })
    }

    /// How often an instruction of a [`block`](Self::block) was found changed. While the number
    /// stays the same, no block has to be compared.
    #[inline]
    pub(crate) fn code_changes(&self) -> u64 {
        self.decoded.code_changes()
    }

    /// Whether the block's instructions are those that the interpreter has decoded. Local store
    /// may already hold others: [`run_decoded`](Self::run_decoded) ends before it runs one of
    /// those.
    pub(crate) fn has_decoded(&mut self, block: &Block) -> bool {
        let decoded = &mut self.decoded;
        block.instructions().all(|(pc, instruction)| decoded.has_for_block(pc, instruction))
    }

    /// The instruction at `pc` as it was decoded last.
    pub(crate) fn latest(&self, pc: u32) -> Option<Instruction> {
        self.decoded.latest(pc)
    }

    /// Decodes these words, each at its address, as the interpreter does when it fetches them.
    pub(crate) fn decode(&mut self, words: &[(u32, u32)]) {
        for &(pc, word) in words {
            self.decoded.get_for_block(pc, word);
        }
    }

    /// Whether [`run_decoded`](Self::run_decoded) would run the instruction at the program counter,
    /// because its word is the one that was decoded last.
    pub(crate) fn is_decoded(&self, local_store: &LocalStore) -> bool {
        self.decoded.is_current(self.pc, local_store.load_word(self.pc))
    }
}
