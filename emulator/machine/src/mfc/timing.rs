//! The interface between the MFC and the timing of its transfers.
//!
//! Without simulated time neither trait is needed: a transfer is complete when its data has moved.

use std::sync::Arc;

use super::command::Command;
use crate::local_store::LocalStore;

/// The other end of a transfer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Peer {
    Memory,
    /// The local store or signal register of the SPE that begins at this address.
    LocalStore(u64),
}

/// Bytes that are to be written to a local store.
pub(crate) struct PendingWrite {
    pub store: Arc<LocalStore>,
    pub address: u32,
    pub bytes: Box<[u8]>,
}

impl PendingWrite {
    pub fn deliver(&self) {
        self.store.write(self.address, &self.bytes);
    }

    /// Whether some of its bytes go to the `length` bytes at `address` of a store.
    pub fn overlaps(&self, store: &LocalStore, address: u32, length: usize) -> bool {
        let (first, end) = (self.address as usize, self.address as usize + self.bytes.len());
        let (from, to) = (address as usize, address as usize + length);
        std::ptr::eq(&*self.store, store) && first < to && from < end
    }
}

/// One contiguous piece of the data that a command moved.
pub(crate) struct Piece {
    pub lsa: u32,
    pub ea: u64,
    pub size: u32,
    pub peer: Peer,
    /// The bytes, if they are to be delivered later.
    pub pending: Option<PendingWrite>,
}

/// The data that a command moved, or that a list moved until it stalled.
pub(crate) struct Movement {
    pub command: Command,
    pub pieces: Vec<Piece>,
    pub stalled: bool,
    /// The outcome of an atomic command.
    pub atomic: Option<Atomic>,
}

/// The effect of an atomic command on its line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Atomic {
    /// `getllar`.
    Read,
    /// `putllc` that was successful, `putlluc` or `putqlluc`.
    Written,
    /// `putllc` that had lost its reservation.
    Lost,
}

/// Number of MFC commands that an SPU gave, and of bytes that they moved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Commands {
    /// Commands that went through the queue.
    pub queued: u64,
    /// Atomic commands, which bypass the queue.
    pub atomic: u64,
    /// Bytes into local store by queued commands.
    pub bytes_in: u64,
    /// Bytes out of local store by queued commands.
    pub bytes_out: u64,
}

/// Times the commands of one SPU whose data has moved but that are not complete yet.
pub(crate) trait TransferTimes: Send {
    /// Times a movement that was made at `now`, and sends the data that is to be delivered later.
    /// Returns when the movement is complete.
    fn add(&mut self, movement: Movement, now: u64) -> u64;
    /// Removes the commands that are complete at `now`.
    fn advance(&mut self, now: u64);
    /// Number of commands that are not complete.
    fn incomplete(&self) -> usize;
    /// The tags of these commands.
    fn busy_tags(&self) -> u32;
    /// When the next command of these tags will be complete.
    fn next(&self, tags: u32) -> Option<u64>;
    /// When the SPU may learn of the lists that have stalled.
    fn stalled_at(&self) -> u64;
    /// When the status of the last atomic command can be read.
    fn atomic_at(&self) -> u64;
    /// Counts of all commands so far.
    fn commands(&self) -> Commands;
    /// The same transfers, for a thread that times a movement in place of the SPU's own.
    fn shared(&self) -> Box<dyn TransferTimes>;
}

/// The data in flight between the local stores of one machine.
pub(crate) trait InFlight: Send + Sync {
    /// Whether no data is in flight.
    fn is_empty(&self) -> bool;
    /// Delivers data in flight to these bytes of a local store at once, whatever its arrival time.
    fn deliver_early(&self, store: &LocalStore, address: u32, length: usize);
}
