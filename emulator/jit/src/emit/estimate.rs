//! The estimates and their interpolation, computed in integers.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{self, I32X4};
use cranelift_codegen::ir::{InstBuilder, MemFlagsData, Value};
use spu_isa::Instruction;

use super::Emitter;
use super::float::{EXPONENT, SIGN};
use super::registers::Facts;

const FRACTION: u32 = 0x007f_ffff;
/// An estimate's base, shifted to the highest bits.
const BASE: u32 = 0xfff8_0000;
/// FPSCR flag: the result was below the smallest number.
const UNDERFLOW: u32 = 2;
/// FPSCR flag: IEEE arithmetic would have given a different result.
const DIFFERENT: u32 = 1;

impl Emitter<'_> {
    /// Looks up each lane in a table. The lane's bits from 2^18 up are the index.
    fn look_up(&mut self, words: Value, table: &'static [u32]) -> Value {
        const ENTRY_LOG2: u32 = 2;
        let distances = self.right(words, 18 - ENTRY_LOG2);
        let distances = self.and(distances, (table.len() as u32 - 1) << ENTRY_LOG2);
        let distances = self.cast(types::I64X2, distances);
        let table = self.b.ins().iconst(types::I64, table.as_ptr() as i64);
        // Two lanes at a time leave the vector, and each entry is loaded where it is inserted:
        // that takes the fewest of the host's instructions.
        let [low, high] = [0, 1].map(|half| {
            let pair = self.b.ins().extractlane(distances, half);
            let first = self.b.ins().ireduce(types::I8, pair);
            let first = self.b.ins().uextend(types::I64, first);
            let second = self.b.ins().ushr_imm_u(pair, 32);
            let flags = MemFlagsData::trusted().with_readonly();
            let at = self.b.ins().iadd(table, first);
            let entry = self.b.ins().load(types::I32, flags, at, 0);
            let entries = self.b.ins().scalar_to_vector(I32X4, entry);
            let at = self.b.ins().iadd(table, second);
            let entry = self.b.ins().load(types::I32, flags, at, 0);
            self.b.ins().insertlane(entries, entry, 1)
        });
        let entries =
            self.shuffle(low, high, [0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23]);
        self.cast(I32X4, entries)
    }

    /// Sets an estimate. It is `plain` in singles, where the unit fails if it is not.
    fn set_estimate(&mut self, register: u8, exponent: Value, entries: Value, plain: bool) {
        let estimate = self.b.ins().bor(exponent, entries);
        let facts = Facts { plain, estimate: true, ..Facts::default() };
        self.set_with(register, estimate, facts);
    }

    pub(super) fn estimate_reciprocal(&mut self, i: Instruction) {
        self.has_fallback = true;
        let x = self.lanes(I32X4, i.ra);
        let entries = self.look_up(x, self.estimates.reciprocal);
        let field = self.and(x, EXPONENT);
        let sign = self.and(x, SIGN);
        let from = self.splat(253 << 23);
        let exponent = self.b.ins().isub(from, field);
        if !self.in_doubles {
            // The difference is 253 where the operand's exponent is 0, and less than 1 where the
            // estimate's would be.
            let one = self.splat(1 << 23);
            let lower = self.b.ins().isub(exponent, one);
            let limit = self.splat(252 << 23);
            let special = self.b.ins().icmp(IntCC::UnsignedGreaterThanOrEqual, lower, limit);
            self.fail_on(special);
            let exponent = self.b.ins().bor(exponent, sign);
            return self.set_estimate(i.rt, exponent, entries, true);
        }
        let zero = self.splat(0);
        let exponent = self.b.ins().smax(exponent, zero);
        let exponent = self.or_largest_for_zeros(x, exponent);
        let exponent = self.b.ins().bor(exponent, sign);
        self.set_estimate(i.rt, exponent, entries, false);
    }

    pub(super) fn estimate_reciprocal_root(&mut self, i: Instruction) {
        self.has_fallback = true;
        let x = self.lanes(I32X4, i.ra);
        let entries = self.look_up(x, self.estimates.reciprocal_root);
        // Half the operand's exponent, rounded up, from 190.
        let field = self.and(x, EXPONENT);
        let one = self.splat(1 << 23);
        let rounded = self.b.ins().iadd(field, one);
        let half = self.right(rounded, 1);
        let half = self.and(half, EXPONENT);
        let from = self.splat(190 << 23);
        let exponent = self.b.ins().isub(from, half);
        if !self.in_doubles {
            let zero = self.splat(0);
            let special = self.b.ins().icmp(IntCC::Equal, field, zero);
            self.fail_on(special);
            return self.set_estimate(i.rt, exponent, entries, true);
        }
        let exponent = self.or_largest_for_zeros(x, exponent);
        self.set_estimate(i.rt, exponent, entries, false);
    }

    /// In doubles: the exponents of an estimate, which are 255 where the operand is zero. Notes
    /// these zeros.
    fn or_largest_for_zeros(&mut self, operand: Value, exponent: Value) -> Value {
        let zero = self.is_zero(operand);
        self.unverified.zeros = Some(self.or(self.unverified.zeros, zero));
        let largest = self.splat(EXPONENT);
        self.b.ins().bitselect(zero, largest, exponent)
    }

    /// `fi`. An estimate's base is at least its step, so it gives no significand below one.
    pub(super) fn interpolate(&mut self, i: Instruction) {
        self.has_fallback = true;
        let id = self.get(i.rb);
        let facts = self.facts(id);
        let (a, estimate) = (self.lanes(I32X4, i.ra), self.words(id));
        let base = self.left(estimate, 9);
        let base = self.and(base, BASE);
        let step = self.and(estimate, 0x3ff);
        let position = self.and(a, 0x7_ffff);
        let part = self.b.ins().imul(step, position);
        let significand = self.b.ins().isub(base, part);
        let kept = self.and(estimate, SIGN | EXPONENT);
        let fraction = self.right(significand, 9);
        let result = self.b.ins().bor(kept, fraction);
        let below_one =
            (!facts.estimate).then(|| self.b.ins().icmp(IntCC::UnsignedGreaterThan, part, base));
        if facts.estimate && facts.plain {
            return self.set_interpolated(i.rt, result, true);
        }
        let exponent = self.and(estimate, EXPONENT);
        let zero = self.splat(0);
        let no_exponent = self.b.ins().icmp(IntCC::Equal, exponent, zero);
        let most = self.splat(EXPONENT);
        let largest = self.b.ins().icmp(IntCC::Equal, exponent, most);
        if !self.in_doubles {
            let mut special = self.b.ins().bor(no_exponent, largest);
            special = self.or(below_one, special);
            self.fail_on(special);
            return self.set_interpolated(i.rt, result, true);
        }
        let fraction = self.and(estimate, FRACTION);
        let none = self.b.ins().icmp(IntCC::Equal, fraction, zero);
        let denormal = self.b.ins().band_not(no_exponent, none);
        let different = self.b.ins().bor(denormal, largest);
        let mut flags = self.and(different, DIFFERENT);
        let Some(below_one) = below_one else {
            self.raise(flags);
            let result = self.b.ins().band_not(result, no_exponent);
            return self.set_interpolated(i.rt, result, false);
        };
        // A significand below one is shifted left by one bit, and its exponent decreases by one,
        // if it can.
        let fraction = self.right(significand, 8);
        let fraction = self.and(fraction, FRACTION);
        let one = self.splat(1 << 23);
        let lower = self.b.ins().isub(kept, one);
        let shifted = self.b.ins().bor(lower, fraction);
        let result = self.b.ins().bitselect(below_one, shifted, result);
        let single = self.b.ins().icmp(IntCC::Equal, exponent, one);
        let underflow = self.b.ins().band(single, below_one);
        let flushed = self.b.ins().bor(no_exponent, underflow);
        let result = self.b.ins().band_not(result, flushed);
        let underflow = self.and(underflow, UNDERFLOW | DIFFERENT);
        flags = self.b.ins().bor(flags, underflow);
        self.raise(flags);
        self.set_interpolated(i.rt, result, false);
    }

    fn set_interpolated(&mut self, register: u8, result: Value, plain: bool) {
        let facts = Facts { plain, no_negative_zero: true, ..Facts::default() };
        self.set_with(register, result, facts);
    }
}
