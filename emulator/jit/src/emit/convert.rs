//! Conversions between 32-bit integers and singles, scaled by a power of two.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{F32X4, I32X4};
use cranelift_codegen::ir::{InstBuilder, Value};
use spu_isa::Instruction;

use super::Emitter;
use super::float::MAGNITUDE;
use super::registers::Facts;

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Sign {
    Signed,
    Unsigned,
}

/// The single 2^exponent.
const fn power_of_two(exponent: i32) -> u32 {
    ((127 + exponent) as u32) << 23
}

/// The bits of the smallest single `x` with `x` * 2^`scale` >= 2^`bits`. `None` if an SPU's single
/// can't be that large. As a signed number the result may exceed all magnitudes. The exponent is
/// at least 1, because all singles with exponent 0 are zero.
fn threshold(bits: i32, scale: i32) -> Option<u32> {
    let exponent = (127 + bits - scale).max(1);
    (exponent <= 255).then_some((exponent as u32) << 23)
}

impl Emitter<'_> {
    /// `csflt` and `cuflt`, at scales without special results.
    pub(super) fn single_of_integer(&mut self, i: Instruction, sign: Sign) {
        let x = self.lanes(I32X4, i.ra);
        let converted = match sign {
            // The host truncates.
            Sign::Signed => self.b.ins().fcvt_from_sint(F32X4, x),
            Sign::Unsigned => {
                let (high, low) = (self.right(x, 16), self.and(x, 0xffff));
                let high = self.b.ins().fcvt_from_sint(F32X4, high);
                let low = self.b.ins().fcvt_from_sint(F32X4, low);
                let scale = self.power(16);
                self.b.ins().fma(high, scale, low)
            }
        };
        let scale = self.power(-i.immediate);
        let scaled = self.b.ins().fmul(converted, scale);
        let facts = Facts { plain: true, no_negative_zero: true, ..Facts::default() };
        self.set_with(i.rt, scaled, facts);
    }

    fn power(&mut self, exponent: i32) -> Value {
        let power = self.splat(power_of_two(exponent));
        self.cast(F32X4, power)
    }

    /// A mask of lanes where `magnitude` * 2^`scale` is at least 2^`bits`. `None` if no single is.
    fn reaches(&mut self, magnitude: Value, bits: i32, scale: i32) -> Option<Value> {
        let limit = self.splat(threshold(bits, scale)?);
        Some(self.b.ins().icmp(IntCC::SignedGreaterThanOrEqual, magnitude, limit))
    }

    /// `cflts` and `cfltu`. The host converts only numbers that fit, so it raises no exceptions.
    pub(super) fn integer_of_single(&mut self, i: Instruction, sign: Sign) {
        let x = self.lanes(I32X4, i.ra);
        let scale = i.immediate;
        let magnitude = self.and(x, MAGNITUDE);
        let negative = self.right_signed(x, 31);
        let zero = self.splat(0);
        let one = self.reaches(magnitude, 0, scale).unwrap_or(zero);
        let large = self.reaches(magnitude, 31, scale).unwrap_or(zero);
        // The scale is added to the exponent.
        let distance = self.splat((scale as u32) << 23);
        let scaled = self.b.ins().iadd(x, distance);
        let fits = self.b.ins().band_not(one, large);
        let scaled = self.b.ins().band(scaled, fits);
        let scaled = self.cast(F32X4, scaled);
        let integer = self.b.ins().x86_cvtt2dq(I32X4, scaled);
        let result = match sign {
            Sign::Signed => {
                let most = self.splat(MAGNITUDE);
                let saturated = self.b.ins().bxor(most, negative);
                self.b.ins().bitselect(large, saturated, integer)
            }
            Sign::Unsigned => {
                // From 2^31 on, all bits of the fraction belong to the integer.
                let fraction = self.left(x, 8);
                let top = self.splat(1 << 31);
                let upper = self.b.ins().bor(fraction, top);
                let beyond = self.reaches(magnitude, 32, scale).unwrap_or(zero);
                let upper = self.b.ins().bor(upper, beyond);
                let result = self.b.ins().bitselect(large, upper, integer);
                self.b.ins().band_not(result, negative)
            }
        };
        self.set(i.rt, result);
    }
}
