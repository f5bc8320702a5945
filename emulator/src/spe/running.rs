//! An SPU that runs: what its channels reach, and how a blocking one sleeps.
//!
//! Invariant: a channel access either happens wholly or, when a stop request ends its sleep, not
//! at all; so the instruction can be run again.

use std::cell::RefCell;
use std::time::Duration;

use super::Spe;
use super::problem_state::{ProblemState, State, Waited};
use crate::decrementer::Decrementer;
use crate::event;
use crate::memory::LINE;
use crate::mfc::interconnect::Unit;
use crate::mfc::queue::Path;
use crate::mfc::spu_side::SpuSide;
use crate::mfc::timing::TransferTimes;
use crate::mfc::{DmaError, Policy};
use crate::simulated::{self, SpeSide, SpuClock, Wait};
use crate::stop::Stop;

/// How long the adversary leaves commands of both sides undone while the SPU sleeps: long enough
/// for the PPE to look too early, short enough not to stop a program whose PPE waits for the data
/// itself.
const GRACE: Duration = Duration::from_millis(10);
/// How often a sleeper that waits for a lost reservation compares the line: the PPE's own stores
/// break no reservation here, so nobody would tell.
const LINE_WATCH: Duration = Duration::from_millis(1);

/// What only the thread that runs the SPU touches, beside the registers. It is kept across runs.
pub(crate) struct SpuState {
    pub(super) mfc: SpuSide,
    pub(super) decrementer: Decrementer,
    pub(super) interrupts_enabled: bool,
    pub(super) srr0: u32,
}

impl SpuState {
    pub(crate) fn new(policy: Policy, transfers: Option<Box<dyn TransferTimes>>) -> Self {
        Self {
            mfc: SpuSide::new(policy, transfers),
            decrementer: Decrementer::default(),
            interrupts_enabled: false,
            srr0: 0,
        }
    }

    pub(crate) fn mfc(&self) -> &SpuSide {
        &self.mfc
    }
}

/// The channels of an SPE while it runs.
pub(crate) struct RunningChannels<'a> {
    pub(super) own: &'a mut SpuState,
    pub(super) spe: &'a Spe,
    /// Counts in simulated time only.
    pub(super) clock: &'a RefCell<SpuClock>,
}

impl<'a> RunningChannels<'a> {
    pub(super) fn problem_state(&self) -> &'a ProblemState {
        &self.spe.problem_state
    }

    fn path(&self) -> Path<'a> {
        Path {
            local_store: &self.spe.local_store,
            interconnect: self.spe.machine.interconnect(),
            unit: &*self.spe.problem_state,
            moved: self.simulated().map(|side| &side.moved),
        }
    }

    pub(super) fn simulated(&self) -> Option<&'a SpeSide> {
        self.spe.simulated.as_ref()
    }

    /// What follows can be seen by others, or depends on them.
    pub(super) fn turn(&self) {
        if let Some(side) = self.simulated() {
            side.turn(self.clock);
        }
    }

    /// Sleeps until `cycle`, which nobody can bring nearer.
    pub(super) fn sleep_until(&self, cycle: u64, wait: Wait) {
        self.clock.borrow_mut().sleep(cycle, wait);
    }

    /// What is complete by now in simulated time is so for the program.
    fn settle(&mut self) {
        if self.simulated().is_some() {
            let now = self.clock.borrow().now();
            self.own
                .mfc
                .change_transfers(|transfers| transfers.advance(now));
            self.problem_state().raise(self.own.mfc.take_events());
        }
    }

    /// 1 if what the MFC gives at `time` in simulated time is there, else 0.
    pub(super) fn arrived(&self, time: impl FnOnce(&dyn TransferTimes) -> u64) -> u32 {
        let transfers = self.own.mfc.transfers();
        u32::from(transfers.is_none_or(|transfers| time(transfers) <= self.clock.borrow().now()))
    }

    /// Does something with the MFC and raises the events that come of it.
    pub(super) fn mfc<T>(
        &mut self,
        body: impl FnOnce(&mut SpuSide, Path<'a>) -> Result<T, DmaError>,
    ) -> Result<T, Stop> {
        let path = self.path();
        self.settle();
        let result = body(&mut self.own.mfc, path);
        if let Some(side) = self.simulated() {
            let now = self.clock.borrow().now();
            side.time_movements(&mut self.own.mfc, now, self.spe.machine.interconnect());
        }
        self.problem_state().raise(self.own.mfc.take_events());
        result.map_err(Stop::Dma)
    }

    /// Carries out what the policy put off: the program has stopped.
    pub(crate) fn finish_commands(&mut self) -> Result<(), Stop> {
        self.mfc(SpuSide::run_ready)
    }

    /// Sleeps until `poll` yields.
    fn sleep<T>(
        &mut self,
        wait: Wait,
        poll: impl FnMut(&mut Self, &mut State) -> Option<T>,
    ) -> Result<T, Stop> {
        match self.simulated() {
            Some(side) => self.sleep_simulated(side, wait, poll),
            None => self.sleep_on_host(wait, poll),
        }
    }

    fn sleep_simulated<T>(
        &mut self,
        side: &SpeSide,
        wait: Wait,
        mut poll: impl FnMut(&mut Self, &mut State) -> Option<T>,
    ) -> Result<T, Stop> {
        side.turn(self.clock);
        loop {
            self.settle();
            if wait == Wait::Event {
                self.watch_line();
            }
            let problem_state = self.problem_state();
            if let Some(value) = problem_state.with(|state| poll(self, state)) {
                return Ok(value);
            }
            if problem_state.stop_requested() {
                return Err(Stop::Requested);
            }
            let (limit, pause) = if wait == Wait::Event {
                (self.silent_event_cycle(), self.line_watch())
            } else {
                (None, None)
            };
            side.publish(self.clock, &self.own.mfc);
            side.sleep(self.clock, wait, limit, pause);
        }
    }

    fn sleep_on_host<T>(
        &mut self,
        wait: Wait,
        mut poll: impl FnMut(&mut Self, &mut State) -> Option<T>,
    ) -> Result<T, Stop> {
        loop {
            let grace = (self.own.mfc.policy() == Policy::AtLast).then_some(GRACE);
            let silent = if wait == Wait::Event {
                self.watch_line();
                self.silent_event_limit()
            } else {
                None
            };
            let limit = silent.into_iter().chain(grace).min();
            let problem_state = self.problem_state();
            match problem_state.wait_as_spu(limit, |state| poll(self, state)) {
                Waited::Ready(value) => return Ok(value),
                Waited::StopRequested => return Err(Stop::Requested),
                Waited::TimedOut if grace.is_some() => {
                    self.finish_commands()?;
                    self.spe.finish_proxy_commands();
                }
                Waited::TimedOut => {}
            }
        }
    }

    /// Sleeps until `take` finds something, then tells those who wait for the room it left.
    pub(super) fn receive(
        &mut self,
        wait: Wait,
        mut take: impl FnMut(&mut State) -> Option<u32>,
    ) -> Result<u32, Stop> {
        let value = self.sleep(wait, |_, state| take(state))?;
        self.problem_state().announce();
        Ok(value)
    }

    pub(super) fn receive_signal(&mut self, at: usize) -> Result<u32, Stop> {
        let word = self.receive(Wait::Signal, |state| state.signals[at].read())?;
        if self.simulated().is_some() {
            let arrives = self.problem_state().with(|state| state.signals_arrive[at]);
            self.sleep_until(arrives, Wait::Signal);
        }
        Ok(word)
    }

    /// Sleeps until `give` finds room, then tells those who wait for the data.
    pub(super) fn send(&mut self, mut give: impl FnMut(&mut State) -> bool) -> Result<(), Stop> {
        self.sleep(Wait::Mailbox, |_, state| give(state).then_some(()))?;
        self.problem_state().announce();
        Ok(())
    }

    /// Sleeps in a channel that only the SPU's own queue can fill. It is called when nothing in
    /// the queue may run, so only a stop ends it.
    pub(super) fn sleep_for_ever<T>(&mut self, wait: Wait) -> Result<T, Stop> {
        self.sleep(wait, |_, _| None)
    }

    /// Sleeps until the MFC yields, which only its own commands can bring about.
    pub(super) fn sleep_for_mfc<T>(
        &mut self,
        wait: Wait,
        mut poll: impl FnMut(&mut SpuSide, Path<'a>) -> Result<Option<T>, DmaError>,
    ) -> Result<T, Stop> {
        loop {
            if wait == Wait::Queue {
                self.turn();
            }
            if let Some(value) = self.mfc(&mut poll)? {
                return Ok(value);
            }
            match self
                .own
                .mfc
                .transfers()
                .and_then(|transfers| transfers.next())
            {
                Some(complete) => self.sleep_until(complete, wait),
                None => return self.sleep_for_ever(wait),
            }
        }
    }

    /// Of the time base: simulated, or the host's.
    pub(super) fn now(&self) -> u64 {
        match self.simulated() {
            Some(_) => simulated::ticks(self.clock.borrow().now()),
            None => self.spe.machine.clock().ticks(),
        }
    }

    /// Raises the decrementer's event, which nobody announces.
    fn poll_decrementer(&mut self, state: &mut State) {
        if self.own.decrementer.expired(self.now()) {
            state.events.raise(event::DECREMENTER);
        }
    }

    /// Ends the reservation of a line that the PPE changed by itself, which nobody announces
    /// either.
    fn watch_line(&mut self) {
        let Some(line) = self.problem_state().reservation().line() else {
            return;
        };
        let mut current = [0; LINE];
        let read = self.spe.machine.memory().read(line, &mut current);
        if read.is_ok()
            && current != *self.own.mfc.seen_line()
            && self.problem_state().reservation().line() == Some(line)
        {
            self.problem_state().reservation().clear();
            self.problem_state().raise(event::RESERVATION_LOST);
        }
    }

    pub(super) fn event_mask(&self) -> u32 {
        self.problem_state().with(|state| state.events.mask())
    }

    /// Ticks to the decrementer's event, if it is awaited.
    fn decrementer_ticks(&self) -> Option<u64> {
        (self.event_mask() & event::DECREMENTER != 0)
            .then(|| self.own.decrementer.until_event(self.now()))
            .flatten()
    }

    /// How often to look at the reserved line, if its loss is awaited.
    fn line_watch(&self) -> Option<Duration> {
        (self.event_mask() & event::RESERVATION_LOST != 0
            && self.problem_state().reservation().line().is_some())
        .then_some(LINE_WATCH)
    }

    /// How long the host may sleep without missing an event that nobody announces.
    fn silent_event_limit(&self) -> Option<Duration> {
        let clock = self.spe.machine.clock();
        let decrementer = self.decrementer_ticks().map(|ticks| clock.host_time(ticks));
        [decrementer, self.line_watch()].into_iter().flatten().min()
    }

    /// The same in simulated time, in which commands become complete too.
    fn silent_event_cycle(&self) -> Option<u64> {
        let now = self.clock.borrow().now();
        let decrementer = self
            .decrementer_ticks()
            .map(|ticks| simulated::cycle_of_tick(self.now().saturating_add(ticks)));
        let line = self
            .line_watch()
            .map(|watch| now + simulated::cycles(watch));
        let mfc = (self.event_mask() & (event::TAG_STATUS | event::QUEUE_ROOM) != 0)
            .then(|| {
                self.own
                    .mfc
                    .transfers()
                    .and_then(|transfers| transfers.next())
            })
            .flatten();
        [decrementer, line, mfc].into_iter().flatten().min()
    }

    pub(super) fn read_events(&mut self) -> Result<u32, Stop> {
        self.sleep(Wait::Event, |channels, state| {
            channels.poll_decrementer(state);
            state.events.read()
        })
    }

    pub(super) fn event_count(&mut self) -> bool {
        self.turn();
        self.settle();
        self.watch_line();
        let problem_state = self.problem_state();
        problem_state.with(|state| {
            self.poll_decrementer(state);
            state.events.count()
        })
    }

    pub(super) fn acknowledge(&mut self, events: u32) {
        let now = self.now();
        self.problem_state().with(|state| {
            if events & event::DECREMENTER != 0 && state.events.mask() & event::DECREMENTER == 0 {
                self.own.decrementer.freeze(now);
            }
            state.events.acknowledge(events);
        });
    }
}
