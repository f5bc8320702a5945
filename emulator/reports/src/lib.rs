//! The reports about a run in simulated time: the [`Figures`] of SPEs, the profile as a
//! [`ProfileFile`], and the timeline as a [`TimelineFile`]. With the feature `views`, a profile by
//! functions and lines, as text and JSON.
//!
//! The emulator counts, and this crate defines the formats. So the emulator needs no serialiser,
//! and a file has the same format whether libspe2 or the tool `spu` wrote it.

mod figures;
mod profile;
mod timeline;
#[cfg(feature = "views")]
pub mod views;

pub use figures::Figures;
pub use profile::{InstructionEntry, ProfileError, ProfileFile, ProgramEntry};
pub use timeline::{SleepEntry, SpeTimeline, TimelineFile, TransferEntry};
