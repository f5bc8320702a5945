//! A doubleword on hosts without 64-bit atomics: two words, each of them atomic.

use std::sync::atomic::{AtomicU32, Ordering};

/// Two words in the host's order. All-zero bytes are valid.
#[repr(C, align(8))]
pub(crate) struct AtomicWords([AtomicU32; 2]);

impl AtomicWords {
    pub fn load(&self, order: Ordering) -> u64 {
        let [first, second] = &self.0;
        let [a, b, c, d] = first.load(order).to_ne_bytes();
        let [e, f, g, h] = second.load(order).to_ne_bytes();
        u64::from_ne_bytes([a, b, c, d, e, f, g, h])
    }

    pub fn store(&self, value: u64, order: Ordering) {
        let [a, b, c, d, e, f, g, h] = value.to_ne_bytes();
        self.0[0].store(u32::from_ne_bytes([a, b, c, d]), order);
        self.0[1].store(u32::from_ne_bytes([e, f, g, h]), order);
    }
}
