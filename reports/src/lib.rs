//! What is told of a run in simulated time: [`Figures`] of SPEs and the profile as a
//! [`ProfileFile`].
//!
//! The emulator counts; the formats are here, so that it needs no serialiser, and so that a file
//! means the same whoever wrote it: libspe2 for a program on it, or the tool `spu`.

mod figures;
mod profile;

pub use figures::Figures;
pub use profile::{InstructionEntry, ProfileError, ProfileFile, ProgramEntry};
