//! The timeline as a JSON file: when each SPE slept, and when its MFC moved data.

use serde::{Deserialize, Serialize};
use spu_emulator::simulated::Timeline;

/// A time for which an SPU slept in a channel. Cycles count from the machine's start.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SleepEntry {
    /// The first cycle.
    pub start: u64,
    /// The cycle after the last.
    pub end: u64,
    /// The cause of the wait, as in the report's `blocked_by`.
    pub cause: String,
}

/// A command of an MFC.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct TransferEntry {
    /// The cycle in which it was given.
    pub start: u64,
    /// The cycle in which it was complete.
    pub end: u64,
    /// `get`, `put`, `atomic`, `signal`, or `order` for barriers and the like.
    pub kind: String,
    /// The effective address, an address of the process that ran.
    pub ea: u64,
    /// The bytes that it moved.
    pub bytes: u64,
}

/// The activities of one SPE.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct SpeTimeline {
    /// Its sleeps.
    pub sleeps: Vec<SleepEntry>,
    /// The commands of its MFC.
    pub transfers: Vec<TransferEntry>,
}

/// The timeline of a machine.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct TimelineFile {
    /// The frequency of the clock that the cycles count.
    pub cycles_per_second: u64,
    /// The SPEs in the order of creation.
    pub spes: Vec<SpeTimeline>,
}

impl TimelineFile {
    /// Creates the file's contents from what each SPE recorded.
    #[must_use]
    pub fn new(cycles_per_second: u64, spes: &[Timeline]) -> Self {
        Self { cycles_per_second, spes: spes.iter().map(SpeTimeline::new).collect() }
    }
}

impl SpeTimeline {
    fn new(timeline: &Timeline) -> Self {
        let sleeps = timeline.sleeps.iter().map(|sleep| SleepEntry {
            start: sleep.start,
            end: sleep.end,
            cause: sleep.cause.to_owned(),
        });
        let transfers = timeline.transfers.iter().map(|transfer| TransferEntry {
            start: transfer.start,
            end: transfer.end,
            kind: transfer.kind.to_owned(),
            ea: transfer.ea,
            bytes: transfer.bytes,
        });
        Self { sleeps: sleeps.collect(), transfers: transfers.collect() }
    }
}
