//! The estimates and their interpolation, computed in integers.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{self, I32X4};
use cranelift_codegen::ir::{InstBuilder, MemFlagsData, Value};
use spu_isa::Instruction;

use super::Emitter;
use super::float::{EXPONENT, SIGN};
use super::registers::Facts;

const FRACTION: u32 = 0x007f_ffff;
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
        let table = self.b.ins().iconst(types::I64, table.as_ptr() as i64);
        let entries: Vec<_> = self
            .extract(distances)
            .into_iter()
            .map(|distance| {
                let distance = self.b.ins().uextend(types::I64, distance);
                let at = self.b.ins().iadd(table, distance);
                self.b
                    .ins()
                    .load(types::I32, MemFlagsData::trusted(), at, 0)
            })
            .collect();
        self.gather(I32X4, &entries)
    }

    /// The exponents of an estimate: 255 where the operand is zero, else `exponent`. Notes zeros.
    fn exponent_of_estimate(&mut self, operand: Value, exponent: Value) -> Value {
        self.has_floats = true;
        let zero = self.is_zero(operand);
        if self.in_doubles {
            self.unverified.zeros = Some(self.or(self.unverified.zeros, zero));
        } else {
            self.unverified.special = Some(self.or(self.unverified.special, zero));
        }
        let largest = self.splat(EXPONENT);
        self.b.ins().bitselect(zero, largest, exponent)
    }

    pub(super) fn estimate_reciprocal(&mut self, i: Instruction) {
        let x = self.lanes(I32X4, i.ra);
        let exponent = self.and(x, EXPONENT);
        let from = self.splat(253 << 23);
        let exponent = self.b.ins().isub(from, exponent);
        let zero = self.splat(0);
        let exponent = self.b.ins().smax(exponent, zero);
        let exponent = self.exponent_of_estimate(x, exponent);
        let sign = self.and(x, SIGN);
        let entries = self.look_up(x, self.estimates.reciprocal);
        let estimate = self.b.ins().bor(exponent, entries);
        let estimate = self.b.ins().bor(estimate, sign);
        self.set(i.rt, estimate);
    }

    pub(super) fn estimate_reciprocal_root(&mut self, i: Instruction) {
        let x = self.lanes(I32X4, i.ra);
        let exponent = self.right(x, 23);
        let exponent = self.and(exponent, 0xff);
        let from = self.splat(380);
        let exponent = self.b.ins().isub(from, exponent);
        let exponent = self.right(exponent, 1);
        let exponent = self.left(exponent, 23);
        let exponent = self.exponent_of_estimate(x, exponent);
        let entries = self.look_up(x, self.estimates.reciprocal_root);
        let estimate = self.b.ins().bor(exponent, entries);
        self.set(i.rt, estimate);
    }

    pub(super) fn interpolate(&mut self, i: Instruction) {
        self.has_floats = true;
        let (a, estimate) = (self.lanes(I32X4, i.ra), self.lanes(I32X4, i.rb));
        let base = self.right(estimate, 10);
        let base = self.left(base, 19);
        let step = self.and(estimate, 0x3ff);
        let position = self.and(a, 0x7_ffff);
        let part = self.b.ins().imul(step, position);
        let significand = self.b.ins().isub(base, part);
        let below_one = self.b.ins().icmp(IntCC::UnsignedGreaterThan, part, base);
        let exponent = self.and(estimate, EXPONENT);
        let zero = self.splat(0);
        let no_exponent = self.b.ins().icmp(IntCC::Equal, exponent, zero);
        let most = self.splat(EXPONENT);
        let largest = self.b.ins().icmp(IntCC::Equal, exponent, most);
        let kept = self.and(estimate, SIGN | EXPONENT);
        let fraction = self.right(significand, 9);
        let result = self.b.ins().bor(kept, fraction);
        if !self.in_doubles {
            let special = self.b.ins().bor(no_exponent, largest);
            let special = self.b.ins().bor(special, below_one);
            self.unverified.special = Some(self.or(self.unverified.special, special));
            let facts = Facts {
                plain: true,
                no_negative_zero: true,
                ..Facts::default()
            };
            return self.set_with(i.rt, result, facts);
        }
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

        let fraction = self.and(estimate, FRACTION);
        let none = self.b.ins().icmp(IntCC::Equal, fraction, zero);
        let denormal = self.b.ins().band_not(no_exponent, none);
        let different = self.b.ins().bor(denormal, largest);
        let different = self.and(different, DIFFERENT);
        let underflow = self.and(underflow, UNDERFLOW | DIFFERENT);
        let flags = self.b.ins().bor(different, underflow);
        self.raise(flags);
        let facts = Facts {
            no_negative_zero: true,
            ..Facts::default()
        };
        self.set_with(i.rt, result, facts);
    }
}
