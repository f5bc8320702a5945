//! The signals that the kernel would send to the thread that runs a context.
//!
//! On PowerPC, a handler gets the signal without its code and address. QEMU's user emulation
//! mistakes a queued SIGSEGV or SIGBUS with a fault's code for a fault of its own and crashes.

use std::mem::MaybeUninit;
use std::ptr;

use libc::c_int;

use crate::fault_handler;

const BUS_ADRALN: c_int = 1;
const BUS_OBJERR: c_int = 3;
const SEGV_ACCERR: c_int = 2;
const ILL_OPC: c_int = 1;

/// Whether a signal can carry the code and address of a fault.
const CARRIES_FAULT: bool = cfg!(not(any(target_arch = "powerpc64", target_arch = "powerpc")));

/// A fault in the form that a signal reports it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FaultSignal {
    signal: c_int,
    code: c_int,
    address: u64,
}

/// Whether the run continues after the program's handler has returned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum After {
    Resume,
    Interrupted,
}

impl FaultSignal {
    pub(crate) fn dma_alignment() -> Self {
        Self::new(libc::SIGBUS, BUS_ADRALN, 0)
    }

    pub(crate) fn invalid_dma() -> Self {
        Self::new(libc::SIGBUS, BUS_OBJERR, 0)
    }

    pub(crate) fn dma_storage(ea: u64) -> Self {
        Self::new(libc::SIGSEGV, SEGV_ACCERR, ea)
    }

    pub(crate) fn invalid_instruction(address: u32) -> Self {
        Self::new(libc::SIGILL, ILL_OPC, u64::from(address))
    }

    pub(crate) fn breakpoint() -> Self {
        Self::new(libc::SIGTRAP, libc::SI_KERNEL, 0)
    }

    fn new(signal: c_int, code: c_int, address: u64) -> Self {
        Self { signal, code, address }
    }

    /// Sends the signal to the calling thread. If the program has a handler, it has run when this
    /// function returns. Without one, the process ends, even if the signal was ignored or blocked,
    /// because a fault can be neither.
    pub(crate) fn raise(self) -> After {
        let action = fault_handler::of_program(self.signal);
        // SAFETY: every pointer is to a local variable of this function, and the signal number is
        // valid.
        unsafe {
            let mut set = MaybeUninit::<libc::sigset_t>::zeroed().assume_init();
            let mut blocked = MaybeUninit::<libc::sigset_t>::zeroed().assume_init();
            libc::sigemptyset(&raw mut set);
            libc::sigaddset(&raw mut set, self.signal);
            libc::pthread_sigmask(libc::SIG_BLOCK, ptr::null(), &raw mut blocked);
            let is_blocked = libc::sigismember(&raw const blocked, self.signal) == 1;
            if is_blocked || [libc::SIG_IGN, libc::SIG_DFL].contains(&action.sa_sigaction) {
                // Nobody will see more than the signal's number.
                libc::signal(self.signal, libc::SIG_DFL);
                libc::pthread_sigmask(libc::SIG_UNBLOCK, &raw const set, ptr::null_mut());
                libc::raise(self.signal);
            } else if CARRIES_FAULT {
                self.send();
            } else {
                libc::raise(self.signal);
            }
            if action.sa_flags & libc::SA_RESTART != 0 { After::Resume } else { After::Interrupted }
        }
    }

    /// # Safety
    /// The program must be ready for the signal.
    unsafe fn send(self) {
        /// Offset of `si_addr` in a 64-bit `siginfo_t`.
        const ADDRESS_OFFSET: usize = 16;
        // SAFETY: all zeros are a valid siginfo_t, which can hold an address at this offset.
        // The kernel lets a thread choose every field of a signal to itself.
        let sent = unsafe {
            let mut info = MaybeUninit::<libc::siginfo_t>::zeroed().assume_init();
            info.si_signo = self.signal;
            info.si_code = self.code;
            (&raw mut info).byte_add(ADDRESS_OFFSET).cast::<u64>().write(self.address);
            libc::syscall(
                libc::SYS_rt_tgsigqueueinfo,
                libc::getpid(),
                libc::syscall(libc::SYS_gettid),
                self.signal,
                &raw const info,
            )
        };
        if sent != 0 {
            // SAFETY: the signal number is valid.
            unsafe { libc::raise(self.signal) };
        }
    }
}
