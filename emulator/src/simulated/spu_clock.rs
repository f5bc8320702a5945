//! An SPU's clock: what the pipelines count, and the time in which it does not run.

use std::cell::RefCell;

use super::report::Waits;
use super::turnstile::Actor;
use crate::channel::Channels;
use crate::interp::{Observer, Spu};
use crate::local_store::LocalStore;
use crate::profile::{Profile, Recording};
use crate::stop::Stopped;
use crate::timer::Timer;
use spu_isa::Instruction;
use spu_isa::timing::{Cause, Pipeline, Rules};

/// What an SPU sleeps for in a channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wait {
    Mailbox,
    Signal,
    Event,
    Tag,
    List,
    Atomic,
    Queue,
}

impl Wait {
    fn cause(self) -> Cause {
        match self {
            Self::Mailbox | Self::Signal | Self::Event => Cause::Channel,
            Self::Tag | Self::List | Self::Atomic | Self::Queue => Cause::Dma,
        }
    }

    fn of(self, waits: &mut Waits) -> &mut u64 {
        match self {
            Self::Mailbox => &mut waits.mailbox,
            Self::Signal => &mut waits.signal,
            Self::Event => &mut waits.event,
            Self::Tag => &mut waits.tag,
            Self::List => &mut waits.list,
            Self::Atomic => &mut waits.atomic,
            Self::Queue => &mut waits.queue,
        }
    }
}

/// Invariant: the clock is the pipelines' clock and `stopped`.
#[derive(Debug, Default)]
pub(crate) struct SpuClock {
    timer: Timer,
    stopped: u64,
    waits: Waits,
    /// If the SPU is profiled.
    recording: Option<Recording>,
}

impl SpuClock {
    pub fn new(rules: Rules, profiled: bool) -> Self {
        Self {
            timer: Timer::new(Pipeline::new(rules)),
            recording: profiled.then(Recording::default),
            ..Self::default()
        }
    }

    pub fn now(&self) -> u64 {
        self.stopped + self.timer.pipeline.clock()
    }

    pub fn timer(&self) -> &Timer {
        &self.timer
    }

    pub fn stopped(&self) -> u64 {
        self.stopped
    }

    pub fn waits(&self) -> Waits {
        self.waits
    }

    /// The SPU starts at `cycle`, having stood still until then.
    pub fn start(&mut self, cycle: u64) {
        self.stopped += cycle.saturating_sub(self.now());
    }

    /// The SPU sleeps until `cycle` in the channel instruction that issued last.
    pub fn sleep(&mut self, cycle: u64, wait: Wait) {
        let slept = cycle.saturating_sub(self.now());
        *wait.of(&mut self.waits) += slept;
        let until = self.timer.pipeline.clock() + slept;
        self.timer.pipeline.stall_until(until, wait.cause());
        if let Some(recording) = &mut self.recording {
            recording.charge_last(&self.timer.pipeline);
        }
    }

    /// Hands over all charges so far, if the SPU is profiled.
    pub fn hand_over(&mut self, to: &mut Profile) {
        if let Some(recording) = &mut self.recording {
            recording.hand_over(to);
        }
    }

    /// The SPU has stopped.
    pub fn stop(&mut self) {
        if let Some(recording) = &mut self.recording {
            recording.stopped();
        }
    }
}

/// Feeds the clock while the SPU runs.
pub(crate) struct Timed<'a> {
    clock: &'a RefCell<SpuClock>,
    actor: &'a Actor,
}

impl<'a> Timed<'a> {
    pub fn new(clock: &'a RefCell<SpuClock>, actor: &'a Actor) -> Self {
        Self { clock, actor }
    }
}

impl Timed<'_> {
    /// Runs at most `limit` instructions, each after the clock and `observer` have seen it; `None`
    /// if the SPU would go on. An interrupt shows one instruction that does not run.
    ///
    /// Instruction by instruction, so that the interpreter's loop exists once in the program:
    /// beside a second one, for this observer, the compiler no longer inlines the arithmetic into
    /// either, and without simulated time the tracer takes 1.4 times as long.
    pub fn run<C: Channels, O: Observer>(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        limit: u64,
        observer: &mut O,
    ) -> Option<Stopped> {
        if self.clock.borrow().recording.is_some() {
            self.run_as::<true, _, _>(spu, local_store, channels, limit, observer)
        } else {
            self.run_as::<false, _, _>(spu, local_store, channels, limit, observer)
        }
    }

    /// [`run`](Self::run), whose loop exists twice so that a profile costs nothing where there is
    /// none.
    #[inline(never)]
    fn run_as<const RECORDED: bool, C: Channels, O: Observer>(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        channels: &mut C,
        limit: u64,
        observer: &mut O,
    ) -> Option<Stopped> {
        for _ in 0..limit {
            let word = local_store.load_word(spu.pc());
            if let Some(instruction) = Instruction::decode(word) {
                self.count::<RECORDED>(spu, instruction);
                observer.before_instruction(spu, instruction);
            }
            let stopped = spu.step(local_store, channels);
            if stopped.is_some() {
                return stopped;
            }
        }
        None
    }

    #[inline]
    fn count<const RECORDED: bool>(&mut self, spu: &Spu, instruction: Instruction) {
        let mut clock = self.clock.borrow_mut();
        let SpuClock {
            timer, recording, ..
        } = &mut *clock;
        match recording {
            Some(recording) if RECORDED => timer.record(spu, instruction, recording),
            _ => timer.before_instruction(spu, instruction),
        }
        // It has issued and takes effect next: a load finds what has arrived by now.
        self.actor.run_up_to(clock.now());
    }
}
