//! Hashes for the tables of states, which have many small fields.
//!
//! The standard library's hasher withstands keys that were chosen to collide. A guest that chose
//! its states so would only slow itself down, since the tables are bounded.

use std::hash::{BuildHasherDefault, Hasher};

/// Makes hashers for a table.
pub(super) type Mixing = BuildHasherDefault<Mixer>;

/// Multiplies and rotates.
#[derive(Default)]
pub(super) struct Mixer(u64);

impl Mixer {
    fn add(&mut self, value: u64) {
        self.0 = (self.0.rotate_left(5) ^ value).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }
}

impl Hasher for Mixer {
    fn write(&mut self, bytes: &[u8]) {
        for piece in bytes.chunks(8) {
            let mut padded = [0; 8];
            padded[..piece.len()].copy_from_slice(piece);
            self.add(u64::from_le_bytes(padded));
        }
    }

    fn write_u8(&mut self, value: u8) {
        self.add(value.into());
    }

    fn write_u32(&mut self, value: u32) {
        self.add(value.into());
    }

    fn write_u64(&mut self, value: u64) {
        self.add(value);
    }

    fn write_usize(&mut self, value: usize) {
        self.add(value as u64);
    }

    fn write_isize(&mut self, value: isize) {
        self.add(value as u64);
    }

    /// The table takes its place from the lowest bits, where a product has mixed least.
    fn finish(&self) -> u64 {
        self.0.rotate_left(26)
    }
}
