//! The reports about a run in simulated time: the [`Figures`] of SPEs, and the profile as a
//! [`ProfileFile`].
//!
//! The emulator counts, and this crate defines the formats. So the emulator needs no serialiser,
//! and a file has the same format whether libspe2 or the tool `spu` wrote it.

mod figures;
mod profile;

pub use figures::Figures;
pub use profile::{InstructionEntry, ProfileError, ProfileFile, ProgramEntry};
