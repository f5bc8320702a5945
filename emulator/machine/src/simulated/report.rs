//! The figures of SPEs in simulated time, for reports.

use spu_isa::timing::Account;

use crate::mfc::Commands;

/// Cycles for which an SPU slept in its channels, by cause. In the pipeline's account these cycles
/// are those of channels and DMA.
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
    /// For a list that has stalled.
    pub list: u64,
    /// For the status of an atomic command.
    pub atomic: u64,
    /// For a free entry of the command queue.
    pub queue: u64,
}

impl Waits {
    /// The sum of all of them.
    #[must_use]
    pub const fn total(&self) -> u64 {
        self.mailbox + self.signal + self.event + self.tag + self.list + self.atomic + self.queue
    }
}

/// The figures of one SPE.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SpeReport {
    /// The SPE's clock in cycles, from the machine's start.
    pub clock: u64,
    /// Cycles in which the SPU did not run: before its first run and between runs.
    pub stopped: u64,
    /// The causes of all other cycles. Their sum plus `stopped` is `clock`.
    pub account: Account,
    /// Cycles for which the SPU slept in a channel.
    pub waits: Waits,
    /// The commands of the SPE's MFC.
    pub commands: Commands,
}

impl SpeReport {
    /// Cycles in which the SPU ran and did not sleep in a channel.
    #[must_use]
    pub fn busy(&self) -> u64 {
        self.account.cycles() - self.waits.total()
    }
}

/// The figures of a machine.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// How often actors stopped waiting for a thread or an SPE that might still have acted. If
    /// there are any, two runs may differ.
    pub timeouts: u64,
    /// The SPEs in the order of creation.
    pub spes: Vec<SpeReport>,
}

impl Report {
    /// The largest clock, in cycles.
    #[must_use]
    pub fn clock(&self) -> u64 {
        self.spes.iter().map(|spe| spe.clock).max().unwrap_or(0)
    }
}
