//! The guest's memory as calls use it: words, strings, argument blocks.
//!
//! Invariant: no access leaves local store or takes unbounded time. Addresses wrap, and no length
//! exceeds local store.

use crate::local_store::{LocalStore, SIZE};
use spu_isa::LIMIT_MASK;

/// Size in bytes of an argument cell, which has the layout of a register.
pub(super) const CELL: u32 = 16;

/// Access to local store. Addresses wrap at its end.
pub trait GuestMemory {
    /// Copies bytes out of local store.
    fn read(&self, address: u32, into: &mut [u8]);
    /// Copies bytes into local store.
    fn write(&self, address: u32, from: &[u8]);
}

impl GuestMemory for LocalStore {
    fn read(&self, address: u32, into: &mut [u8]) {
        Self::read(self, address, into);
    }

    fn write(&self, address: u32, from: &[u8]) {
        Self::write(self, address, from);
    }
}

/// Local store with the accesses that calls need.
#[derive(Clone, Copy)]
pub(super) struct Guest<'a>(pub &'a dyn GuestMemory);

impl Guest<'_> {
    pub fn array<const N: usize>(self, address: u32) -> [u8; N] {
        let mut bytes = [0; N];
        self.0.read(address & LIMIT_MASK, &mut bytes);
        bytes
    }

    pub fn word(self, address: u32) -> u32 {
        u32::from_be_bytes(self.array(address))
    }

    pub fn doubleword(self, address: u32) -> u64 {
        u64::from_be_bytes(self.array(address))
    }

    /// `length` bytes, but at most the size of local store.
    pub fn bytes(self, address: u32, length: u32) -> Vec<u8> {
        let mut bytes = vec![0; length.min(SIZE) as usize];
        self.0.read(address & LIMIT_MASK, &mut bytes);
        bytes
    }

    pub fn write(self, address: u32, bytes: &[u8]) {
        let most = bytes.len().min(SIZE as usize);
        self.0.write(address & LIMIT_MASK, &bytes[..most]);
    }

    pub fn set_word(self, address: u32, word: u32) {
        self.write(address, &word.to_be_bytes());
    }

    /// Writes consecutive words. The structures of the calls consist of such words.
    pub fn set_words(self, address: u32, words: &[u32]) {
        let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_be_bytes()).collect();
        self.write(address, &bytes);
    }

    /// The bytes before the first 0, but at most `most` of them.
    pub fn string_of_at_most(self, address: u32, most: u32) -> Vec<u8> {
        const STEP: u32 = 256;
        let mut text = Vec::new();
        let most = most.min(SIZE);
        while (text.len() as u32) < most {
            let step = STEP.min(most - text.len() as u32);
            let piece = self.bytes(address.wrapping_add(text.len() as u32), step);
            if let Some(end) = piece.iter().position(|&byte| byte == 0) {
                text.extend_from_slice(&piece[..end]);
                break;
            }
            text.extend_from_slice(&piece);
        }
        text
    }

    pub fn string(self, address: u32) -> Vec<u8> {
        self.string_of_at_most(address, SIZE)
    }

    /// Writes bytes and a terminating 0.
    pub fn set_string(self, address: u32, text: &[u8]) {
        self.write(address, text);
        self.write(address.wrapping_add(text.len() as u32), &[0]);
    }
}

/// The block of 16-byte cells that holds a call's arguments and then its result.
#[derive(Clone, Copy)]
pub(super) struct Block<'a> {
    pub guest: Guest<'a>,
    pub address: u32,
}

impl Block<'_> {
    pub fn cell(self, index: u32) -> u32 {
        self.address.wrapping_add(index * CELL)
    }

    /// The preferred word of a cell.
    pub fn word(self, index: u32) -> u32 {
        self.guest.word(self.cell(index))
    }

    pub fn int(self, index: u32) -> i32 {
        self.word(index) as i32
    }

    /// The preferred doubleword of a cell.
    pub fn doubleword(self, index: u32) -> u64 {
        self.guest.doubleword(self.cell(index))
    }

    /// The string that a cell points to.
    pub fn string(self, index: u32) -> Vec<u8> {
        self.guest.string(self.word(index))
    }

    /// The string that a cell points to, or `None` for a null pointer.
    pub fn optional_string(self, index: u32) -> Option<Vec<u8>> {
        (self.word(index) != 0).then(|| self.string(index))
    }

    /// Writes a reply to cell 0, where the guest expects it.
    pub fn put(self, reply: Reply) {
        let (high, low, errno) = match reply {
            Reply::Nothing => return,
            Reply::Word(word, errno) => (word, 0, errno),
            Reply::Doubleword(value, errno) => ((value >> 32) as u32, value as u32, errno),
        };
        self.guest.set_words(self.address, &[high, low, 0, errno as u32]);
    }
}

/// The result of a call, with an error number or 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reply {
    /// The cell remains unchanged.
    Nothing,
    Word(u32, i32),
    Doubleword(u64, i32),
}

impl From<i32> for Reply {
    fn from(value: i32) -> Self {
        Self::Word(value as u32, 0)
    }
}

/// A failure returns -1 and the error number.
impl From<Result<i32, super::Errno>> for Reply {
    fn from(result: Result<i32, super::Errno>) -> Self {
        match result {
            Ok(value) => value.into(),
            Err(errno) => Self::Word(u32::MAX, errno.0),
        }
    }
}

impl From<Result<(), super::Errno>> for Reply {
    fn from(result: Result<(), super::Errno>) -> Self {
        result.map(|()| 0).into()
    }
}
