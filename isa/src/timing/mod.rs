//! The SPU's pipelines: when each instruction issues, and where the cycles go.
//!
//! A separate pass over the instruction table. It knows addresses, registers and classes, nothing
//! of what instructions compute: [`Pipeline`] is fed the executed stream by whoever runs the
//! program, or the words of a file by whoever analyses it ([`straight_line`], [`find_loops`]). The
//! rules and their sources are in `docs/timing.md`; their numbers are in [`rules`]. Invariant:
//! every cycle up to the clock has exactly one entry in the [`Account`].
//!
//! Known weakness: nothing here was compared with the console. What no source settles is a switch
//! in [`Rules`].

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
pub use hint::hinted_branch;
pub use hint_distance::{HintDistance, Verdict, hint_distances};
pub use loops::{Loop, Steady, find_loops};
pub use pipeline::{Issue, Pipeline, State};
pub use recurrence::Recurrence;
pub use rules::Rules;
pub use schedule::{Line, Schedule, straight_line};
