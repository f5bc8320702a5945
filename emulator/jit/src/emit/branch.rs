//! Branches and halts, which become side exits where the SPU may leave the path of the trace.

use cranelift_codegen::ir::condcodes::{CondCode, IntCC};
use cranelift_codegen::ir::{InstBuilder, Value, types};
use spu_isa::{Instruction, Op};

use super::Emitter;
use crate::trace::{code_address, following};

/// The part of rt that a branch tests.
#[derive(Clone, Copy)]
enum Tested {
    Word,
    Halfword,
}

impl Emitter<'_> {
    /// Emits a branch or a halt, after which the trace continues at `next`. Returns `false` if the
    /// instruction is neither.
    pub(super) fn branch(&mut self, i: Instruction, next: u32) -> bool {
        use IntCC::{Equal, NotEqual, SignedGreaterThan, UnsignedGreaterThan};
        use Tested::{Halfword, Word};
        match i.op {
            Op::Br | Op::Bra => {}
            Op::Brsl | Op::Brasl => self.link(i),
            Op::Brz => self.relative_if(i, Word, Equal, next),
            Op::Brnz => self.relative_if(i, Word, NotEqual, next),
            Op::Brhz => self.relative_if(i, Halfword, Equal, next),
            Op::Brhnz => self.relative_if(i, Halfword, NotEqual, next),
            Op::Bi => self.indirect(i, next),
            Op::Bisl => {
                let target = self.target(i);
                self.link(i);
                self.expect(target, next);
            }
            Op::Biz => self.indirect_if(i, Word, Equal, next),
            Op::Binz => self.indirect_if(i, Word, NotEqual, next),
            Op::Bihz => self.indirect_if(i, Halfword, Equal, next),
            Op::Bihnz => self.indirect_if(i, Halfword, NotEqual, next),
            Op::Heq => self.halt(i, Equal),
            Op::Heqi => self.halt_immediate(i, Equal),
            Op::Hgt => self.halt(i, SignedGreaterThan),
            Op::Hgti => self.halt_immediate(i, SignedGreaterThan),
            Op::Hlgt => self.halt(i, UnsignedGreaterThan),
            Op::Hlgti => self.halt_immediate(i, UnsignedGreaterThan),
            _ => return false,
        }
        true
    }

    fn link(&mut self, i: Instruction) {
        self.set_constant(i.rt, [following(self.pc), 0, 0, 0]);
    }

    /// Emits a side exit to `pc` after this instruction, taken if `condition` holds.
    fn leave_if(&mut self, condition: Value, pc: impl FnOnce(&mut Self) -> Value) {
        self.count += 1;
        self.side_exit_if(condition, |e| {
            let pc = pc(e);
            e.chain_to(pc);
        });
        self.count -= 1;
    }

    fn tested(&mut self, i: Instruction, tested: Tested) -> Value {
        let word = self.scalar(i.rt);
        match tested {
            Tested::Word => word,
            Tested::Halfword => self.b.ins().band_imm_u(word, 0xffff),
        }
    }

    fn relative_if(&mut self, i: Instruction, tested: Tested, compare: IntCC, next: u32) {
        let target = code_address(self.pc.wrapping_add_signed(i.immediate));
        let straight = following(self.pc);
        if target == straight {
            return;
        }
        let (compare, other) =
            if next == target { (compare.complement(), straight) } else { (compare, target) };
        let value = self.tested(i, tested);
        let zero = self.word(0);
        let condition = self.b.ins().icmp(compare, value, zero);
        self.leave_if(condition, |e| e.word(other));
    }

    fn target(&mut self, i: Instruction) -> Result<u32, Value> {
        let id = self.get(i.ra);
        match self.constant(id) {
            Some(words) => Ok(code_address(words[0])),
            None => {
                let scalar = self.scalar_of(id);
                let mask = i64::from(code_address(u32::MAX));
                Err(self.b.ins().band_imm_u(scalar, mask))
            }
        }
    }

    /// Emits a side exit, taken unless `target` is the address where the trace continues.
    fn expect(&mut self, target: Result<u32, Value>, next: u32) {
        let target = match target {
            Ok(target) if target == next => return,
            Ok(target) => self.word(target),
            Err(target) => target,
        };
        let next = self.word(next);
        let elsewhere = self.b.ins().icmp(IntCC::NotEqual, target, next);
        self.leave_if(elsewhere, |_| target);
    }

    fn indirect(&mut self, i: Instruction, next: u32) {
        let target = self.target(i);
        self.expect(target, next);
    }

    fn indirect_if(&mut self, i: Instruction, tested: Tested, compare: IntCC, next: u32) {
        let straight = following(self.pc);
        let value = self.tested(i, tested);
        let zero = self.word(0);
        if next == straight {
            let target = match self.target(i) {
                Ok(target) => self.word(target),
                Err(target) => target,
            };
            let condition = self.b.ins().icmp(compare, value, zero);
            self.leave_if(condition, |_| target);
        } else {
            let condition = self.b.ins().icmp(compare.complement(), value, zero);
            self.leave_if(condition, |e| e.word(straight));
            self.indirect(i, next);
        }
    }

    /// Leaves a halt to the interpreter if its condition holds.
    fn halt_if(&mut self, condition: Value) {
        self.side_exit_if(condition, Self::leave_to_interpreter);
    }

    fn halt(&mut self, i: Instruction, compare: IntCC) {
        let (a, b) = (self.scalar(i.ra), self.scalar(i.rb));
        let condition = self.b.ins().icmp(compare, a, b);
        self.halt_if(condition);
    }

    fn halt_immediate(&mut self, i: Instruction, compare: IntCC) {
        let a = self.scalar(i.ra);
        let b = self.b.ins().iconst(types::I32, i64::from(i.immediate as u32));
        let condition = self.b.ins().icmp(compare, a, b);
        self.halt_if(condition);
    }
}
