//! Simulated time: SPEs and PPE threads affect each other in the order of their simulated clocks.
//!
//! Each SPE has a clock in SPU cycles, which the pipeline model drives. Each PPE thread that calls
//! the library has one too. They are the actors. An action that other actors can see is an act: on
//! a mailbox, a signal, an event, an MFC command or an atomic line. A scheduler lets the actor
//! with the smallest clock act. Between acts an SPE runs freely on its host thread, because its
//! instructions access only its own registers and local store. Invariant: acts happen one at a
//! time, in the order of (clock, rank). So the same program takes the same number of cycles,
//! however the host schedules its threads.
//!
//! Once local stores can be accessed from outside ([`Simulation::serialise`]), SPEs run in short
//! time slices, one at a time, the one with the smallest clock first. A time slice ends where data
//! from another SPE could next arrive in the local store. So the SPU's loads find the data from
//! exactly that cycle on.
//!
//! The PPE's own computations take no simulated time. Each call costs cycles, and so does each
//! wake-up ([`PpeFigures`]). While a PPE thread is between two calls, SPEs run up to its clock and
//! wait there. The scheduler can't foresee that a thread never calls again: see [`timeout`]. Two
//! runs may differ for that reason, and if the PPE stores to memory that SPEs read at the same
//! time.

mod actor_table;
mod arrivals;
mod check;
mod figures;
mod host_threads;
mod memo;
mod memory_system;
mod path;
mod ppe;
mod published;
mod races;
mod report;
mod reservation_table;
mod scheduler;
mod simulation;
mod spe_side;
mod spu_clock;
mod time;
mod timed;
mod timeline;
pub mod timeout;
#[cfg(feature = "timing-file")]
mod timing_file;
mod transfers;

pub use actor_table::WaitKey;
pub use check::Difference;
pub use figures::{MemoryFigures, Method, PpeFigures, SimulationOptions, Timing};
pub use host_threads::HelperThread;
pub use races::{CommandInFlight, Marks, Race, Use, command_name};
pub use report::{Report, SpeReport, Waits};
pub use simulation::Simulation;
pub use time::{CYCLES_PER_SECOND, CYCLES_PER_TICK, Tenths, cycle_of_tick, ticks};
pub use timeline::{Sleep, Timeline, Transfer};
#[cfg(feature = "timing-file")]
pub use timing_file::TimingFileError;

pub(crate) use path::Path;
pub(crate) use races::Races;
pub(crate) use spe_side::SpeSide;
pub(crate) use spu_clock::{SpuClock, Wait};
pub(crate) use time::cycles;
pub(crate) use timed::Timed;
