//! A running SPU: its channels, and how it sleeps in a blocking one.
//!
//! Invariant: a channel access either takes effect completely, or not at all if a stop request
//! ends its sleep. So the instruction can be run again.

use std::cell::RefCell;
use std::sync::Arc;
use std::sync::atomic::Ordering::SeqCst;
use std::time::Duration;

use super::Spe;
use super::problem_state::{ProblemState, State, WaitOutcome};
use crate::decrementer::Decrementer;
use crate::event;
use crate::memory::LINE;
use crate::mfc::interconnect::Unit;
use crate::mfc::queue::Path;
use crate::mfc::spu_side::SpuSide;
use crate::mfc::timing::TransferTimes;
use crate::mfc::{DmaError, Policy};
use crate::simulated::{self, Races, SpeSide, SpuClock, Wait};
use crate::stop::Stop;

/// With [`Policy::AtLast`], how long commands of both sides stay undone while the SPU sleeps. It
/// is long enough to reveal a PPE that looks too early, and short enough not to hang a program
/// whose PPE waits for the data itself.
const GRACE: Duration = Duration::from_millis(10);
/// How often an SPU that waits for a lost reservation compares the line. The PPE's own stores end
/// no reservation here, so there is no notification of them.
const LINE_WATCH: Duration = Duration::from_millis(1);

/// The state, except the registers, that only the thread that runs the SPU uses. It is kept across
/// runs.
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
    /// Used only in simulated time.
    pub(super) clock: &'a RefCell<SpuClock>,
    /// Used only in simulated time.
    pub(super) races: &'a RefCell<Races>,
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

    /// Waits for the SPU's turn, before an action that others can see or that depends on them.
    pub(super) fn turn(&self) -> Result<(), Stop> {
        self.simulated().map_or(Ok(()), |side| side.turn(self.clock))
    }

    /// Sleeps until `cycle`. Nothing wakes the SPU earlier.
    pub(super) fn sleep_until(&self, cycle: u64, wait: Wait) {
        if let Some(side) = self.simulated() {
            side.sleep_until(self.clock, cycle, wait);
        }
    }

    /// In simulated time: makes the completion of commands visible to the program.
    fn advance_transfers(&mut self) {
        if self.simulated().is_some() {
            let now = self.clock.borrow().now();
            self.own.mfc.change_transfers(|transfers| transfers.advance(now));
            self.problem_state().raise(self.own.mfc.take_events());
        }
    }

    /// The program has read something that may show it which commands are complete.
    pub(super) fn learn(&self) {
        if self.races.borrow().are_possible() {
            self.await_completions();
            self.races.borrow_mut().learn(self.clock.borrow().now());
        }
    }

    /// Waits until it is known when each command is complete.
    pub(super) fn await_completions(&self) {
        if let Some(side) = self.simulated()
            && self.races.borrow().await_another_thread()
        {
            side.await_deferred(self.clock, u32::MAX);
        }
    }

    /// In simulated time: 1 if the result that the MFC delivers at `time` has arrived, else 0.
    pub(super) fn arrived(&self, time: impl FnOnce(&dyn TransferTimes) -> u64) -> u32 {
        let transfers = self.own.mfc.transfers();
        u32::from(transfers.is_none_or(|transfers| time(transfers) <= self.clock.borrow().now()))
    }

    /// Calls `body` with the MFC, and raises the events that result.
    pub(super) fn mfc<T>(
        &mut self,
        body: impl FnOnce(&mut SpuSide, Path<'a>) -> Result<T, DmaError>,
    ) -> Result<T, Stop> {
        self.mfc_for(u32::MAX, body)
    }

    /// As [`mfc`](Self::mfc), where `body` depends on the commands of these tags only.
    pub(super) fn mfc_for<T>(
        &mut self,
        tags: u32,
        body: impl FnOnce(&mut SpuSide, Path<'a>) -> Result<T, DmaError>,
    ) -> Result<T, Stop> {
        if let Some(side) = self.simulated() {
            side.await_deferred(self.clock, tags);
        }
        let path = self.path();
        self.advance_transfers();
        let result = body(&mut self.own.mfc, path);
        if let Some(side) = self.simulated() {
            let now = self.clock.borrow().now();
            let interconnect = self.spe.machine.interconnect();
            let races = &mut *self.races.borrow_mut();
            side.time_movements(&mut self.own.mfc, now, interconnect, races);
        }
        self.problem_state().raise(self.own.mfc.take_events());
        result.map_err(Stop::Dma)
    }

    /// In simulated time: gives the MFC a put whose turn is not waited for. Returns `false`,
    /// without any effect, if it must be waited for.
    pub(super) fn defer_put(&mut self, word: u32) -> bool {
        let Some(side) = self.simulated() else {
            return false;
        };
        if !side.may_defer() {
            return false;
        }
        // In this order: a put that is carried out in between counts twice, and not never.
        let deferred = side.actor.deferred();
        self.advance_transfers();
        let path = self.path();
        let mfc = &mut self.own.mfc;
        let put = mfc.put_to_defer(word, path, deferred);
        let (Some(put), Some(transfers)) = (put, mfc.transfers()) else {
            return false;
        };
        let now = self.clock.borrow().now();
        let (machine, problem_state) =
            (Arc::clone(&self.spe.machine), Arc::clone(&self.spe.problem_state));
        let mut transfers = transfers.shared();
        let tag = put.tag_bit();
        let completion = {
            let mut races = self.races.borrow_mut();
            let movement = races.are_watched().then(|| put.movement());
            let given = movement.and_then(|movement| races.give(&movement));
            given.map(|given| races.is_deferred(given))
        };
        let act = move || match put.write(machine.interconnect()) {
            Ok(movement) => {
                let complete = transfers.add(movement, now);
                if let Some(completion) = completion {
                    completion.store(complete, SeqCst);
                }
            }
            Err(fault) => problem_state.request_stop(Some(fault)),
        };
        side.actor.defer(now, tag, Box::new(act));
        true
    }

    /// Carries out the commands that the policy put off, because the program has stopped.
    pub(crate) fn finish_commands(&mut self) -> Result<(), Stop> {
        self.mfc(SpuSide::run_ready)
    }

    /// Sleeps until `poll` returns a value.
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
        side.turn(self.clock)?;
        loop {
            self.advance_transfers();
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
            side.sleep(self.clock, wait, limit, pause)?;
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
            if self.spe.machine.turns().is_some() {
                return match problem_state.with(|state| poll(self, state)) {
                    Some(value) => Ok(value),
                    None if problem_state.stop_requested() => Err(Stop::Requested),
                    None => Err(Stop::Waits),
                };
            }
            match problem_state.wait_as_spu(limit, |state| poll(self, state)) {
                WaitOutcome::Ready(value) => return Ok(value),
                WaitOutcome::StopRequested => return Err(Stop::Requested),
                WaitOutcome::TimedOut if grace.is_some() => {
                    self.finish_commands()?;
                    self.spe.finish_proxy_commands();
                }
                WaitOutcome::TimedOut => {}
            }
        }
    }

    /// Sleeps until `take` returns a value, then notifies the threads that wait to write.
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

    /// Sleeps until `give` succeeds, then notifies the threads that wait for the data.
    pub(super) fn send(&mut self, mut give: impl FnMut(&mut State) -> bool) -> Result<(), Stop> {
        self.sleep(Wait::Mailbox, |_, state| give(state).then_some(()))?;
        self.learn();
        self.problem_state().announce();
        Ok(())
    }

    /// Sleeps in a channel that only the SPU's own queue can fill. It is called when no command in
    /// the queue may run, so only a stop request ends the sleep.
    pub(super) fn sleep_for_ever<T>(&mut self, wait: Wait) -> Result<T, Stop> {
        self.sleep(wait, |_, _| None)
    }

    /// Sleeps until the MFC returns a value, which only its own commands can cause.
    pub(super) fn sleep_for_mfc<T>(
        &mut self,
        wait: Wait,
        mut poll: impl FnMut(&mut SpuSide, Path<'a>) -> Result<Option<T>, DmaError>,
    ) -> Result<T, Stop> {
        loop {
            if wait == Wait::Queue {
                self.turn()?;
            }
            let tags = match wait {
                Wait::Tag => self.own.mfc.tag_mask(),
                _ => u32::MAX,
            };
            if let Some(value) = self.mfc_for(tags, &mut poll)? {
                return Ok(value);
            }
            match self.own.mfc.transfers().and_then(|transfers| transfers.next(tags)) {
                Some(complete) => self.sleep_until(complete, wait),
                None => return self.sleep_for_ever(wait),
            }
        }
    }

    /// The current time of the time base, simulated or the host's.
    pub(super) fn now(&self) -> u64 {
        match self.simulated() {
            Some(_) => simulated::ticks(self.clock.borrow().now()),
            None => self.spe.machine.clock().ticks(),
        }
    }

    /// Raises the decrementer's event, of which there is no notification.
    fn poll_decrementer(&mut self, state: &mut State) {
        if self.own.decrementer.expired(self.now()) {
            state.events.raise(event::DECREMENTER);
        }
    }

    /// Ends the reservation of a line that the PPE itself changed. There is no notification of
    /// that either.
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

    /// Ticks until the decrementer's event, if the program waits for it.
    fn decrementer_ticks(&self) -> Option<u64> {
        (self.event_mask() & event::DECREMENTER != 0)
            .then(|| self.own.decrementer.until_event(self.now()))
            .flatten()
    }

    /// How often to compare the reserved line, if the program waits for its loss.
    fn line_watch(&self) -> Option<Duration> {
        (self.event_mask() & event::RESERVATION_LOST != 0
            && self.problem_state().reservation().line().is_some())
        .then_some(LINE_WATCH)
    }

    /// How long the host may sleep without missing an event that has no notification.
    fn silent_event_limit(&self) -> Option<Duration> {
        let clock = self.spe.machine.clock();
        let decrementer = self.decrementer_ticks().map(|ticks| clock.host_time(ticks));
        [decrementer, self.line_watch()].into_iter().flatten().min()
    }

    /// The same in simulated time, where the completion of commands counts too.
    fn silent_event_cycle(&self) -> Option<u64> {
        let now = self.clock.borrow().now();
        let decrementer = self
            .decrementer_ticks()
            .map(|ticks| simulated::cycle_of_tick(self.now().saturating_add(ticks)));
        let line = self.line_watch().map(|watch| now + simulated::cycles(watch));
        let mfc = (self.event_mask() & (event::TAG_STATUS | event::QUEUE_ROOM) != 0)
            .then(|| self.own.mfc.transfers().and_then(|transfers| transfers.next(u32::MAX)))
            .flatten();
        [decrementer, line, mfc].into_iter().flatten().min()
    }

    pub(super) fn read_events(&mut self) -> Result<u32, Stop> {
        self.sleep(Wait::Event, |channels, state| {
            channels.poll_decrementer(state);
            state.events.read()
        })
    }

    pub(super) fn event_count(&mut self) -> Result<bool, Stop> {
        self.turn()?;
        self.advance_transfers();
        self.watch_line();
        let problem_state = self.problem_state();
        Ok(problem_state.with(|state| {
            self.poll_decrementer(state);
            state.events.count()
        }))
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
