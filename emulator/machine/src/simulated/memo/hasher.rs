//! The hash function for the tables of states, whose keys have many small fields.
//!
//! The standard library's hasher resists keys that are chosen to collide. This one need not: a
//! guest that caused collisions would only slow itself down, because the tables are bounded.

use std::hash::{BuildHasherDefault, Hasher};

/// Builds hashers for a table.
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

    /// The table uses the lowest bits as the index, and in a product those are the worst mixed. So
    /// rotate.
    fn finish(&self) -> u64 {
        self.0.rotate_left(26)
    }
}
