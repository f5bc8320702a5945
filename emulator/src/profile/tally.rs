//! What one instruction, or several, cost.

use spu_isa::timing::{Cause, Stalls};

/// Issues and cycles charged to them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// How often it issued.
    pub issued: u64,
    /// How often as the second of a dual pair.
    pub joined: u64,
    /// Cycles in which nothing issued because of it.
    pub stalls: Stalls,
}

impl Tally {
    /// Cycles in which it issued alone or as the first of a pair.
    #[must_use]
    pub const fn issuing(&self) -> u64 {
        self.issued - self.joined
    }

    /// All cycles charged to it.
    #[must_use]
    pub fn cycles(&self) -> u64 {
        self.issuing() + self.stalls.total()
    }

    /// Share of the issuing cycles in which two instructions issued, 0 to 1: for what is whole
    /// pairs.
    #[must_use]
    pub fn dual_share(&self) -> f64 {
        match self.issuing() {
            0 => 0.0,
            issuing => self.joined as f64 / issuing as f64,
        }
    }

    /// The cause of most of its stalls, and its cycles.
    #[must_use]
    pub fn largest_stall(&self) -> Option<(Cause, u64)> {
        self.stalls.by_cost().into_iter().next()
    }

    /// Adds another's.
    pub fn add(&mut self, other: &Self) {
        self.issued += other.issued;
        self.joined += other.joined;
        self.stalls.extend(&other.stalls);
    }
}
