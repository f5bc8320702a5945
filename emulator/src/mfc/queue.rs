//! A command queue: which command may run, and running it.
//!
//! Invariant: an entry leaves the queue when it is complete, so the entries are exactly what is
//! outstanding, oldest first. Ordering is decided from the entries alone.

use std::collections::VecDeque;
use std::sync::Mutex;

use super::command::{Command, ELEMENT, MAX_TRANSFER, Operation, Order};
use super::error::DmaError;
use super::interconnect::{Interconnect, Unit};
use super::timing::{Movement, Parcel, Piece};
use crate::local_store::LocalStore;
use crate::lock::lock;
use crate::memory::{LINE, MemoryFault};

/// Commands that the SPU's queue holds.
pub const SPU_QUEUE_DEPTH: usize = 16;
/// Commands that the proxy queue holds.
pub const PROXY_QUEUE_DEPTH: usize = 8;

/// When a queued command is carried out, of all the moments that the architecture allows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Policy {
    /// As soon as its ordering lets it, oldest first.
    #[default]
    AtOnce,
    /// An adversary, which shows missing waits, fences and parameters: only when the program waits
    /// for a tag (or asks a second time for its status), when the queue is full, when the SPU has
    /// slept for some milliseconds, or when it stops; newest first where the order is free; and
    /// the command's parameters don't outlive it.
    AtLast,
}

/// What commands move between.
#[derive(Clone, Copy)]
pub(crate) struct Path<'a> {
    pub local_store: &'a LocalStore,
    pub interconnect: &'a Interconnect,
    pub unit: &'a dyn Unit,
    /// Where movements are noted, in simulated time.
    pub moved: Option<&'a Mutex<Vec<Movement>>>,
}

impl Path<'_> {
    /// Notes what a command moved.
    pub(crate) fn note(&self, movement: impl FnOnce() -> Movement) {
        if let Some(moved) = self.moved {
            lock(moved).push(movement());
        }
    }

    fn piece(&self, command: &Command, parcel: Option<Parcel>) -> Piece {
        Piece {
            ea: command.ea,
            size: command.size,
            peer: self.interconnect.peer(command.ea),
            parcel,
        }
    }

    /// Moves bytes out, or gives them back as what is still to be delivered.
    fn send(&self, ea: u64, bytes: &[u8]) -> Result<Option<Parcel>, MemoryFault> {
        if self.moved.is_some()
            && let Some(parcel) = self.interconnect.send_to_local_store(ea, bytes)
        {
            return Ok(Some(parcel));
        }
        self.interconnect.write(ea, bytes).map(|()| None)
    }
}

struct Entry {
    command: Command,
    /// Bytes of the list that are done, and where its next element goes.
    list_done: u32,
    list_lsa: u32,
    stalled: bool,
}

/// What became of a command that was run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ran {
    Complete,
    /// A list of this tag stalls until it is resumed.
    Stalled(u8),
}

pub(crate) struct Queue {
    entries: VecDeque<Entry>,
    depth: usize,
    policy: Policy,
    buffer: Box<[u8]>,
}

impl Queue {
    pub(crate) fn new(depth: usize, policy: Policy) -> Self {
        Self {
            entries: VecDeque::with_capacity(depth),
            depth,
            policy,
            buffer: vec![0; MAX_TRANSFER as usize].into_boxed_slice(),
        }
    }

    pub(crate) fn policy(&self) -> Policy {
        self.policy
    }

    pub(crate) fn room(&self) -> usize {
        self.depth - self.entries.len()
    }

    /// Appends a command. The caller has made room.
    pub(crate) fn push(&mut self, command: Command) {
        debug_assert!(self.room() > 0);
        self.entries.push_back(Entry {
            command,
            list_done: 0,
            list_lsa: command.lsa,
            stalled: false,
        });
    }

    /// Tags with something outstanding.
    pub(crate) fn busy_tags(&self) -> u32 {
        self.entries
            .iter()
            .fold(0, |tags, entry| tags | entry.command.tag_bit())
    }

    /// Lets the stalled lists of a tag go on.
    pub(crate) fn resume(&mut self, tag: u32) {
        for entry in &mut self.entries {
            if u32::from(entry.command.tag) == tag {
                entry.stalled = false;
            }
        }
    }

    /// Whether ordering lets entry `at` run.
    fn ready(&self, at: usize) -> bool {
        let own = &self.entries[at];
        if own.stalled {
            return false;
        }
        let tag = own.command.tag;
        let mut earlier_any = false;
        let mut earlier_of_tag = false;
        for entry in self.entries.range(..at) {
            let command = &entry.command;
            let same_tag = command.tag == tag;
            let holds_back = match command.operation {
                Operation::QueueBarrier => earlier_any,
                Operation::Sync => same_tag,
                _ => same_tag && command.order == Order::Barrier && earlier_of_tag,
            };
            if holds_back {
                return false;
            }
            earlier_any = true;
            earlier_of_tag |= same_tag;
        }
        match own.command.operation {
            Operation::QueueBarrier | Operation::Sync => !earlier_any,
            _ => own.command.order == Order::Free || !earlier_of_tag,
        }
    }

    /// The command to run next, one of `tags` before others. The adversary takes the newest, so
    /// that commands that need an order and did not ask for it come in the wrong one.
    fn next(&self, tags: u32) -> Option<usize> {
        let pick = |mask: u32| {
            let mut candidates = (0..self.entries.len())
                .filter(|&at| self.entries[at].command.tag_bit() & mask != 0 && self.ready(at));
            match self.policy {
                Policy::AtOnce => candidates.next(),
                Policy::AtLast => candidates.next_back(),
            }
        };
        pick(tags).or_else(|| pick(!tags))
    }

    /// Runs one command if any may run. A command that fails leaves the queue.
    pub(crate) fn run_one(&mut self, tags: u32, path: Path<'_>) -> Result<Option<Ran>, DmaError> {
        let Some(at) = self.next(tags) else {
            return Ok(None);
        };
        let Some(entry) = self.entries.get_mut(at) else {
            return Ok(None);
        };
        let ran = if entry.command.operation.is_list() {
            run_list(entry, &mut self.buffer, path)
        } else {
            run_simple(&entry.command, &mut self.buffer, path).map(|parcel| {
                path.note(|| Movement {
                    command: entry.command,
                    pieces: pieces_of(&entry.command, parcel, path),
                    stalled: false,
                });
                Ran::Complete
            })
        };
        if !matches!(ran, Ok(Ran::Stalled(_))) {
            self.entries.remove(at);
        }
        ran.map(Some)
    }
}

fn run_list(entry: &mut Entry, buffer: &mut [u8], path: Path<'_>) -> Result<Ran, DmaError> {
    let list = entry.command;
    let mut pieces = Vec::new();
    while entry.list_done < list.size {
        let address = (list.ea as u32).wrapping_add(entry.list_done);
        let words = [0, 4].map(|n| path.local_store.load_word(address.wrapping_add(n)));
        let (element, stall) = list.element(words, entry.list_lsa)?;
        let parcel = run_simple(&element, buffer, path)?;
        if path.moved.is_some() {
            pieces.push(path.piece(&element, parcel));
        }
        entry.list_done += ELEMENT;
        entry.list_lsa = entry
            .list_lsa
            .wrapping_add(element.size.next_multiple_of(16));
        if stall {
            entry.stalled = true;
            path.note(|| Movement {
                command: list,
                pieces,
                stalled: true,
            });
            return Ok(Ran::Stalled(list.tag));
        }
    }
    path.note(|| Movement {
        command: list,
        pieces,
        stalled: false,
    });
    Ok(Ran::Complete)
}

/// What a command that is no list moves over the bus.
fn pieces_of(command: &Command, parcel: Option<Parcel>, path: Path<'_>) -> Vec<Piece> {
    match command.operation {
        Operation::QueueBarrier | Operation::Sync | Operation::CacheHint => Vec::new(),
        _ => vec![path.piece(command, parcel)],
    }
}

/// Runs a command that is no list; gives what of it is still to be delivered.
fn run_simple(
    command: &Command,
    buffer: &mut [u8],
    path: Path<'_>,
) -> Result<Option<Parcel>, DmaError> {
    let Command { lsa, ea, size, .. } = *command;
    let bytes = &mut buffer[..size.min(MAX_TRANSFER) as usize];
    let moved = match command.operation {
        Operation::Put | Operation::SendSignal => {
            path.local_store.read(lsa, bytes);
            path.send(ea, bytes)
        }
        Operation::Get => path.interconnect.read(ea, bytes).map(|()| {
            path.local_store.write(lsa, bytes);
            None
        }),
        Operation::ZeroRange => {
            bytes.fill(0);
            path.send(ea, bytes)
        }
        Operation::PutLineQueued => {
            let mut line = [0; LINE];
            path.local_store.read(lsa, &mut line);
            path.interconnect
                .put_line(ea, path.unit.reservation(), &line)
                .map(|()| None)
        }
        _ => Ok(None),
    };
    moved.map_err(|fault| command.storage(fault.ea))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mfc::command::{Parameters, Side};

    /// A queue with these (opcode, tag) in it.
    fn queue(commands: &[(u32, u32)]) -> Queue {
        let mut queue = Queue::new(16, Policy::AtLast);
        for &(word, tag) in commands {
            let parameters = Parameters {
                tag,
                ..Parameters::default()
            };
            queue.push(Command::new(word, parameters, Side::Spu).unwrap());
        }
        queue
    }

    fn ready(commands: &[(u32, u32)]) -> Vec<usize> {
        let queue = queue(commands);
        (0..commands.len()).filter(|&at| queue.ready(at)).collect()
    }

    #[test]
    fn unordered_commands_are_all_ready() {
        assert_eq!(ready(&[(0x20, 1), (0x40, 1), (0x20, 2)]), [0, 1, 2]);
    }

    #[test]
    fn a_fence_holds_only_itself() {
        assert_eq!(ready(&[(0x20, 1), (0x22, 1), (0x20, 1)]), [0, 2]);
        assert_eq!(ready(&[(0x20, 2), (0x22, 1)]), [0, 1]);
    }

    #[test]
    fn a_barrier_holds_itself_and_the_later_of_its_tag() {
        assert_eq!(ready(&[(0x20, 1), (0x21, 1), (0x20, 1), (0x20, 2)]), [0, 3]);
        assert_eq!(ready(&[(0x21, 1), (0x20, 1)]), [0, 1]);
    }

    #[test]
    fn the_barrier_command_holds_every_tag() {
        assert_eq!(ready(&[(0x20, 1), (0xc0, 3), (0x20, 2)]), [0]);
        assert_eq!(ready(&[(0xc0, 3), (0x20, 2)]), [0, 1]);
    }

    #[test]
    fn sync_waits_for_all_and_holds_its_tag() {
        assert_eq!(ready(&[(0x20, 1), (0xcc, 3), (0x20, 2), (0x20, 3)]), [0, 2]);
    }

    #[test]
    fn the_policies_differ_in_direction() {
        let mut queue = queue(&[(0x20, 1), (0x20, 2), (0x22, 2)]);
        assert_eq!(queue.next(u32::MAX), Some(1));
        assert_eq!(queue.next(1 << 1), Some(0));
        assert_eq!(queue.next(1 << 9), Some(1));
        queue.policy = Policy::AtOnce;
        assert_eq!(queue.next(u32::MAX), Some(0));
        assert_eq!(queue.busy_tags(), 0b110);
    }
}
