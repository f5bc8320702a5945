//! The profile of a run: each cycle of the account, charged to an instruction.
//!
//! The cycles from the issue of the instruction before until an instruction issues are its own; the
//! second of a dual pair costs nothing. What an instruction holds up behind itself is its own too: a
//! branch its miss, a double-precision instruction its stall, `sync` its fetch, a channel instruction
//! the time that it sleeps. What an interrupt or a restart costs goes to the first instruction behind
//! it. Invariant: after every call the charges add up to the pipelines' account, cause by cause.

mod figures;
mod file;
mod json;
mod listing;
mod table;
mod tally;
mod view;

pub use figures::{FunctionFigures, LineFigures};
pub use file::{ProfileError, ProfileFile, ProgramId};
pub use tally::Tally;
pub use view::{View, ViewError};

pub(crate) use table::{Profile, Recording};
