//! Integer arithmetic, multiplication, counting, logic, selection, compares.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{self, I8X16, I16X8, I32X4};
use cranelift_codegen::ir::{InstBuilder, Type, Value};
use spu_isa::Instruction;

use super::Emitter;
use super::registers::{Facts, Node};
use crate::trace::{bytes, halfwords};

/// A half of each word.
#[derive(Clone, Copy)]
pub(super) enum Half {
    Low,
    High,
    SignedLow,
    SignedHigh,
}

#[derive(Clone, Copy)]
pub(super) enum Logic {
    And,
    Or,
    Xor,
    Nand,
    Nor,
    Eqv,
    Andc,
    Orc,
}

impl Logic {
    const fn of(self, a: u32, b: u32) -> u32 {
        match self {
            Self::And => a & b,
            Self::Or => a | b,
            Self::Xor => a ^ b,
            Self::Nand => !(a & b),
            Self::Nor => !(a | b),
            Self::Eqv => !(a ^ b),
            Self::Andc => a & !b,
            Self::Orc => a | !b,
        }
    }
}

impl Emitter<'_> {
    fn operands(&mut self, ty: Type, i: Instruction) -> (Value, Value) {
        (self.lanes(ty, i.ra), self.lanes(ty, i.rb))
    }

    /// The immediate in every lane.
    fn immediate(&mut self, ty: Type, i: Instruction) -> Value {
        let words = match ty {
            I8X16 => bytes(i),
            I16X8 => halfwords(i),
            _ => i.immediate as u32,
        };
        let vector = self.splat(words);
        self.cast(ty, vector)
    }

    pub(super) fn add(&mut self, i: Instruction, ty: Type) {
        let (a, b) = self.operands(ty, i);
        let sum = self.b.ins().iadd(a, b);
        self.set(i.rt, sum);
    }

    pub(super) fn add_constant(&mut self, i: Instruction) {
        let id = self.get(i.ra);
        let distance = i.immediate as u32;
        if let Some(words) = self.constant(id) {
            return self.set_constant(i.rt, words.map(|word| word.wrapping_add(distance)));
        }
        let (root, before) = self.node(id).root.unwrap_or((id, 0));
        let words = self.words(id);
        let constant = self.splat(distance);
        let words = self.b.ins().iadd(words, constant);
        self.put_node(
            i.rt,
            Node {
                words: Some(words),
                root: Some((root, before.wrapping_add(distance))),
                ..Node::default()
            },
        );
    }

    pub(super) fn add_halfword_constant(&mut self, i: Instruction) {
        let a = self.lanes(I16X8, i.ra);
        let b = self.immediate(I16X8, i);
        let sum = self.b.ins().iadd(a, b);
        self.set(i.rt, sum);
    }

    pub(super) fn subtract(&mut self, i: Instruction, ty: Type) {
        let (a, b) = self.operands(ty, i);
        let difference = self.b.ins().isub(b, a);
        self.set(i.rt, difference);
    }

    pub(super) fn subtract_from_constant(&mut self, i: Instruction, ty: Type) {
        let a = self.lanes(ty, i.ra);
        let b = self.immediate(ty, i);
        let difference = self.b.ins().isub(b, a);
        self.set(i.rt, difference);
    }

    /// The lowest bit of each word of rt.
    fn carry_in(&mut self, i: Instruction) -> Value {
        let t = self.lanes(I32X4, i.rt);
        self.and(t, 1)
    }

    /// ra, or its complement.
    fn minuend(&mut self, i: Instruction, complement: bool) -> Value {
        let a = self.lanes(I32X4, i.ra);
        if complement { self.b.ins().bnot(a) } else { a }
    }

    pub(super) fn add_extended(&mut self, i: Instruction, complement: bool) {
        let a = self.minuend(i, complement);
        let b = self.lanes(I32X4, i.rb);
        let carry = self.carry_in(i);
        let sum = self.b.ins().iadd(a, b);
        let sum = self.b.ins().iadd(sum, carry);
        self.set(i.rt, sum);
    }

    /// The carries out of ra + rb. With `complement`, ra is complemented, and the carry in is 1
    /// unless `extended` takes it from rt: then the carries out are those of rb - ra.
    pub(super) fn carry(&mut self, i: Instruction, complement: bool, extended: bool) {
        let a = self.minuend(i, complement);
        let b = self.lanes(I32X4, i.rb);
        let sum = self.b.ins().iadd(a, b);
        let mut out = self.b.ins().icmp(IntCC::UnsignedLessThan, sum, a);
        let carry = match (extended, complement) {
            (true, _) => Some(self.carry_in(i)),
            (false, true) => Some(self.splat(1)),
            (false, false) => None,
        };
        if let Some(carry) = carry {
            let more = self.b.ins().iadd(sum, carry);
            let again = self.b.ins().icmp(IntCC::UnsignedLessThan, more, sum);
            out = self.b.ins().bor(out, again);
        }
        let out = self.and(out, 1);
        self.set(i.rt, out);
    }

    fn half(&mut self, register: u8, half: Half) -> Value {
        let words = self.lanes(I32X4, register);
        match half {
            Half::Low => self.and(words, 0xffff),
            Half::High => self.right(words, 16),
            Half::SignedLow => {
                let high = self.left(words, 16);
                self.right_signed(high, 16)
            }
            Half::SignedHigh => self.right_signed(words, 16),
        }
    }

    fn product(&mut self, i: Instruction, half: Half) -> Value {
        let (a, b) = (self.half(i.ra, half), self.half(i.rb, half));
        self.b.ins().imul(a, b)
    }

    pub(super) fn multiply(&mut self, i: Instruction, half: Half) {
        let product = self.product(i, half);
        self.set(i.rt, product);
    }

    pub(super) fn multiply_constant(&mut self, i: Instruction, half: Half) {
        let a = self.half(i.ra, half);
        let constant = match half {
            Half::Low => i.immediate as u32 & 0xffff,
            _ => i.immediate as u32,
        };
        let b = self.splat(constant);
        let product = self.b.ins().imul(a, b);
        self.set(i.rt, product);
    }

    pub(super) fn multiply_add(&mut self, i: Instruction, half: Half, addend: u8) {
        let product = self.product(i, half);
        let addend = self.lanes(I32X4, addend);
        let sum = self.b.ins().iadd(product, addend);
        self.set(i.rt, sum);
    }

    pub(super) fn multiply_high(&mut self, i: Instruction) {
        let a = self.half(i.ra, Half::High);
        let b = self.half(i.rb, Half::Low);
        let product = self.b.ins().imul(a, b);
        let product = self.left(product, 16);
        self.set(i.rt, product);
    }

    pub(super) fn multiply_shifted(&mut self, i: Instruction) {
        let product = self.product(i, Half::SignedLow);
        let product = self.right_signed(product, 16);
        self.set(i.rt, product);
    }

    pub(super) fn leading_zeros(&mut self, i: Instruction) {
        let a = self.lanes(I32X4, i.ra);
        let lanes: Vec<_> = self.extract(a);
        let counts: Vec<_> = lanes.into_iter().map(|lane| self.b.ins().clz(lane)).collect();
        let counts = self.gather(I32X4, &counts);
        self.set(i.rt, counts);
    }

    pub(super) fn count_ones_in_bytes(&mut self, i: Instruction) {
        let a = self.lanes(I8X16, i.ra);
        let counts = self.b.ins().popcnt(a);
        self.set(i.rt, counts);
    }

    pub(super) fn average_bytes(&mut self, i: Instruction) {
        let (a, b) = self.operands(I8X16, i);
        let average = self.b.ins().avg_round(a, b);
        self.set(i.rt, average);
    }

    pub(super) fn difference_of_bytes(&mut self, i: Instruction) {
        let (a, b) = self.operands(I8X16, i);
        let (max, min) = (self.b.ins().umax(a, b), self.b.ins().umin(a, b));
        let difference = self.b.ins().isub(max, min);
        self.set(i.rt, difference);
    }

    /// The sum of each word's bytes.
    fn byte_sums(&mut self, register: u8) -> Value {
        let words = self.lanes(I32X4, register);
        let odd = self.and(words, 0x00ff_00ff);
        let even = self.right(words, 8);
        let even = self.and(even, 0x00ff_00ff);
        let pairs = self.b.ins().iadd(odd, even);
        let high = self.right(pairs, 16);
        let low = self.and(pairs, 0xffff);
        self.b.ins().iadd(high, low)
    }

    pub(super) fn sum_bytes(&mut self, i: Instruction) {
        let (a, b) = (self.byte_sums(i.ra), self.byte_sums(i.rb));
        let b = self.left(b, 16);
        let sums = self.b.ins().bor(a, b);
        self.set(i.rt, sums);
    }

    pub(super) fn extend_sign(&mut self, i: Instruction, ty: Type, bits: u32) {
        let a = self.lanes(ty, i.ra);
        let high = self.left(a, bits);
        let extended = self.right_signed(high, bits);
        self.set(i.rt, extended);
    }

    pub(super) fn extend_sign_of_word(&mut self, i: Instruction) {
        let a = self.lanes(I32X4, i.ra);
        let signs = self.right_signed(a, 31);
        let from = [20, 21, 22, 23, 4, 5, 6, 7, 28, 29, 30, 31, 12, 13, 14, 15];
        let extended = self.shuffle(a, signs, from);
        self.set(i.rt, extended);
    }

    pub(super) fn logic(&mut self, i: Instruction, logic: Logic) {
        let (a, b) = (self.get(i.ra), self.get(i.rb));
        if a == b && matches!(logic, Logic::And | Logic::Or) {
            return self.put(i.rt, a);
        }
        if let (Some(a), Some(b)) = (self.constant(a), self.constant(b)) {
            return self.set_constant(i.rt, std::array::from_fn(|n| logic.of(a[n], b[n])));
        }
        let mask = self.facts(a).mask && self.facts(b).mask;
        let (a, b) = (self.words(a), self.words(b));
        let result = match logic {
            Logic::And => self.b.ins().band(a, b),
            Logic::Or => self.b.ins().bor(a, b),
            Logic::Xor => self.b.ins().bxor(a, b),
            Logic::Nand => {
                let and = self.b.ins().band(a, b);
                self.b.ins().bnot(and)
            }
            Logic::Nor => {
                let or = self.b.ins().bor(a, b);
                self.b.ins().bnot(or)
            }
            Logic::Eqv => {
                let xor = self.b.ins().bxor(a, b);
                self.b.ins().bnot(xor)
            }
            Logic::Andc => {
                let not = self.b.ins().bnot(b);
                self.b.ins().band(a, not)
            }
            Logic::Orc => {
                let not = self.b.ins().bnot(b);
                self.b.ins().bor(a, not)
            }
        };
        let facts = Facts { mask, ..Facts::default() };
        self.set_with(i.rt, result, facts);
    }

    pub(super) fn logic_constant(&mut self, i: Instruction, from: u8, logic: Logic, word: u32) {
        let id = self.get(from);
        if let (Logic::Or, 0) = (logic, word) {
            return self.put(i.rt, id);
        }
        if let Some(words) = self.constant(id) {
            return self.set_constant(i.rt, words.map(|a| logic.of(a, word)));
        }
        let (a, b) = (self.words(id), self.splat(word));
        let result = match logic {
            Logic::And => self.b.ins().band(a, b),
            Logic::Or => self.b.ins().bor(a, b),
            _ => self.b.ins().bxor(a, b),
        };
        self.set(i.rt, result);
    }

    pub(super) fn or_across(&mut self, i: Instruction) {
        let a = self.lanes(I32X4, i.ra);
        let swapped = self.shuffle(a, a, [8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7]);
        let swapped = self.cast(I32X4, swapped);
        let pairs = self.b.ins().bor(a, swapped);
        let one = self.b.ins().extractlane(pairs, 0);
        let other = self.b.ins().extractlane(pairs, 1);
        let all = self.b.ins().bor(one, other);
        self.set_scalar(i.rt, all);
    }

    pub(super) fn select(&mut self, i: Instruction) {
        let (a, b, c) = (self.get(i.ra), self.get(i.rb), self.get(i.rc));
        let facts = if self.facts(c).mask {
            let (a, b) = (self.facts(a), self.facts(b));
            Facts {
                plain: a.plain && b.plain,
                no_negative_zero: a.no_negative_zero && b.no_negative_zero,
                mask: a.mask && b.mask,
                estimate: a.estimate && b.estimate,
                flags_noted: (a.flags_noted || a.plain) && (b.flags_noted || b.plain),
                raises: false,
            }
        } else {
            Facts::default()
        };
        let are_all = self.node(a).is_of_doubles && self.node(b).is_of_doubles;
        if let (Some(one), Some(other), true) =
            (self.node(a).doubles, self.node(b).doubles, self.facts(c).mask && are_all)
        {
            return self.select_doubles(i, [one, other], c, facts);
        }
        let (a, b, c) = (self.words(a), self.words(b), self.words(c));
        let selected = self.b.ins().bitselect(c, b, a);
        self.set_with(i.rt, selected, facts);
    }

    pub(super) fn compare(&mut self, i: Instruction, ty: Type, compare: IntCC) {
        let (a, b) = self.operands(ty, i);
        self.compared(i.rt, ty, compare, a, b);
    }

    pub(super) fn compare_constant(&mut self, i: Instruction, ty: Type, compare: IntCC) {
        let a = self.lanes(ty, i.ra);
        let b = self.immediate(ty, i);
        self.compared(i.rt, ty, compare, a, b);
    }

    fn compared(&mut self, rt: u8, ty: Type, compare: IntCC, a: Value, b: Value) {
        let result = self.b.ins().icmp(compare, a, b);
        let facts = Facts { mask: ty == I32X4, ..Facts::default() };
        self.set_with(rt, result, facts);
    }

    /// The preferred word of a register, or its low halfword, in every lane.
    pub(super) fn splat_scalar(&mut self, ty: Type, register: u8) -> Value {
        let scalar = self.scalar(register);
        let lane = match ty {
            I16X8 => self.b.ins().ireduce(types::I16, scalar),
            _ => scalar,
        };
        self.b.ins().splat(ty, lane)
    }
}
