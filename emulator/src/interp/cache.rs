//! Decoded instructions, by address.
//!
//! Invariant: an entry's instruction is what its word decodes to. The word is compared with local
//! store on every fetch, so code that was rewritten or brought by DMA is never run stale.

use crate::local_store::SIZE;
use spu_isa::{Instruction, Machine};

const ENTRIES: usize = SIZE as usize / 4;

#[derive(Clone, Copy)]
struct Entry {
    word: u32,
    instruction: Option<Instruction>,
}

pub(super) struct DecodeCache {
    entries: Box<[Entry; ENTRIES]>,
    double_extension: bool,
}

impl DecodeCache {
    pub fn new(double_extension: bool) -> Self {
        let entry = Entry::of(0, double_extension);
        let entries = vec![entry; ENTRIES].into_boxed_slice();
        let Ok(entries) = entries.try_into() else {
            unreachable!("the vector was made with this length");
        };
        Self {
            entries,
            double_extension,
        }
    }

    /// The instruction in `word`, which was just fetched from `pc`; `None` if this machine has
    /// none.
    #[inline]
    pub fn get(&mut self, pc: u32, word: u32) -> Option<Instruction> {
        let entry = &mut self.entries[pc as usize / 4 % ENTRIES];
        if entry.word != word {
            *entry = Entry::of(word, self.double_extension);
        }
        entry.instruction
    }
}

impl Entry {
    #[cold]
    fn of(word: u32, double_extension: bool) -> Self {
        let instruction = Instruction::decode(word)
            .filter(|i| double_extension || i.op.row().machine == Machine::Every);
        Self { word, instruction }
    }
}
