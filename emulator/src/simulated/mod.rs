//! Simulated time: what several SPEs and the PPE do to each other happens in the order of their
//! clocks.
//!
//! Each SPE has a clock in SPU cycles, which the pipeline model drives; each PPE thread that calls
//! in has one too. A turnstile lets whoever has the smallest clock act, wherever an act can be
//! seen by others: a mailbox, a signal, an event, an MFC command, an atomic line. Between acts an
//! SPE runs freely on its host thread, since its instructions reach its own registers and local
//! store only. Invariant: acts happen one at a time, in the order of (clock, rank), so that the
//! same program gives the same cycle counts however the host schedules its threads.
//!
//! Once local stores may be reached from outside ([`Simulation::serialise`]), SPEs run in short
//! spells, one at a time, again the one with the smallest clock first. A spell ends where the next
//! data from another SPE could lie in the local store, so that the SPU's loads find it from that
//! very cycle on.
//!
//! The PPE's own computing takes no simulated time; each call costs it cycles, and so does being
//! woken ([`PpeFigures`]). While a PPE thread is between two calls, SPEs run up to its clock and
//! wait there. What can't be foreseen is a thread that never calls again: see [`absence`]. That,
//! and what the PPE stores to memory while SPEs read it, are the places where two runs may differ.

pub mod absence;
mod arrivals;
mod calendar;
mod check;
mod figures;
mod memo;
mod memory_system;
mod path;
mod ppe;
mod published;
mod race;
mod report;
mod simulation;
mod spe_side;
mod spu_clock;
mod time;
mod timed;
mod transfers;
mod turnstile;

pub use check::Difference;
pub use figures::{Keep, MemoryFigures, Method, PpeFigures, Timing};
pub use race::WaitKey;
pub use report::{Report, SpeReport, Waits};
pub use simulation::Simulation;
pub use time::{CYCLES_PER_SECOND, CYCLES_PER_TICK, cycle_of_tick, ticks};

pub(crate) use path::Path;
pub(crate) use spe_side::SpeSide;
pub(crate) use spu_clock::{SpuClock, Wait};
pub(crate) use time::cycles;
pub(crate) use timed::Timed;
