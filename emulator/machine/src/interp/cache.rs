//! Decoded instructions, by address.
//!
//! Invariant: an entry's instruction is the decoding of its word. Every fetch compares the word
//! with local store, so code that was rewritten or loaded by DMA never runs stale.

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
    /// One bit for each entry: whether it is in a block that is in use elsewhere.
    in_blocks: Box<[u64]>,
    /// How often one of these entries has changed.
    code_changes: u64,
}

#[inline]
fn index(pc: u32) -> usize {
    pc as usize / 4 % ENTRIES
}

impl DecodeCache {
    pub fn new(double_extension: bool) -> Self {
        let entry = Entry::of(0, double_extension);
        let entries = vec![entry; ENTRIES].into_boxed_slice();
        let Ok(entries) = entries.try_into() else {
            unreachable!("the vector was made with this length");
        };
        Self { entries, double_extension, in_blocks: vec![0; ENTRIES / 64].into(), code_changes: 0 }
    }

    /// Whether `word` is the word that was decoded last at `pc`.
    #[inline]
    pub fn is_current(&self, pc: u32, word: u32) -> bool {
        self.entries[index(pc)].word == word
    }

    /// The instruction that was decoded last at `pc`. `None` if this machine has no such
    /// instruction.
    #[inline]
    pub fn latest(&self, pc: u32) -> Option<Instruction> {
        self.entries[index(pc)].instruction
    }

    /// Decodes `word`, which was fetched from `pc`.
    #[cold]
    pub fn decode(&mut self, pc: u32, word: u32) {
        let at = index(pc);
        self.entries[at] = Entry::of(word, self.double_extension);
        let (group, bit) = (&mut self.in_blocks[at / 64], 1 << (at % 64));
        if *group & bit != 0 {
            *group &= !bit;
            self.code_changes += 1;
        }
    }

    /// The instruction in `word` at `pc`. From now on it counts as part of a block.
    pub fn get_for_block(&mut self, pc: u32, word: u32) -> Option<Instruction> {
        if !self.is_current(pc, word) {
            self.decode(pc, word);
        }
        self.latest_for_block(pc)
    }

    /// What was decoded at `pc` last, which somebody remembers from now on.
    pub fn latest_for_block(&mut self, pc: u32) -> Option<Instruction> {
        let instruction = self.latest(pc)?;
        self.remember(pc);
        Some(instruction)
    }

    /// Whether `instruction` is the one that was decoded last at `pc`. If so, it counts as part of
    /// a block again.
    pub fn has_for_block(&mut self, pc: u32, instruction: Instruction) -> bool {
        let same = self.latest(pc) == Some(instruction);
        if same {
            self.remember(pc);
        }
        same
    }

    fn remember(&mut self, pc: u32) {
        let at = index(pc);
        self.in_blocks[at / 64] |= 1 << (at % 64);
    }

    pub fn code_changes(&self) -> u64 {
        self.code_changes
    }
}

impl Entry {
    fn of(word: u32, double_extension: bool) -> Self {
        let instruction = Instruction::decode(word)
            .filter(|i| double_extension || i.op.row().machine == Machine::Every);
        Self { word, instruction }
    }
}
