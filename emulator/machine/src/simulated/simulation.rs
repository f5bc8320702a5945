//! The state that the SPEs of one machine share: the scheduler, the memory system, the published
//! figures.

use std::sync::{Arc, Mutex, MutexGuard};

use super::actor_table::WaitKey;
use super::check::Difference;
use super::figures::{SimulationOptions, Timing};
use super::memory_system::MemorySystem;
use super::published::Published;
use super::races::{Race, RaceReports};
use super::report::Report;
use super::scheduler::Scheduler;
use super::time::NEVER;
use super::timeline::Timeline;
use crate::in_turn::Turns;
use crate::local_store::LocalStore;
use crate::lock::lock;
use crate::mfc::timing::{InFlight, PendingWrite};
use crate::profile::SpeProfile;

/// The state that the SPEs of one machine share in simulated time.
pub struct Simulation {
    scheduler: Arc<Scheduler>,
    /// Lives as long as the machine. PPE threads identify the machine by it.
    alive: Arc<()>,
    timing: Timing,
    memory: Mutex<MemorySystem>,
    spes: Mutex<Vec<Arc<Mutex<Published>>>>,
    options: SimulationOptions,
    difference: Mutex<Option<Difference>>,
    races: RaceReports,
}

impl Simulation {
    pub(crate) fn new(timing: Timing, options: SimulationOptions) -> Arc<Self> {
        Self::scheduled(timing, options, Scheduler::new(timing.memory.local_store_delay(), None))
    }

    /// One whose SPEs run in turn.
    pub(crate) fn in_turn(
        timing: Timing,
        options: SimulationOptions,
        turns: Arc<Turns>,
    ) -> Arc<Self> {
        let delay = timing.memory.local_store_delay();
        Self::scheduled(timing, options, Scheduler::new(delay, Some(turns)))
    }

    fn scheduled(timing: Timing, options: SimulationOptions, scheduler: Scheduler) -> Arc<Self> {
        Arc::new(Self {
            scheduler: Arc::new(scheduler),
            alive: Arc::default(),
            timing,
            memory: Mutex::new(MemorySystem::new(timing.memory)),
            spes: Mutex::default(),
            options,
            difference: Mutex::default(),
            races: RaceReports::default(),
        })
    }

    /// The latencies and rates of this machine.
    #[must_use]
    pub fn timing(&self) -> &Timing {
        &self.timing
    }

    /// Its records, and its method of counting cycles.
    #[must_use]
    pub fn options(&self) -> SimulationOptions {
        self.options
    }

    /// The first difference between the two methods of counting, if an SPE that
    /// [checks](super::Method::Checked) has found one.
    #[must_use]
    pub fn difference(&self) -> Option<Difference> {
        lock(&self.difference).clone()
    }

    pub(super) fn report_difference(&self, difference: &Difference) {
        lock(&self.difference).get_or_insert_with(|| difference.clone());
    }

    /// Has `report` called for each race between an SPU and its own DMA commands, once for each
    /// pair of instructions, if the [options](SimulationOptions::races) ask for it. The thread that
    /// runs the SPU calls it. Only the first receiver of a machine is called.
    pub fn on_race(&self, report: impl Fn(&Race) + Send + Sync + 'static) {
        self.races.set(Box::new(report));
    }

    pub(super) fn report_race(&self, race: &Race) {
        self.races.report(race);
    }

    pub(super) fn scheduler(&self) -> &Arc<Scheduler> {
        &self.scheduler
    }

    /// Lives as long as the machine.
    pub(super) fn alive(&self) -> &Arc<()> {
        &self.alive
    }

    /// The memory system. Only the actor that has the turn may use it.
    pub(super) fn memory(&self) -> MutexGuard<'_, MemorySystem> {
        lock(&self.memory)
    }

    /// Adds an SPE. Returns its number, and the place where it publishes its figures.
    pub(super) fn add_spe(&self) -> (u64, Arc<Mutex<Published>>) {
        let mut spes = lock(&self.spes);
        let published = Arc::new(Mutex::new(Published::new(self.options)));
        spes.push(Arc::clone(&published));
        (spes.len() as u64 - 1, published)
    }

    /// A new key that no other actor waits on.
    #[must_use]
    pub fn new_key(&self) -> WaitKey {
        self.scheduler.new_key()
    }

    /// Makes the actors that sleep on `key` poll again. Only the acting actor calls it.
    pub fn wake(&self, key: WaitKey) {
        self.scheduler.wake(key);
    }

    /// Delivers the selected data in flight at once, whatever its arrival time.
    pub(crate) fn deliver_early(&self, wanted: impl Fn(&PendingWrite) -> bool) {
        self.scheduler.arrivals.deliver_early(wanted);
    }

    /// Must be called when a local store can be accessed from outside while its SPU runs. From now
    /// on SPUs run one at a time, so that they see such data at the same time in every run.
    pub fn serialise(&self) {
        self.scheduler.serialise();
    }

    /// The figures of every SPE so far, in the order of creation. An SPE publishes them when it
    /// sleeps in a channel or stops.
    #[must_use]
    pub fn report(&self) -> Report {
        let spes =
            lock(&self.spes).iter().map(|published| lock(published).report().clone()).collect();
        Report { timeouts: self.scheduler.timeouts(), spes }
    }

    /// The profile of every SPE, published at the same moments as the [`report`](Self::report).
    /// `None` if the machine does not record one.
    #[must_use]
    pub fn profile(&self) -> Option<Vec<SpeProfile>> {
        self.options.profile.then(|| {
            let spes = lock(&self.spes);
            spes.iter().map(|spe| lock(spe).profile()).collect()
        })
    }

    /// The timeline of every SPE so far. `None` if the machine does not record one.
    #[must_use]
    pub fn timeline(&self) -> Option<Vec<Timeline>> {
        let spes = lock(&self.spes);
        let timeline = |spe: &Arc<Mutex<Published>>| lock(spe).timeline().cloned();
        spes.iter().map(timeline).collect()
    }
}

impl InFlight for Simulation {
    fn is_empty(&self) -> bool {
        self.scheduler.arrivals.next() == NEVER
    }

    fn deliver_early(&self, store: &LocalStore, address: u32, length: usize) {
        self.deliver_early(|write| write.overlaps(store, address, length));
    }
}
