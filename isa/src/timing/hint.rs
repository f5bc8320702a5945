//! The branch hint: one entry, the last hint wins.

use super::rules::{HINT_CYCLES, HINT_MINIMUM_INSTRUCTIONS};
use crate::address::LIMIT_MASK;
use crate::instructions::{Class, Instruction, Op, feature};

/// Where the SPU goes on fetching behind a branch before it knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Prediction {
    /// Straight on.
    NotTaken,
    /// At this address.
    To(u32),
    /// Where the branch goes: a register's value that the analysis does not know, taken for right.
    Right,
}

/// What one hint loaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Hint {
    branch: u32,
    prediction: Prediction,
    /// First cycle in which the branch can use it.
    ready: u64,
    /// Which instruction of the stream it was.
    number: u64,
}

/// Whether the instruction only reserves a slot for prefetch: it hints nothing and reads nothing.
#[inline]
pub(super) fn reserves_prefetch(i: Instruction) -> bool {
    i.op == Op::Hbr && i.immediate & feature::CHANNEL_OR_PREFETCH != 0
}

/// Address of the branch that the instruction at `pc` hints; `None` if it hints none.
#[must_use]
pub fn hinted_branch(pc: u32, i: Instruction) -> Option<u32> {
    let hints = i.op.row().class == Class::Hb && !reserves_prefetch(i);
    hints.then(|| pc.wrapping_add_signed(i.branch_distance.into()) & LIMIT_MASK)
}

/// Whether the instruction hints a branch to where a register says.
#[must_use]
pub fn hints_by_register(i: Instruction) -> bool {
    i.op == Op::Hbr && hinted_branch(0, i).is_some()
}

impl Hint {
    /// The entry that the hint `i` loads, which is instruction `number` of the stream and issues
    /// in `cycle`; `None` if it hints no branch.
    pub fn new(pc: u32, i: Instruction, cycle: u64, number: u64) -> Option<Self> {
        let branch = hinted_branch(pc, i)?;
        let prediction = match i.op {
            Op::Hbra => Prediction::To(i.immediate as u32 & LIMIT_MASK),
            Op::Hbrr => Prediction::To(pc.wrapping_add_signed(i.immediate) & LIMIT_MASK),
            _ => Prediction::Right,
        };
        Some(Self {
            branch,
            prediction,
            ready: cycle + HINT_CYCLES,
            number,
        })
    }

    /// Whether the hint was this instruction of the stream.
    pub fn is_number(&self, number: u64) -> bool {
        self.number == number
    }

    /// Sets the target, which for `hbr` is a register's value.
    pub fn set_target(&mut self, target: u32) {
        self.prediction = Prediction::To(target & LIMIT_MASK & !3);
    }

    /// The prediction for the branch at `pc`, instruction `number` of the stream, and the first
    /// cycle in which it can issue; `None` if the hint is for another, or comes too late to be
    /// seen.
    #[inline]
    pub fn for_branch(&self, pc: u32, number: u64) -> Option<(Prediction, u64)> {
        let seen = number > self.number + HINT_MINIMUM_INSTRUCTIONS;
        (self.branch == pc && seen).then_some((self.prediction, self.ready))
    }

    /// The entry as seen from `clock` and instruction `number`: equal entries work alike.
    pub fn relative(&self, clock: u64, number: u64) -> Self {
        // An older hint works no better than one that is just old enough.
        let age = number
            .saturating_sub(self.number)
            .min(HINT_MINIMUM_INSTRUCTIONS + 1);
        Self {
            ready: self.ready.saturating_sub(clock),
            number: age,
            ..*self
        }
    }

    /// What [`relative`](Self::relative) gave, at another `clock` and instruction `number`.
    pub fn at(&self, clock: u64, number: u64) -> Self {
        Self {
            ready: clock + self.ready,
            number: number - self.number,
            ..*self
        }
    }
}
