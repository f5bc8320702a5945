//! A profile for reports: charges in the order of addresses.

use super::program::ProgramId;
use super::table::{Entry, Profile};
use super::tally::Tally;

/// The charges of one instruction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InstructionProfile {
    /// The instruction's address.
    pub address: u32,
    /// The instruction's word.
    pub word: u32,
    /// The cost of the instruction.
    pub tally: Tally,
}

/// The instructions of one program that an SPE executed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProgramProfile {
    /// The program, or `None` for what ran before any program was
    /// [named](crate::spe::Spe::profile_as).
    pub program: Option<ProgramId>,
    /// The instructions by address and word, each pair once.
    pub instructions: Vec<InstructionProfile>,
}

impl ProgramProfile {
    pub(crate) fn new(program: Option<ProgramId>, profile: &Profile) -> Self {
        let entries = profile.entries().iter();
        let charge = |entry: &Entry| InstructionProfile {
            address: entry.pc,
            word: entry.instruction.encode(),
            tally: entry.tally.clone(),
        };
        let mut instructions: Vec<_> = entries.map(charge).collect();
        instructions.sort_by_key(|entry| (entry.address, entry.word));
        Self { program, instructions }
    }
}

/// The instructions that one SPE executed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SpeProfile {
    /// The programs, in the order in which they were loaded.
    pub programs: Vec<ProgramProfile>,
}

impl SpeProfile {
    /// The sum of all charged cycles.
    #[must_use]
    pub fn cycles(&self) -> u64 {
        let instructions = self.programs.iter().flat_map(|it| &it.instructions);
        instructions.map(|entry| entry.tally.cycles()).sum()
    }
}
