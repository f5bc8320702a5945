//! Copies between this process's memory and addresses that may be invalid, without a system call.
//!
//! If a load or a store of such a copy faults, [the handler](crate::fault_handler) lets it return
//! what it has not copied. This is done only on threads where that handler is sure to be called.
//! On other threads, and on processors other than x86-64, each copy fails, so that the kernel makes
//! it.

use std::cell::Cell;

use crate::error::Errno;
use crate::fault_handler;

thread_local! {
    /// Whether this thread may fault.
    static MAY_FAULT: Cell<bool> = const { Cell::new(false) };
}

/// Installs the handler, where there are quick copies.
pub(crate) fn prepare() -> Result<(), Errno> {
    if copying::SUPPORTED { fault_handler::install() } else { Ok(()) }
}

/// While it lives, its thread may make quick copies, if a fault would be handled.
pub(crate) struct QuickCopies {
    before: bool,
}

impl QuickCopies {
    /// Asks the kernel whether a fault of this thread would be handled now.
    pub(crate) fn where_handled() -> Self {
        let may = copying::SUPPORTED && fault_handler::is_reached();
        Self { before: MAY_FAULT.replace(may) }
    }
}

impl Drop for QuickCopies {
    fn drop(&mut self) {
        MAY_FAULT.set(self.before);
    }
}

/// Copies from `ea`. Returns whether it could: if not, a part of it may have been copied.
pub(crate) fn fetch(ea: u64, into: &mut [u8]) -> bool {
    // SAFETY: `into` may be written, and a fault at `ea` is handled.
    MAY_FAULT.get() && unsafe { copying::copy(into.as_mut_ptr(), at(ea), into.len()) }
}

/// Copies to `ea`. Returns whether it could: if not, a part of it may have been copied.
pub(crate) fn store(ea: u64, from: &[u8]) -> bool {
    // SAFETY: `from` may be read, and a fault at `ea` is handled. The program asked its MFC to
    // write there.
    MAY_FAULT.get() && unsafe { copying::copy(at(ea), from.as_ptr(), from.len()) }
}

fn at(ea: u64) -> *mut u8 {
    std::ptr::with_exposed_provenance_mut(ea as usize)
}

/// Lets a copy end, if it has faulted. Returns whether there was one.
///
/// # Safety
/// `context` is what the kernel passes to a handler of a signal.
pub(crate) unsafe fn end_after_fault(context: *mut libc::c_void) -> bool {
    // SAFETY: the caller vouches for the context.
    unsafe { copying::end_after_fault(context) }
}

#[cfg(target_arch = "x86_64")]
mod copying {
    use std::arch::global_asm;

    use libc::{c_void, greg_t, ucontext_t};

    pub(super) const SUPPORTED: bool = true;

    // The symbols are weak, because a program may have this file twice: in the library, and in the
    // stand-in for spufs. An aligned part of up to 16 bytes is moved at once, as an MFC moves it.
    global_asm!(
        ".hidden libspe2_quick_copy",
        ".hidden libspe2_quick_copy_end",
        ".weak libspe2_quick_copy",
        ".weak libspe2_quick_copy_end",
        ".type libspe2_quick_copy, @function",
        "libspe2_quick_copy:", // to rdi, from rsi, rdx bytes
        "mov rax, rdx",        // the bytes that are left
        "cmp rax, 16",
        "jb 3f",
        "2:",
        "movups xmm0, [rsi]",
        "movups [rdi], xmm0",
        "add rsi, 16",
        "add rdi, 16",
        "sub rax, 16",
        "cmp rax, 16",
        "jae 2b",
        "3:",
        "cmp rax, 8",
        "jb 4f",
        "mov rcx, [rsi]",
        "mov [rdi], rcx",
        "add rsi, 8",
        "add rdi, 8",
        "sub rax, 8",
        "4:",
        "cmp rax, 4",
        "jb 5f",
        "mov ecx, [rsi]",
        "mov [rdi], ecx",
        "add rsi, 4",
        "add rdi, 4",
        "sub rax, 4",
        "5:",
        "cmp rax, 2",
        "jb 6f",
        "mov cx, [rsi]",
        "mov [rdi], cx",
        "add rsi, 2",
        "add rdi, 2",
        "sub rax, 2",
        "6:",
        "test rax, rax",
        "jz libspe2_quick_copy_end",
        "mov cl, [rsi]",
        "mov [rdi], cl",
        "sub rax, 1",
        "libspe2_quick_copy_end:",
        "ret",
        ".size libspe2_quick_copy, . - libspe2_quick_copy",
    );

    unsafe extern "C" {
        fn libspe2_quick_copy(to: *mut u8, from: *const u8, bytes: usize) -> usize;
        safe fn libspe2_quick_copy_end();
    }

    /// Returns whether all bytes were copied.
    ///
    /// # Safety
    /// Both places may be accessed by the program, or an access faults and the fault is handled.
    pub(super) unsafe fn copy(to: *mut u8, from: *const u8, bytes: usize) -> bool {
        // SAFETY: the caller vouches for the places.
        unsafe { libspe2_quick_copy(to, from, bytes) == 0 }
    }

    /// # Safety
    /// `context` is what the kernel passes to a handler of a signal.
    pub(super) unsafe fn end_after_fault(context: *mut c_void) -> bool {
        let start = libspe2_quick_copy as *const () as greg_t;
        let end = libspe2_quick_copy_end as *const () as greg_t;
        // SAFETY: the kernel's context is valid until the handler returns.
        let registers = unsafe { &mut (*context.cast::<ucontext_t>()).uc_mcontext.gregs };
        let at = &mut registers[libc::REG_RIP as usize];
        let is_copy = (start..end).contains(at);
        if is_copy {
            *at = end;
        }
        is_copy
    }
}

#[cfg(not(target_arch = "x86_64"))]
mod copying {
    pub(super) const SUPPORTED: bool = false;

    /// # Safety
    /// None.
    pub(super) unsafe fn copy(_: *mut u8, _: *const u8, _: usize) -> bool {
        false
    }

    /// # Safety
    /// None.
    pub(super) unsafe fn end_after_fault(_: *mut libc::c_void) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: usize = 4096;

    /// Two pages, of which nobody may access the second one.
    fn half_accessible() -> *mut u8 {
        let (flags, access) = (libc::MAP_PRIVATE | libc::MAP_ANONYMOUS, libc::PROT_READ);
        // SAFETY: a new mapping at an address that the kernel chooses overlaps nothing.
        unsafe {
            let start =
                libc::mmap(std::ptr::null_mut(), 2 * PAGE, access | libc::PROT_WRITE, flags, -1, 0);
            assert_ne!(start, libc::MAP_FAILED);
            assert_eq!(libc::mprotect(start.byte_add(PAGE), PAGE, libc::PROT_NONE), 0);
            start.cast()
        }
    }

    /// Bytes that can be accessed are copied. A fault ends a copy, as often as it occurs.
    #[test]
    fn faults_end_copies() {
        prepare().unwrap();
        let _copies = QuickCopies::where_handled();
        assert_eq!(MAY_FAULT.get(), copying::SUPPORTED);
        let pages = half_accessible();
        for length in (0..70).chain([1000, PAGE]) {
            let sent: Vec<u8> = (0..length).map(|at| (at * 7 + length) as u8).collect();
            let mut back = vec![0; length];
            for beyond in [0, 1, 16].map(|beyond: usize| beyond.min(length)) {
                let ea = (pages.expose_provenance() + PAGE - length + beyond) as u64;
                let may = copying::SUPPORTED && beyond == 0;
                assert_eq!(store(ea, &sent), may, "{length} {beyond}");
                assert_eq!(fetch(ea, &mut back), may, "{length} {beyond}");
                assert!(!may || back == sent, "{length}");
            }
        }
        for ea in [0, 8, u64::MAX - 15, 1 << 62] {
            assert!(!fetch(ea, &mut [0; 16]) && !store(ea, &[0; 16]), "{ea:#x}");
        }
        // SAFETY: the pages are this test's own.
        unsafe { libc::munmap(pages.cast(), 2 * PAGE) };
    }

    /// A thread that has blocked the signal of a fault would be ended by it, so it makes none.
    #[test]
    fn no_fault_where_its_signal_is_blocked() {
        prepare().unwrap();
        for signal in [libc::SIGSEGV, libc::SIGBUS] {
            std::thread::spawn(move || {
                // SAFETY: all zeros are a valid set, and the signal's number is valid.
                unsafe {
                    let mut set: libc::sigset_t = std::mem::zeroed();
                    libc::sigaddset(&raw mut set, signal);
                    libc::pthread_sigmask(libc::SIG_BLOCK, &raw const set, std::ptr::null_mut());
                }
                let _copies = QuickCopies::where_handled();
                let bytes = [1_u8; 16];
                assert!(!fetch(bytes.as_ptr().expose_provenance() as u64, &mut [0; 16]));
            })
            .join()
            .unwrap();
        }
    }
}
