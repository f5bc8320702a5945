//! The SPU's channels: what each number leads to, and how a blocking one sleeps.
//!
//! Invariant: a channel access either happens wholly or, when a stop request ends its sleep, not at
//! all; so the instruction can be run again.

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
    pub(crate) fn new(policy: Policy) -> Self {
        Self {
            mfc: SpuSide::new(policy),
            decrementer: Decrementer::default(),
            interrupts_enabled: false,
            srr0: 0,
        }
    }
}

/// The channels of an SPE while it runs.
pub(crate) struct RunningChannels<'a> {
    pub(super) own: &'a mut SpuState,
    pub(super) spe: &'a Spe,
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
        }
    }

    /// Does something with the MFC and raises the events that come of it.
    fn mfc<T>(
        &mut self,
        body: impl FnOnce(&mut SpuSide, Path<'a>) -> Result<T, DmaError>,
    ) -> Result<T, Stop> {
        let path = self.path();
        let result = body(&mut self.own.mfc, path);
        self.problem_state().raise(self.own.mfc.take_events());
        result.map_err(Stop::Dma)
    }

    /// Carries out what the policy put off: the program has stopped.
    pub(crate) fn finish_commands(&mut self) -> Result<(), Stop> {
        self.mfc(SpuSide::run_ready)
    }

    /// Sleeps until `poll` yields. `limit` bounds one sleep; after it both are asked anew.
    fn sleep<T>(
        &mut self,
        mut limit: impl FnMut(&mut Self) -> Option<Duration>,
        mut poll: impl FnMut(&mut Self, &mut State) -> Option<T>,
    ) -> Result<T, Stop> {
        loop {
            let grace = (self.own.mfc.policy() == Policy::AtLast).then_some(GRACE);
            let limit = limit(self).into_iter().chain(grace).min();
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
    fn receive(&mut self, mut take: impl FnMut(&mut State) -> Option<u32>) -> Result<u32, Stop> {
        let value = self.sleep(|_| None, |_, state| take(state))?;
        self.problem_state().announce();
        Ok(value)
    }

    /// Sleeps until `give` finds room, then tells those who wait for the data.
    fn send(&mut self, mut give: impl FnMut(&mut State) -> bool) -> Result<(), Stop> {
        self.sleep(|_| None, |_, state| give(state).then_some(()))?;
        self.problem_state().announce();
        Ok(())
    }

    /// Sleeps in a channel that only the SPU's own queue can fill. It is called when nothing in the
    /// queue may run, so only a stop ends it.
    fn sleep_for_ever<T>(&mut self) -> Result<T, Stop> {
        self.sleep(|_| None, |_, _| None)
    }

    fn now(&self) -> u64 {
        self.spe.interconnect.clock().ticks()
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

    fn silent_event_limit(&self) -> Option<Duration> {
        let mask = self.problem_state().with(|state| state.events.mask());
        let decrementer = (mask & event::DECREMENTER != 0)
            .then(|| self.own.decrementer.until_event(self.now()))
            .flatten()
            .map(|ticks| self.spe.interconnect.clock().host_time(ticks));
        let line = (mask & event::RESERVATION_LOST != 0
            && self.problem_state().reservation().line().is_some())
        .then_some(LINE_WATCH);
        [decrementer, line].into_iter().flatten().min()
    }

    fn read_events(&mut self) -> Result<u32, Stop> {
        self.sleep(
            |channels| {
                channels.watch_line();
                channels.silent_event_limit()
            },
            |channels, state| {
                channels.poll_decrementer(state);
                state.events.read()
            },
        )
    }

    fn event_count(&mut self) -> bool {
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
            RD_SIG_NOTIFY_1 => self.receive(|state| state.signals[0].read()),
            RD_SIG_NOTIFY_2 => self.receive(|state| state.signals[1].read()),
            RD_DEC => Ok(self.own.decrementer.value(self.now())),
            RD_EVENT_MASK => Ok(self.problem_state().with(|state| state.events.mask())),
            RD_TAG_MASK => Ok(self.own.mfc.tag_mask()),
            RD_MACH_STAT => Ok(u32::from(self.own.interrupts_enabled)),
            RD_SRR0 => Ok(self.own.srr0),
            RD_TAG_STAT => match self.mfc(SpuSide::read_tag_status)? {
                Some(status) => Ok(status),
                None => self.sleep_for_ever(),
            },
            RD_LIST_STALL_STAT => match self.mfc(SpuSide::read_stalled)? {
                Some(tags) => Ok(tags),
                None => self.sleep_for_ever(),
            },
            RD_ATOMIC_STAT => match self.own.mfc.read_atomic_status() {
                Some(status) => Ok(status),
                None => self.sleep_for_ever(),
            },
            RD_IN_MBOX => self.receive(|state| state.inbound.read()),
            _ => Err(Stop::InvalidChannel(channel, ChannelAccess::Read)),
        }
    }

    fn write(&mut self, channel: u8, value: u32) -> Result<(), Stop> {
        match channel {
            WR_EVENT_MASK => self
                .problem_state()
                .with(|state| state.events.set_mask(value)),
            WR_EVENT_ACK => self.acknowledge(value),
            WR_DEC => {
                let now = self.now();
                self.own.decrementer.load(value, now);
            }
            // Transfers of others into this local store are done when they are done: there is
            // nothing to wait for.
            WR_MS_SYNC_REQ => self.problem_state().raise(event::MULTISOURCE_SYNC),
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
            CMD => {
                if self.mfc(|mfc, path| mfc.command(value, path))?.is_none() {
                    return self.sleep_for_ever();
                }
            }
            WR_TAG_MASK => self.mfc(|mfc, _| {
                mfc.set_tag_mask(value);
                Ok(())
            })?,
            WR_TAG_UPDATE => self.mfc(|mfc, path| mfc.request_tag_status(value, path))?,
            WR_LIST_STALL_ACK => self.mfc(|mfc, path| mfc.resume(value, path))?,
            WR_OUT_MBOX => self.send(|state| state.outbound.write(value))?,
            WR_OUT_INTR_MBOX => self.send(|state| state.outbound_interrupt.write(value))?,
            _ => return Err(Stop::InvalidChannel(channel, ChannelAccess::Write)),
        }
        Ok(())
    }

    fn count(&mut self, channel: u8) -> Result<u32, Stop> {
        let count = |waiting: usize| waiting as u32;
        match channel {
            RD_EVENT_STAT => Ok(u32::from(self.event_count())),
            RD_SIG_NOTIFY_1 | RD_SIG_NOTIFY_2 => {
                let at = usize::from(channel - RD_SIG_NOTIFY_1);
                Ok(self
                    .problem_state()
                    .with(|state| u32::from(state.signals[at].waiting())))
            }
            CMD => self.mfc(SpuSide::room),
            RD_TAG_STAT => self.mfc(SpuSide::tag_status_count),
            RD_LIST_STALL_STAT => self.mfc(SpuSide::stalled_count),
            RD_ATOMIC_STAT => Ok(self.own.mfc.atomic_status_count()),
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
