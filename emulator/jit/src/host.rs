//! The host's side of compiled code: its floating-point control register, and the call that enters
//! compiled code.

use std::arch::{asm, naked_asm};
use std::mem::offset_of;
use std::ptr;

/// The control register for compiled code: round toward zero, flush tiny results to zero, keep
/// denormal operands, mask all exceptions. Its exception flags are clear.
const MXCSR: u32 = 0xff80;

/// The bits that mask exceptions.
const MASKS: u32 = 0x1f80;

/// The exceptions after which the host's result may differ from an SPU's: invalid, denormal
/// operand, overflow, underflow. Inexact results are truncated, as on an SPU, and compiled code
/// has no divisions.
pub(crate) const EXCEPTIONS: u32 = 0x1b;

/// The data that compiled code shares with its caller.
#[repr(C, align(16))]
pub(crate) struct Context {
    /// The SPU's FPSCR.
    pub fpscr: [u32; 4],
    /// A sink for results that nobody reads. Storing them here makes sure that they are computed.
    pub sink: [u32; 4],
    /// For each word of local store, the code to run there.
    pub table: *const *const u8,
    /// How often each unit was entered, by unit number.
    pub entries: *mut u32,
    /// Where the next passage through a unit is logged, if passages are logged.
    pub log: *mut u32,
    /// For each quadword of local store, the accesses that compiled code leaves to the interpreter,
    /// if the compiler's units look for that.
    pub watched: *const u8,
    /// The number of instructions that may still run.
    pub budget: i64,
    /// The SPU's program counter.
    pub pc: u32,
    /// The number of the unit that failed or was stale.
    pub unit: u32,
    /// The host's control register, as compiled code last read it.
    pub mxcsr: u32,
    /// The host's control register outside compiled code.
    pub host_mxcsr: u32,
}

impl Context {
    /// The data of an SPU's units, with its table and its numbers of entries.
    pub fn new(table: *mut *const u8, entries: *mut u32) -> Self {
        Self {
            fpscr: [0; 4],
            sink: [0; 4],
            table,
            entries,
            log: ptr::null_mut(),
            watched: ptr::null(),
            budget: 0,
            pc: 0,
            unit: 0,
            mxcsr: 0,
            host_mxcsr: 0,
        }
    }
}

/// Whether compiled code can run on this host.
pub(crate) fn supported() -> bool {
    is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")
}

/// Stores the host's control register in the [`Context`] that `rdi` points to. Compiled code calls
/// it with the calling convention that preserves all registers.
#[unsafe(naked)]
pub(crate) extern "C" fn read_mxcsr() {
    naked_asm!(
        "stmxcsr [rdi + {mxcsr}]",
        "ret",
        mxcsr = const offset_of!(Context, mxcsr)
    )
}

/// Has the host round to nearest and keep tiny results, as double precision needs. Called like
/// [`read_mxcsr`].
#[unsafe(naked)]
pub(crate) extern "C" fn round_to_nearest() {
    naked_asm!(
        "stmxcsr [rdi + {mxcsr}]",
        "and dword ptr [rdi + {mxcsr}], {kept}",
        "ldmxcsr [rdi + {mxcsr}]",
        "ret",
        mxcsr = const offset_of!(Context, mxcsr),
        kept = const !(MXCSR & !MASKS),
    )
}

/// Undoes [`round_to_nearest`]. Called like [`read_mxcsr`].
#[unsafe(naked)]
pub(crate) extern "C" fn round_toward_zero() {
    naked_asm!(
        "stmxcsr [rdi + {mxcsr}]",
        "or dword ptr [rdi + {mxcsr}], {added}",
        "ldmxcsr [rdi + {mxcsr}]",
        "ret",
        mxcsr = const offset_of!(Context, mxcsr),
        added = const MXCSR & !MASKS,
    )
}

/// Calls `trampoline` with the host's control register set for compiled code, and returns its
/// result.
///
/// # Safety
///
/// `trampoline` must be the compiler's, which takes the other four arguments by the System V
/// convention. `context` and all that it points to must be valid for the call, `registers` for 128
/// quadwords and `local_store` for 256 KB. `target` must be the code of a unit or the exit stub.
pub(crate) unsafe fn call(
    trampoline: *const u8,
    registers: *mut u8,
    local_store: *mut u8,
    context: *mut Context,
    target: *const u8,
) -> u32 {
    let status: u64;
    // SAFETY: the control register is restored before Rust code continues. The call follows the
    // System V convention, whose clobbers are declared. `asm!` keeps the stack aligned.
    unsafe {
        asm!(
            "stmxcsr [r12 + {host}]",
            "mov dword ptr [r12 + {mxcsr}], {value}",
            "ldmxcsr [r12 + {mxcsr}]",
            "call {trampoline}",
            "ldmxcsr [r12 + {host}]",
            host = const offset_of!(Context, host_mxcsr),
            mxcsr = const offset_of!(Context, mxcsr),
            value = const MXCSR,
            trampoline = in(reg) trampoline,
            in("r12") context,
            in("rdi") registers,
            in("rsi") local_store,
            in("rdx") context,
            in("rcx") target,
            lateout("rax") status,
            clobber_abi("sysv64"),
        );
    }
    status as u32
}
