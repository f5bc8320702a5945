//! The branch hint. There is one entry, and the last hint replaces it.

use super::rules::HINT_MINIMUM_INSTRUCTIONS;
use crate::address::LIMIT_MASK;
use crate::instructions::{Class, Instruction, Op, feature};

/// The address from which the SPU fetches after a branch until the branch is decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Prediction {
    /// The next instruction.
    NotTaken,
    /// This address.
    To(u32),
    /// The branch's target, which is assumed to be correct: a register's value that the analysis
    /// can't determine.
    Right,
}

/// The entry that one hint loaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Hint {
    branch: u32,
    prediction: Prediction,
    /// The first cycle in which the branch can use the hint.
    ready: u64,
    /// The position of the hint in the stream.
    number: u64,
}

/// Whether the instruction only reserves a slot for prefetch. It then hints no branch and reads no
/// register.
#[inline]
pub(super) fn reserves_prefetch(i: Instruction) -> bool {
    i.op == Op::Hbr && i.immediate & feature::CHANNEL_OR_PREFETCH != 0
}

/// The address of the branch that the instruction at `pc` hints, or `None` if it hints none.
#[must_use]
pub fn hinted_branch(pc: u32, i: Instruction) -> Option<u32> {
    let hints = i.op.row().class == Class::Hb && !reserves_prefetch(i);
    hints.then(|| pc.wrapping_add_signed(i.branch_distance.into()) & LIMIT_MASK)
}

/// Whether the instruction hints a branch to the address in a register.
#[must_use]
pub fn hints_by_register(i: Instruction) -> bool {
    i.op == Op::Hbr && hinted_branch(0, i).is_some()
}

impl Hint {
    /// The entry that the hint `i` loads. The hint is instruction `number` of the stream, and its
    /// branch can use it in cycle `ready`. `None` if it hints no branch.
    pub fn new(pc: u32, i: Instruction, ready: u64, number: u64) -> Option<Self> {
        let branch = hinted_branch(pc, i)?;
        let prediction = match i.op {
            Op::Hbra => Prediction::To(i.immediate as u32 & LIMIT_MASK),
            Op::Hbrr => Prediction::To(pc.wrapping_add_signed(i.immediate) & LIMIT_MASK),
            _ => Prediction::Right,
        };
        Some(Self { branch, prediction, ready, number })
    }

    /// Whether the hint is this instruction of the stream.
    pub fn is_number(&self, number: u64) -> bool {
        self.number == number
    }

    /// Sets the target, which is a register's value for `hbr`.
    pub fn set_target(&mut self, target: u32) {
        self.prediction = Prediction::To(target & LIMIT_MASK & !3);
    }

    /// The prediction for the branch at `pc`, which is instruction `number` of the stream, and the
    /// first cycle in which it can issue. `None` if the hint is for another branch or too close to
    /// the branch to be seen.
    #[inline]
    pub fn for_branch(&self, pc: u32, number: u64) -> Option<(Prediction, u64)> {
        let seen = number > self.number + HINT_MINIMUM_INSTRUCTIONS;
        (self.branch == pc && seen).then_some((self.prediction, self.ready))
    }

    /// The entry relative to `clock` and to instruction `number`. Equal relative entries behave
    /// equally.
    pub fn relative(&self, clock: u64, number: u64) -> Self {
        // Once a hint is old enough, its age no longer matters.
        let age = number.saturating_sub(self.number).min(HINT_MINIMUM_INSTRUCTIONS + 1);
        Self { ready: self.ready.saturating_sub(clock), number: age, ..*self }
    }

    /// The inverse of [`relative`](Self::relative), for another `clock` and instruction `number`.
    pub fn at(&self, clock: u64, number: u64) -> Self {
        Self { ready: clock + self.ready, number: number - self.number, ..*self }
    }
}
