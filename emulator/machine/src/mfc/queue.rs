//! A command queue: it decides which command may run, and runs it.
//!
//! Invariant: an entry leaves the queue when it is complete, so the entries are exactly the
//! outstanding commands, oldest first. Ordering is decided from the entries alone.

use std::collections::VecDeque;
use std::sync::Mutex;

use super::command::{Command, ELEMENT, MAX_TRANSFER, Operation, Order};
use super::error::DmaError;
use super::interconnect::{Interconnect, Unit};
use super::timing::{Movement, Peer, PendingWrite, Piece};
use crate::local_store::{self, LocalStore};
use crate::lock::lock;
use crate::memory::{LINE, MemoryFault};

/// Number of commands that the SPU's queue holds.
pub const SPU_QUEUE_DEPTH: usize = 16;
/// Number of commands that the proxy queue holds.
pub const PROXY_QUEUE_DEPTH: usize = 8;

/// When a queued command is carried out. The architecture allows each of these policies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Policy {
    /// As soon as its ordering allows, oldest first.
    #[default]
    AtOnce,
    /// As late as possible, to reveal missing waits, fences and parameters. Commands run only when
    /// the program waits for a tag (or asks a second time for its status), when the queue is full,
    /// when the SPU has slept for some milliseconds, or when it stops. Where the order is free,
    /// the newest runs first. The command's parameters don't outlive it.
    AtLast,
}

/// The units between which commands move data.
#[derive(Clone, Copy)]
pub(crate) struct Path<'a> {
    pub local_store: &'a LocalStore,
    pub interconnect: &'a Interconnect,
    pub unit: &'a dyn Unit,
    /// In simulated time: records the movements.
    pub moved: Option<&'a Mutex<Vec<Movement>>>,
}

impl Path<'_> {
    /// Records what a command moved.
    pub(crate) fn note(&self, movement: impl FnOnce() -> Movement) {
        if let Some(moved) = self.moved {
            lock(moved).push(movement());
        }
    }

    fn piece(&self, command: &Command, pending: Option<PendingWrite>) -> Piece {
        Piece {
            lsa: command.lsa,
            ea: command.ea,
            size: command.size,
            peer: self.interconnect.peer(command.ea),
            pending,
        }
    }

    /// Writes the bytes, or returns them if they are to be delivered later.
    fn send(&self, ea: u64, bytes: &[u8]) -> Result<Option<PendingWrite>, MemoryFault> {
        if self.moved.is_some()
            && let Some(pending) = self.interconnect.send_to_local_store(ea, bytes)
        {
            return Ok(Some(pending));
        }
        self.interconnect.write(ea, bytes).map(|()| None)
    }
}

#[derive(Clone, Copy)]
struct Entry {
    command: Command,
    /// Bytes of the list that are done, and the local-store address of its next element.
    list_done: u32,
    list_lsa: u32,
    stalled: bool,
}

impl Entry {
    fn new(command: Command) -> Self {
        Self { command, list_done: 0, list_lsa: command.lsa, stalled: false }
    }

    /// The list's next element, and whether the list stalls after it.
    fn element(&self, path: Path<'_>) -> Result<(Command, bool), DmaError> {
        let address = (self.command.ea as u32).wrapping_add(self.list_done);
        let words = [0, 4].map(|n| path.local_store.load_word(address.wrapping_add(n)));
        self.command.element(words, self.list_lsa)
    }

    /// The list's next element is done.
    fn pass(&mut self, element: &Command) {
        self.list_done += ELEMENT;
        let size = element.size.next_multiple_of(16);
        self.list_lsa = self.list_lsa.wrapping_add(size);
    }
}

/// The outcome of running a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RunOutcome {
    Complete,
    /// A list with this tag stalls until it is resumed.
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

    pub(crate) fn free(&self) -> usize {
        self.depth - self.entries.len()
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// What this put would write, with copies of its bytes. `None` if it is no put to main memory,
    /// stalls, might fail, or does not fit the buffer.
    pub(crate) fn prepare_put(&mut self, command: &Command, path: Path<'_>) -> Option<Put> {
        let mut entry = Entry::new(*command);
        let is_writable = |ea, size| path.interconnect.is_writable_memory(ea, size);
        let elements = match command.operation {
            Operation::PutList => {
                let is_good = |element: &Command| is_writable(element.ea, element.size);
                let elements = next_elements(&mut entry, &self.buffer, path, is_good);
                (entry.list_done == command.size).then_some(())?;
                copy_out(&elements, &mut self.buffer, path);
                elements
            }
            Operation::Put if is_writable(command.ea, command.size) => {
                let bytes = &mut self.buffer[..command.size as usize];
                path.local_store.read(command.lsa, bytes);
                vec![*command]
            }
            _ => return None,
        };
        let length: u32 = elements.iter().map(|element| element.size).sum();
        Some(Put { command: *command, bytes: self.buffer[..length as usize].into(), elements })
    }

    /// The commands in the queue, oldest first.
    pub(crate) fn commands(&self) -> impl Iterator<Item = &Command> {
        self.entries.iter().map(|entry| &entry.command)
    }

    /// Appends a command. The queue must not be full.
    pub(crate) fn push(&mut self, command: Command) {
        debug_assert!(self.free() > 0);
        self.entries.push_back(Entry::new(command));
    }

    /// Tags that have outstanding commands.
    pub(crate) fn busy_tags(&self) -> u32 {
        self.entries.iter().fold(0, |tags, entry| tags | entry.command.tag_bit())
    }

    /// Resumes the stalled lists of a tag.
    pub(crate) fn resume(&mut self, tag: u32) {
        for entry in &mut self.entries {
            if u32::from(entry.command.tag) == tag {
                entry.stalled = false;
            }
        }
    }

    /// Whether the ordering rules allow entry `at` to run.
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

    /// The next command to run, with those of `tags` before others. [`Policy::AtLast`] takes the
    /// newest, so that commands that need an order but did not request it run in the wrong one.
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

    /// Runs one command, if one may run. A command that fails leaves the queue.
    pub(crate) fn run_one(
        &mut self,
        tags: u32,
        path: Path<'_>,
    ) -> Result<Option<RunOutcome>, DmaError> {
        let Some(at) = self.next(tags) else {
            return Ok(None);
        };
        let Some(entry) = self.entries.get_mut(at) else {
            return Ok(None);
        };
        let ran = if entry.command.operation.is_list() {
            run_list(entry, &mut self.buffer, path)
        } else {
            run_simple(&entry.command, &mut self.buffer, path).map(|pending| {
                path.note(|| Movement {
                    command: entry.command,
                    pieces: pieces_of(&entry.command, pending, path),
                    stalled: false,
                    atomic: None,
                });
                RunOutcome::Complete
            })
        };
        if !matches!(ran, Ok(RunOutcome::Stalled(_))) {
            self.entries.remove(at);
        }
        ran.map(Some)
    }
}

/// A put to main memory, with the bytes that it writes.
pub(crate) struct Put {
    command: Command,
    elements: Vec<Command>,
    bytes: Box<[u8]>,
}

impl Put {
    pub(crate) fn tag_bit(&self) -> u32 {
        self.command.tag_bit()
    }

    pub(crate) fn movement(&self) -> Movement {
        let piece = |element: &Command| Piece {
            lsa: element.lsa,
            ea: element.ea,
            size: element.size,
            peer: Peer::Memory,
            pending: None,
        };
        Movement {
            command: self.command,
            pieces: self.elements.iter().map(piece).collect(),
            stalled: false,
            atomic: None,
        }
    }

    /// Writes the bytes. Returns what was moved.
    pub(crate) fn write(self, interconnect: &Interconnect) -> Result<Movement, DmaError> {
        let (pieces, _) = addresses(&self.elements);
        if let Err(fault) = interconnect.write_pieces(&pieces, &self.bytes) {
            let has_fault = |element: &&Command| {
                (element.ea..element.ea + u64::from(element.size)).contains(&fault.ea)
            };
            let failed = self.elements.iter().find(has_fault);
            return Err(failed.unwrap_or(&self.command).storage(fault.ea));
        }
        Ok(self.movement())
    }
}

fn run_list(entry: &mut Entry, buffer: &mut [u8], path: Path<'_>) -> Result<RunOutcome, DmaError> {
    let list = entry.command;
    let mut pieces = Vec::new();
    let together = match list.operation {
        Operation::PutList => put_together,
        _ => get_together,
    };
    let mut may_join = true;
    while entry.list_done < list.size {
        if may_join {
            may_join = together(entry, buffer, path, &mut pieces);
            if entry.list_done == list.size {
                break;
            }
        }
        let (element, stall) = entry.element(path)?;
        let pending = run_simple(&element, buffer, path)?;
        if path.moved.is_some() {
            pieces.push(path.piece(&element, pending));
        }
        entry.pass(&element);
        if stall {
            entry.stalled = true;
            path.note(|| Movement { command: list, pieces, stalled: true, atomic: None });
            return Ok(RunOutcome::Stalled(list.tag));
        }
    }
    path.note(|| Movement { command: list, pieces, stalled: false, atomic: None });
    Ok(RunOutcome::Complete)
}

/// Passes the next elements of a list, as many as fit the buffer, need no stall and are `good`.
fn next_elements(
    entry: &mut Entry,
    buffer: &[u8],
    path: Path<'_>,
    good: impl Fn(&Command) -> bool,
) -> Vec<Command> {
    let mut elements = Vec::new();
    let mut length = 0;
    while entry.list_done < entry.command.size {
        let Ok((element, false)) = entry.element(path) else {
            break;
        };
        length += element.size as usize;
        if length > buffer.len() || !good(&element) {
            break;
        }
        entry.pass(&element);
        elements.push(element);
    }
    elements
}

/// Copies the elements' bytes from local store to the buffer, one after the other.
fn copy_out(elements: &[Command], buffer: &mut [u8], path: Path<'_>) {
    let mut rest = buffer;
    for element in elements {
        let (bytes, others) = rest.split_at_mut(element.size as usize);
        path.local_store.read(element.lsa, bytes);
        rest = others;
    }
}

/// The addresses and lengths of elements, and the sum of the lengths.
fn addresses(elements: &[Command]) -> (Vec<(u64, usize)>, usize) {
    let address = |element: &Command| (element.ea, element.size as usize);
    let pieces: Vec<_> = elements.iter().map(address).collect();
    let length = pieces.iter().map(|(_, length)| length).sum();
    (pieces, length)
}

/// Carries out the next elements of a list of puts to main memory in one access, as many as fit
/// the buffer and need no stall. If that fails, it returns `false`, and the elements don't count as
/// done: one by one, they fail at the right one.
fn put_together(
    entry: &mut Entry,
    buffer: &mut [u8],
    path: Path<'_>,
    moved: &mut Vec<Piece>,
) -> bool {
    let mut ahead = *entry;
    let is_good = |element: &Command| path.interconnect.is_memory(element.ea, element.size);
    let elements = next_elements(&mut ahead, buffer, path, is_good);
    copy_out(&elements, buffer, path);
    let (pieces, length) = addresses(&elements);
    if path.interconnect.write_pieces(&pieces, &buffer[..length]).is_err() {
        return false;
    }
    *entry = ahead;
    note_elements(&elements, path, moved);
    true
}

/// The same for a list of gets.
fn get_together(
    entry: &mut Entry,
    buffer: &mut [u8],
    path: Path<'_>,
    moved: &mut Vec<Piece>,
) -> bool {
    let mut ahead = *entry;
    let list = entry.command;
    // Bytes that arrive in the list itself change its later elements.
    let is_good = |element: &Command| {
        path.interconnect.is_memory(element.ea, element.size)
            && is_apart((element.lsa, element.size), (list.ea as u32, list.size))
    };
    let elements = next_elements(&mut ahead, buffer, path, is_good);
    let (pieces, length) = addresses(&elements);
    if path.interconnect.read_pieces(&pieces, &mut buffer[..length]).is_err() {
        return false;
    }
    *entry = ahead;
    let mut rest = &buffer[..length];
    for element in &elements {
        let (bytes, others) = rest.split_at(element.size as usize);
        path.local_store.write(element.lsa, bytes);
        rest = others;
    }
    note_elements(&elements, path, moved);
    true
}

/// Whether two areas of local store, which have an address and a size each, share no byte.
fn is_apart((one, one_size): (u32, u32), (other, other_size): (u32, u32)) -> bool {
    let distance = |from: u32, to: u32| to.wrapping_sub(from) & (local_store::SIZE - 1);
    distance(one, other) >= one_size && distance(other, one) >= other_size
}

/// In simulated time: records what elements have moved.
fn note_elements(elements: &[Command], path: Path<'_>, moved: &mut Vec<Piece>) {
    if path.moved.is_some() {
        moved.extend(elements.iter().map(|element| path.piece(element, None)));
    }
}

/// The pieces that a command other than a list moves over the bus.
fn pieces_of(command: &Command, pending: Option<PendingWrite>, path: Path<'_>) -> Vec<Piece> {
    match command.operation {
        Operation::QueueBarrier | Operation::Sync | Operation::CacheHint => Vec::new(),
        _ => vec![path.piece(command, pending)],
    }
}

/// Runs a command other than a list. Returns the bytes that are to be delivered later.
fn run_simple(
    command: &Command,
    buffer: &mut [u8],
    path: Path<'_>,
) -> Result<Option<PendingWrite>, DmaError> {
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
            path.interconnect.put_line(ea, path.unit.reservation(), &line).map(|()| None)
        }
        _ => Ok(None),
    };
    moved.map_err(|fault| command.storage(fault.ea))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mfc::command::{Parameters, Side};

    /// A queue that holds these (opcode, tag) pairs.
    fn queue(commands: &[(u32, u32)]) -> Queue {
        let mut queue = Queue::new(16, Policy::AtLast);
        for &(word, tag) in commands {
            let parameters = Parameters { tag, ..Parameters::default() };
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
