//! The SPU's side of the MFC: parameters, tag status, stalled lists, atomic status.
//!
//! Only the thread that runs the SPU uses it. Where a channel would sleep, a method returns `None`
//! and the caller sleeps. Events are returned as bits, for the caller to raise.

use super::command::{Command, Operation, Order, Parameters, Side};
use super::error::DmaError;
use super::queue::{Path, Policy, Put, Queue, RunOutcome, SPU_QUEUE_DEPTH};
use super::timing::{Atomic, Movement, TransferTimes};
use crate::event;
use crate::memory::LINE;

const PUT_CONDITIONAL_DONE: u32 = 0;
const PUT_CONDITIONAL_FAILED: u32 = 1;
const PUT_UNCONDITIONAL_DONE: u32 = 2;
const GET_LINE_DONE: u32 = 4;

/// The value of parameters that a program did not write. No command accepts it.
const STALE: Parameters =
    Parameters { lsa: 0xdead_beef, ea: 0xdead_beef_dead_beef, size: 0xdead, tag: 0xdead };

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Condition {
    Any,
    All,
}

pub(crate) struct SpuSide {
    pub parameters: Parameters,
    queue: Queue,
    /// In simulated time: the commands that are not complete yet.
    transfers: Option<Box<dyn TransferTimes>>,
    tag_mask: u32,
    awaited: Option<Condition>,
    tag_status: Option<u32>,
    stalled_tags: u32,
    atomic_status: Option<u32>,
    /// The line that `getllar` read.
    seen: [u8; LINE],
    /// Events that occurred since they were last taken.
    events: u32,
}

impl SpuSide {
    pub(crate) fn new(policy: Policy, transfers: Option<Box<dyn TransferTimes>>) -> Self {
        Self {
            parameters: Parameters::default(),
            queue: Queue::new(SPU_QUEUE_DEPTH, policy),
            transfers,
            tag_mask: 0,
            awaited: None,
            tag_status: None,
            stalled_tags: 0,
            atomic_status: None,
            seen: [0; LINE],
            events: 0,
        }
    }

    pub(crate) fn take_events(&mut self) -> u32 {
        std::mem::take(&mut self.events)
    }

    /// The line as it was when it was reserved.
    pub(crate) fn seen_line(&self) -> &[u8; LINE] {
        &self.seen
    }

    /// Channel 21. Returns `None` if the queue is full and its commands may not run yet. The new
    /// command is not accepted then.
    pub(crate) fn command(&mut self, word: u32, path: Path<'_>) -> Result<Option<()>, DmaError> {
        let command = Command::new(word, self.parameters, Side::Spu)?;
        if command.operation.is_immediate() {
            self.atomic(&command, path)?;
        } else {
            while self.free_entries() == 0 {
                if !self.step(u32::MAX, path)? {
                    return Ok(None);
                }
            }
            self.queue.push(command);
            if self.queue.policy() == Policy::AtOnce {
                self.run_ready(path)?;
            }
        }
        if self.queue.policy() == Policy::AtLast {
            self.parameters = STALE;
        }
        Ok(Some(()))
    }

    /// In simulated time: the put that channel 21 is given, if it may be carried out later, as if
    /// it had been carried out now: if it needs no order, and nothing waits for a command's
    /// completion. With it and `deferred` earlier ones, the queue must not be full.
    pub(crate) fn put_to_defer(
        &mut self,
        word: u32,
        path: Path<'_>,
        deferred: usize,
    ) -> Option<Put> {
        let command = Command::new(word, self.parameters, Side::Spu).ok()?;
        let is_free = command.order == Order::Free && self.queue.is_empty();
        let has_space = self.free_entries() > deferred + 1;
        if !is_free || !has_space || self.awaited.is_some() {
            return None;
        }
        self.queue.prepare_put(&command, path)
    }

    /// Whether a status update waits for its condition.
    pub(crate) fn awaits_tags(&self) -> bool {
        self.awaited.is_some()
    }

    fn atomic(&mut self, command: &Command, path: Path<'_>) -> Result<(), DmaError> {
        let own = path.unit.reservation();
        let mut line = [0; LINE];
        path.local_store.read(command.lsa, &mut line);
        let status = match command.operation {
            Operation::GetLine => path.interconnect.get_line(command.ea, own).map(|line| {
                path.local_store.write(command.lsa, &line);
                self.seen = line;
                GET_LINE_DONE
            }),
            Operation::PutLineConditional => path
                .interconnect
                .put_line_conditional(command.ea, own, &self.seen, &line)
                .map(|done| if done { PUT_CONDITIONAL_DONE } else { PUT_CONDITIONAL_FAILED }),
            _ => {
                path.interconnect.put_line(command.ea, own, &line).map(|()| PUT_UNCONDITIONAL_DONE)
            }
        };
        let status = status.map_err(|fault| command.storage(fault.ea))?;
        self.atomic_status = Some(status);
        path.note(|| Movement {
            command: *command,
            pieces: Vec::new(),
            stalled: false,
            atomic: Some(match status {
                GET_LINE_DONE => Atomic::Read,
                PUT_CONDITIONAL_FAILED => Atomic::Lost,
                _ => Atomic::Written,
            }),
        });
        Ok(())
    }

    /// The timing of the commands, in simulated time.
    pub(crate) fn transfers(&self) -> Option<&dyn TransferTimes> {
        self.transfers.as_deref()
    }

    /// Lets `body` change the timing of the commands. This may complete tags and free queue
    /// entries.
    pub(crate) fn change_transfers(&mut self, body: impl FnOnce(&mut dyn TransferTimes)) {
        let was_full = self.free_entries() == 0;
        if let Some(transfers) = &mut self.transfers {
            body(&mut **transfers);
        }
        if was_full && self.free_entries() > 0 {
            self.events |= event::QUEUE_ROOM;
        }
        self.evaluate();
    }

    fn free_entries(&self) -> usize {
        let incomplete = self.transfers().map_or(0, |transfers| transfers.incomplete());
        self.queue.free().saturating_sub(incomplete)
    }

    /// Runs one command, with those of `tags` before others. Returns whether one could run.
    fn step(&mut self, tags: u32, path: Path<'_>) -> Result<bool, DmaError> {
        let was_full = self.free_entries() == 0;
        let ran = self.queue.run_one(tags, path);
        if was_full && self.free_entries() > 0 && self.transfers.is_none() {
            self.events |= event::QUEUE_ROOM;
        }
        if let Ok(Some(RunOutcome::Stalled(tag))) = ran {
            if self.stalled_tags == 0 {
                self.events |= event::LIST_STALL;
            }
            self.stalled_tags |= 1 << tag;
        }
        // In simulated time, a command is not complete when its data has moved.
        if self.transfers.is_none() {
            self.evaluate();
        }
        ran.map(|ran| ran.is_some())
    }

    /// Runs all commands that may run.
    pub(crate) fn run_ready(&mut self, path: Path<'_>) -> Result<(), DmaError> {
        while self.step(u32::MAX, path)? {}
        Ok(())
    }

    /// When commands are carried out.
    pub(crate) fn policy(&self) -> Policy {
        self.queue.policy()
    }

    /// The commands that wait in the queue, oldest first.
    pub(crate) fn queued(&self) -> impl Iterator<Item = &Command> {
        self.queue.commands()
    }

    /// What channels 24, 25 and 27 hold: the tag status and the atomic command's, if there are any,
    /// and the tags of stalled lists.
    pub(crate) fn statuses(&self) -> (Option<u32>, Option<u32>, u32) {
        (self.tag_status, self.atomic_status, self.stalled_tags)
    }

    /// Channel 21's count.
    pub(crate) fn free(&mut self, path: Path<'_>) -> Result<u32, DmaError> {
        let free = self.free_entries();
        if free == 0 {
            self.step(u32::MAX, path)?;
        }
        Ok(free as u32)
    }

    fn idle(&self) -> u32 {
        let incomplete = self.transfers().map_or(0, |transfers| transfers.busy_tags());
        self.tag_mask & !self.queue.busy_tags() & !incomplete
    }

    fn set_tag_status(&mut self, status: u32) {
        if self.tag_status.is_none() {
            self.events |= event::TAG_STATUS;
        }
        self.tag_status = Some(status);
        self.awaited = None;
    }

    fn evaluate(&mut self) {
        let idle = self.idle();
        let met = match self.awaited {
            None => false,
            Some(Condition::Any) => idle != 0,
            Some(Condition::All) => idle == self.tag_mask,
        };
        if met {
            self.set_tag_status(idle);
        }
    }

    /// Channel 22.
    pub(crate) fn set_tag_mask(&mut self, mask: u32) {
        self.tag_mask = mask;
        self.evaluate();
    }

    /// Channel 12.
    pub(crate) fn tag_mask(&self) -> u32 {
        self.tag_mask
    }

    /// Channel 23. A new condition replaces one that is still pending. A status that was not read
    /// stays.
    pub(crate) fn request_tag_status(
        &mut self,
        condition: u32,
        path: Path<'_>,
    ) -> Result<(), DmaError> {
        match condition {
            0 => {
                self.set_tag_status(self.idle());
                if self.idle() != self.tag_mask {
                    self.step(self.tag_mask, path)?;
                }
            }
            1 => self.awaited = Some(Condition::Any),
            2 => self.awaited = Some(Condition::All),
            _ => {
                return Err(DmaError::InvalidCommand {
                    what: "the condition of a tag-status update is 0, 1 or 2",
                    command: condition,
                });
            }
        }
        self.evaluate();
        Ok(())
    }

    /// Channel 24.
    pub(crate) fn read_tag_status(&mut self, path: Path<'_>) -> Result<Option<u32>, DmaError> {
        while self.tag_status.is_none() {
            if self.awaited.is_none() || !self.step(self.tag_mask, path)? {
                return Ok(None);
            }
        }
        Ok(self.tag_status.take())
    }

    /// Channel 24's count.
    pub(crate) fn tag_status_count(&mut self, path: Path<'_>) -> Result<u32, DmaError> {
        let count = u32::from(self.tag_status.is_some());
        if count == 0 && self.awaited.is_some() {
            self.step(self.tag_mask, path)?;
        }
        Ok(count)
    }

    /// Channel 25.
    pub(crate) fn read_stalled(&mut self, path: Path<'_>) -> Result<Option<u32>, DmaError> {
        while self.stalled_tags == 0 {
            if !self.step(u32::MAX, path)? {
                return Ok(None);
            }
        }
        Ok(Some(std::mem::take(&mut self.stalled_tags)))
    }

    /// Channel 25's count.
    pub(crate) fn stalled_count(&mut self, path: Path<'_>) -> Result<u32, DmaError> {
        let count = u32::from(self.stalled_tags != 0);
        if count == 0 {
            self.step(u32::MAX, path)?;
        }
        Ok(count)
    }

    /// Channel 26.
    pub(crate) fn resume(&mut self, tag: u32, path: Path<'_>) -> Result<(), DmaError> {
        self.queue.resume(tag);
        if self.queue.policy() == Policy::AtOnce {
            self.run_ready(path)?;
        }
        Ok(())
    }

    /// Channel 27.
    pub(crate) fn read_atomic_status(&mut self) -> Option<u32> {
        self.atomic_status.take()
    }

    /// Channel 27's count.
    pub(crate) fn atomic_status_count(&self) -> u32 {
        u32::from(self.atomic_status.is_some())
    }
}
