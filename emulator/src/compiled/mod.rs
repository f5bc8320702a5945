//! Runs SPU code that was compiled for the host, and leaves the rest to the interpreter.
//!
//! The interpreter is the definition: what runs here gives the same registers, local store, FPSCR,
//! stops and counts. Code that was entered often is recorded as a trace and compiled
//! (`spu-compiler`); one translation serves all SPEs of a machine whose local stores hold the same
//! code. A translation compares its code with local store each time it is entered, so code that was
//! rewritten or brought by DMA is never run stale.

mod check;
mod record;
mod runner;
mod specials;
mod translations;
mod turn;

pub use check::Difference;
pub use runner::Runner;
pub use translations::Translations;
pub(crate) use turn::Turn;
