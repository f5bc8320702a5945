//! Single precision: the code for both singles and doubles of the host.

use cranelift_codegen::ir::condcodes::{FloatCC, IntCC};
use cranelift_codegen::ir::types::{F32X4, F64X2, I32X4};
use cranelift_codegen::ir::{InstBuilder, Value};
use spu_isa::Instruction;

use super::Emitter;
use super::registers::{Facts, Id};

pub(super) const SIGN: u32 = 0x8000_0000;
pub(super) const MAGNITUDE: u32 = 0x7fff_ffff;
pub(super) const EXPONENT: u32 = 0x7f80_0000;

#[derive(Clone, Copy)]
pub(super) enum Compare {
    Equal,
    Greater,
}

impl Emitter<'_> {
    /// `fa`, `fs`, `fm`, `fma`, `fms`, `fnms`.
    pub(super) fn arithmetic(&mut self, i: Instruction) {
        self.has_fallback = true;
        if self.in_doubles {
            self.arithmetic_in_doubles(i);
        } else {
            self.arithmetic_in_singles(i);
        }
    }

    /// A mask of lanes whose exponent field is 0.
    pub(super) fn is_zero(&mut self, words: Value) -> Value {
        let exponent = self.and(words, EXPONENT);
        let zero = self.splat(0);
        self.b.ins().icmp(IntCC::Equal, exponent, zero)
    }

    /// Integers that have the same order as the singles. All zeros become 0.
    fn order(&mut self, id: Id) -> Value {
        if let Some(order) = self.node(id).order {
            return order;
        }
        let words = self.words(id);
        let magnitude = self.and(words, MAGNITUDE);
        let sign = self.right_signed(words, 31);
        let flipped = self.b.ins().bxor(magnitude, sign);
        let mut order = self.b.ins().isub(flipped, sign);
        if !self.facts(id).plain {
            let zero = self.is_zero(words);
            let other = self.b.ins().bnot(zero);
            order = self.b.ins().band(order, other);
        }
        if !self.in_side_exit {
            self.node(id).order = Some(order);
        }
        order
    }

    fn magnitude_order(&mut self, id: Id) -> Value {
        let words = self.words(id);
        let magnitude = self.and(words, MAGNITUDE);
        if self.facts(id).plain {
            return magnitude;
        }
        let zero = self.is_zero(words);
        let other = self.b.ins().bnot(zero);
        self.b.ins().band(magnitude, other)
    }

    /// `fceq` and `fcgt`, or with `magnitude` `fcmeq` and `fcmgt`.
    pub(super) fn compare_singles(&mut self, i: Instruction, compare: Compare, magnitude: bool) {
        let (a, b) = (self.get(i.ra), self.get(i.rb));
        let facts = Facts { mask: true, ..Facts::default() };
        let in_doubles = |e: &mut Self, id: Id| {
            e.node(id).doubles.is_some() || e.in_doubles && e.constant(id).is_some()
        };
        let result = if in_doubles(self, a) && in_doubles(self, b) {
            let (a, b) = (self.doubles(a), self.doubles(b));
            let compared = [0, 1].map(|n| {
                let [a, b] = [a[n], b[n]].map(|x| self.magnitude_if(magnitude, x));
                self.b.ins().fcmp(compare.of_floats(), a, b)
            });
            self.narrow_mask(compared)
        } else if !self.in_doubles && self.facts(a).plain && self.facts(b).plain {
            let [a, b] = [a, b].map(|id| {
                let mut words = self.words(id);
                if magnitude {
                    words = self.and(words, MAGNITUDE);
                }
                self.cast(F32X4, words)
            });
            self.b.ins().fcmp(compare.of_floats(), a, b)
        } else {
            let [a, b] = [a, b].map(|id| match magnitude {
                true => self.magnitude_order(id),
                false => self.order(id),
            });
            let compare = match compare {
                Compare::Equal => IntCC::Equal,
                Compare::Greater => IntCC::SignedGreaterThan,
            };
            self.b.ins().icmp(compare, a, b)
        };
        let result = self.cast(I32X4, result);
        self.set_with(i.rt, result, facts);
    }

    fn magnitude_if(&mut self, magnitude: bool, double: Value) -> Value {
        if magnitude {
            let double = self.cast(F64X2, double);
            self.b.ins().fabs(double)
        } else {
            double
        }
    }
}

impl Compare {
    fn of_floats(self) -> FloatCC {
        match self {
            Self::Equal => FloatCC::Equal,
            Self::Greater => FloatCC::GreaterThan,
        }
    }
}
