//! Microbenchmarks of the Cell's pipelines, MFC and interconnect, in SPU assembly.
//!
//! The same program runs on a console through libspe2 and on the emulator, and times itself by the
//! SPU's decrementer. [`rows`] is the table: what each row measures, and what others measured on a
//! console. [`results`] is the file that the owner of a console can send, and [`document`] the page
//! that compares console and model.
//!
//! Invariant: the figures of the model are measured by the programs that measure a console, and
//! they are the same in every run.

pub mod document;
mod order;
pub mod results;
pub mod rows;
mod spes;

pub use spes::ClockError;

/// Cycles in a tick of the decrementer: 3.192 GHz against 79.8 MHz.
pub(crate) const CYCLES_PER_TICK: f64 = 40.0;
/// The SPU's clock in GHz.
pub(crate) const GIGAHERTZ: f64 = 3.192;
