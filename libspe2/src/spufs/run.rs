//! Running a context: the start of a program, and the meaning of the kernel's result.

use libc::c_int;
use spu_emulator::interp::Quad;
use spu_emulator::local_store::SIZE;
use spu_isa::LIMIT_MASK;

use super::calls;
use super::context::Spufs;
use crate::run::{Ended, Outcome, STACK_TOP, START_BLOCK, StartRegisters};
use crate::types::{
    SPE_SPU_HALT, SPE_SPU_INVALID_CHANNEL, SPE_SPU_INVALID_INSTR, SPE_SPU_STOPPED_BY_STOP,
    SPE_SPU_WAITING_ON_CHANNEL,
};

/// Where the start block begins: images of registers 3 to 6, and then the start code.
const BLOCK: u32 = SIZE - START_BLOCK as u32;
/// Where the start code ends, and the back chain lies.
const CODE_WORDS: usize = 8;
const CODE: u32 = STACK_TOP - 4 * CODE_WORDS as u32;

/// Instructions with an 18-bit address of words and a register.
const fn absolute(opcode: u32, address: u32, register: u32) -> u32 {
    opcode << 23 | (address >> 2 & 0xffff) << 7 | register
}

const fn load_quadword(register: u32, address: u32) -> u32 {
    const LQA: u32 = 0x61;
    absolute(LQA, address, register)
}

/// The block at the top of local store that sets the registers of a program's start, as IBM's
/// library does. The last instruction branches to the program and links to the address after
/// itself. That is the back chain's, so the link register is the stack pointer.
fn start_block(start: &StartRegisters, entry: u32) -> [u8; START_BLOCK] {
    const BRASL: u32 = 0x62;
    const STACK_POINTER: u32 = 1;
    /// `il $2,0`
    const CLEAR_ENVIRONMENT: u32 = 0x081 << 23 | 2;
    const NOP: u32 = 0x201 << 21;
    let mut block = [0; START_BLOCK];
    for (at, quad) in block.chunks_exact_mut(16).zip(start.arguments()) {
        at.copy_from_slice(&Quad::bytes(quad));
    }
    let code: [u32; CODE_WORDS] = [
        load_quadword(3, BLOCK),
        load_quadword(4, BLOCK + 16),
        load_quadword(5, BLOCK + 32),
        load_quadword(6, BLOCK + 48),
        CLEAR_ENVIRONMENT,
        NOP,
        NOP,
        absolute(BRASL, entry, STACK_POINTER),
    ];
    let at = (CODE - BLOCK) as usize;
    for (at, word) in block[at..].chunks_exact_mut(4).zip(code) {
        at.copy_from_slice(&word.to_be_bytes());
    }
    block
}

impl Spufs {
    pub(super) fn run_from(&self, at: u32, start: Option<&StartRegisters>) -> (u32, Ended) {
        let mut npc = at;
        if let Some(start) = start {
            self.write_to_local_store(BLOCK, &start_block(start, at));
            npc = CODE;
        }
        let mut event = 0;
        let events = self.events_enabled.then_some(&mut event);
        let status = calls::run(self.directory.descriptor(), &mut npc, events);
        let ended = match status {
            Ok(status) => ended(status, event as c_int),
            Err(error) => {
                let errno = error.raw_os_error().unwrap_or(-1);
                Ended::Return(Outcome::fatal(errno))
            }
        };
        (npc & LIMIT_MASK, ended)
    }
}

/// The meaning of an SPU's status and of the event of a DMA error. The order is that of IBM's
/// library.
fn ended(status: c_int, event: c_int) -> Ended {
    let has = |bit| status & bit != 0;
    let error = |bit| Ended::Return(Outcome::error(bit, status));
    if has(SPE_SPU_INVALID_INSTR) {
        return error(SPE_SPU_INVALID_INSTR);
    }
    if event != 0 {
        return Ended::Return(Outcome::exception(event));
    }
    if has(SPE_SPU_STOPPED_BY_STOP) {
        let code = (status >> 16 & 0x3fff) as u16;
        return Ended::Stop { code, status };
    }
    if has(SPE_SPU_HALT) {
        return error(SPE_SPU_HALT);
    }
    if has(SPE_SPU_WAITING_ON_CHANNEL) {
        return Ended::Return(Outcome::exception(event));
    }
    if has(SPE_SPU_INVALID_CHANNEL) {
        return error(SPE_SPU_INVALID_CHANNEL);
    }
    Ended::Return(Outcome::fatal(-1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::types::{
        SPE_DMA_STORAGE, SPE_RUNTIME_ERROR, SPE_RUNTIME_EXCEPTION, SPE_RUNTIME_FATAL,
    };

    /// The stop reason, result and status that a status and an event become.
    fn reported(status: c_int, event: c_int) -> (u32, c_int, c_int) {
        match ended(status, event) {
            Ended::Return(outcome) => {
                let record = outcome.record();
                (record.stop_reason, record.result, record.spu_status)
            }
            Ended::Stop { code, status } => (0, c_int::from(code), status),
            Ended::Resume => panic!("the kernel has nothing to resume"),
        }
    }

    #[test]
    fn stop_causes_are_ordered() {
        const STORAGE: c_int = SPE_DMA_STORAGE;
        let exit = 0x2007 << 16 | SPE_SPU_STOPPED_BY_STOP;
        assert_eq!(reported(exit, 0), (0, 0x2007, exit));
        let exception = (SPE_RUNTIME_EXCEPTION, STORAGE, -1);
        assert_eq!(reported(exit, STORAGE), exception);
        let invalid = exit | SPE_SPU_INVALID_INSTR;
        let error = |bit, status| (SPE_RUNTIME_ERROR, bit, status);
        assert_eq!(reported(invalid, STORAGE), error(SPE_SPU_INVALID_INSTR, invalid));
        for bit in [SPE_SPU_HALT, SPE_SPU_INVALID_CHANNEL] {
            assert_eq!(reported(bit, 0), error(bit, bit));
        }
        let waiting = reported(SPE_SPU_WAITING_ON_CHANNEL, 0);
        assert_eq!(waiting, (SPE_RUNTIME_EXCEPTION, 0, -1));
        assert_eq!(reported(0, 0), (SPE_RUNTIME_FATAL, -1, -1));
        // A stop code has 14 bits.
        let wide = c_int::MAX & !0xffff | SPE_SPU_STOPPED_BY_STOP;
        assert_eq!(reported(wide, 0), (0, 0x3fff, wide));
    }
}
