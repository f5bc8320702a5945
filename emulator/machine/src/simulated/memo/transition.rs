//! The effect of a block on a state of the pipelines.

use std::sync::Arc;

use super::StateId;
use crate::interp::Block;
use crate::profile::Recording;
use crate::timer::{Recorder, Timer, TimerState};
use spu_isa::Instruction;
use spu_isa::timing::{AccountDelta, Cause, Issue, Pipeline, Rules, Stalls, hints_by_register};

/// The account that is assumed before a transition is computed. It is large enough that everything
/// in a state has happened in some cycle.
const BEFORE: AccountDelta =
    AccountDelta { instructions: 1 << 60, joined: 0, stalls: Stalls::NONE };

/// Cycles in which nothing issues.
#[derive(Clone, Copy, Debug)]
struct Charge {
    /// The instruction that is charged: 0 is the last one before the block, 1 is the block's
    /// first.
    to: u8,
    cause: Cause,
    cycles: u64,
}

/// The transition by a block from a state. The part that each run of the block reads fits into one
/// cache line.
#[derive(Debug)]
pub(in super::super) struct Transition {
    /// [`Spu::code_changes`](crate::interp::Spu::code_changes) when the block was last compared.
    pub(super) code_changes: u64,
    /// How often the transition was taken since it was last settled.
    pub(super) count: u64,
    /// The cycles that it adds to the clock.
    pub cycles: u64,
    /// The state after it.
    pub(super) to: StateId,
    /// Number of instructions in the block.
    pub length: u32,
    /// The hint by register that ends the block, if one does.
    pub hint: Option<Instruction>,
    details: Box<Details>,
}

/// The composition of a transition's cycles.
#[derive(Debug)]
struct Details {
    block: Arc<Block>,
    /// The last instruction before the block, with its address.
    previous: (u32, Instruction),
    /// Which instructions issued as the second of a pair, beginning with the lowest bit.
    joined: u64,
    charges: Box<[Charge]>,
}

impl Transition {
    /// The transition by `block` from `start`, and the state after it. The caller sets the state's
    /// number.
    pub(super) fn new(start: &TimerState, block: Arc<Block>, rules: Rules) -> (Self, TimerState) {
        let mut timer = timer(start, rules);
        let before = timer.pipeline.clock();
        let mut charging = Charging::new(&timer.pipeline);
        for (pc, instruction) in block.instructions() {
            timer.issue(pc, instruction, &mut charging);
        }
        let transition = Self {
            code_changes: 0,
            count: 0,
            cycles: timer.pipeline.clock() - before,
            to: StateId(0),
            length: block.instructions.len() as u32,
            hint: Some(block.last()).filter(|last| hints_by_register(*last)),
            details: Box::new(Details {
                block,
                previous: start.previous,
                joined: charging.joined,
                charges: charging.charges.into(),
            }),
        };
        (transition, state(&timer))
    }

    /// The block.
    pub fn block(&self) -> &Arc<Block> {
        &self.details.block
    }

    /// Adds the effect of taking the transition `count` times.
    pub(super) fn add_to(&self, count: u64, delta: &mut AccountDelta) {
        delta.instructions += count * u64::from(self.length);
        delta.joined += count * u64::from(self.details.joined.count_ones());
        for charge in &self.details.charges {
            delta.stalls.add(charge.cause, count * charge.cycles);
        }
    }

    /// Charges the cost of taking the transition `count` times.
    pub(super) fn charge(&self, count: u64, recording: &mut Recording) {
        if count == 0 {
            return;
        }
        let Details { block, previous, joined, charges } = &*self.details;
        for (at, (pc, instruction)) in block.instructions().enumerate() {
            let tally = recording.tally(pc, instruction);
            tally.issued += count;
            tally.joined += count * (joined >> at & 1);
        }
        for charge in charges {
            let (pc, instruction) = match charge.to {
                0 => *previous,
                at => block.instruction(usize::from(at) - 1),
            };
            let stalls = &mut recording.tally(pc, instruction).stalls;
            stalls.add(charge.cause, count * charge.cycles);
        }
    }
}

/// `state` after its hint, with the hint's target.
pub(super) fn hinted(before: &TimerState, target: u32, rules: Rules) -> TimerState {
    let mut timer = timer(before, rules);
    timer.pipeline.hint_target(target);
    state(&timer)
}

fn timer(start: &TimerState, rules: Rules) -> Timer {
    let mut timer = Timer::new(Pipeline::new(rules));
    timer.resume(start, &BEFORE);
    timer
}

fn state(timer: &Timer) -> TimerState {
    match timer.state() {
        Some(state) => state,
        None => unreachable!("it has gone on from a state"),
    }
}

/// Charges as [`Recording`] does, but by position in the block instead of entries in a profile.
struct Charging {
    issued: u8,
    joined: u64,
    charges: Vec<Charge>,
    /// Cycles charged so far, and those of them in which nothing issued.
    clock: u64,
    stalls: Stalls,
}

impl Charging {
    fn new(pipeline: &Pipeline) -> Self {
        Self {
            issued: 0,
            joined: 0,
            charges: Vec::new(),
            clock: pipeline.clock(),
            stalls: pipeline.account().stalls().clone(),
        }
    }

    fn charge(&mut self, pipeline: &Pipeline) {
        if pipeline.clock() == self.clock {
            return;
        }
        let stalls = pipeline.account().stalls();
        let charge = |(cause, cycles)| Charge { to: self.issued, cause, cycles };
        let passed = stalls.since(&self.stalls).by_cost();
        self.charges.extend(passed.into_iter().map(charge));
        self.stalls = stalls.clone();
        self.clock = pipeline.clock();
    }
}

impl Recorder for Charging {
    fn issued(&mut self, _: u32, _: Instruction, issue: &Issue, pipeline: &Pipeline) {
        self.joined |= u64::from(issue.dual) << self.issued;
        self.issued += 1;
        self.clock += u64::from(!issue.dual);
        self.charge(pipeline);
    }

    fn branched(&mut self, pipeline: &Pipeline) {
        self.charge(pipeline);
    }
}
