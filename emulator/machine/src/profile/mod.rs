//! The profile of a run: each cycle of the account is charged to an instruction.
//!
//! An instruction is charged the cycles from the issue of the previous instruction to its own
//! issue. The second instruction of a dual pair costs nothing. An instruction is also charged for
//! delays that it causes after itself: a branch for its miss, a double-precision instruction for
//! its stall, `sync` for its fetch, a channel instruction for the time that it sleeps. The cost of
//! an interrupt or a restart is charged to the first instruction after it. Invariant: after every
//! call the charges add up to the pipelines' account, cause by cause.

mod charges;
mod program;
mod table;
mod tally;

pub use charges::{InstructionProfile, ProgramProfile, SpeProfile};
pub use program::{NoProgramId, ProgramId};
pub use tally::Tally;

pub(crate) use table::{Profile, Recording};
