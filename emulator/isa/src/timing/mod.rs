//! The SPU's pipelines: when each instruction issues, and where the cycles go.
//!
//! This is a separate pass over the instruction table. It uses addresses, registers and classes,
//! but not the results of instructions. [`Pipeline`] is fed the executed stream by the code that
//! runs the program. An analysis of a file feeds it the file's words ([`straight_line`],
//! [`find_loops`]). The rules and their sources are in `docs/timing.md`, their numbers in
//! [`rules`]. Invariant: every cycle up to the clock has exactly one entry in the [`Account`].
//!
//! Known weakness: nothing here was compared with the console. Rules that no source documents
//! are switches in [`Rules`].

mod account;
mod fetch;
mod hint;
mod hint_distance;
mod loops;
mod pipeline;
mod recurrence;
pub mod rules;
mod schedule;

pub use account::{Account, AccountDelta, Cause, Stalls};
pub use hint::{hinted_branch, hints_by_register};
pub use hint_distance::{HintDistance, Verdict, hint_distances};
pub use loops::{Loop, Steady, find_loops};
pub use pipeline::{Issue, Pipeline, State};
pub use recurrence::Recurrence;
pub use rules::Rules;
pub use schedule::{Line, Schedule, straight_line};
