//! Paths: instructions that compiled code may run, in the order in which it does, as the clock
//! takes them.

use crate::interp::{self, ends_block};
use spu_isa::Instruction;
use spu_isa::timing::hints_by_register;

/// The path through one piece of compiled code.
#[derive(Debug)]
pub(crate) struct Path {
    /// The address of each instruction, and its word.
    pub words: Box<[(u32, u32)]>,
    pub ends: Box<[End]>,
}

/// Where a basic block ends on a path.
#[derive(Clone, Copy, Debug)]
pub(crate) struct End {
    /// The number of instructions up to here.
    pub after: u32,
    /// Where the path goes on.
    pub next: u32,
    /// The hint by a register that ends the block.
    pub hint: Option<Instruction>,
}

impl Path {
    /// From address, word and instruction, and where each goes on.
    pub fn new(steps: impl Iterator<Item = (u32, u32, Instruction, u32)>) -> Self {
        let (mut words, mut ends) = (Vec::new(), Vec::new());
        for (pc, word, instruction, next) in steps {
            words.push((pc, word));
            if ends_block(instruction) || interp::next(pc) == 0 {
                ends.push(End {
                    after: words.len() as u32,
                    next,
                    hint: Some(instruction).filter(|i| hints_by_register(*i)),
                });
            }
        }
        Self {
            words: words.into(),
            ends: ends.into(),
        }
    }
}
