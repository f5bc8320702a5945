//! Paths: the instructions of compiled units, in the form in which the clock times them.

use crate::interp::{self, ends_block};
use spu_isa::Instruction;
use spu_isa::timing::hints_by_register;

/// The path through one compiled unit: its instructions in the order in which they run.
#[derive(Debug)]
pub(crate) struct Path {
    /// The address of each instruction, and its word.
    pub words: Box<[(u32, u32)]>,
    /// The ends of the basic blocks on the path.
    pub ends: Box<[End]>,
}

/// The end of a basic block on a path.
#[derive(Clone, Copy, Debug)]
pub(crate) struct End {
    /// The number of instructions of the path up to here.
    pub after: u32,
    /// The address where the path continues.
    pub next: u32,
    /// The hint by register that ends the block, if one does.
    pub hint: Option<Instruction>,
}

impl Path {
    /// Makes a path of steps: address, word, instruction, and the address of the next one.
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
        Self { words: words.into(), ends: ends.into() }
    }
}
