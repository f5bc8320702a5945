//! The SPU's channels: what each number leads to, and how a blocking one sleeps.
//!
//! Invariant: a channel access either happens wholly or, when a stop request ends its sleep, not at
//! all; so the instruction can be run again.

use std::cell::RefCell;
use std::sync::Arc;
use std::time::Duration;

use super::Spe;
use super::problem_state::{ProblemState, State, Waited};
use crate::channel::Channels;
use crate::decrementer::Decrementer;
use crate::event;
use crate::memory::LINE;
use crate::mfc::interconnect::Unit;
use crate::mfc::queue::Path;
use crate::mfc::spu_side::SpuSide;
use crate::mfc::{DmaError, Policy};
use crate::simulated::{self, Parcel, SpeSide, SpuClock, Transfers, Wait};
use crate::stop::{ChannelAccess, Stop};

/// How long the adversary leaves commands of both sides undone while the SPU sleeps: long enough for the PPE to
/// look too early, short enough not to stop a program whose PPE waits for the data itself.
const GRACE: Duration = Duration::from_millis(10);
/// How often a sleeper that waits for a lost reservation compares the line: the PPE's own stores
/// break no reservation here, so nobody would tell.
const LINE_WATCH: Duration = Duration::from_millis(1);

const RD_EVENT_STAT: u8 = 0;
const WR_EVENT_MASK: u8 = 1;
const WR_EVENT_ACK: u8 = 2;
const RD_SIG_NOTIFY_1: u8 = 3;
const RD_SIG_NOTIFY_2: u8 = 4;
const WR_DEC: u8 = 7;
const RD_DEC: u8 = 8;
const WR_MS_SYNC_REQ: u8 = 9;
const RD_EVENT_MASK: u8 = 11;
const RD_TAG_MASK: u8 = 12;
const RD_MACH_STAT: u8 = 13;
const WR_SRR0: u8 = 14;
const RD_SRR0: u8 = 15;
const LSA: u8 = 16;
const EAH: u8 = 17;
const EAL: u8 = 18;
const SIZE: u8 = 19;
const TAG_ID: u8 = 20;
const CMD: u8 = 21;
const WR_TAG_MASK: u8 = 22;
const WR_TAG_UPDATE: u8 = 23;
const RD_TAG_STAT: u8 = 24;
const RD_LIST_STALL_STAT: u8 = 25;
const WR_LIST_STALL_ACK: u8 = 26;
const RD_ATOMIC_STAT: u8 = 27;
const WR_OUT_MBOX: u8 = 28;
const RD_IN_MBOX: u8 = 29;
const WR_OUT_INTR_MBOX: u8 = 30;

/// What only the thread that runs the SPU touches, beside the registers. It is kept across runs.
pub(crate) struct SpuState {
    mfc: SpuSide,
    decrementer: Decrementer,
    interrupts_enabled: bool,
    srr0: u32,
}

impl SpuState {
    pub(crate) fn new(policy: Policy, simulated: bool) -> Self {
        Self {
            mfc: SpuSide::new(policy, simulated.then(Transfers::new)),
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
    fn problem_state(&self) -> &'a ProblemState {
        &self.spe.problem_state
    }

    fn path(&self) -> Path<'a> {
        Path {
            local_store: &self.spe.local_store,
            interconnect: &self.spe.interconnect,
            unit: &*self.spe.problem_state,
            moved: self.simulated().map(|side| &side.moved),
        }
    }

    fn simulated(&self) -> Option<&'a SpeSide> {
        self.spe.simulated.as_ref()
    }

    /// What follows can be seen by others, or depends on them.
    fn turn(&self) {
        if let Some(side) = self.simulated() {
            side.turn(self.clock);
        }
    }

    /// Sleeps until `cycle`, which nobody can bring nearer.
    fn sleep_until(&self, cycle: u64, wait: Wait) {
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
    fn arrived(&self, time: impl FnOnce(&Transfers) -> u64) -> u32 {
        let transfers = self.own.mfc.transfers();
        u32::from(transfers.is_none_or(|transfers| time(transfers) <= self.clock.borrow().now()))
    }

    /// Does something with the MFC and raises the events that come of it.
    fn mfc<T>(
        &mut self,
        body: impl FnOnce(&mut SpuSide, Path<'a>) -> Result<T, DmaError>,
    ) -> Result<T, Stop> {
        let path = self.path();
        self.settle();
        let result = body(&mut self.own.mfc, path);
        if let Some(side) = self.simulated() {
            let now = self.clock.borrow().now();
            side.time_movements(&mut self.own.mfc, now, &self.spe.interconnect);
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
    fn receive(
        &mut self,
        wait: Wait,
        mut take: impl FnMut(&mut State) -> Option<u32>,
    ) -> Result<u32, Stop> {
        let value = self.sleep(wait, |_, state| take(state))?;
        self.problem_state().announce();
        Ok(value)
    }

    fn receive_signal(&mut self, at: usize) -> Result<u32, Stop> {
        let word = self.receive(Wait::Signal, |state| state.signals[at].read())?;
        if self.simulated().is_some() {
            let arrives = self.problem_state().with(|state| state.signals_arrive[at]);
            self.sleep_until(arrives, Wait::Signal);
        }
        Ok(word)
    }

    /// Sleeps until `give` finds room, then tells those who wait for the data.
    fn send(&mut self, mut give: impl FnMut(&mut State) -> bool) -> Result<(), Stop> {
        self.sleep(Wait::Mailbox, |_, state| give(state).then_some(()))?;
        self.problem_state().announce();
        Ok(())
    }

    /// Sleeps in a channel that only the SPU's own queue can fill. It is called when nothing in the
    /// queue may run, so only a stop ends it.
    fn sleep_for_ever<T>(&mut self, wait: Wait) -> Result<T, Stop> {
        self.sleep(wait, |_, _| None)
    }

    /// Sleeps until the MFC yields, which only its own commands can bring about.
    fn sleep_for_mfc<T>(
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
            match self.own.mfc.transfers().and_then(Transfers::next) {
                Some(complete) => self.sleep_until(complete, wait),
                None => return self.sleep_for_ever(wait),
            }
        }
    }

    /// Of the time base: simulated, or the host's.
    fn now(&self) -> u64 {
        match self.simulated() {
            Some(_) => simulated::ticks(self.clock.borrow().now()),
            None => self.spe.interconnect.clock().ticks(),
        }
    }

    /// Raises the decrementer's event, which nobody announces.
    fn poll_decrementer(&mut self, state: &mut State) {
        if self.own.decrementer.expired(self.now()) {
            state.events.raise(event::DECREMENTER);
        }
    }

    /// Ends the reservation of a line that the PPE changed by itself, which nobody announces either.
    fn watch_line(&mut self) {
        let Some(line) = self.problem_state().reservation().line() else {
            return;
        };
        let mut current = [0; LINE];
        let read = self.spe.interconnect.memory().read(line, &mut current);
        if read.is_ok()
            && current != *self.own.mfc.seen_line()
            && self.problem_state().reservation().line() == Some(line)
        {
            self.problem_state().reservation().clear();
            self.problem_state().raise(event::RESERVATION_LOST);
        }
    }

    fn event_mask(&self) -> u32 {
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
        let clock = self.spe.interconnect.clock();
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
            .then(|| self.own.mfc.transfers().and_then(Transfers::next))
            .flatten();
        [decrementer, line, mfc].into_iter().flatten().min()
    }

    fn read_events(&mut self) -> Result<u32, Stop> {
        self.sleep(Wait::Event, |channels, state| {
            channels.poll_decrementer(state);
            state.events.read()
        })
    }

    fn event_count(&mut self) -> bool {
        self.turn();
        self.settle();
        self.watch_line();
        let problem_state = self.problem_state();
        problem_state.with(|state| {
            self.poll_decrementer(state);
            state.events.count()
        })
    }

    fn acknowledge(&mut self, events: u32) {
        let now = self.now();
        self.problem_state().with(|state| {
            if events & event::DECREMENTER != 0 && state.events.mask() & event::DECREMENTER == 0 {
                self.own.decrementer.freeze(now);
            }
            state.events.acknowledge(events);
        });
    }
}

impl Channels for RunningChannels<'_> {
    fn read(&mut self, channel: u8) -> Result<u32, Stop> {
        match channel {
            RD_EVENT_STAT => self.read_events(),
            RD_SIG_NOTIFY_1 | RD_SIG_NOTIFY_2 => {
                self.receive_signal(usize::from(channel - RD_SIG_NOTIFY_1))
            }
            RD_DEC => Ok(self.own.decrementer.value(self.now())),
            RD_EVENT_MASK => Ok(self.event_mask()),
            RD_TAG_MASK => Ok(self.own.mfc.tag_mask()),
            RD_MACH_STAT => Ok(u32::from(self.own.interrupts_enabled)),
            RD_SRR0 => Ok(self.own.srr0),
            RD_TAG_STAT => self.sleep_for_mfc(Wait::Tag, SpuSide::read_tag_status),
            RD_LIST_STALL_STAT => {
                let tags = self.sleep_for_mfc(Wait::List, SpuSide::read_stalled)?;
                if let Some(transfers) = self.own.mfc.transfers() {
                    self.sleep_until(transfers.stalled_at(), Wait::List);
                }
                Ok(tags)
            }
            RD_ATOMIC_STAT => match self.own.mfc.read_atomic_status() {
                Some(status) => {
                    if let Some(transfers) = self.own.mfc.transfers() {
                        self.sleep_until(transfers.atomic_at(), Wait::Atomic);
                    }
                    Ok(status)
                }
                None => self.sleep_for_ever(Wait::Atomic),
            },
            RD_IN_MBOX => self.receive(Wait::Mailbox, |state| state.inbound.read()),
            _ => Err(Stop::InvalidChannel(channel, ChannelAccess::Read)),
        }
    }

    fn write(&mut self, channel: u8, value: u32) -> Result<(), Stop> {
        match channel {
            WR_EVENT_MASK => {
                self.turn();
                self.problem_state()
                    .with(|state| state.events.set_mask(value));
            }
            WR_EVENT_ACK => {
                self.turn();
                self.acknowledge(value);
            }
            WR_DEC => {
                let now = self.now();
                self.own.decrementer.load(value, now);
            }
            // Data from others lies in this local store already, or is taken to.
            WR_MS_SYNC_REQ => {
                if let Some(side) = self.simulated() {
                    self.turn();
                    let own = &self.spe.local_store;
                    let here = |parcel: &Parcel| Arc::ptr_eq(&parcel.store, own);
                    side.simulation.deliver_early(here);
                }
                self.problem_state().raise(event::MULTISOURCE_SYNC);
            }
            WR_SRR0 => self.set_srr0(value),
            LSA => self.own.mfc.parameters.lsa = value,
            EAH => {
                let ea = &mut self.own.mfc.parameters.ea;
                *ea = *ea & u64::from(u32::MAX) | u64::from(value) << 32;
            }
            EAL => {
                let ea = &mut self.own.mfc.parameters.ea;
                *ea = *ea & !u64::from(u32::MAX) | u64::from(value);
            }
            SIZE => self.own.mfc.parameters.size = value,
            TAG_ID => self.own.mfc.parameters.tag = value,
            CMD => self.sleep_for_mfc(Wait::Queue, |mfc, path| mfc.command(value, path))?,
            WR_TAG_MASK => self.mfc(|mfc, _| {
                mfc.set_tag_mask(value);
                Ok(())
            })?,
            WR_TAG_UPDATE => self.mfc(|mfc, path| mfc.request_tag_status(value, path))?,
            WR_LIST_STALL_ACK => {
                self.turn();
                self.mfc(|mfc, path| mfc.resume(value, path))?;
            }
            WR_OUT_MBOX => self.send(|state| state.outbound.write(value))?,
            WR_OUT_INTR_MBOX => self.send(|state| state.outbound_interrupt.write(value))?,
            _ => return Err(Stop::InvalidChannel(channel, ChannelAccess::Write)),
        }
        Ok(())
    }

    fn count(&mut self, channel: u8) -> Result<u32, Stop> {
        let count = |waiting: usize| waiting as u32;
        if matches!(
            channel,
            RD_SIG_NOTIFY_1 | RD_SIG_NOTIFY_2 | WR_OUT_MBOX | RD_IN_MBOX | WR_OUT_INTR_MBOX
        ) {
            self.turn();
        }
        match channel {
            RD_EVENT_STAT => Ok(u32::from(self.event_count())),
            RD_SIG_NOTIFY_1 | RD_SIG_NOTIFY_2 => {
                let at = usize::from(channel - RD_SIG_NOTIFY_1);
                let now = self.clock.borrow().now();
                Ok(self.problem_state().with(|state| {
                    let there = self.simulated().is_none() || state.signals_arrive[at] <= now;
                    u32::from(there && state.signals[at].waiting())
                }))
            }
            CMD => self.mfc(SpuSide::room),
            RD_TAG_STAT => self.mfc(SpuSide::tag_status_count),
            RD_LIST_STALL_STAT => {
                let count = self.mfc(SpuSide::stalled_count)?;
                Ok(count * self.arrived(Transfers::stalled_at))
            }
            RD_ATOMIC_STAT => {
                let count = self.own.mfc.atomic_status_count();
                Ok(count * self.arrived(Transfers::atomic_at))
            }
            WR_OUT_MBOX => Ok(self
                .problem_state()
                .with(|state| count(state.outbound.room()))),
            RD_IN_MBOX => Ok(self
                .problem_state()
                .with(|state| count(state.inbound.waiting()))),
            WR_OUT_INTR_MBOX => Ok(self
                .problem_state()
                .with(|state| count(state.outbound_interrupt.room()))),
            WR_EVENT_MASK..=WR_EVENT_ACK
            | WR_DEC..=WR_MS_SYNC_REQ
            | RD_EVENT_MASK..=TAG_ID
            | WR_TAG_MASK..=WR_TAG_UPDATE
            | WR_LIST_STALL_ACK => Ok(1),
            // The architecture gives every other channel the count 0, and asking is allowed.
            _ => Ok(0),
        }
    }

    fn external_condition(&mut self) -> bool {
        self.event_count()
    }

    fn stop_requested(&self) -> bool {
        self.problem_state().stop_requested()
    }

    fn set_interrupts_enabled(&mut self, enabled: bool) {
        self.own.interrupts_enabled = enabled;
    }

    fn srr0(&self) -> u32 {
        self.own.srr0
    }

    fn set_srr0(&mut self, address: u32) {
        self.own.srr0 = address & crate::local_store::LIMIT_MASK & !3;
    }
}
