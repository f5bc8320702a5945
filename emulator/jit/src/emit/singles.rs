//! Arithmetic in the host's singles.
//!
//! The host rounds toward zero, flushes tiny results and keeps denormal operands. An SPU treats
//! denormal operands, overflow and tiny results differently, and the host's flags report these.
//! They don't report exponents of 255, so operands that aren't results of arithmetic are checked
//! for them. An SPU's result is never -0, so terms that may be -0 are changed to +0 first.

use cranelift_codegen::ir::types::F32X4;
use cranelift_codegen::ir::{InstBuilder, Value};
use spu_isa::{Instruction, Op};

use super::Emitter;
use super::float::SIGN;
use super::registers::{Facts, Id};

impl Emitter<'_> {
    pub(super) fn arithmetic_in_singles(&mut self, i: Instruction) {
        self.unverified.arithmetic = true;
        let (ida, idb) = (self.get(i.ra), self.get(i.rb));
        let (a, b) = (self.operand(ida), self.operand(idb));
        let result = match i.op {
            Op::Fa if self.facts(ida).no_negative_zero => self.b.ins().fadd(a, b),
            Op::Fa => {
                let b = self.canonical(idb);
                self.b.ins().fadd(a, b)
            }
            Op::Fs => {
                let a = self.canonical(ida);
                self.b.ins().fsub(a, b)
            }
            Op::Fm => {
                let zero = self.positive_zero();
                self.b.ins().fma(a, b, zero)
            }
            _ => {
                let idc = self.get(i.rc);
                self.operand(idc);
                if i.op == Op::Fms {
                    let c = self.negated(idc);
                    self.b.ins().fma(a, b, c)
                } else {
                    let c = self.canonical(idc);
                    let a = if i.op == Op::Fnms { self.b.ins().fneg(a) } else { a };
                    self.b.ins().fma(a, b, c)
                }
            }
        };
        let facts = Facts { plain: true, no_negative_zero: true, raises: true, ..Facts::default() };
        self.set_with(i.rt, result, facts);
    }

    fn positive_zero(&mut self) -> Value {
        let zero = self.splat(0);
        self.cast(F32X4, zero)
    }

    /// A value as singles. Notes it for the check of exponents, unless it is known to pass.
    fn operand(&mut self, id: Id) -> Value {
        let words = self.words(id);
        self.node(id).computed = true;
        if !self.facts(id).plain {
            let shifted = self.b.ins().iadd(words, words);
            self.unverified.magnitudes = Some(match self.unverified.magnitudes {
                Some(largest) => self.b.ins().umax(largest, shifted),
                None => shifted,
            });
            // The host's flags will report denormal lanes.
            self.node(id).facts.plain = true;
        }
        self.cast(F32X4, words)
    }

    /// A value as singles, with +0 in place of -0.
    fn canonical(&mut self, id: Id) -> Value {
        if let Some(canonical) = self.node(id).canonical {
            return canonical;
        }
        let words = self.words(id);
        let single = self.cast(F32X4, words);
        if self.facts(id).no_negative_zero {
            return single;
        }
        let zero = self.positive_zero();
        let canonical = self.b.ins().fadd(single, zero);
        self.node(id).canonical = Some(canonical);
        canonical
    }

    /// A value as negated singles, with +0 for zeros.
    fn negated(&mut self, id: Id) -> Value {
        if let Some(negated) = self.node(id).negated {
            return negated;
        }
        if let Some(words) = self.constant(id) {
            let negated = words.map(|word| if word << 1 == 0 { 0 } else { word ^ SIGN });
            let negated = self.vector(negated);
            return self.cast(F32X4, negated);
        }
        let words = self.words(id);
        let single = self.cast(F32X4, words);
        let zero = self.positive_zero();
        let negated = self.b.ins().fsub(zero, single);
        self.node(id).negated = Some(negated);
        negated
    }
}
