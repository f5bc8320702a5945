//! Asking the kernel whether a word may be written, without changing it.

use std::ptr;

/// What the kernel said of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Writable {
    Yes,
    No,
    /// This kernel does not answer.
    Unknown,
}

/// ORs 0 to the 32-bit word at `ea` (a multiple of 4), atomically and with the kernel's checks:
/// the operation of `FUTEX_WAKE_OP` on its second word.
pub(crate) fn probe_write(ea: u64) -> Writable {
    const OR_ZERO_AND_WAKE_IF_LESS: u32 = 2 << 28 | 2 << 24;
    let own_word = 0_u32;
    let address: *const u32 = ptr::with_exposed_provenance(ea as usize);
    // SAFETY: the kernel checks both words; the second keeps its value, and nobody sleeps on
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
