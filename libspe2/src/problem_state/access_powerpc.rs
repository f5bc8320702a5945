//! Loads and stores of words on PowerPC, of 32 and of 64 bits: `lwz`, `stw` and their indexed and
//! byte-reversed forms.
//!
//! The C library's `ucontext_t` is not in Rust's bindings for this processor, so the places of the
//! registers are the kernel's.

use libc::c_void;

pub(super) const SUPPORTED: bool = true;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Access {
    Load,
    /// The value that is stored.
    Store(u32),
}

pub(super) struct Decoded {
    pub access: Access,
    register: usize,
    reversed: bool,
}

/// Index of the next instruction's address, after the 32 general registers.
const NEXT: usize = 32;

/// The saved general registers. In both contexts a pointer leads to them: `uc_mcontext.regs` in
/// that of 64 bits, `uc_regs` in that of 32 bits.
///
/// # Safety
/// `context` is the context of a thread that was interrupted by a signal.
unsafe fn registers(context: *mut c_void) -> *mut usize {
    const POINTER: usize = if cfg!(target_pointer_width = "64") { 224 } else { 48 };
    // SAFETY: the kernel has put a valid pointer there.
    unsafe { context.byte_add(POINTER).cast::<*mut usize>().read() }
}

/// Whether it is a load, the register's number, and whether the bytes are reversed.
fn parse(word: u32) -> Option<(bool, usize, bool)> {
    const LWZ: u32 = 32;
    const STW: u32 = 36;
    const INDEXED: u32 = 31;
    let (load, reversed) = match (word >> 26, word >> 1 & 0x3ff) {
        (LWZ, _) | (INDEXED, 23) => (true, false),
        (STW, _) | (INDEXED, 151) => (false, false),
        (INDEXED, 534) => (true, true),
        (INDEXED, 662) => (false, true),
        _ => return None,
    };
    Some((load, (word >> 21 & 31) as usize, reversed))
}

/// Decodes the instruction that made the access.
///
/// # Safety
/// `context` is the context of a thread that was interrupted by an access to memory.
pub(super) unsafe fn decode(context: *mut c_void) -> Option<Decoded> {
    // SAFETY: the caller vouches for the context.
    let registers = unsafe { registers(context) };
    // SAFETY: this register's place holds the address of the instruction, which the thread has
    // just fetched.
    let word = unsafe {
        let at: *const u32 = std::ptr::with_exposed_provenance(registers.add(NEXT).read());
        at.read()
    };
    let (load, register, reversed) = parse(word)?;
    // SAFETY: there are 32 registers.
    let value = unsafe { registers.add(register).read() } as u32;
    let access = match (load, reversed) {
        (true, _) => Access::Load,
        (false, true) => Access::Store(value.swap_bytes()),
        (false, false) => Access::Store(value),
    };
    Some(Decoded { access, register, reversed })
}

impl Decoded {
    /// Sets the register that the load changes. The upper half becomes 0.
    ///
    /// # Safety
    /// `context` is the one that was decoded.
    pub unsafe fn set_result(&self, context: *mut c_void, value: u32) {
        let value = if self.reversed { value.swap_bytes() } else { value };
        // SAFETY: the caller vouches for the context, and there are 32 registers.
        unsafe { registers(context).add(self.register).write(value as usize) };
    }

    /// Continues after the instruction.
    ///
    /// # Safety
    /// `context` is the one that was decoded.
    pub unsafe fn step(&self, context: *mut c_void) {
        // SAFETY: the caller vouches for the context.
        unsafe {
            let next = registers(context).add(NEXT);
            next.write(next.read() + 4);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Provenance: assembled by GNU as.
    #[test]
    fn loads_and_stores_are_decoded() {
        assert_eq!(parse(0x8123_0014), Some((true, 9, false))); // lwz 9,20(3)
        assert_eq!(parse(0x9145_000c), Some((false, 10, false))); // stw 10,12(5)
        assert_eq!(parse(0x7d23_202e), Some((true, 9, false))); // lwzx 9,3,4
        assert_eq!(parse(0x7d23_212e), Some((false, 9, false))); // stwx 9,3,4
        assert_eq!(parse(0x7d23_242c), Some((true, 9, true))); // lwbrx 9,3,4
        assert_eq!(parse(0x7d23_252c), Some((false, 9, true))); // stwbrx 9,3,4
        assert_eq!(parse(0x8823_0014), None); // lbz 1,20(3)
    }
}
