//! The profile as a JSON file. Equal runs produce equal files.
//!
//! Invariant of a [`ProfileFile`] that was read: addresses are those of words in local store,
//! words are instructions, and each SPE's cycles are the sum of its instructions' cycles.

use std::collections::BTreeMap;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use spu_emulator::local_store::SIZE;
use spu_emulator::profile::{InstructionProfile, ProgramId, SpeProfile, Tally};
use spu_isa::Instruction;
use spu_isa::timing::{Cause, Stalls};
use thiserror::Error;

/// More cycles than a machine runs in centuries. Sums of smaller numbers do not overflow.
const MAX_CYCLES: u128 = 1 << 60;

/// Why a file is not a valid profile.
#[derive(Debug, Error)]
pub enum ProfileError {
    /// Not JSON, or JSON of another format.
    #[error("not a profile: {0}")]
    Json(#[from] serde_json::Error),
    /// An address that is outside local store or not a multiple of 4.
    #[error("damaged profile: address {0:#x}")]
    Address(u32),
    /// A word that is not an instruction.
    #[error("damaged profile: {word:#010x} at {address:#07x} is not an instruction")]
    Word {
        /// The word's address.
        address: u32,
        /// The word.
        word: u32,
    },
    /// Cycles that are not the sum of the parts, or too many.
    #[error("damaged profile: the cycles of SPE {0} are not the sum of its instructions'")]
    Sum(usize),
}

/// The entry of one instruction.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct InstructionEntry {
    /// The instruction's address.
    pub address: u32,
    /// The instruction's word.
    pub word: u32,
    issued: u64,
    joined: u64,
    #[serde(with = "by_name")]
    stalls: Stalls,
}

impl InstructionEntry {
    fn new(entry: &InstructionProfile) -> Self {
        let tally = &entry.tally;
        Self {
            address: entry.address,
            word: entry.word,
            issued: tally.issued,
            joined: tally.joined,
            stalls: tally.stalls.clone(),
        }
    }

    /// The cost of the instruction.
    #[must_use]
    pub fn tally(&self) -> Tally {
        Tally { issued: self.issued, joined: self.joined, stalls: self.stalls.clone() }
    }
}

/// What an SPE ran of one program. Without `program`, it is code that ran before libspe2 loaded a
/// program.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ProgramEntry {
    /// The program.
    #[serde(default, with = "by_text")]
    pub program: Option<ProgramId>,
    /// The instructions by address and word.
    pub instructions: Vec<InstructionEntry>,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct SpeEntry {
    cycles: u64,
    programs: Vec<ProgramEntry>,
}

impl SpeEntry {
    fn new(spe: &SpeProfile) -> Self {
        let programs = spe.programs.iter().map(|program| ProgramEntry {
            program: program.program,
            instructions: program.instructions.iter().map(InstructionEntry::new).collect(),
        });
        Self { cycles: spe.cycles(), programs: programs.collect() }
    }
}

/// The profile of a machine.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ProfileFile {
    cycles_per_second: u64,
    spes: Vec<SpeEntry>,
}

impl ProfileFile {
    /// Creates the profile from what each SPE ran.
    #[must_use]
    pub fn new(cycles_per_second: u64, spes: &[SpeProfile]) -> Self {
        Self { cycles_per_second, spes: spes.iter().map(SpeEntry::new).collect() }
    }

    /// Reads a profile from JSON.
    pub fn parse(text: &[u8]) -> Result<Self, ProfileError> {
        let file: Self = serde_json::from_slice(text)?;
        let mut total = 0;
        for (number, spe) in file.spes.iter().enumerate() {
            let mut cycles: u128 = 0;
            let (mut issuing, mut joined): (u128, u128) = (0, 0);
            for entry in spe.programs.iter().flat_map(|it| &it.instructions) {
                let (address, word) = (entry.address, entry.word);
                if address % 4 != 0 || address >= SIZE {
                    return Err(ProfileError::Address(address));
                }
                if Instruction::decode(word).is_none() {
                    return Err(ProfileError::Word { address, word });
                }
                let alone = entry.issued.checked_sub(entry.joined);
                let alone = alone.ok_or(ProfileError::Sum(number))?;
                issuing += u128::from(alone);
                joined += u128::from(entry.joined);
                let stalls = Cause::all().map(|cause| u128::from(entry.stalls.of(cause)));
                cycles += u128::from(alone) + stalls.sum::<u128>();
            }
            total += cycles;
            if cycles != u128::from(spe.cycles) || joined > issuing || total > MAX_CYCLES {
                return Err(ProfileError::Sum(number));
            }
        }
        Ok(file)
    }

    /// The cycles charged on each SPE.
    pub fn cycles(&self) -> impl Iterator<Item = u64> {
        self.spes.iter().map(|spe| spe.cycles)
    }

    /// The sum of everything that one SPE did.
    #[must_use]
    pub fn tally(&self, spe: usize) -> Tally {
        let mut tally = Tally::default();
        let programs = self.spes[spe].programs.iter();
        for entry in programs.flat_map(|program| &program.instructions) {
            tally.add(&entry.tally());
        }
        tally
    }

    /// The frequency of the clock that the cycles count.
    #[must_use]
    pub const fn cycles_per_second(&self) -> u64 {
        self.cycles_per_second
    }

    /// The programs that each SPE ran.
    pub fn programs(&self) -> impl Iterator<Item = &ProgramEntry> {
        self.spes.iter().flat_map(|spe| &spe.programs)
    }
}

/// Serialises a program's identity as hexadecimal digits.
mod by_text {
    use super::{Deserialize, Deserializer, ProgramId, Serialize, Serializer, de};

    pub fn serialize<S: Serializer>(
        program: &Option<ProgramId>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        let text = program.map(|program| program.to_string());
        text.serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Option<ProgramId>, D::Error> {
        let text = Option::<String>::deserialize(deserializer)?;
        text.map(|text| text.parse().map_err(de::Error::custom)).transpose()
    }
}

/// Serialises stalls as an object with the causes that cost cycles.
mod by_name {
    use super::{BTreeMap, Cause, Deserialize, Deserializer, Serializer, Stalls, de};

    pub fn serialize<S: Serializer>(stalls: &Stalls, serializer: S) -> Result<S::Ok, S::Error> {
        let stalls = stalls.by_cost().into_iter();
        serializer.collect_map(stalls.map(|(cause, cycles)| (cause.to_string(), cycles)))
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Stalls, D::Error> {
        let mut stalls = Stalls::default();
        for (name, cycles) in BTreeMap::<String, u64>::deserialize(deserializer)? {
            let cause = Cause::all().find(|cause| cause.to_string() == name);
            let unknown = || de::Error::custom(format_args!("unknown cause {name:?}"));
            stalls.add(cause.ok_or_else(unknown)?, cycles);
        }
        Ok(stalls)
    }
}
