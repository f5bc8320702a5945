//! The account of cycles: what each cycle was spent on.

use crate::instructions::Class;
use std::fmt;

/// The reason why no instruction issued in a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Cause {
    /// The next instruction needed the result of an instruction of this class.
    Operand(Class),
    /// Nothing issues in the cycles after a double-precision instruction.
    DoubleStall,
    /// An FP6 instruction needed the unit that an FP7 instruction occupied.
    FloatConflict,
    /// The instructions were not available: straight-line code whose line had not arrived.
    Fetch,
    /// A branch was mispredicted.
    BranchMiss,
    /// A branch waited for its hint.
    HintWait,
    /// `sync` or `dsync` waited.
    Synchronise,
    /// A channel was empty for a read or full for a write.
    Channel,
    /// The program waited for the MFC.
    Dma,
}

const CLASSES: [Class; 13] = [
    Class::Fx2,
    Class::Fx3,
    Class::Fxb,
    Class::Fp6,
    Class::Fp7,
    Class::Fpd,
    Class::Nop,
    Class::Shuf,
    Class::Ls,
    Class::Hb,
    Class::Br,
    Class::Spr,
    Class::Lnop,
];

const OTHERS: [Cause; 8] = [
    Cause::DoubleStall,
    Cause::FloatConflict,
    Cause::Fetch,
    Cause::BranchMiss,
    Cause::HintWait,
    Cause::Synchronise,
    Cause::Channel,
    Cause::Dma,
];

impl Cause {
    const COUNT: usize = CLASSES.len() + OTHERS.len();

    #[inline]
    const fn index(self) -> usize {
        match self {
            Self::Operand(class) => class as usize,
            Self::DoubleStall => CLASSES.len(),
            Self::FloatConflict => CLASSES.len() + 1,
            Self::Fetch => CLASSES.len() + 2,
            Self::BranchMiss => CLASSES.len() + 3,
            Self::HintWait => CLASSES.len() + 4,
            Self::Synchronise => CLASSES.len() + 5,
            Self::Channel => CLASSES.len() + 6,
            Self::Dma => CLASSES.len() + 7,
        }
    }

    /// All causes, operands first.
    pub fn all() -> impl Iterator<Item = Self> {
        CLASSES.into_iter().map(Self::Operand).chain(OTHERS)
    }
}

/// The name of the class in binutils and in the schedules.
fn class_name(class: Class) -> String {
    format!("{class:?}").to_uppercase()
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = match self {
            Self::Operand(class) => return write!(f, "operand of {}", class_name(*class)),
            Self::DoubleStall => "double-precision stall",
            Self::FloatConflict => "FP6 after FP7",
            Self::Fetch => "fetch",
            Self::BranchMiss => "branch miss",
            Self::HintWait => "hint wait",
            Self::Synchronise => "synchronise",
            Self::Channel => "channel",
            Self::Dma => "DMA",
        };
        f.write_str(name)
    }
}

/// Cycles in which nothing issued, by cause.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stalls([u64; Cause::COUNT]);

impl Default for Stalls {
    fn default() -> Self {
        Self::NONE
    }
}

impl Stalls {
    /// No cycles.
    pub const NONE: Self = Self([0; Cause::COUNT]);

    /// The cycles of one cause.
    #[must_use]
    pub const fn of(&self, cause: Cause) -> u64 {
        self.0[cause.index()]
    }

    /// The sum of all cycles.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.0.iter().sum()
    }

    /// The causes that cost cycles, with their cycles, the most expensive first.
    #[must_use]
    pub fn by_cost(&self) -> Vec<(Cause, u64)> {
        let mut stalls: Vec<_> = Cause::all()
            .map(|cause| (cause, self.of(cause)))
            .filter(|&(_, cycles)| cycles != 0)
            .collect();
        stalls.sort_by_key(|&(_, cycles)| std::cmp::Reverse(cycles));
        stalls
    }

    /// The cycles that were added since `earlier`, an older copy of these counts.
    #[inline]
    #[must_use]
    pub fn since(&self, earlier: &Self) -> Self {
        Self(std::array::from_fn(|cause| self.0[cause] - earlier.0[cause]))
    }

    /// Adds `cycles` of one cause.
    #[inline]
    pub fn add(&mut self, cause: Cause, cycles: u64) {
        self.0[cause.index()] += cycles;
    }

    /// Adds all of `others`.
    #[inline]
    pub fn extend(&mut self, others: &Self) {
        for (sum, cycles) in self.0.iter_mut().zip(others.0) {
            *sum += cycles;
        }
    }
}

/// The number of cycles by how they were spent. Invariant: each cycle is counted once.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Account {
    single: u64,
    dual: u64,
    stalls: Stalls,
}

impl Account {
    /// Cycles in which one instruction issued.
    #[must_use]
    pub const fn single(&self) -> u64 {
        self.single
    }

    /// Cycles in which two instructions issued.
    #[must_use]
    pub const fn dual(&self) -> u64 {
        self.dual
    }

    /// Cycles in which no instruction issued for this cause.
    #[must_use]
    pub const fn waited(&self, cause: Cause) -> u64 {
        self.stalls.of(cause)
    }

    /// Cycles in which no instruction issued, by cause.
    #[must_use]
    pub const fn stalls(&self) -> &Stalls {
        &self.stalls
    }

    /// The causes that cost cycles, with their cycles, the most expensive first.
    #[must_use]
    pub fn waits(&self) -> Vec<(Cause, u64)> {
        self.stalls.by_cost()
    }

    /// Cycles in which no instruction issued.
    #[must_use]
    pub fn stalled(&self) -> u64 {
        self.stalls.total()
    }

    /// The sum of all cycles.
    #[must_use]
    pub fn cycles(&self) -> u64 {
        self.single + self.dual + self.stalled()
    }

    /// Number of instructions issued.
    #[must_use]
    pub const fn instructions(&self) -> u64 {
        self.single + 2 * self.dual
    }

    /// The share of the issuing cycles in which two instructions issued, from 0 to 1.
    #[must_use]
    pub fn dual_share(&self) -> f64 {
        match self.single + self.dual {
            0 => 0.0,
            issuing => self.dual as f64 / issuing as f64,
        }
    }

    /// The cycles that were added since `earlier`, an older copy of this account.
    #[must_use]
    pub fn since(&self, earlier: &Self) -> Self {
        Self {
            single: self.single - earlier.single,
            dual: self.dual - earlier.dual,
            stalls: self.stalls.since(&earlier.stalls),
        }
    }

    pub(super) fn apply(&mut self, delta: &AccountDelta) {
        // The second of a pair turns a cycle that was counted as single into a dual one.
        self.single = self.single + delta.instructions - 2 * delta.joined;
        self.dual += delta.joined;
        self.stalls.extend(&delta.stalls);
    }

    #[inline]
    pub(super) fn add_wait(&mut self, cause: Cause, cycles: u64) {
        self.stalls.add(cause, cycles);
    }

    #[inline]
    pub(super) fn add_single(&mut self) {
        self.single += 1;
    }

    /// A second instruction issues in the last cycle, which was counted as single.
    #[inline]
    pub(super) fn join(&mut self) {
        self.single -= 1;
        self.dual += 1;
    }
}

/// The amounts that parts of the executed stream add to an account.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AccountDelta {
    /// Number of instructions issued.
    pub instructions: u64,
    /// How many of them issued as the second of a pair.
    pub joined: u64,
    /// Cycles in which no instruction issued.
    pub stalls: Stalls,
}

impl AccountDelta {
    /// The sum of all cycles.
    #[must_use]
    pub fn cycles(&self) -> u64 {
        self.instructions - self.joined + self.stalls.total()
    }
}
