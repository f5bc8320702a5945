//! The cost of one or several instructions.

use spu_isa::timing::{Cause, Stalls};

/// Issues, and the cycles charged to them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// How often the instruction issued.
    pub issued: u64,
    /// How often it issued as the second of a dual pair.
    pub joined: u64,
    /// Cycles in which nothing issued because of the instruction.
    pub stalls: Stalls,
}

impl Tally {
    /// Cycles in which the instruction issued alone or as the first of a pair.
    #[must_use]
    pub const fn issuing(&self) -> u64 {
        self.issued - self.joined
    }

    /// All cycles charged to the instruction.
    #[must_use]
    pub fn cycles(&self) -> u64 {
        self.issuing() + self.stalls.total()
    }

    /// The share of the issuing cycles in which two instructions issued, from 0 to 1. It is
    /// meaningful only for code that contains whole pairs.
    #[must_use]
    pub fn dual_share(&self) -> f64 {
        match self.issuing() {
            0 => 0.0,
            issuing => self.joined as f64 / issuing as f64,
        }
    }

    /// The cause of most stall cycles, and their number.
    #[must_use]
    pub fn largest_stall(&self) -> Option<(Cause, u64)> {
        self.stalls.by_cost().into_iter().next()
    }

    /// Adds another tally.
    pub fn add(&mut self, other: &Self) {
        self.issued += other.issued;
        self.joined += other.joined;
        self.stalls.extend(&other.stalls);
    }
}
