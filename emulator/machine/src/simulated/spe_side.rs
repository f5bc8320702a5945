//! One SPE as an actor: its start and end, its acts, and the figures that it publishes.

use std::cell::RefCell;
use std::sync::atomic::Ordering::SeqCst;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use portable_atomic::AtomicU64;

use super::actor_table::{Rank, WaitKey};
use super::published::Published;
use super::races::{LoadedProgram, Races};
use super::scheduler::Actor;
use super::simulation::Simulation;
use super::spu_clock::{SpuClock, Wait};
use super::timeline::Timeline;
use super::transfers::SpuTransfers;
use crate::lock::lock;
use crate::mfc::command::{Command, Operation};
use crate::mfc::interconnect::Interconnect;
use crate::mfc::spu_side::SpuSide;
use crate::mfc::timing::{Movement, Peer, TransferTimes};
use crate::profile::ProgramId;
use crate::stop::Stop;

/// The SPE's state for simulated time, except its clock, which belongs to the thread that runs the
/// SPU.
pub(crate) struct SpeSide {
    pub simulation: Arc<Simulation>,
    /// The number of the SPE, in the order of creation.
    number: u64,
    pub actor: Actor,
    /// When the SPE last became ready to run.
    ready: AtomicU64,
    /// The key on which actors wait for a change of this SPE.
    key: WaitKey,
    /// The data that MFC commands have moved since the last timing.
    pub moved: Mutex<Vec<Movement>>,
    published: Arc<Mutex<Published>>,
    program: LoadedProgram,
    /// Where SPEs run in turn: what the SPU sleeps for.
    sleeps_in: Mutex<Option<Wait>>,
}

impl SpeSide {
    pub fn new(simulation: &Arc<Simulation>) -> Self {
        let (number, published) = simulation.add_spe();
        Self {
            simulation: Arc::clone(simulation),
            number,
            actor: Actor::spe(simulation.scheduler(), Rank::spe(number)),
            ready: AtomicU64::new(0),
            key: simulation.new_key(),
            moved: Mutex::default(),
            published,
            program: LoadedProgram::default(),
            sleeps_in: Mutex::default(),
        }
    }

    /// A new clock for the SPU.
    pub fn new_clock(&self) -> SpuClock {
        SpuClock::new(self.simulation.timing().rules, self.simulation.options())
    }

    /// Looks for races between the SPU and its commands.
    pub fn new_races(&self) -> Races {
        Races::new(&self.simulation, &self.program)
    }

    /// The timing of the SPU's MFC commands.
    pub fn new_transfers(&self) -> Box<dyn TransferTimes> {
        Box::new(SpuTransfers::new(self.number, &self.simulation))
    }

    /// Cycles from the call that runs an SPE to its first instruction.
    fn start_cycles(&self) -> u64 {
        let ppe = &self.simulation.timing().ppe;
        ppe.call_cycles + ppe.run_cycles
    }

    pub fn key(&self) -> WaitKey {
        self.key
    }

    /// The SPE will be run soon. Until then no clock passes the earliest clock at which it could
    /// start.
    pub fn expect(&self) {
        let ready = self.simulation.this_thread(None).resume();
        let ready = ready.max(self.ready.fetch_max(ready, SeqCst));
        self.actor.expect(ready + self.start_cycles());
    }

    /// Makes this thread the SPU. It starts at the thread's own clock. If the thread is new, it
    /// starts at the time at which the SPE became ready, which does not depend on when the host
    /// starts the thread.
    pub fn start(&self, clock: &RefCell<SpuClock>) {
        let ready = self.ready.load(SeqCst);
        let thread = self.simulation.this_thread(Some(ready));
        let begins = ready.max(thread.resume()) + self.start_cycles();
        clock.borrow_mut().start(begins);
        thread.actor().hand_over_to(&self.actor, begins);
    }

    /// The SPU has stopped. `announce` notifies other threads, and the thread becomes a PPE thread
    /// again.
    pub fn end(&self, clock: &RefCell<SpuClock>, mfc: &SpuSide, announce: impl FnOnce()) {
        self.actor.turn(clock.borrow().now());
        self.publish(clock, mfc);
        clock.borrow_mut().stop();
        if let Some(difference) = clock.borrow().difference() {
            self.simulation.report_difference(difference);
        }
        announce();
        let back = self.actor.clock() + self.simulation.timing().ppe.wake_cycles;
        self.ready.store(back, SeqCst);
        let thread = self.simulation.this_thread(Some(back));
        self.actor.hand_over_to(thread.actor(), back);
    }

    /// Begins a program that runs in turn.
    pub fn begin(&self, clock: &RefCell<SpuClock>) {
        self.expect();
        clock.borrow_mut().start(self.actor.clock());
    }

    /// The SPU goes on, as the leader, after what it waited for.
    pub fn resume(&self, clock: &RefCell<SpuClock>) {
        let now = self.actor.resume();
        if let Some(wait) = lock(&self.sleeps_in).take() {
            self.sleep_until(clock, now, wait);
        }
    }

    /// A program that runs in turn has stopped.
    pub fn end_in_turn(&self, clock: &RefCell<SpuClock>, mfc: &SpuSide) {
        self.publish(clock, mfc);
        clock.borrow_mut().stop();
        self.actor.leave();
    }

    /// Waits for the SPU's turn. Where SPEs run in turn, it is an error if others come first.
    pub fn turn(&self, clock: &RefCell<SpuClock>) -> Result<(), Stop> {
        let now = clock.borrow().now();
        if !self.actor.is_in_turn() {
            self.actor.turn(now);
        } else if !self.actor.has_turn(now) {
            return Err(Stop::Waits);
        }
        Ok(())
    }

    /// Whether puts may be deferred: not if SPUs run one at a time, and not if a timeline records
    /// them in their order.
    pub fn may_defer(&self) -> bool {
        !self.actor.is_serial() && !self.actor.is_in_turn() && !self.simulation.options().timeline
    }

    /// Waits until this SPE's deferred puts of these tags have been carried out.
    pub fn await_deferred(&self, clock: &RefCell<SpuClock>, tags: u32) {
        if self.actor.deferred() > 0 {
            self.actor.await_deferred(clock.borrow().now(), tags);
        }
    }

    /// Sleeps until another actor changes this SPE, or until `limit`. Where SPEs run in turn, that
    /// is an error, and the SPU is run again then.
    pub fn sleep(
        &self,
        clock: &RefCell<SpuClock>,
        wait: Wait,
        limit: Option<u64>,
        pause: Option<Duration>,
    ) -> Result<(), Stop> {
        if self.actor.is_in_turn() {
            *lock(&self.sleeps_in) = Some(wait);
            self.actor.fall_asleep(self.key, limit);
            return Err(Stop::Waits);
        }
        let now = self.actor.sleep(self.key, limit, pause);
        self.sleep_until(clock, now, wait);
        Ok(())
    }

    /// Lets the SPU sleep until `cycle`, whatever other actors do.
    pub fn sleep_until(&self, clock: &RefCell<SpuClock>, cycle: u64, wait: Wait) {
        let began = clock.borrow().now();
        clock.borrow_mut().sleep(cycle, wait);
        self.record(|timeline| timeline.sleep(began, cycle, wait));
    }

    /// Adds to the timeline, if there is one.
    fn record(&self, add: impl FnOnce(&mut Timeline)) {
        if self.simulation.options().timeline {
            lock(&self.published).timeline().map(add);
        }
    }

    /// Times the commands that were just carried out.
    pub fn time_movements(
        &self,
        mfc: &mut SpuSide,
        now: u64,
        interconnect: &Interconnect,
        races: &mut Races,
    ) {
        let moved = std::mem::take(&mut *lock(&self.moved));
        if !moved.is_empty() {
            mfc.change_transfers(|transfers| {
                for movement in moved {
                    let Command { operation, ea, .. } = movement.command;
                    let mut peers = movement.pieces.iter().map(|piece| piece.peer);
                    let only_memory = peers.all(|peer| peer == Peer::Memory);
                    let bytes = movement.pieces.iter().map(|piece| u64::from(piece.size));
                    let bytes = bytes.sum();
                    let given = races.give(&movement);
                    let complete = transfers.add(movement, now);
                    if let Some(given) = given {
                        races.is_complete_at(given, complete);
                    }
                    self.record(|timeline| {
                        timeline.transfer((now, complete), operation, ea, bytes);
                    });
                    if operation == Operation::SendSignal {
                        interconnect.signal_arrives(ea, complete);
                    } else if !only_memory {
                        self.simulation.serialise();
                    }
                }
            });
            self.actor.expect_arrivals();
        }
    }

    /// Publishes the current figures.
    pub fn publish(&self, clock: &RefCell<SpuClock>, mfc: &SpuSide) {
        let commands = mfc.transfers().map(|transfers| transfers.commands());
        let commands = commands.unwrap_or_default();
        lock(&self.published).publish(&mut clock.borrow_mut(), commands);
    }

    /// From now on, figures belong to this program.
    pub fn load(&self, program: ProgramId) {
        lock(&self.published).load(program);
        *lock(&self.program) = Some(program);
    }
}
