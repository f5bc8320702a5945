//! What the SPEs of one machine share: the race, the memory system, the figures that they show.

use std::sync::{Arc, Mutex, MutexGuard};

use super::check::Difference;
use super::figures::{Keep, Timing};
use super::memory_system::MemorySystem;
use super::published::Published;
use super::race::WaitKey;
use super::report::Report;
use super::time::NEVER;
use super::turnstile::Turnstile;
use crate::local_store::LocalStore;
use crate::lock::lock;
use crate::mfc::timing::{Parcel, UnderWay};
use crate::profile::SpeProfile;

/// What the SPEs of one machine share in simulated time.
pub struct Simulation {
    turnstile: Arc<Turnstile>,
    /// Lives as long as the machine: PPE threads remember the machine by it.
    alive: Arc<()>,
    timing: Timing,
    memory: Mutex<MemorySystem>,
    spes: Mutex<Vec<Arc<Mutex<Published>>>>,
    keep: Keep,
    difference: Mutex<Option<Difference>>,
}

impl Simulation {
    pub(crate) fn new(timing: Timing, keep: Keep) -> Arc<Self> {
        let delay = timing.memory.local_store_delay();
        Arc::new(Self {
            turnstile: Arc::new(Turnstile::new(delay)),
            alive: Arc::default(),
            timing,
            memory: Mutex::new(MemorySystem::new(timing.memory)),
            spes: Mutex::default(),
            keep,
            difference: Mutex::default(),
        })
    }

    /// The figures that its cycles come from.
    #[must_use]
    pub fn timing(&self) -> &Timing {
        &self.timing
    }

    /// What it keeps, and how it counts.
    #[must_use]
    pub fn keep(&self) -> Keep {
        self.keep
    }

    /// The first difference between the two ways of counting, if an SPE that
    /// [checks](super::Method::Checked) has found one.
    #[must_use]
    pub fn difference(&self) -> Option<Difference> {
        lock(&self.difference).clone()
    }

    pub(super) fn tell_difference(&self, difference: &Difference) {
        lock(&self.difference).get_or_insert_with(|| difference.clone());
    }

    pub(super) fn turnstile(&self) -> &Arc<Turnstile> {
        &self.turnstile
    }

    /// Lives as long as the machine.
    pub(super) fn alive(&self) -> &Arc<()> {
        &self.alive
    }

    /// The memory system. Only whoever has the turn may ask it for time.
    pub(super) fn memory(&self) -> MutexGuard<'_, MemorySystem> {
        lock(&self.memory)
    }

    /// A new SPE: its number, and where it publishes its figures.
    pub(super) fn add_spe(&self) -> (u64, Arc<Mutex<Published>>) {
        let mut spes = lock(&self.spes);
        let published = Arc::new(Mutex::new(Published::new(self.keep.profile)));
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

    /// What was sent to the `wanted` places is there at once, whatever its time.
    pub(crate) fn deliver_early(&self, wanted: impl Fn(&Parcel) -> bool) {
        self.turnstile.arrivals.deliver_early(wanted);
    }

    /// Somebody knows where a local store lies, and may reach into it while its SPU runs: from now
    /// on SPUs do not run side by side, so that they meet such data at the same time in every run.
    pub fn serialise(&self) {
        self.turnstile.serialise();
    }

    /// The figures of every SPE so far, in the order of their making: those that they published
    /// when they last slept in a channel or stopped.
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

    /// The profile of every SPE, of the same moments as the [`report`](Self::report) is; `None`
    /// unless the machine was made to keep one.
    #[must_use]
    pub fn profile(&self) -> Option<Vec<SpeProfile>> {
        self.keep.profile.then(|| {
            let spes = lock(&self.spes);
            spes.iter().map(|spe| lock(spe).profile()).collect()
        })
    }
}

impl UnderWay for Simulation {
    fn is_empty(&self) -> bool {
        self.turnstile.arrivals.next() == NEVER
    }

    fn deliver_early(&self, store: &LocalStore, address: u32, length: usize) {
        self.deliver_early(|parcel| parcel.meets(store, address, length));
    }
}
