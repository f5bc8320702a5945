//! When an SPE slept and when its MFC moved data, for pictures of a run.
//!
//! The times are simulated cycles from the machine's start, the same in every run. Effective
//! addresses are those of the process, which differ from run to run.

use super::spu_clock::Wait;
use crate::mfc::command::Operation;

/// A time for which an SPU slept in a channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sleep {
    /// The first cycle.
    pub start: u64,
    /// The cycle after the last.
    pub end: u64,
    /// The reason of the wait: a name as in [`Waits`](super::Waits).
    pub cause: &'static str,
}

/// A command of an SPE's MFC.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Transfer {
    /// The cycle in which the command was given.
    pub start: u64,
    /// The cycle in which it was complete.
    pub end: u64,
    /// The kind of command: `get`, `put`, `atomic`, `signal`, or `order` for barriers and the like.
    pub kind: &'static str,
    /// The effective address; for a list, that of the list's base.
    pub ea: u64,
    /// The bytes that it moved.
    pub bytes: u64,
}

/// The activities of one SPE, ordered by the times at which they began.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Timeline {
    /// Its sleeps.
    pub sleeps: Vec<Sleep>,
    /// The commands of its MFC.
    pub transfers: Vec<Transfer>,
}

impl Timeline {
    /// Records a sleep. An SPU that wakes, finds nothing and sleeps again has slept once.
    pub(super) fn sleep(&mut self, start: u64, end: u64, wait: Wait) {
        let cause = wait.name();
        if end <= start {
            return;
        }
        match self.sleeps.last_mut() {
            Some(last) if last.end == start && last.cause == cause => last.end = end,
            _ => self.sleeps.push(Sleep { start, end, cause }),
        }
    }

    pub(super) fn transfer(
        &mut self,
        (start, end): (u64, u64),
        operation: Operation,
        ea: u64,
        bytes: u64,
    ) {
        let kind = match operation {
            Operation::Get | Operation::GetList => "get",
            Operation::Put | Operation::PutList => "put",
            Operation::GetLine
            | Operation::PutLineConditional
            | Operation::PutLineUnconditional
            | Operation::PutLineQueued => "atomic",
            Operation::SendSignal => "signal",
            Operation::QueueBarrier
            | Operation::Sync
            | Operation::CacheHint
            | Operation::ZeroRange => "order",
        };
        self.transfers.push(Transfer { start, end, kind, ea, bytes });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn adjacent_sleeps_with_one_cause_are_merged() {
        let mut timeline = Timeline::default();
        for (start, end, wait) in [
            (10, 20, Wait::Tag),
            (20, 35, Wait::Tag),
            (35, 40, Wait::Mailbox),
            (50, 50, Wait::Tag),
            (60, 70, Wait::Mailbox),
        ] {
            timeline.sleep(start, end, wait);
        }
        let found = timeline.sleeps.iter().map(|s| (s.start, s.end, s.cause));
        let expected = [(10, 35, "tag"), (35, 40, "mailbox"), (60, 70, "mailbox")];
        assert_eq!(found.collect::<Vec<_>>(), expected);
    }
}
