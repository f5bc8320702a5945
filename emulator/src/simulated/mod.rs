//! Simulated time: what several SPEs and the PPE do to each other happens in the order of their clocks.
//!
//! Each SPE has a clock in SPU cycles, which the pipeline model drives; each PPE thread that calls in
//! has one too. A turnstile lets whoever has the smallest clock act, wherever an act can be seen by
//! others: a mailbox, a signal, an event, an MFC command, an atomic line. Between acts an SPE runs
//! freely on its host thread, since its instructions reach its own registers and local store only.
//! Invariant: acts happen one at a time, in the order of (clock, rank), so that the same program gives
//! the same cycle counts however the host schedules its threads.
//!
//! Once local stores may be reached from outside ([`Simulation::serialise`]), SPEs run in short
//! spells, one at a time, again the one with the smallest clock first. A spell ends where the next
//! data from another SPE could lie in the local store, so that the SPU's loads find it from that
//! very cycle on.
//!
//! The PPE's own computing takes no simulated time; each call costs it [`PPE_CALL_CYCLES`], and being
//! woken [`PPE_WAKE_CYCLES`]. While a PPE thread is between two calls, SPEs run up to its clock and
//! wait there. What can't be foreseen is a thread that never calls again: see [`absence`]. That, and
//! what the PPE stores to memory while SPEs read it, are the places where two runs may differ.

pub mod absence;
mod arrivals;
mod calendar;
mod figures;
pub mod memory_system;
mod ppe;
mod published;
mod report;
mod spe_side;
mod spu_clock;
mod transfers;
mod turnstile;

use std::sync::{Arc, Mutex};
use std::time::Duration;

use crate::decrementer::TICKS_PER_SECOND;
use crate::memory::MainMemory;
use crate::mfc::Interconnect;
use crate::spe::lock::lock;
use crate::timing::profile::ProfileFile;
use memory_system::MemorySystem;
use published::Published;
use turnstile::Turnstile;

pub use figures::Figures;
pub use ppe::{PPE_CALL_CYCLES, PPE_RUN_CYCLES, PPE_WAKE_CYCLES};
pub use report::{Commands, Report, SpeReport, Waits};
pub use turnstile::WaitKey;

pub(crate) use arrivals::Parcel;
pub(crate) use memory_system::Peer;
pub(crate) use spe_side::SpeSide;
pub(crate) use spu_clock::{SpuClock, Timed, Wait};
pub(crate) use transfers::{Movement, Piece, Transfers};

/// Cycles of a decrementer tick. Source: cycle counts that programs print on a PlayStation 3 are
/// multiples of it. Firm.
pub const CYCLES_PER_TICK: u64 = 40;

/// The SPU's clock: 3.192 GHz.
pub const CYCLES_PER_SECOND: u64 = CYCLES_PER_TICK * TICKS_PER_SECOND;

/// Decrementer ticks in `cycles`.
#[must_use]
pub const fn ticks(cycles: u64) -> u64 {
    cycles / CYCLES_PER_TICK
}

/// The first cycle in which [`ticks`] has reached `ticks`.
#[must_use]
pub const fn cycle_of_tick(ticks: u64) -> u64 {
    ticks.saturating_mul(CYCLES_PER_TICK)
}

/// Cycles in `time`, to the microsecond; at least one.
pub(crate) fn cycles(time: Duration) -> u64 {
    let micros = u64::try_from(time.as_micros()).unwrap_or(u64::MAX);
    micros.saturating_mul(CYCLES_PER_SECOND / 1_000_000).max(1)
}

/// What the SPEs of one machine share in simulated time.
pub struct Simulation {
    turnstile: Arc<Turnstile>,
    /// Lives as long as the machine: PPE threads remember the machine by it.
    alive: Arc<()>,
    memory: Mutex<MemorySystem>,
    spes: Mutex<Vec<Arc<Mutex<Published>>>>,
    /// Whether the SPUs keep a profile.
    profiled: bool,
}

impl Simulation {
    fn new(profiled: bool) -> Arc<Self> {
        Arc::new(Self {
            turnstile: Arc::default(),
            alive: Arc::default(),
            memory: Mutex::default(),
            spes: Mutex::default(),
            profiled,
        })
    }

    /// The memory system. Only whoever has the turn may ask it for time.
    fn memory(&self) -> std::sync::MutexGuard<'_, MemorySystem> {
        lock(&self.memory)
    }

    /// A new SPE: its number, and where it publishes its figures.
    fn add_spe(&self) -> (u64, Arc<Mutex<Published>>) {
        let mut spes = lock(&self.spes);
        let published = Arc::new(Mutex::new(Published::new(self.profiled)));
        spes.push(Arc::clone(&published));
        (spes.len() as u64 - 1, published)
    }

    /// A key that nobody else waits on.
    #[must_use]
    pub fn new_key(&self) -> WaitKey {
        self.turnstile.new_key()
    }

    /// Has those who wait on `key` look again. Called by whoever acts.
    pub fn wake(&self, key: WaitKey) {
        self.turnstile.wake(key);
    }

    /// Whether data is under way between local stores.
    pub(crate) fn has_parcels(&self) -> bool {
        self.turnstile.arrivals.next() != turnstile::NEVER
    }

    /// What was sent to the `wanted` places is there at once, whatever its time.
    pub(crate) fn deliver_early(&self, wanted: impl Fn(&Parcel) -> bool) {
        self.turnstile.arrivals.deliver_early(wanted);
    }

    /// Somebody knows where a local store lies, and may reach into it while its SPU runs: from now on
    /// SPUs do not run side by side, so that they meet such data at the same time in every run.
    pub fn serialise(&self) {
        self.turnstile.serialise();
    }

    /// The figures of every SPE so far, in the order of their making: those that they published when
    /// they last slept in a channel or stopped.
    #[must_use]
    pub fn report(&self) -> Report {
        let spes = lock(&self.spes)
            .iter()
            .map(|published| lock(published).report().clone())
            .collect();
        Report {
            absences: self.turnstile.absences(),
            spes,
        }
    }

    /// The profile of every SPE, of the same moments as the [`report`](Self::report) is; `None` unless
    /// the machine was made to keep one.
    #[must_use]
    pub fn profile(&self) -> Option<ProfileFile> {
        self.profiled.then(|| {
            let mut file = ProfileFile::new(CYCLES_PER_SECOND);
            for published in &*lock(&self.spes) {
                file.add_spe(lock(published).programs());
            }
            file
        })
    }
}

impl Interconnect {
    /// A machine with this memory, in simulated time.
    #[must_use]
    pub fn simulated(memory: Arc<dyn MainMemory>) -> Arc<Self> {
        Self::with_simulation(memory, Simulation::new(false))
    }

    /// A machine with this memory, in simulated time, that keeps the [profile](Simulation::profile).
    #[must_use]
    pub fn profiled(memory: Arc<dyn MainMemory>) -> Arc<Self> {
        Self::with_simulation(memory, Simulation::new(true))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_and_cycles_agree() {
        assert_eq!(CYCLES_PER_SECOND, 3_192_000_000);
        assert_eq!(ticks(CYCLES_PER_SECOND), TICKS_PER_SECOND);
        assert_eq!((ticks(39), ticks(40), ticks(80)), (0, 1, 2));
        for tick in [1, 2, 399, 79_800_000, 1 << 40] {
            let cycle = cycle_of_tick(tick);
            assert_eq!((ticks(cycle - 1), ticks(cycle)), (tick - 1, tick));
        }
        assert_eq!(cycle_of_tick(u64::MAX), u64::MAX);
    }
}
