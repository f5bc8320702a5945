//! A profile as it is shown: charges in the order of addresses.

use super::program::ProgramId;
use super::table::{Entry, Profile};
use super::tally::Tally;

/// An instruction's part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InstructionProfile {
    /// Where it stood.
    pub address: u32,
    /// Its word.
    pub word: u32,
    /// What it cost.
    pub tally: Tally,
}

/// What an SPE ran of one program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProgramProfile {
    /// Which; nothing for what ran before any was [named](crate::spe::Spe::profile_as).
    pub program: Option<ProgramId>,
    /// By address and word, each pair once.
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
        Self {
            program,
            instructions,
        }
    }
}

/// What one SPE ran.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SpeProfile {
    /// Its programs, in the order of their loading.
    pub programs: Vec<ProgramProfile>,
}

impl SpeProfile {
    /// All cycles charged.
    #[must_use]
    pub fn cycles(&self) -> u64 {
        let instructions = self.programs.iter().flat_map(|it| &it.instructions);
        instructions.map(|entry| entry.tally.cycles()).sum()
    }
}
