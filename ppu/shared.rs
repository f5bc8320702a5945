//! Memory that SPUs read and write while this program runs.

use std::cell::UnsafeCell;
use std::sync::atomic::{AtomicU32, Ordering};

use protocol::layout::LINE;

#[repr(C, align(128))]
struct Line(UnsafeCell<[u8; LINE as usize]>);

/// Zeroed memory on 128-byte lines, for records of the work-unit protocol.
///
/// SPUs access it by its address, unseen by the compiler, so it is never lent out as a slice.
/// Bytes are copied in before the address is mailed, and out after the reply. The mailbox calls
/// in between keep that order.
pub struct SharedMemory(Box<[Line]>);

impl SharedMemory {
    /// Allocates `bytes` bytes, rounded up to whole lines, and at least one line.
    #[must_use]
    pub fn new(bytes: usize) -> Self {
        let lines = bytes.div_ceil(LINE as usize).max(1);
        Self((0..lines).map(|_| Line(UnsafeCell::new([0; LINE as usize]))).collect())
    }

    /// Makes it at least as large; its bytes are lost if it must grow. All addresses of what grows
    /// have the same upper word, as those in a DMA list must.
    pub(crate) fn reserve(&mut self, bytes: usize) {
        while self.bytes() < bytes || {
            let last = self.address() + self.bytes() as u64 - 1;
            self.address() >> 32 != last >> 32
        } {
            // As long as the old memory is kept, the new one is elsewhere.
            *self = Self::new(bytes);
        }
    }

    /// Writes `bytes` from the beginning on, in larger memory if it needs that, and returns their
    /// address.
    pub(crate) fn put(&mut self, bytes: &[u8]) -> u64 {
        self.reserve(bytes.len());
        self.write(0, bytes);
        self.address()
    }

    /// The effective address of the first byte.
    #[must_use]
    pub fn address(&self) -> u64 {
        self.0.as_ptr().expose_provenance() as u64
    }

    /// The size in bytes.
    fn bytes(&self) -> usize {
        self.0.len() * LINE as usize
    }

    /// Copies `bytes` to the offset `offset`.
    ///
    /// # Panics
    /// The bytes don't fit. All sizes are this program's own, so that is a bug.
    pub fn write(&mut self, offset: usize, bytes: &[u8]) {
        assert!(bytes.len() <= self.bytes() && offset <= self.bytes() - bytes.len());
        let base = self.0.as_ptr().cast::<u8>().cast_mut();
        // SAFETY: the range was checked. The bytes are in `UnsafeCell`s, so they may be written.
        // `bytes` can't overlap them, because they are never lent out.
        unsafe { base.add(offset).copy_from_nonoverlapping(bytes.as_ptr(), bytes.len()) };
    }

    /// Copies bytes from the offset `offset` out to `into`.
    ///
    /// # Panics
    /// The memory has fewer bytes.
    pub fn read(&self, offset: usize, into: &mut [u8]) {
        assert!(into.len() <= self.bytes() && offset <= self.bytes() - into.len());
        let base = self.0.as_ptr().cast::<u8>();
        // SAFETY: the range was checked; `into` can't overlap it, because it is never lent out.
        unsafe { base.add(offset).copy_to_nonoverlapping(into.as_mut_ptr(), into.len()) };
    }

    /// Reads a word that an SPU may be writing concurrently. The result is the old or the new
    /// word.
    ///
    /// # Panics
    /// `offset` is not a multiple of 4, or beyond the end.
    #[must_use]
    pub fn peek_word(&self, offset: usize) -> u32 {
        assert!(offset.is_multiple_of(4) && offset < self.bytes());
        let word = self.0.as_ptr().cast::<u32>().wrapping_byte_add(offset);
        // SAFETY: the word is aligned and within the memory, as checked above. The read is atomic,
        // because SPUs may write.
        u32::from_be(unsafe { AtomicU32::from_ptr(word.cast_mut()) }.load(Ordering::Relaxed))
    }
}
