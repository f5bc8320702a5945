//! Branches and halts, which become side exits where the SPU may leave the path of the trace.

use spu_isa::{Instruction, Op};
use wasm_encoder::InstructionSink;

use super::emitter::{ADDRESS, Emitter};
use crate::exit::Exit;
use crate::trace::{code_address, following};

/// The bits of the preferred word that a branch compares with zero.
const WORD: u32 = u32::MAX;
const HALFWORD: u32 = 0xffff;

type Compare = for<'a, 'b> fn(&'b mut InstructionSink<'a>) -> &'b mut InstructionSink<'a>;

impl Emitter<'_> {
    /// Emits a branch or a halt, after which the trace continues at `next`. Returns `false` if the
    /// instruction is neither.
    pub(super) fn branch(&mut self, i: Instruction, next: u32) -> bool {
        match i.op {
            Op::Br | Op::Bra => {}
            Op::Brsl | Op::Brasl => self.link(i),
            Op::Brz => self.relative_if(i, WORD, true, next),
            Op::Brnz => self.relative_if(i, WORD, false, next),
            Op::Brhz => self.relative_if(i, HALFWORD, true, next),
            Op::Brhnz => self.relative_if(i, HALFWORD, false, next),
            Op::Bi => self.indirect(i, next),
            Op::Bisl => {
                self.target(i);
                self.link(i);
                self.expect(next);
            }
            Op::Biz => self.indirect_if(i, WORD, true, next),
            Op::Binz => self.indirect_if(i, WORD, false, next),
            Op::Bihz => self.indirect_if(i, HALFWORD, true, next),
            Op::Bihnz => self.indirect_if(i, HALFWORD, false, next),
            Op::Heq => self.halt(i, |f| f.i32_eq()),
            Op::Heqi => self.halt_immediate(i, |f| f.i32_eq()),
            Op::Hgt => self.halt(i, |f| f.i32_gt_s()),
            Op::Hgti => self.halt_immediate(i, |f| f.i32_gt_s()),
            Op::Hlgt => self.halt(i, |f| f.i32_gt_u()),
            Op::Hlgti => self.halt_immediate(i, |f| f.i32_gt_u()),
            _ => return false,
        }
        true
    }

    fn link(&mut self, i: Instruction) {
        self.set_constant(i.rt, [following(self.pc), 0, 0, 0]);
    }

    /// Emits a side exit after this instruction, taken if the value on the stack is not 0.
    fn leave_if(&mut self, pc: Option<u32>) {
        self.count += 1;
        self.aside(|e| {
            if let Some(pc) = pc {
                e.f().i32_const(pc as i32).local_set(ADDRESS);
            }
            e.chain();
        });
        self.count -= 1;
    }

    /// Pushes whether the tested part of rt is zero, or is not.
    fn test(&mut self, i: Instruction, part: u32, zero: bool) {
        self.push_scalar(i.rt);
        if part != WORD {
            self.f().i32_const(part as i32).i32_and();
        }
        if zero {
            self.f().i32_eqz();
        }
    }

    fn relative_if(&mut self, i: Instruction, part: u32, zero: bool, next: u32) {
        let target = code_address(self.pc.wrapping_add_signed(i.immediate));
        let straight = following(self.pc);
        if target == straight {
            return;
        }
        let taken = next == target;
        self.test(i, part, zero != taken);
        self.leave_if(Some(if taken { straight } else { target }));
    }

    /// Sets the address to the target of an indirect branch.
    fn target(&mut self, i: Instruction) {
        self.push_scalar(i.ra);
        let mask = code_address(u32::MAX) as i32;
        self.f().i32_const(mask).i32_and().local_set(ADDRESS);
    }

    /// Emits a side exit, taken unless the address is the one where the trace continues.
    fn expect(&mut self, next: u32) {
        self.f().local_get(ADDRESS).i32_const(next as i32).i32_ne();
        self.leave_if(None);
    }

    fn indirect(&mut self, i: Instruction, next: u32) {
        self.target(i);
        self.expect(next);
    }

    fn indirect_if(&mut self, i: Instruction, part: u32, zero: bool, next: u32) {
        let straight = following(self.pc);
        if next == straight {
            self.target(i);
            self.test(i, part, zero);
            self.leave_if(None);
        } else {
            self.test(i, part, !zero);
            self.leave_if(Some(straight));
            self.indirect(i, next);
        }
    }

    /// Leaves a halt to the interpreter if its condition, which is on the stack, holds.
    fn halt_if(&mut self) {
        self.aside(|e| e.exit(Exit::INTERPRET));
    }

    fn halt(&mut self, i: Instruction, compare: Compare) {
        self.push_scalar(i.ra);
        self.push_scalar(i.rb);
        compare(&mut self.f());
        self.halt_if();
    }

    fn halt_immediate(&mut self, i: Instruction, compare: Compare) {
        self.push_scalar(i.ra);
        compare(self.f().i32_const(i.immediate));
        self.halt_if();
    }
}
