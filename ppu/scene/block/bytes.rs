//! Bytes that lie at `SCENE_ADDRESS` of local store, addressed as they will be there.

use protocol::layout::{LINE, SCENE_ADDRESS};

/// The bytes of a block. All that is taken is a multiple of a quadword.
#[derive(Clone, Debug, Default)]
pub(super) struct Block {
    bytes: Vec<u8>,
}

impl Block {
    /// Takes room at the end, zeroes so far; its address.
    pub fn reserve(&mut self, size: usize) -> u32 {
        let address = SCENE_ADDRESS + self.bytes.len() as u32;
        self.bytes.resize(self.bytes.len() + size, 0);
        address
    }

    /// Appends a record; its address.
    pub fn append(&mut self, record: &[u8]) -> u32 {
        let address = self.reserve(record.len());
        self.at(address, record.len()).copy_from_slice(record);
        address
    }

    /// The bytes of something that room was taken for.
    pub fn at(&mut self, address: u32, size: usize) -> &mut [u8] {
        let start = (address - SCENE_ADDRESS) as usize;
        &mut self.bytes[start..start + size]
    }

    /// Fills the last line.
    pub fn finish(&mut self) {
        let whole = self.bytes.len().next_multiple_of(LINE as usize);
        self.bytes.resize(whole, 0);
    }

    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }
}
