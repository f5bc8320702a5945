//! The host's side of compiled code: its floating-point control register, and the way in.

use std::arch::{asm, naked_asm};
use std::mem::offset_of;

/// Round toward zero, flush tiny results to zero, take denormal operands as they are, mask all
/// exceptions; no exception has happened.
const MXCSR: u32 = 0xff80;

/// Exceptions after which the host's results are not an SPU's: invalid, denormal operand,
/// overflow, underflow. Inexact is what truncation is for, and nothing here divides.
pub(crate) const EXCEPTIONS: u32 = 0x1b;

/// What compiled code and those who enter it share.
#[repr(C, align(16))]
pub(crate) struct Context {
    /// The SPU's FPSCR.
    pub fpscr: [u32; 4],
    /// Where results go that nobody reads, so that they are computed.
    pub unread: [u32; 4],
    /// Code by word address.
    pub table: *const *const u8,
    /// How often each unit was entered, by its number.
    pub entries: *mut u32,
    /// Where the next passage through a unit is written down, if passages are.
    pub log: *mut u32,
    /// Instructions that may still run.
    pub budget: i64,
    /// Where the SPU is.
    pub pc: u32,
    /// The unit that left, if it was one that failed or was stale.
    pub unit: u32,
    /// The host's control register, as compiled code looked at it last.
    pub mxcsr: u32,
    /// The same as it has to be outside.
    pub host_mxcsr: u32,
}

/// Whether compiled code can run here.
pub(crate) fn supported() -> bool {
    is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")
}

/// Stores the host's control register in the [`Context`] that `rdi` points to. Compiled code calls
/// it with the convention that preserves all registers.
#[unsafe(naked)]
pub(crate) extern "C" fn read_mxcsr() {
    naked_asm!(
        "stmxcsr [rdi + {mxcsr}]",
        "ret",
        mxcsr = const offset_of!(Context, mxcsr)
    )
}

/// Calls `trampoline`, with the host's control register as compiled code needs it; gives what it
/// returns.
///
/// # Safety
///
/// `trampoline` is the compiler's, which takes these five arguments as System V has it; `context`
/// and what it points to are valid for the call, `registers` for 128 quadwords and `local_store`
/// for 256 KB; `target` is a unit's code or the leaving one's.
pub(crate) unsafe fn call(
    trampoline: *const u8,
    registers: *mut u8,
    local_store: *mut u8,
    context: *mut Context,
    target: *const u8,
) -> u32 {
    let status: u64;
    // SAFETY: the control register is restored before Rust's code goes on. The call follows the
    // System V convention, whose clobbers are declared; the assembler keeps the stack aligned.
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
