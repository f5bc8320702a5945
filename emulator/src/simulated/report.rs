//! Figures of SPEs in simulated time, as they can be read from outside.

use spu_isa::timing::Account;

use crate::mfc::Commands;

/// Cycles that an SPU slept in its channels, by what it slept for. The pipeline's account has the
/// same cycles, as those of channels and of DMA.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Waits {
    /// For a mailbox, in either direction.
    pub mailbox: u64,
    /// For a signal.
    pub signal: u64,
    /// For an event.
    pub event: u64,
    /// For a tag.
    pub tag: u64,
    /// For a list that stalls.
    pub list: u64,
    /// For the status of an atomic command.
    pub atomic: u64,
    /// For room in the command queue.
    pub queue: u64,
}

impl Waits {
    /// All of them.
    #[must_use]
    pub const fn total(&self) -> u64 {
        self.mailbox + self.signal + self.event + self.tag + self.list + self.atomic + self.queue
    }
}

/// One SPE.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SpeReport {
    /// Its clock, from the machine's start, in cycles.
    pub clock: u64,
    /// Cycles in which it did not run at all: before its first run and between runs.
    pub stopped: u64,
    /// Where the others went: their sum and `stopped` are `clock`.
    pub account: Account,
    /// Cycles asleep in a channel.
    pub waits: Waits,
    /// What its MFC did.
    pub commands: Commands,
}

impl SpeReport {
    /// Cycles that it ran and did not sleep in a channel.
    #[must_use]
    pub fn busy(&self) -> u64 {
        self.account.cycles() - self.waits.total()
    }
}

/// A machine.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// How often the race went on without a thread or an SPE that might still have acted: more
    /// than the program's joins, and two runs may differ.
    pub absences: u64,
    /// Its SPEs, in the order of their making.
    pub spes: Vec<SpeReport>,
}

impl Report {
    /// The furthest clock, in cycles.
    #[must_use]
    pub fn clock(&self) -> u64 {
        self.spes.iter().map(|spe| spe.clock).max().unwrap_or(0)
    }
}
