//! Runs SPU code that was compiled for the host, and falls back to the interpreter for the rest.
//!
//! The interpreter is the reference: compiled code gives the same registers, local store, FPSCR,
//! stops and instruction counts. Hot code, which is entered often, is recorded as a trace and
//! compiled (`spu-jit`). All SPEs of a machine whose local stores hold the same code share
//! one translation. Each time a translation is entered, it compares its code with local store. So
//! stale code never runs, even if a store or DMA has replaced the code.

mod check;
mod dispatch;
#[cfg(target_arch = "wasm32")]
mod interpret;
mod record;
mod runner;
mod specials;
mod translations;

pub use check::Difference;
pub(crate) use dispatch::Dispatch;
pub use runner::Runner;
pub use translations::Translations;
