//! Asks the kernel whether a word can be written, without changing the word.

use std::ptr;

/// The kernel's reply about a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Writable {
    Yes,
    No,
    /// This kernel doesn't support the question.
    Unknown,
}

/// ORs 0 into the 32-bit word at `ea` (a multiple of 4), atomically and with the kernel's checks.
/// This is the operation that `FUTEX_WAKE_OP` does on its second word.
pub(crate) fn probe_write(ea: u64) -> Writable {
    const OR_ZERO_AND_WAKE_IF_LESS: u32 = 2 << 28 | 2 << 24;
    let own_word = 0_u32;
    let address: *const u32 = ptr::with_exposed_provenance(ea as usize);
    // SAFETY: the kernel checks both words. The second keeps its value, and no thread sleeps on
    // `own_word`.
    let result = unsafe {
        libc::syscall(
            libc::SYS_futex,
            &raw const own_word,
            libc::FUTEX_WAKE_OP | libc::FUTEX_PRIVATE_FLAG,
            1_usize,
            ptr::null::<libc::timespec>(),
            address,
            OR_ZERO_AND_WAKE_IF_LESS as usize,
        )
    };
    if result >= 0 {
        return Writable::Yes;
    }
    match std::io::Error::last_os_error().raw_os_error() {
        Some(libc::EFAULT) => Writable::No,
        _ => Writable::Unknown,
    }
}
