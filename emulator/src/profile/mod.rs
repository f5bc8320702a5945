//! The profile of a run: each cycle of the account, charged to an instruction.
//!
//! The cycles from the issue of the instruction before until an instruction issues are its own;
//! the second of a dual pair costs nothing. What an instruction holds up behind itself is its own
//! too: a branch its miss, a double-precision instruction its stall, `sync` its fetch, a channel
//! instruction the time that it sleeps. What an interrupt or a restart costs goes to the first
//! instruction behind it. Invariant: after every call the charges add up to the pipelines'
//! account, cause by cause.

mod charges;
mod program;
mod table;
mod tally;

pub use charges::{InstructionProfile, ProgramProfile, SpeProfile};
pub use program::{NoProgramId, ProgramId};
pub use tally::Tally;

pub(crate) use table::{Profile, Recording};
