//! 32-bit moves between a register and memory, as compilers make them of accesses to volatile
//! words on x86-64.

use libc::{c_void, greg_t, ucontext_t};
use spu_emulator::memory::MainMemory;

use crate::process_memory::ProcessMemory;

pub(super) const SUPPORTED: bool = true;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Access {
    Load,
    /// The value that is stored.
    Store(u32),
}

pub(super) struct Decoded {
    pub access: Access,
    /// Index of the register that a load changes.
    register: usize,
    length: greg_t,
}

/// The general registers in the order of their numbers in instructions.
const REGISTERS: [libc::c_int; 16] = [
    libc::REG_RAX,
    libc::REG_RCX,
    libc::REG_RDX,
    libc::REG_RBX,
    libc::REG_RSP,
    libc::REG_RBP,
    libc::REG_RSI,
    libc::REG_RDI,
    libc::REG_R8,
    libc::REG_R9,
    libc::REG_R10,
    libc::REG_R11,
    libc::REG_R12,
    libc::REG_R13,
    libc::REG_R14,
    libc::REG_R15,
];

/// What kind of move it is, the register's number, and the instruction's length.
#[derive(Debug, PartialEq, Eq)]
enum Move {
    Load(usize, usize),
    Store(usize, usize),
    StoreImmediate(u32, usize),
}

/// Decodes `mov`: opcodes 8B, 89 and C7 /0, with an optional REX prefix that asks for no 64-bit
/// operand.
fn parse(code: &[u8]) -> Option<Move> {
    const WIDE: u8 = 8;
    const HIGH_REGISTER: u8 = 4;
    let (rex, code, prefix) = match code {
        [rex @ 0x40..=0x4f, rest @ ..] => (*rex, rest, 1),
        _ => (0, code, 0),
    };
    let [opcode, modes, rest @ ..] = code else {
        return None;
    };
    if rex & WIDE != 0 {
        return None;
    }
    let (mode, base) = (modes >> 6, modes & 7);
    let register = usize::from(modes >> 3 & 7) + if rex & HIGH_REGISTER != 0 { 8 } else { 0 };
    // A byte for a scaled index, and the displacement.
    let index = usize::from(mode != 3 && base == 4);
    let index_base = rest.first().map_or(0, |index| index & 7);
    let displacement = match mode {
        0 if base == 5 || (base == 4 && index_base == 5) => 4,
        0 => 0,
        1 => 1,
        2 => 4,
        _ => return None,
    };
    let length = prefix + 2 + index + displacement;
    match opcode {
        0x8b => Some(Move::Load(register, length)),
        0x89 => Some(Move::Store(register, length)),
        0xc7 if modes >> 3 & 7 == 0 => {
            let immediate = rest.get(index + displacement..)?.first_chunk()?;
            Some(Move::StoreImmediate(u32::from_le_bytes(*immediate), length + 4))
        }
        _ => None,
    }
}

/// Decodes the instruction that made the access.
///
/// # Safety
/// `context` is the context of a thread that was interrupted by an access to memory.
pub(super) unsafe fn decode(context: *mut c_void) -> Option<Decoded> {
    /// The longest instruction that `parse` decodes.
    const LONGEST: usize = 12;
    const PAGE: usize = 4096;
    let context: *mut ucontext_t = context.cast();
    // SAFETY: the caller vouches for the context.
    let registers = unsafe { &(*context).uc_mcontext.gregs };
    let at = registers[libc::REG_RIP as usize] as usize;
    // The instruction was fetched, but the page after it may not exist.
    let mut code = [0; LONGEST];
    let on_page = LONGEST.min(PAGE - at % PAGE);
    for (from, to) in [(0, on_page), (on_page, LONGEST)] {
        let part = &mut code[from..to];
        if !part.is_empty() && ProcessMemory.read((at + from) as u64, part).is_err() {
            break;
        }
    }
    let (access, register, length) = match parse(&code)? {
        Move::Load(register, length) => (Access::Load, register, length),
        Move::Store(register, length) => {
            let value = registers[REGISTERS[register] as usize] as u32;
            (Access::Store(value), register, length)
        }
        Move::StoreImmediate(value, length) => (Access::Store(value), 0, length),
    };
    Some(Decoded { access, register: REGISTERS[register] as usize, length: length as greg_t })
}

impl Decoded {
    /// Sets the register that the load changes. The upper half becomes 0.
    ///
    /// # Safety
    /// `context` is the one that was decoded.
    pub unsafe fn set_result(&self, context: *mut c_void, value: u32) {
        let context: *mut ucontext_t = context.cast();
        // SAFETY: the caller vouches for the context.
        unsafe { (*context).uc_mcontext.gregs[self.register] = greg_t::from(value) };
    }

    /// Continues after the instruction.
    ///
    /// # Safety
    /// `context` is the one that was decoded.
    pub unsafe fn step(&self, context: *mut c_void) {
        let context: *mut ucontext_t = context.cast();
        // SAFETY: the caller vouches for the context.
        unsafe { (*context).uc_mcontext.gregs[libc::REG_RIP as usize] += self.length };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Provenance: assembled by GNU as.
    #[test]
    fn moves_are_decoded() {
        let cases: [(&[u8], Move); 9] = [
            (&[0x8b, 0x00, 0, 0, 0, 0, 0], Move::Load(0, 2)), // mov (%rax),%eax
            (&[0x8b, 0x40, 0x14, 0, 0, 0, 0], Move::Load(0, 3)), // mov 0x14(%rax),%eax
            (&[0x44, 0x8b, 0x82, 0, 1, 0, 0], Move::Load(8, 7)), // mov 0x100(%rdx),%r8d
            (&[0x41, 0x89, 0x4c, 0x24, 0x0c, 0, 0], Move::Store(1, 5)), // mov %ecx,0xc(%r12)
            (&[0x89, 0x04, 0x8a, 0, 0, 0, 0], Move::Store(0, 3)), // mov %eax,(%rdx,%rcx,4)
            (&[0x8b, 0x04, 0x25, 0, 0, 0, 1], Move::Load(0, 7)), // mov 0x1000000,%eax
            (&[0x8b, 0x0d, 1, 0, 0, 0, 0], Move::Load(1, 6)), // mov 1(%rip),%ecx
            (&[0xc7, 0x40, 0x0c, 4, 3, 2, 1], Move::StoreImmediate(0x0102_0304, 7)),
            (&[0x41, 0xc7, 0x01, 7, 0, 0, 0], Move::StoreImmediate(7, 7)),
        ];
        for (code, expected) in cases {
            assert_eq!(parse(code), Some(expected), "{code:x?}");
        }
        for code in [
            [0x48, 0x8b, 0x00, 0, 0], // mov (%rax),%rax
            [0x0f, 0xb6, 0x00, 0, 0], // movzbl (%rax),%eax
            [0x83, 0x38, 0x01, 0, 0], // cmpl $1,(%rax)
            [0x8b, 0xc1, 0x00, 0, 0], // mov %ecx,%eax
        ] {
            assert_eq!(parse(&code), None, "{code:x?}");
        }
    }
}
