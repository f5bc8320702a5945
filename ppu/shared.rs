//! Memory that SPUs read and write while this program lives on.

use std::cell::UnsafeCell;
use std::sync::atomic::{AtomicU32, Ordering};

use protocol::layout::LINE;

#[repr(C, align(128))]
struct Line(UnsafeCell<[u8; LINE as usize]>);

/// Zeroed memory on 128-byte lines, for records of the work-unit protocol.
///
/// SPUs reach it by its address, behind the compiler's back, so it is never lent out as a slice:
/// bytes are copied in before the address is mailed, and out after the answer, and the mailbox
/// calls in between keep that order.
pub struct SharedMemory(Box<[Line]>);

impl SharedMemory {
    /// Room for `bytes`, rounded up to whole lines; at least one.
    #[must_use]
    pub fn new(bytes: usize) -> Self {
        let lines = bytes.div_ceil(LINE as usize).max(1);
        Self(
            (0..lines)
                .map(|_| Line(UnsafeCell::new([0; LINE as usize])))
                .collect(),
        )
    }

    /// Effective address of the first byte.
    #[must_use]
    pub fn address(&self) -> u64 {
        self.0.as_ptr().expose_provenance() as u64
    }

    /// Bytes in all.
    fn bytes(&self) -> usize {
        self.0.len() * LINE as usize
    }

    /// Copies `bytes` in. Panics if they do not fit: sizes are this program's own.
    pub fn write(&mut self, offset: usize, bytes: &[u8]) {
        assert!(bytes.len() <= self.bytes() && offset <= self.bytes() - bytes.len());
        let base = self.0.as_ptr().cast::<u8>().cast_mut();
        // SAFETY: the range was checked; the bytes are in `UnsafeCell`s, so writing them is
        // allowed; `bytes` can't overlap them, as they are never lent out.
        unsafe {
            base.add(offset)
                .copy_from_nonoverlapping(bytes.as_ptr(), bytes.len())
        };
    }

    /// Copies bytes out. Panics if there are not as many.
    pub fn read(&self, offset: usize, into: &mut [u8]) {
        assert!(into.len() <= self.bytes() && offset <= self.bytes() - into.len());
        let base = self.0.as_ptr().cast::<u8>();
        // SAFETY: the range was checked; `into` can't overlap it, as it is never lent out.
        unsafe {
            base.add(offset)
                .copy_to_nonoverlapping(into.as_mut_ptr(), into.len())
        };
    }

    /// A word that an SPU may be writing at this moment: the old one or the new one. Panics if
    /// there is no such word.
    #[must_use]
    pub fn peek_word(&self, offset: usize) -> u32 {
        assert!(offset.is_multiple_of(4) && offset < self.bytes());
        let word = self.0.as_ptr().cast::<u32>().wrapping_byte_add(offset);
        // SAFETY: an aligned word of the memory, checked above; an atomic read, as others may
        // write.
        u32::from_be(unsafe { AtomicU32::from_ptr(word.cast_mut()) }.load(Ordering::Relaxed))
    }
}
