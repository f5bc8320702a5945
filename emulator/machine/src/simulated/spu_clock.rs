//! An SPU's clock: the cycles that the pipelines count, and the time in which the SPU does not
//! run.

use std::sync::Arc;

use super::check::{Check, Difference};
use super::figures::{Method, SimulationOptions};
use super::memo::{Memo, StateId, TransitionId};
use super::path::Path;
use super::report::Waits;
use crate::interp::{Block, LONGEST, Spu, next};
use crate::local_store::LocalStore;
use crate::profile::{Profile, Recording};
use crate::timer::Timer;
use spu_isa::timing::{Account, Cause, Pipeline, Rules};
use spu_isa::{Instruction, LIMIT_MASK};

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

    /// The name of the cause, that of its field in [`Waits`].
    pub fn name(self) -> &'static str {
        match self {
            Self::Mailbox => "mailbox",
            Self::Signal => "signal",
            Self::Event => "event",
            Self::Tag => "tag",
            Self::List => "list",
            Self::Atomic => "atomic",
            Self::Queue => "queue",
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
    /// The instructions of the next block that have run, but whose time has not passed yet.
    untimed: Untimed,
    stopped: u64,
    waits: Waits,
    /// Present if the SPU is profiled.
    recording: Option<Recording>,
    /// Present if the clock is checked.
    check: Option<Box<Check>>,
}

/// The first instructions of a block, which compiled code has run, but which the clock has not
/// timed yet.
#[derive(Clone, Copy, Debug, Default)]
struct Untimed {
    start: u32,
    length: u32,
}

/// A block that the clock has timed, but which has not run to its end yet.
#[derive(Clone, Copy, Debug)]
pub(super) struct TimedBlock {
    from: StateId,
    transition: TransitionId,
    /// The number of its instructions that have run already.
    pub ran: u32,
    /// The number of instructions that have not run yet.
    pub length: u64,
    /// The address after the block.
    pub end: u32,
    /// The hint by register that ends the block, if one does.
    pub hint: Option<Instruction>,
}

impl SpuClock {
    pub fn new(rules: Rules, options: SimulationOptions) -> Self {
        Self {
            timer: Timer::new(Pipeline::new(rules)),
            memo: Memo::new(rules),
            recording: options.profile.then(Recording::default),
            check: (options.method == Method::Checked)
                .then(|| Box::new(Check::new(rules, options))),
            ..Self::default()
        }
    }

    #[inline]
    pub fn now(&self) -> u64 {
        self.stopped + self.timer.pipeline.clock() + self.ahead
    }

    /// The causes of the cycles.
    pub fn account(&mut self) -> &Account {
        self.bring_up_to_date();
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
        self.bring_up_to_date();
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
        self.bring_up_to_date();
        if let Some(recording) = &mut self.recording {
            if let Some(check) = &mut self.check {
                check.compare_profile(recording);
            }
            recording.hand_over(to);
        }
    }

    /// The SPU has stopped.
    pub fn stop(&mut self) {
        self.bring_up_to_date();
        if let Some(recording) = &mut self.recording {
            recording.stopped();
        }
        if let Some(check) = &mut self.check {
            check.stop();
        }
    }

    /// Brings the timer to the current state of the pipelines.
    fn bring_up_to_date(&mut self) {
        if let Some(state) = self.state.take() {
            self.bring_up_to(state);
            if let Some(check) = &mut self.check {
                check.compare_account(&self.timer);
            }
        }
    }

    fn bring_up_to(&mut self, state: StateId) {
        self.memo.bring_up_to(state, &mut self.timer, self.recording.as_mut());
        self.ahead = 0;
    }

    /// Times one instruction, at the program counter, in the pipeline model.
    pub(super) fn issue(&mut self, spu: &Spu, instruction: Instruction) {
        self.time_by_instruction(spu);
        self.bring_up_to_date();
        match &mut self.recording {
            Some(recording) => self.timer.record(spu, instruction, recording),
            None => self.timer.record(spu, instruction, &mut ()),
        }
        self.issue_in_check(spu, instruction);
    }

    /// Times one instruction, at the program counter, only in the check's model.
    pub(super) fn issue_in_check(&mut self, spu: &Spu, instruction: Instruction) {
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
    ) -> Option<TimedBlock> {
        let Untimed { start, length: ran } = self.untimed;
        let start = if ran == 0 { spu.pc() } else { start };
        let (from, at) = self.find((start, ran), spu, local_store)?;
        let transition = self.memo.transition(at);
        let cycles = transition.cycles;
        let timed = TimedBlock {
            from,
            transition: at,
            ran,
            length: u64::from(transition.length.checked_sub(ran)?),
            end: start.wrapping_add(4 * transition.length) & LIMIT_MASK,
            hint: transition.hint,
        };
        if timed.length > most || !may_pass(self.now() + cycles) {
            return None;
        }
        self.advance(at);
        self.untimed.length = 0;
        Some(timed)
    }

    /// The state of the pipelines, and the transition that a block takes from it. `block` is the
    /// block's address and the number of its instructions that have run.
    #[inline]
    fn find(
        &mut self,
        block: (u32, u32),
        spu: &mut Spu,
        local_store: &LocalStore,
    ) -> Option<(StateId, TransitionId)> {
        let from = match self.state {
            Some(state) if !self.memo.is_full() => state,
            _ => self.remember(block.0)?,
        };
        let at = self.memo.find(from, block, spu, local_store)?;
        Some((from, at))
    }

    #[inline]
    fn advance(&mut self, at: TransitionId) {
        self.ahead += self.memo.transition(at).cycles;
        self.state = Some(self.memo.take(at));
    }

    /// Whether compiled code may run: memoised timing needs a pipeline state to start from, so
    /// some instruction must have issued.
    #[inline]
    pub(crate) fn may_pass(&mut self, pc: u32) -> bool {
        self.untimed.length > 0 || self.state.is_some() || self.remember(pc).is_some()
    }

    /// Advances the clock by the first `count` instructions of a path, which compiled code has
    /// run. `hints` are the targets of its hints by register. The last instructions may stay
    /// untimed, if their block is not complete.
    ///
    /// `proven` is the value of [`Spu::code_changes`] when the path was last compared with the
    /// interpreter's decoded instructions. Local store held the path's words when it ran.
    pub(crate) fn advance_along(
        &mut self,
        spu: &mut Spu,
        local_store: &LocalStore,
        (path, proven): (&Path, &mut u64),
        count: u32,
        hints: &mut impl Iterator<Item = u32>,
    ) {
        if *proven != spu.code_changes() {
            self.time_by_instruction(spu);
            spu.decode(&path.words);
            *proven = spu.code_changes();
        }
        if self.untimed.length == 0 {
            self.untimed.start = path.words[0].0;
        }
        let mut passed = 0;
        for end in path.ends.iter().take_while(|end| end.after <= count) {
            self.untimed.length += end.after - passed;
            passed = end.after;
            while self.untimed.length > 0 {
                self.time_one_block(spu, local_store);
            }
            if end.hint.is_some()
                && let Some(target) = hints.next()
            {
                self.hint_target(target);
                if let Some(check) = &mut self.check {
                    check.hint_target(target);
                }
            }
            self.untimed.start = end.next;
        }
        self.untimed.length += count - passed;
        while self.untimed.length >= LONGEST as u32 {
            self.time_one_block(spu, local_store);
        }
    }

    /// Times the first untimed block, which compiled code has run to its end.
    #[inline]
    fn time_one_block(&mut self, spu: &mut Spu, local_store: &LocalStore) {
        let Untimed { start, length } = self.untimed;
        let Some((_, at)) = self.find((start, length), spu, local_store) else {
            return self.time_by_instruction(spu);
        };
        let transition = self.memo.transition(at);
        let Some(left) = length.checked_sub(transition.length) else {
            return self.time_by_instruction(spu);
        };
        self.untimed =
            Untimed { start: start.wrapping_add(4 * transition.length) & LIMIT_MASK, length: left };
        if self.check.is_some() {
            let block = Arc::clone(transition.block());
            self.issue_block_in_check(&block, usize::MAX);
        }
        self.advance(at);
    }

    /// Times all untimed instructions, one by one.
    #[inline]
    pub(super) fn time_by_instruction(&mut self, spu: &Spu) {
        if self.untimed.length > 0 {
            self.issue_untimed(spu);
        }
    }

    #[cold]
    fn issue_untimed(&mut self, spu: &Spu) {
        let Untimed { start, length } = std::mem::take(&mut self.untimed);
        self.bring_up_to_date();
        let mut pc = start;
        for _ in 0..length {
            let Some(instruction) = spu.latest(pc) else {
                unreachable!("instructions of compiled code are decoded before they are timed");
            };
            self.issue_at(pc, instruction);
            if let Some(check) = &mut self.check {
                check.issue_at(pc, instruction);
            }
            pc = next(pc);
        }
    }

    fn issue_at(&mut self, pc: u32, instruction: Instruction) {
        match &mut self.recording {
            Some(recording) => self.timer.issue(pc, instruction, recording),
            None => self.timer.issue(pc, instruction, &mut ()),
        }
    }

    /// Times the first `count` instructions of a block only in the check's model.
    fn issue_block_in_check(&mut self, block: &Block, count: usize) {
        if let Some(check) = &mut self.check {
            for (pc, instruction) in block.instructions().take(count) {
                check.issue_at(pc, instruction);
            }
        }
    }

    /// Times the instructions of a block that have run already in the check's model.
    pub(super) fn issue_ran_in_check(&mut self, timed: TimedBlock) {
        let block = self.block(timed);
        self.issue_block_in_check(&block, timed.ran as usize);
    }

    /// The block that began last.
    pub(super) fn block(&self, timed: TimedBlock) -> Arc<Block> {
        Arc::clone(self.memo.transition(timed.transition).block())
    }

    /// The number of the timer's state. `None` if the instruction at `pc` has issued already.
    #[cold]
    fn remember(&mut self, pc: u32) -> Option<StateId> {
        self.bring_up_to_date();
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
    pub(super) fn cut_short(&mut self, timed: TimedBlock, ran: u64) {
        let block = self.block(timed);
        self.memo.undo(timed.transition);
        self.state = None;
        self.bring_up_to(timed.from);
        for (pc, instruction) in block.instructions().take(timed.ran as usize + ran as usize) {
            self.issue_at(pc, instruction);
        }
    }

    /// The last instruction was a hint by register, with this target.
    #[inline]
    pub(super) fn hint_target(&mut self, target: u32) {
        match self.state {
            Some(state) => self.state = Some(self.memo.hinted(state, target)),
            None => self.timer.pipeline.hint_target(target),
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
