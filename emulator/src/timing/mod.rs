//! The SPU's pipelines: when each instruction issues, and where the cycles go.
//!
//! A separate pass over the instruction table. It knows addresses, registers and classes, nothing of
//! what instructions compute: [`Pipeline`] is fed the executed stream by whoever runs the program
//! ([`Timer`] does it for the interpreter), or the words of a file by the static analyser
//! ([`report`], [`check`]). The rules and their sources are in `docs/timing.md`; their numbers are in
//! [`rules`]. Invariant: every cycle up to the clock has exactly one entry in the [`Account`].
//!
//! Known weakness: nothing here was compared with the console. What no source settles is a switch in
//! [`Rules`].

mod account;
pub mod check;
pub mod code;
mod fetch;
mod hint;
mod hint_distance;
mod json;
mod lines;
mod listing;
mod loops;
mod pipeline;
pub mod profile;
mod recurrence;
pub mod report;
pub mod rules;
mod schedule;
mod timer;

pub use account::{Account, Cause, Stalls};
pub use hint_distance::{HintDistance, Verdict};
pub use loops::{Loop, Recurrence, Steady, find_loops};
pub use pipeline::{Issue, Pipeline};
pub use rules::Rules;
pub use schedule::{Line, Schedule, straight_line};
pub use timer::Timer;
