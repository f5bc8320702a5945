//! The bytes of a block, addressed as they will be in local store, from `SCENE_ADDRESS` on.

use protocol::layout::{LINE, SCENE_ADDRESS};

/// The bytes of a block. Every reservation is a multiple of a quadword.
#[derive(Clone, Debug, Default)]
pub(super) struct Block {
    bytes: Vec<u8>,
}

impl Block {
    /// Reserves zeroed bytes at the end, and returns their address.
    pub fn reserve(&mut self, size: usize) -> u32 {
        let address = SCENE_ADDRESS + self.bytes.len() as u32;
        self.bytes.resize(self.bytes.len() + size, 0);
        address
    }

    /// The address of the next reservation.
    pub fn end(&self) -> u32 {
        SCENE_ADDRESS + self.bytes.len() as u32
    }

    /// Appends a record, and returns its address.
    pub fn append(&mut self, record: &[u8]) -> u32 {
        let address = self.reserve(record.len());
        self.at(address, record.len()).copy_from_slice(record);
        address
    }

    /// The bytes of an earlier reservation.
    pub fn at(&mut self, address: u32, size: usize) -> &mut [u8] {
        let start = (address - SCENE_ADDRESS) as usize;
        &mut self.bytes[start..start + size]
    }

    /// Pads the last line with zeroes.
    pub fn finish(&mut self) {
        let whole = self.bytes.len().next_multiple_of(LINE as usize);
        self.bytes.resize(whole, 0);
    }

    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }
}
