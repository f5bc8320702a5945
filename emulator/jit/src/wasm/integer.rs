//! Integer arithmetic, logic, compares, masks and gathers.

use spu_isa::Instruction;
use wasm_encoder::InstructionSink;

use super::emitter::{ADDRESS, Emitter, Facts, splat};

/// An operation on the top of the stack.
pub(super) type Operation =
    for<'a, 'b> fn(&'b mut InstructionSink<'a>) -> &'b mut InstructionSink<'a>;

/// What is known of the result of a compare.
pub(super) const MASK: Facts = Facts { no_denormals: false, mask: true };

/// The half of a word that a multiplication uses.
#[derive(Clone, Copy)]
pub(super) enum Half {
    SignedLow,
    Low,
    SignedHigh,
    High,
}

impl Emitter<'_> {
    pub(super) fn unary(&mut self, i: Instruction, operation: Operation) {
        self.push(i.ra);
        operation(&mut self.f());
        self.set(i.rt);
    }

    pub(super) fn binary(&mut self, i: Instruction, operation: Operation) {
        self.push(i.ra);
        self.push(i.rb);
        operation(&mut self.f());
        self.set(i.rt);
    }

    /// rt = rb operation ra.
    pub(super) fn reversed(&mut self, i: Instruction, operation: Operation) {
        self.push(i.rb);
        self.push(i.ra);
        operation(&mut self.f());
        self.set(i.rt);
    }

    /// rt = ra operation word.
    pub(super) fn with_constant(&mut self, i: Instruction, word: u32, operation: Operation) {
        self.push(i.ra);
        operation(self.f().v128_const(splat(word)));
        self.set(i.rt);
    }

    /// rt = word - ra.
    pub(super) fn subtract_from(&mut self, i: Instruction, word: u32, operation: Operation) {
        self.f().v128_const(splat(word));
        self.push(i.ra);
        operation(&mut self.f());
        self.set(i.rt);
    }

    /// `ori` with 0 copies a register.
    pub(super) fn or_constant(&mut self, i: Instruction, register: u8, word: u32) {
        let facts = if word == 0 { self.facts(register) } else { Facts::default() };
        match self.constant(register) {
            Some(words) => self.set_constant(i.rt, words.map(|old| old | word)),
            None => {
                self.push(register);
                if word != 0 {
                    self.f().v128_const(splat(word)).v128_or();
                }
                self.set_with(i.rt, facts);
            }
        }
    }

    pub(super) fn compare(&mut self, i: Instruction, operation: Operation) {
        self.binary(i, operation);
        self.set_facts(i.rt, MASK);
    }

    pub(super) fn compare_constant(&mut self, i: Instruction, word: u32, operation: Operation) {
        self.with_constant(i, word, operation);
        self.set_facts(i.rt, MASK);
    }

    /// rt = ra + rb + (rt & 1), or rb - ra with the borrow in rt.
    pub(super) fn extended(&mut self, i: Instruction, subtract: bool) {
        self.push_terms(i, subtract);
        self.f().i32x4_add();
        self.push(i.rt);
        self.f().v128_const(splat(1)).v128_and().i32x4_add();
        self.set(i.rt);
    }

    fn push_terms(&mut self, i: Instruction, subtract: bool) {
        self.push(i.ra);
        if subtract {
            self.f().v128_not();
        }
        self.push(i.rb);
    }

    /// The carry out of ra + rb, or of rb - ra.
    pub(super) fn carry(&mut self, i: Instruction, subtract: bool) {
        if subtract {
            self.push(i.rb);
            self.push(i.ra);
            self.f().i32x4_ge_u();
        } else {
            self.push(i.ra);
            self.push(i.rb);
            self.f().i32x4_add();
            self.push(i.ra);
            self.f().i32x4_lt_u();
        }
        self.f().v128_const(splat(1)).v128_and();
        self.set(i.rt);
    }

    /// The carry out of the sum of [`extended`](Self::extended).
    pub(super) fn extended_carry(&mut self, i: Instruction, subtract: bool) {
        let [a, sum] = [0, 1].map(|number| self.temporary(number));
        self.push(i.rt);
        self.f().v128_const(splat(1)).v128_and();
        self.push_terms(i, subtract);
        let mut f = self.f();
        // The sum of the terms, below one of them if it has a carry.
        f.local_set(sum).local_tee(a).local_get(sum).i32x4_add().local_tee(sum);
        f.i32x4_add().local_get(sum).i32x4_lt_u();
        f.local_get(sum).local_get(a).i32x4_lt_u();
        f.v128_or().v128_const(splat(1)).v128_and();
        self.set(i.rt);
    }

    pub(super) fn push_half(&mut self, register: u8, half: Half) {
        self.push(register);
        let mut f = self.f();
        match half {
            Half::SignedLow => f.i32_const(16).i32x4_shl().i32_const(16).i32x4_shr_s(),
            Half::Low => f.v128_const(splat(0xffff)).v128_and(),
            Half::SignedHigh => f.i32_const(16).i32x4_shr_s(),
            Half::High => f.i32_const(16).i32x4_shr_u(),
        };
    }

    pub(super) fn push_product(&mut self, i: Instruction, half: Half) {
        self.push_half(i.ra, half);
        self.push_half(i.rb, half);
        self.f().i32x4_mul();
    }

    pub(super) fn multiply(&mut self, i: Instruction, half: Half) {
        self.push_product(i, half);
        self.set(i.rt);
    }

    pub(super) fn multiply_constant(&mut self, i: Instruction, half: Half, word: u32) {
        self.push_half(i.ra, half);
        self.f().v128_const(splat(word)).i32x4_mul();
        self.set(i.rt);
    }

    pub(super) fn multiply_add(&mut self, i: Instruction, half: Half, addend: u8) {
        self.push_product(i, half);
        self.push(addend);
        self.f().i32x4_add();
        self.set(i.rt);
    }

    /// rt = c ? rb : ra, bit by bit.
    pub(super) fn select(&mut self, i: Instruction) {
        let [a, b, c] = [i.ra, i.rb, i.rc].map(|register| self.facts(register));
        let no_denormals = c.mask && a.no_denormals && b.no_denormals;
        self.push(i.rb);
        self.push(i.ra);
        self.push(i.rc);
        self.f().v128_bitselect();
        self.set_with(i.rt, Facts { no_denormals, mask: a.mask && b.mask && c.mask });
    }

    /// `and`, `or`, `xor` and their like, which make masks of masks.
    pub(super) fn logic(&mut self, i: Instruction, operation: Operation) {
        let mask = self.facts(i.ra).mask && self.facts(i.rb).mask;
        self.binary(i, operation);
        self.set_facts(i.rt, Facts { mask, ..Facts::default() });
    }

    /// Selects bytes of ra and rb. Controls are numbers of bytes from the left, from 0x80 on 0,
    /// from 0xc0 on 0xff, and from 0xe0 on 0x80. Byte `n` from the left is at `n ^ 3`.
    pub(super) fn shuffle(&mut self, i: Instruction) {
        let bytes = |byte: u8| i128::from_le_bytes([byte; 16]);
        let [from, twice] = [0, 1].map(|number| self.temporary(number));
        self.push(i.ra);
        self.push(i.rc);
        let mut f = self.f();
        f.v128_const(bytes(0x9f)).v128_and().v128_const(bytes(3)).v128_xor().local_tee(from);
        f.i8x16_swizzle();
        self.push(i.rb);
        self.f().local_get(from).v128_const(bytes(0x10)).v128_xor().i8x16_swizzle().v128_or();
        self.push(i.rc);
        self.push(i.rc);
        self.push(i.rc);
        let mut f = self.f();
        f.i8x16_add().local_tee(twice).v128_and().v128_const(0).i8x16_lt_s();
        f.local_get(twice).local_get(twice).i8x16_add().v128_const(0).i8x16_lt_s();
        f.v128_const(bytes(0x7f)).v128_and().v128_andnot().v128_or();
        self.set(i.rt);
    }

    pub(super) fn extend_words(&mut self, i: Instruction) {
        let words = self.temporary(0);
        self.push(i.ra);
        let mut f = self.f();
        f.local_tee(words).i32_const(31).i32x4_shr_s().local_get(words);
        f.i8x16_shuffle([4, 5, 6, 7, 20, 21, 22, 23, 12, 13, 14, 15, 28, 29, 30, 31]);
        self.set(i.rt);
    }

    /// Spreads the lowest bits of the preferred word over lanes. Each lane of `bits` has the one
    /// that it tests, in a byte that `from` selects.
    pub(super) fn spread(&mut self, i: Instruction, from: i128, bits: i128, equal: Operation) {
        self.push(i.ra);
        let mut f = self.f();
        f.v128_const(from).i8x16_swizzle().v128_const(bits).v128_and().v128_const(bits);
        equal(&mut f);
        self.set_with(i.rt, MASK);
    }

    /// Sets the preferred word to the lowest bits of lanes, which `from` brings into the order of
    /// bits.
    pub(super) fn gather(&mut self, i: Instruction, from: i128, bits: i128, bitmask: Operation) {
        self.push(i.ra);
        let mut f = self.f();
        f.v128_const(bits).v128_and().v128_const(from).i8x16_swizzle();
        bitmask(&mut f).local_set(ADDRESS);
        self.set_scalar(i);
    }

    /// Sets the preferred word to the address, and the others to 0.
    fn set_scalar(&mut self, i: Instruction) {
        self.f().v128_const(0).local_get(ADDRESS).i32x4_replace_lane(0);
        self.set(i.rt);
    }

    pub(super) fn or_across(&mut self, i: Instruction) {
        for lane in 0..4 {
            self.push(i.ra);
            self.f().i32x4_extract_lane(lane);
        }
        self.f().i32_or().i32_or().i32_or().local_set(ADDRESS);
        self.set_scalar(i);
    }
}
