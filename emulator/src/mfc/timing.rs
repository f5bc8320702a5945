//! What the MFC tells of its transfers, and what it asks of whoever times them.
//!
//! An MFC without time needs neither trait: what has moved is complete.

use std::sync::Arc;

use super::command::Command;
use crate::local_store::LocalStore;

/// What lies at the other end of a transfer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Peer {
    Memory,
    /// The SPE whose local store or signal register is there, by the address where it begins.
    LocalStore(u64),
}

/// Bytes for a local store.
pub(crate) struct Parcel {
    pub store: Arc<LocalStore>,
    pub address: u32,
    pub bytes: Box<[u8]>,
}

impl Parcel {
    pub fn deliver(&self) {
        self.store.write(self.address, &self.bytes);
    }

    /// Whether some of its bytes go to `length` bytes at `address` of a store.
    pub fn meets(&self, store: &LocalStore, address: u32, length: usize) -> bool {
        let (first, end) = (
            self.address as usize,
            self.address as usize + self.bytes.len(),
        );
        let (from, to) = (address as usize, address as usize + length);
        std::ptr::eq(&*self.store, store) && first < to && from < end
    }
}

/// One contiguous piece of what a command moved.
pub(crate) struct Piece {
    pub ea: u64,
    pub size: u32,
    pub peer: Peer,
    /// The bytes, if they are still to be delivered.
    pub parcel: Option<Parcel>,
}

/// What a command moved, or a list until it stalled.
pub(crate) struct Movement {
    pub command: Command,
    pub pieces: Vec<Piece>,
    pub stalled: bool,
}

/// MFC commands that an SPU gave, and bytes that they moved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Commands {
    /// Commands through the queue.
    pub queued: u64,
    /// Atomic commands, which bypass it.
    pub atomic: u64,
    /// Bytes into local store by queued commands.
    pub bytes_in: u64,
    /// Bytes out of local store by queued commands.
    pub bytes_out: u64,
}

/// Times the commands of one SPU: those whose data has moved and that are not complete yet.
pub(crate) trait TransferTimes: Send {
    /// Times what was moved at `now`, and sends off what is to be delivered; says when it is
    /// complete.
    fn add(&mut self, movement: Movement, now: u64) -> u64;
    /// Forgets what is complete at `now`.
    fn advance(&mut self, now: u64);
    /// Commands that are not complete.
    fn incomplete(&self) -> usize;
    /// Their tags.
    fn busy_tags(&self) -> u32;
    /// When the next command will be complete.
    fn next(&self) -> Option<u64>;
    /// When the SPU can be told of the lists that stall.
    fn stalled_at(&self) -> u64;
    /// When the status of the last atomic command can be read.
    fn atomic_at(&self) -> u64;
    /// All commands so far.
    fn commands(&self) -> Commands;
}

/// The data that is under way between the local stores of one machine.
pub(crate) trait UnderWay: Send + Sync {
    /// Whether there is none.
    fn is_empty(&self) -> bool;
    /// What goes to these bytes of a local store is there at once, whatever its time.
    fn deliver_early(&self, store: &LocalStore, address: u32, length: usize);
}
