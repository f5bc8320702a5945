//! One SPE: the SPU, its local store and MFC, and the PPE's side of them.
//!
//! An [`Spe`] is shared. One thread at a time runs the SPU ([`Spe::run`]), and any thread may use
//! the PPE's side. Waiting threads sleep. A stop request wakes the SPU wherever it sleeps.
//!
//! Locks are taken in this order: the SPU's own state or the proxy queue, the interconnect, the
//! problem state. No transfer is made while the problem state's lock is held.
//!
//! [`Spe`] and the files of this folder depend on each other, because they are its parts:
//! `running` and `proxy` borrow the whole SPE while they work.

mod channels;
mod halted;
mod problem_state;
mod proxy;
mod running;

use std::cell::RefCell;
use std::ops::ControlFlow;
use std::sync::{Arc, Mutex, TryLockError, Weak};
use std::time::Instant;

use crate::compiled::Runner;
use crate::event;
use crate::interp::{Observer, Spu};
use crate::local_store::LocalStore;
use crate::lock::lock;
use crate::machine::Machine;
use crate::mfc::interconnect::Unit;
use crate::mfc::{DmaError, Policy};
use crate::profile::ProgramId;
use crate::signal::{SignalMode, SignalRegister};
use crate::simulated::{Races, Simulation, SpeSide, SpuClock, Timed};
use crate::stop::{Stop, Stopped};
use problem_state::{ProblemState, State};
use proxy::Proxy;
use running::{RunningChannels, SpuState};

pub use halted::{ChannelState, Halted, QueuedCommand};
pub use problem_state::Watcher;
pub use proxy::{ProxyCommand, TagWait};

/// The settings of an SPE.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Config {
    /// Modes of signal-notification registers 1 and 2.
    pub signal_modes: [SignalMode; 2],
    /// When MFC commands are carried out. In simulated time, data always moves at once.
    pub policy: Policy,
}

struct Engine {
    spu: Spu,
    state: SpuState,
    clock: RefCell<SpuClock>,
    races: RefCell<Races>,
    /// Runs compiled code, if the machine compiles.
    runner: Option<Runner>,
    turn: Turn,
}

/// The program of an SPE that runs in turn.
enum Turn {
    NotBegun,
    Runs,
    Ended(Stopped),
}

/// What a run works with.
struct Parts<'a, 'b> {
    spu: &'a mut Spu,
    channels: &'a mut RunningChannels<'b>,
    runner: Option<&'a mut Runner>,
    clock: &'a RefCell<SpuClock>,
    races: &'a RefCell<Races>,
}

fn stop_at(pc: u32, reason: Stop) -> Stopped {
    Stopped { reason, pc, npc: pc }
}

/// A synergistic processor element.
pub struct Spe {
    local_store: Arc<LocalStore>,
    machine: Arc<Machine>,
    problem_state: Arc<ProblemState>,
    engine: Mutex<Engine>,
    proxy: Mutex<Proxy>,
    simulated: Option<SpeSide>,
}

impl Spe {
    /// A new SPE of `machine`. Local store and registers are 0.
    #[must_use]
    pub fn new(machine: &Arc<Machine>, config: Config) -> Arc<Self> {
        let simulated = machine.simulation().map(SpeSide::new);
        let sleepers = simulated.as_ref().map(|side| (Arc::clone(&side.simulation), side.key()));
        let policy = match simulated {
            Some(_) => Policy::AtOnce,
            None => config.policy,
        };
        let clock = simulated.as_ref().map(SpeSide::new_clock);
        let transfers = simulated.as_ref().map(SpeSide::new_transfers);
        let races = simulated.as_ref().map(SpeSide::new_races);
        let races = races.unwrap_or_default();
        let mut runner = machine.translations().map(Runner::new);
        if let Some(runner) = &mut runner {
            runner.watch(races.marks());
        }
        let problem_state = Arc::new(ProblemState::new(config.signal_modes, sleepers));
        let unit: Arc<dyn Unit> = problem_state.clone();
        machine.interconnect().attach(&unit);
        let spe = Arc::new(Self {
            local_store: Arc::new(LocalStore::new()),
            machine: Arc::clone(machine),
            problem_state,
            engine: Mutex::new(Engine {
                spu: Spu::default(),
                state: SpuState::new(policy, transfers),
                clock: RefCell::new(clock.unwrap_or_default()),
                races: RefCell::new(races),
                runner,
                turn: Turn::NotBegun,
            }),
            proxy: Mutex::new(Proxy::new(policy)),
            simulated,
        });
        if let Some(turns) = machine.turns() {
            turns.add(&spe);
        }
        spe
    }

    /// The local store. It may be read and written while the SPU runs.
    #[must_use]
    pub fn local_store(&self) -> &Arc<LocalStore> {
        &self.local_store
    }

    /// Runs the SPU from `entry` on the calling thread until it stops. Registers and channels keep
    /// their contents from the previous run. A second caller sleeps until the first has returned.
    pub fn run(&self, entry: u32) -> Stopped {
        self.run_prepared(entry, |_| ())
    }

    /// As [`run`](Self::run), but `prepare` can set registers before the first instruction.
    pub fn run_prepared(&self, entry: u32, prepare: impl FnOnce(&mut Spu)) -> Stopped {
        let mut stopped = self.run_observed(entry, u64::MAX, &mut (), prepare);
        loop {
            if let Some(stopped) = stopped {
                return stopped;
            }
            let pc = self.with_spu(Spu::pc);
            stopped = self.run_observed(pc, u64::MAX, &mut (), |_| ());
        }
    }

    /// As [`run_prepared`](Self::run_prepared), with calls to `observer`, and for at most `limit`
    /// instructions. Returns `None` if the SPU can continue after them.
    pub fn run_observed<O: Observer>(
        &self,
        entry: u32,
        limit: u64,
        observer: &mut O,
        prepare: impl FnOnce(&mut Spu),
    ) -> Option<Stopped> {
        self.run_by(entry, prepare, |parts| {
            let Parts { spu, channels, runner, clock, races } = parts;
            let runner = runner.filter(|_| !observer.wants_all());
            let store = &self.local_store;
            match (&self.simulated, runner) {
                (None, Some(runner)) => runner.run_observed(spu, store, channels, limit, observer),
                (None, None) => spu.run_observed(store, channels, limit, observer),
                (Some(side), runner) => {
                    let method = side.simulation.options().method;
                    let mut timed = Timed::new((clock, races), &side.actor, method, runner);
                    timed.run(spu, store, channels, limit, observer)
                }
            }
        })
    }

    /// As [`run_prepared`](Self::run_prepared), but calls `look` before each instruction, with the
    /// clock in simulated time. It may change registers and the program counter, and take as long
    /// as it likes: simulated time stands still meanwhile. If it breaks, the run ends before that
    /// instruction and returns `None`.
    pub fn run_stepwise(
        &self,
        entry: u32,
        mut look: impl FnMut(&mut Spu, Option<u64>) -> ControlFlow<()>,
        prepare: impl FnOnce(&mut Spu),
    ) -> Option<Stopped> {
        self.run_halting(entry, |spu, halted| look(spu, halted.cycles()), prepare)
    }

    /// As [`run_stepwise`](Self::run_stepwise), where `look` also sees the channels.
    pub fn run_halting(
        &self,
        entry: u32,
        mut look: impl FnMut(&mut Spu, &Halted<'_>) -> ControlFlow<()>,
        prepare: impl FnOnce(&mut Spu),
    ) -> Option<Stopped> {
        const ONE: u64 = 1;
        self.run_by(entry, prepare, |parts| {
            let Parts { spu, channels, clock, races, .. } = parts;
            let store = &self.local_store;
            loop {
                if look(spu, &Halted::new(channels)).is_break() {
                    return None;
                }
                let stopped = match &self.simulated {
                    None => spu.step(store, channels),
                    Some(side) => {
                        let method = side.simulation.options().method;
                        let mut timed = Timed::new((clock, races), &side.actor, method, None);
                        timed.run(spu, store, channels, ONE, &mut ())
                    }
                };
                if stopped.is_some() {
                    return stopped;
                }
            }
        })
    }

    /// The start and the end of a run, with `run` between them.
    fn run_by(
        &self,
        entry: u32,
        prepare: impl FnOnce(&mut Spu),
        run: impl FnOnce(Parts<'_, '_>) -> Option<Stopped>,
    ) -> Option<Stopped> {
        let mut engine = lock(&self.engine);
        let Engine { spu, state, clock, races, runner, .. } = &mut *engine;
        let (clock, races): (&RefCell<SpuClock>, &RefCell<Races>) = (clock, races);
        spu.set_pc(entry);
        prepare(spu);
        if let Some(side) = &self.simulated {
            side.start(clock);
        }
        let mut channels = RunningChannels { own: state, spe: self, clock, races };
        let mut stopped = if self.problem_state.stop_requested() {
            Some(stop_at(spu.pc(), Stop::Requested))
        } else {
            let parts =
                Parts { spu, channels: &mut channels, runner: runner.as_mut(), clock, races };
            run(parts)
        };
        if let Err(fault) = channels.finish_commands() {
            let pc = spu.pc();
            let stopped = stopped.get_or_insert_with(|| stop_at(pc, Stop::Requested));
            stopped.reason = fault;
        }
        self.finish_proxy_commands();
        if let Some(stopped) = &mut stopped
            && stopped.reason == Stop::Requested
            && let Some(fault) = self.problem_state.take_stop_request()
        {
            stopped.reason = Stop::Dma(fault);
        }
        match &self.simulated {
            Some(side) => side.end(clock, state.mfc(), || self.problem_state.announce()),
            None => {
                drop(engine);
                self.problem_state.announce();
            }
        }
        stopped
    }

    /// Begins to run the SPU from `entry` on a machine whose SPEs run
    /// [in turn](crate::in_turn). `prepare` can set registers.
    pub fn begin(&self, entry: u32, prepare: impl FnOnce(&mut Spu)) {
        let mut engine = lock(&self.engine);
        engine.spu.set_pc(entry);
        prepare(&mut engine.spu);
        engine.turn = Turn::Runs;
        if let Some(side) = &self.simulated {
            side.begin(&engine.clock);
        }
    }

    /// Why the program that was [begun](Self::begin) has stopped, if it has.
    #[must_use]
    pub fn ended(&self) -> Option<Stopped> {
        match &lock(&self.engine).turn {
            Turn::Ended(stopped) => Some(stopped.clone()),
            Turn::NotBegun | Turn::Runs => None,
        }
    }

    /// Runs a program that was begun for at most `limit` instructions. Returns whether it ran.
    pub(crate) fn go_on(&self, limit: u64) -> bool {
        let mut engine = lock(&self.engine);
        let Engine { spu, state, clock, races, runner, turn } = &mut *engine;
        if !matches!(turn, Turn::Runs) {
            return false;
        }
        let (clock, races): (&RefCell<SpuClock>, &RefCell<Races>) = (clock, races);
        let before = spu.executed();
        let mut channels = RunningChannels { own: state, spe: self, clock, races };
        let store = &self.local_store;
        let stopped = match (&self.simulated, runner) {
            (None, Some(runner)) => runner.run(spu, store, &mut channels, limit),
            (None, None) => spu.run_limited(store, &mut channels, limit),
            (Some(side), _) => {
                side.resume(clock);
                let method = side.simulation.options().method;
                let mut timed = Timed::new((clock, races), &side.actor, method, None);
                timed.run(spu, store, &mut channels, limit, &mut ())
            }
        };
        let stopped = match stopped {
            Some(Stopped { reason: Stop::Waits, .. }) => return spu.executed() != before,
            None => {
                if let Some(side) = &self.simulated {
                    side.actor.progress(clock.borrow().now());
                }
                return true;
            }
            Some(stopped) => stopped,
        };
        let fault = match stopped.reason {
            Stop::Requested => self.problem_state.take_stop_request(),
            _ => None,
        };
        let reason = fault.map_or(stopped.reason, Stop::Dma);
        *turn = Turn::Ended(Stopped { reason, ..stopped });
        if let Some(side) = &self.simulated {
            side.end_in_turn(clock, state.mfc());
        }
        drop(engine);
        self.problem_state.announce();
        true
    }

    /// Gives `look` access to the registers. Sleeps while the SPU runs.
    pub fn with_spu<T>(&self, look: impl FnOnce(&Spu) -> T) -> T {
        look(&lock(&self.engine).spu)
    }

    /// Asks the SPU to stop, and wakes it if it sleeps. If it is not running, its next run ends at
    /// once.
    pub fn request_stop(&self) {
        self.problem_state.request_stop(None);
    }

    /// Whether a thread runs the SPU.
    #[must_use]
    pub fn is_running(&self) -> bool {
        // It holds the lock for the whole run.
        matches!(self.engine.try_lock(), Err(TryLockError::WouldBlock))
    }

    /// Whether the SPU found nothing in a blocking channel when it last looked, and sleeps there.
    /// In simulated time, it also sleeps while it waits for its turn.
    #[must_use]
    pub fn sleeps(&self) -> bool {
        match &self.simulated {
            None => self.problem_state.with(|state| state.sleeps),
            Some(side) => side.actor.waits(),
        }
    }

    /// The simulated time of the SPE's machine, if it has one.
    #[must_use]
    pub fn simulation(&self) -> Option<&Arc<Simulation>> {
        self.machine.simulation()
    }

    /// The first difference that a check of the machine has found between two ways of running code,
    /// or of counting its cycles: the address, and a description.
    #[must_use]
    pub fn difference(&self) -> Option<(u32, String)> {
        let counted = self.simulation().and_then(|simulation| simulation.difference());
        let counted = counted.map(|difference| (difference.address, difference.to_string()));
        let run = || Some(self.machine.difference()?.described());
        counted.or_else(run)
    }

    /// In simulated time: executes `body` as one call of a PPE thread, in its turn. Otherwise just
    /// executes `body`.
    pub fn act<T>(&self, body: impl FnOnce() -> T) -> T {
        match &self.simulated {
            Some(side) => side.simulation.act(body),
            None => body(),
        }
    }

    /// In simulated time: announces that a thread will soon run this SPE, so that the other SPEs
    /// don't run ahead of it.
    pub fn expect_run(&self) {
        if let Some(side) = &self.simulated {
            side.expect();
        }
    }

    /// In simulated time: charges what runs from now on to this program, in the machine's profile.
    pub fn profile_as(&self, program: ProgramId) {
        if let Some(side) = &self.simulated {
            side.load(program);
        }
    }

    /// Declares that the local store is mapped at effective address `ea` of the machine's memory.
    /// Simulated time then distinguishes transfers to it from those to main memory.
    pub fn map_local_store(&self, ea: u64) {
        let store = Arc::downgrade(&self.local_store);
        self.machine.interconnect().map_local_store(ea, store);
    }

    /// Reads the problem state for a PPE thread.
    fn look<T>(&self, look: impl FnOnce(&mut State) -> T) -> T {
        self.act(|| self.problem_state.with(look))
    }

    /// A PPE thread sleeps until `poll` returns a value or the deadline has passed.
    fn wait<T>(
        &self,
        deadline: Option<Instant>,
        mut poll: impl FnMut(&mut State) -> Option<T>,
    ) -> Option<T> {
        match &self.simulated {
            None => self.problem_state.wait(deadline, poll),
            Some(side) => {
                let left = |deadline: Instant| deadline.saturating_duration_since(Instant::now());
                let limit = deadline.map(left);
                let poll = || self.problem_state.with(&mut poll);
                side.simulation.wait(side.key(), limit, poll)
            }
        }
    }

    /// Number of words that still fit into the inbound mailbox.
    #[must_use]
    pub fn inbound_free(&self) -> usize {
        self.look(|state| state.inbound.free())
    }

    /// Writes a word to the inbound mailbox, and sleeps while it is full. Returns `false` if the
    /// deadline passed first. With a deadline in the past it never sleeps. Without a deadline it
    /// may sleep forever.
    pub fn write_inbound(&self, word: u32, deadline: Option<Instant>) -> bool {
        let written = self.wait(deadline, |state| {
            let was_empty = state.inbound.waiting() == 0;
            let written = state.inbound.write(word);
            if written && was_empty {
                state.events.raise(event::INBOUND_DATA);
            }
            written.then_some(())
        });
        if written.is_some() {
            self.problem_state.announce();
        }
        written.is_some()
    }

    /// Number of words in the outbound mailbox.
    #[must_use]
    pub fn outbound_waiting(&self) -> usize {
        self.look(|state| state.outbound.waiting())
    }

    /// Reads a word from the outbound mailbox. Sleeps while it is empty, until the deadline.
    pub fn read_outbound(&self, deadline: Option<Instant>) -> Option<u32> {
        let word = self.wait(deadline, |state| {
            let word = state.outbound.read()?;
            state.events.raise(event::OUTBOUND_ROOM);
            Some(word)
        });
        if word.is_some() {
            self.problem_state.announce();
        }
        word
    }

    /// Number of words in the outbound interrupt mailbox.
    #[must_use]
    pub fn outbound_interrupt_waiting(&self) -> usize {
        self.look(|state| state.outbound_interrupt.waiting())
    }

    /// Reads a word from the outbound interrupt mailbox. Sleeps while it is empty, until the
    /// deadline.
    pub fn read_outbound_interrupt(&self, deadline: Option<Instant>) -> Option<u32> {
        let word = self.wait(deadline, |state| {
            let word = state.outbound_interrupt.read()?;
            state.events.raise(event::OUTBOUND_INTERRUPT_ROOM);
            Some(word)
        });
        if word.is_some() {
            self.problem_state.announce();
        }
        word
    }

    /// Writes a signal-notification register.
    pub fn signal(&self, register: SignalRegister, word: u32) {
        self.act(|| self.problem_state.signal(register, word));
    }

    /// Maps a signal-notification register at the effective address `ea`, so that `sndsig`
    /// commands of other SPEs reach it.
    pub fn map_signal(&self, register: SignalRegister, ea: u64) {
        let unit: Arc<dyn Unit> = self.problem_state.clone();
        let unit: Weak<dyn Unit> = Arc::downgrade(&unit);
        self.machine.interconnect().map_signal(ea, unit, register);
    }

    /// Notifies `watcher` of changes from now on.
    pub fn watch(&self, watcher: Arc<dyn Watcher>) {
        self.problem_state.watch(watcher);
    }

    /// Notifies the watchers of a change in something that the SPE's owner keeps for it.
    pub fn announce(&self) {
        self.act(|| self.problem_state.announce());
    }

    /// Cancels one [`watch`](Self::watch) of this watcher.
    pub fn unwatch(&self, watcher: &Arc<dyn Watcher>) {
        self.problem_state.unwatch(watcher);
    }

    /// Stops the SPU with the error of a proxy command, as the hardware's interrupt does.
    pub fn proxy_failed(&self, fault: DmaError) {
        self.problem_state.request_stop(Some(fault));
    }
}
