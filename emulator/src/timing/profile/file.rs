//! The profile as a file: JSON, the same for equal runs.
//!
//! Invariant of a [`ProfileFile`] that was read: addresses are those of words of local store, words are
//! instructions, and each SPE's cycles are the sum of its instructions'.

use std::collections::BTreeMap;
use std::fmt;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use thiserror::Error;

use super::table::{Entry, Profile};
use super::tally::Tally;
use crate::isa::Instruction;
use crate::local_store::SIZE;
use crate::timing::account::{Cause, Stalls};

/// More than a machine runs in centuries: sums of what is smaller do not overflow.
const MAX_CYCLES: u128 = 1 << 60;

/// Tells programs apart: the 64-bit FNV-1a hash of the ELF file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ProgramId(u64);

impl ProgramId {
    /// Of a whole ELF file.
    #[must_use]
    pub fn of(image: &[u8]) -> Self {
        const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
        const PRIME: u64 = 0x0100_0000_01b3;
        let step = |hash: u64, &byte: &u8| (hash ^ u64::from(byte)).wrapping_mul(PRIME);
        Self(image.iter().fold(OFFSET, step))
    }
}

impl fmt::Display for ProgramId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

impl Serialize for ProgramId {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for ProgramId {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let digits = text.len() == 16 && text.bytes().all(|byte| byte.is_ascii_hexdigit());
        let hash = u64::from_str_radix(&text, 16).ok().filter(|_| digits);
        let unknown = || de::Error::custom(format_args!("no program {text:?}"));
        hash.map(Self).ok_or_else(unknown)
    }
}

/// Why a file is no profile.
#[derive(Debug, Error)]
pub enum ProfileError {
    /// Not JSON, or not this kind of it.
    #[error("no profile: {0}")]
    Json(#[from] serde_json::Error),
    /// An address outside local store or of no word.
    #[error("damaged profile: address {0:#x}")]
    Address(u32),
    /// A word that can't have issued.
    #[error("damaged profile: {word:#010x} at {address:#07x} is no instruction")]
    Word {
        /// Its address.
        address: u32,
        /// The word.
        word: u32,
    },
    /// Cycles that don't add up, or too many.
    #[error("damaged profile: the cycles of SPE {0} are not the sum of its instructions'")]
    Sum(usize),
}

/// An instruction's part.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct InstructionProfile {
    pub address: u32,
    pub word: u32,
    issued: u64,
    joined: u64,
    #[serde(with = "by_name")]
    stalls: Stalls,
}

impl InstructionProfile {
    fn new(entry: &Entry) -> Self {
        let tally = &entry.tally;
        Self {
            address: entry.pc,
            word: entry.instruction.encode(),
            issued: tally.issued,
            joined: tally.joined,
            stalls: tally.stalls.clone(),
        }
    }

    pub fn tally(&self) -> Tally {
        Tally {
            issued: self.issued,
            joined: self.joined,
            stalls: self.stalls.clone(),
        }
    }
}

/// What an SPE ran of one program; without a name what ran before any was loaded by libspe2.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct ProgramProfile {
    pub program: Option<ProgramId>,
    pub instructions: Vec<InstructionProfile>,
}

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct SpeProfile {
    cycles: u64,
    programs: Vec<ProgramProfile>,
}

/// The profile of a machine.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ProfileFile {
    cycles_per_second: u64,
    spes: Vec<SpeProfile>,
}

impl ProfileFile {
    pub(crate) fn new(cycles_per_second: u64) -> Self {
        Self {
            cycles_per_second,
            spes: Vec::new(),
        }
    }

    pub(crate) fn add_spe<'a>(
        &mut self,
        programs: impl Iterator<Item = (Option<ProgramId>, &'a Profile)>,
    ) {
        let programs: Vec<_> = programs
            .map(|(program, profile)| {
                let entries = profile.entries().iter();
                let mut instructions: Vec<_> = entries.map(InstructionProfile::new).collect();
                instructions.sort_by_key(|entry| (entry.address, entry.word));
                ProgramProfile {
                    program,
                    instructions,
                }
            })
            .collect();
        let instructions = programs.iter().flat_map(|program| &program.instructions);
        let cycles = instructions.map(|entry| entry.tally().cycles()).sum();
        self.spes.push(SpeProfile { cycles, programs });
    }

    /// Reads one.
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

    /// Cycles charged, of each SPE.
    pub fn cycles(&self) -> impl Iterator<Item = u64> {
        self.spes.iter().map(|spe| spe.cycles)
    }

    /// Everything that one SPE did, together.
    #[must_use]
    pub fn tally(&self, spe: usize) -> Tally {
        let mut tally = Tally::default();
        let programs = self.spes[spe].programs.iter();
        for entry in programs.flat_map(|program| &program.instructions) {
            tally.add(&entry.tally());
        }
        tally
    }

    pub(super) const fn cycles_per_second(&self) -> u64 {
        self.cycles_per_second
    }

    pub(super) fn programs(&self) -> impl Iterator<Item = &ProgramProfile> {
        self.spes.iter().flat_map(|spe| &spe.programs)
    }
}

/// Stalls as an object of the causes that cost cycles.
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
            let unknown = || de::Error::custom(format_args!("no cause {name:?}"));
            stalls.add(cause.ok_or_else(unknown)?, cycles);
        }
        Ok(stalls)
    }
}
