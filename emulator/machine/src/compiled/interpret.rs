//! Runs single instructions for compiled code.

use std::cell::RefCell;

use spu_isa::Instruction;

use crate::channel::NoChannels;
use crate::float::fpscr::Fpscr;
use crate::interp::{Quad, Spu};
use crate::local_store::LocalStore;

thread_local! {
    static SPU: RefCell<(Spu, LocalStore)> = RefCell::default();
}

/// Runs an instruction that uses registers only.
///
/// # Safety
///
/// `registers` must point to 128 registers and `fpscr` to an FPSCR, which nobody else accesses
/// during the call.
pub(super) unsafe extern "C" fn interpret(
    registers: *mut [u32; 4],
    fpscr: *mut [u32; 4],
    word: u32,
) {
    // SAFETY: the caller guarantees both.
    let (registers, fpscr) = unsafe { (&mut *registers.cast::<[[u32; 4]; 128]>(), &mut *fpscr) };
    let Some(i) = Instruction::decode(word) else { return };
    let row = i.op.row();
    SPU.with_borrow_mut(|(spu, local_store)| {
        for &field in row.reads {
            let register = i.register(field);
            spu.set_register(register, Quad(registers[usize::from(register)]));
        }
        spu.fpscr = Fpscr::from_words(*fpscr);
        spu.set_pc(0);
        local_store.write(0, &word.to_be_bytes());
        spu.step(local_store, &mut NoChannels);
        *fpscr = spu.fpscr.words();
        registers[usize::from(i.rt)] = spu.register(i.rt).0;
    });
}
