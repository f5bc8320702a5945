//! An SPU's clock: the cycles that the pipelines count, and the time in which the SPU does not
//! run.

use std::sync::Arc;

use super::check::{Check, Difference};
use super::figures::{Keep, Method};
use super::memo::{Memo, StateId, TransitionId};
use super::report::Waits;
use crate::interp::Spu;
use crate::local_store::LocalStore;
use crate::profile::{Profile, Recording};
use crate::timer::Timer;
use spu_isa::Instruction;
use spu_isa::timing::{Account, Cause, Pipeline, Rules};

/// The reason for which an SPU sleeps in a channel.
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

/// Invariant: the clock is the sum of the timer's clock, `ahead` and `stopped`.
#[derive(Debug, Default)]
pub(crate) struct SpuClock {
    timer: Timer,
    memo: Memo,
    /// The state of the pipelines, if blocks have passed that the timer has not seen.
    state: Option<StateId>,
    /// The cycles of these blocks.
    ahead: u64,
    stopped: u64,
    waits: Waits,
    /// Present if the SPU is profiled.
    recording: Option<Recording>,
    /// Present if the clock is checked.
    check: Option<Box<Check>>,
}

/// A block whose time has passed, but which has not run yet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Begun {
    from: StateId,
    transition: TransitionId,
    /// Number of instructions.
    pub length: u64,
    /// The hint by register that ends the block, if one does.
    pub hint: Option<Instruction>,
}

impl SpuClock {
    pub fn new(rules: Rules, keep: Keep) -> Self {
        Self {
            timer: Timer::new(Pipeline::new(rules)),
            memo: Memo::new(rules),
            recording: keep.profile.then(Recording::default),
            check: (keep.method == Method::Checked).then(|| Box::new(Check::new(rules, keep))),
            ..Self::default()
        }
    }

    #[inline]
    pub fn now(&self) -> u64 {
        self.stopped + self.timer.pipeline.clock() + self.ahead
    }

    /// The causes of the cycles.
    pub fn account(&mut self) -> &Account {
        self.settle();
        self.timer.pipeline.account()
    }

    pub fn stopped(&self) -> u64 {
        self.stopped
    }

    pub fn waits(&self) -> Waits {
        self.waits
    }

    /// The first difference that the check has found, if the clock is checked.
    pub fn difference(&self) -> Option<&Difference> {
        self.check.as_ref()?.difference()
    }

    /// The SPU starts at `cycle`, and did not run until then.
    pub fn start(&mut self, cycle: u64) {
        self.stopped += cycle.saturating_sub(self.now());
    }

    /// The SPU sleeps until `cycle` in the channel instruction that issued last.
    pub fn sleep(&mut self, cycle: u64, wait: Wait) {
        let slept = cycle.saturating_sub(self.now());
        if slept == 0 {
            return;
        }
        *wait.of(&mut self.waits) += slept;
        self.settle();
        let until = self.timer.pipeline.clock() + slept;
        self.timer.pipeline.stall_until(until, wait.cause());
        if let Some(recording) = &mut self.recording {
            recording.charge_last(&self.timer.pipeline);
        }
        if let Some(check) = &mut self.check {
            check.sleep(slept, wait.cause());
        }
    }

    /// Hands over all charges so far, if the SPU is profiled.
    pub fn hand_over(&mut self, to: &mut Profile) {
        self.settle();
        if let Some(recording) = &mut self.recording {
            if let Some(check) = &mut self.check {
                check.compare_profile(recording);
            }
            recording.hand_over(to);
        }
    }

    /// The SPU has stopped.
    pub fn stop(&mut self) {
        self.settle();
        if let Some(recording) = &mut self.recording {
            recording.stopped();
        }
        if let Some(check) = &mut self.check {
            check.stop();
        }
    }

    /// Brings the timer to the current state of the pipelines.
    fn settle(&mut self) {
        if let Some(state) = self.state.take() {
            self.settle_at(state);
            if let Some(check) = &mut self.check {
                check.compare_account(&self.timer);
            }
        }
    }

    fn settle_at(&mut self, state: StateId) {
        self.memo
            .settle(state, &mut self.timer, self.recording.as_mut());
        self.ahead = 0;
    }

    /// Times one instruction, at the program counter, in the pipeline model.
    pub(super) fn issue(&mut self, spu: &Spu, instruction: Instruction) {
        self.settle();
        match &mut self.recording {
            Some(recording) => self.timer.record(spu, instruction, recording),
            None => self.timer.record(spu, instruction, &mut ()),
        }
        self.issue_beside(spu, instruction);
    }

    /// Times one instruction, at the program counter, only in the check's model.
    pub(super) fn issue_beside(&mut self, spu: &Spu, instruction: Instruction) {
        if let Some(check) = &mut self.check {
            check.issue(spu, instruction);
        }
    }

    /// Lets the time of the block at the program counter pass. Returns `None`, without any effect,
    /// if the next instruction must be timed by itself: if there is no block, if it has more than
    /// `most` instructions, or if `may_pass` refuses the cycle in which its last instruction
    /// issues.
    #[inline]
    pub(super) fn begin(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        most: u64,
        may_pass: impl FnOnce(u64) -> bool,
    ) -> Option<Begun> {
        let from = match self.state {
            Some(state) if !self.memo.is_full() => state,
            _ => self.remember(spu.pc())?,
        };
        let at = self.memo.find(from, spu, local_store)?;
        let transition = self.memo.transition(at);
        let cycles = transition.cycles;
        let begun = Begun {
            from,
            transition: at,
            length: transition.length.into(),
            hint: transition.hint,
        };
        if begun.length > most || !may_pass(self.now() + cycles) {
            return None;
        }
        self.state = Some(self.memo.happen(at));
        self.ahead += cycles;
        Some(begun)
    }

    /// The number of the timer's state. `None` if the instruction at `pc` has issued already.
    #[cold]
    fn remember(&mut self, pc: u32) -> Option<StateId> {
        self.settle();
        if self.memo.is_full() {
            self.memo.forget();
        }
        if self.timer.waits_at(pc) {
            return None;
        }
        let state = self.memo.number(self.timer.state()?);
        self.state = Some(state);
        Some(state)
    }

    /// Corrects the time of the last block: only `ran` of its instructions have run, because the
    /// next one was rewritten.
    #[cold]
    pub(super) fn cut_short(&mut self, begun: Begun, ran: u64) {
        let transition = self.memo.transition(begun.transition);
        let block = Arc::clone(transition.block());
        self.memo.undo(begun.transition);
        self.state = None;
        self.settle_at(begun.from);
        for (pc, instruction) in block.instructions().take(ran as usize) {
            match &mut self.recording {
                Some(recording) => self.timer.issue(pc, instruction, recording),
                None => self.timer.issue(pc, instruction, &mut ()),
            }
        }
    }

    /// The last block has run, and ended with a hint by register.
    #[inline]
    pub(super) fn hint_target(&mut self, spu: &Spu, hint: Instruction) {
        if let Some(state) = self.state {
            let target = spu.register(hint.ra).preferred();
            self.state = Some(self.memo.hinted(state, target));
        }
    }

    /// Compares the pipelines with the check's model, after the block at `address`.
    pub(super) fn compare(&mut self, address: u32) {
        if let Some(check) = &mut self.check {
            let clock = self.timer.pipeline.clock() + self.ahead;
            let state = match self.state {
                Some(state) => Some(self.memo.state(state).clone()),
                None => self.timer.state(),
            };
            check.compare_state(address, clock, state);
        }
    }
}
