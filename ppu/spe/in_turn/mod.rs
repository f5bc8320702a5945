//! SPE contexts for hosts without threads and libspe2: emulated SPEs, which run in turn.
//!
//! There is no clock of the host either. [`Instant`] counts how long [`Events::wait`] has waited in
//! vain, in which each SPE had its turns.

mod context;
mod events;
mod memory;

use std::cell::RefCell;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::time::Duration;

use spu_emulator::decrementer::Clock;
use spu_emulator::machine::Machine;
use spu_emulator::simulated::{SimulationOptions, Timing};

use super::SpeError;
use memory::HostMemory;

pub use context::{Context, Running};
pub use events::{Events, Instant};

thread_local! {
    static MACHINE: RefCell<Option<Arc<Machine>>> = const { RefCell::new(None) };
}

/// Makes a machine whose SPEs run in turn, in simulated time with these options or without.
/// Contexts that are created from now on are its SPEs.
pub fn use_machine(simulated: Option<SimulationOptions>) -> Arc<Machine> {
    let memory = Arc::new(HostMemory);
    let machine = match simulated {
        Some(options) => Machine::simulated_in_turn(memory, Timing::default(), options),
        None => Machine::in_turn(memory, Arc::new(Readings::default())),
    };
    MACHINE.set(Some(Arc::clone(&machine)));
    machine
}

/// A time base without simulated time, whose ticks are its readings.
#[derive(Default)]
struct Readings(AtomicU64);

impl Clock for Readings {
    fn ticks(&self) -> u64 {
        self.0.fetch_add(1, Relaxed)
    }

    fn host_time(&self, ticks: u64) -> Duration {
        Duration::from_millis(ticks)
    }
}

fn machine() -> Result<Arc<Machine>, SpeError> {
    let chosen = MACHINE.with_borrow(Clone::clone);
    chosen.ok_or_else(|| failed("use_machine", "no machine was chosen for SPEs"))
}

fn failed(
    call: &'static str,
    why: impl Into<Box<dyn std::error::Error + Send + Sync>>,
) -> SpeError {
    SpeError { call, source: std::io::Error::other(why) }
}
