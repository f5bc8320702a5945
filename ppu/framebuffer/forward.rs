//! Stores to a device's memory.
//!
//! Such memory may be write-combined, uncached and slow to read. So it is written only in
//! ascending order, with the widest stores that the address allows, and never read. The C
//! library's copy and fill can't be used: on the PowerPC they may use dcbz, which faults on
//! uncached memory.

use std::ptr;

const WORD: usize = size_of::<u64>();

/// Copies `from` to `to`, without reading from `to`.
///
/// # Safety
/// `to` must be writable for the length of `from`, which must not overlap it.
pub(super) unsafe fn copy(from: &[u8], to: *mut u8) {
    // SAFETY: the caller's promise.
    unsafe {
        store(
            from.len(),
            to,
            // The source words are read in memory order, so the host's byte order doesn't matter.
            |at| ptr::read_unaligned(from.as_ptr().add(at).cast::<u64>()),
            |at| from[at],
        );
    }
}

/// Fills `bytes` at `to` with zeros.
///
/// # Safety
/// `to` must be writable for `bytes`.
pub(super) unsafe fn clear(to: *mut u8, bytes: usize) {
    // SAFETY: the caller's promise.
    unsafe { store(bytes, to, |_| 0, |_| 0) }
}

/// Stores `bytes` bytes at `to`: single bytes up to the first word boundary, then words, then
/// single bytes.
///
/// # Safety
/// `to` must be writable for `bytes` bytes. `word` is only called where eight bytes are left.
unsafe fn store(
    bytes: usize,
    to: *mut u8,
    word: impl Fn(usize) -> u64,
    byte: impl Fn(usize) -> u8,
) {
    let head = to.align_offset(WORD).min(bytes);
    let words_end = head + (bytes - head) / WORD * WORD;
    let single = |at| {
        // SAFETY: `at` is below `bytes` in each loop below.
        unsafe { to.add(at).write_volatile(byte(at)) }
    };
    (0..head).for_each(single);
    for at in (head..words_end).step_by(WORD) {
        // SAFETY: `at` is a multiple of a word from an aligned address, and the word ends within
        // `bytes`.
        unsafe { to.add(at).cast::<u64>().write_volatile(word(at)) };
    }
    (words_end..bytes).for_each(single);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_alignment_and_length_is_exact() {
        let source: Vec<u8> = (1..=64).collect();
        for to in 0..WORD {
            for from in 0..WORD {
                for bytes in 0..40 {
                    let mut memory = [0xA5u8; 64];
                    // SAFETY: at most 7 + 39 of the 64 bytes are accessed.
                    unsafe { copy(&source[from..from + bytes], memory.as_mut_ptr().add(to)) };
                    assert_eq!(memory[to..to + bytes], source[from..from + bytes]);
                    assert!(
                        memory[..to].iter().chain(&memory[to + bytes..]).all(|&byte| byte == 0xA5)
                    );
                    // SAFETY: as above.
                    unsafe { clear(memory.as_mut_ptr().add(to), bytes) };
                    assert!(memory[to..to + bytes].iter().all(|&byte| byte == 0));
                    assert!(
                        memory[..to].iter().chain(&memory[to + bytes..]).all(|&byte| byte == 0xA5)
                    );
                }
            }
        }
    }
}
