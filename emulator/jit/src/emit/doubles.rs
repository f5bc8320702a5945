//! Arithmetic in the host's doubles, which represent all of an SPU's numbers as ordinary numbers.
//!
//! The product of two singles is exact in a double. A sum is truncated to 53 bits, and truncating
//! it again to 24 bits gives the same as truncating the exact value once. The emitted code
//! saturates and flushes results itself.

use cranelift_codegen::ir::condcodes::{FloatCC, IntCC};
use cranelift_codegen::ir::types::{F64X2, I32X4, I64X2};
use cranelift_codegen::ir::{InstBuilder, Value};
use spu_isa::{Instruction, Op};

use super::Emitter;
use super::float::{EXPONENT, MAGNITUDE, SIGN};
use super::registers::{Facts, Id, Node};

/// The difference of the exponent biases, at the position of the exponent in a double's upper
/// word.
const REBIAS: u32 = (1023 - 127) << 20;
/// The number of bits by which exponent and fraction are further right in a double's upper word
/// than in a single.
const SHIFT: u32 = 3;
/// The bits of a double that a single has too.
const KEPT: u64 = !((1 << (32 - SHIFT)) - 1);
/// 2^-126.
const SMALLEST: u64 = (1023 - 126) << 52;
/// (2 - 2^-23) * 2^128.
const LARGEST: u64 = (1023 + 128) << 52 | 0xf_ffff_e000_0000;
const DOUBLE_SIGN: u64 = 1 << 63;

/// A shuffle that selects the even words of two vectors, counted through both from 0 to 7.
const EVEN_WORDS: [u8; 16] = [0, 1, 2, 3, 8, 9, 10, 11, 16, 17, 18, 19, 24, 25, 26, 27];
const ODD_WORDS: [u8; 16] = [4, 5, 6, 7, 12, 13, 14, 15, 20, 21, 22, 23, 28, 29, 30, 31];
const INTERLEAVED_LOW: [u8; 16] = [0, 1, 2, 3, 16, 17, 18, 19, 4, 5, 6, 7, 20, 21, 22, 23];
const INTERLEAVED_HIGH: [u8; 16] = [8, 9, 10, 11, 24, 25, 26, 27, 12, 13, 14, 15, 28, 29, 30, 31];

/// The value of a single, exactly.
fn widened(x: u32) -> u64 {
    if x & EXPONENT == 0 {
        return 0;
    }
    let upper = ((x as i32 >> SHIFT) as u32 & (SIGN | MAGNITUDE >> SHIFT)) + REBIAS;
    u64::from(upper) << 32 | u64::from(x << (32 - SHIFT))
}

impl Emitter<'_> {
    pub(super) fn arithmetic_in_doubles(&mut self, i: Instruction) {
        let (a, b) = (self.doubles_with_flags(i.ra), self.doubles_with_flags(i.rb));
        let c = match i.op {
            Op::Fma | Op::Fms | Op::Fnms => Some(self.doubles_with_flags(i.rc)),
            _ => None,
        };
        let results = [0, 1].map(|n| {
            let (a, b) = (a[n], b[n]);
            match (i.op, c) {
                (Op::Fa, _) => self.sum(n, a, b),
                (Op::Fs, _) => {
                    let b = self.b.ins().fneg(b);
                    self.sum(n, a, b)
                }
                (Op::Fma, Some(c)) => self.fused(n, a, b, c[n]),
                (Op::Fms, Some(c)) => {
                    let c = self.b.ins().fneg(c[n]);
                    self.fused(n, a, b, c)
                }
                (Op::Fnms, Some(c)) => {
                    let a = self.b.ins().fneg(a);
                    self.fused(n, a, b, c[n])
                }
                // A product is exact.
                _ => {
                    let product = self.b.ins().fmul(a, b);
                    self.finish(n, product)
                }
            }
        });
        self.put_node(
            i.rt,
            Node {
                doubles: Some(results),
                is_of_doubles: true,
                facts: Facts { no_negative_zero: true, flags_noted: true, ..Facts::default() },
                ..Node::default()
            },
        );
    }

    fn sum(&mut self, n: usize, a: Value, b: Value) -> Value {
        let sum = self.b.ins().fadd(a, b);
        if self.mode.exact_sums {
            // The rest is exact if the larger term is subtracted first.
            let rests = [[a, b], [b, a]].map(|[first, second]| {
                let rest = self.b.ins().fsub(sum, first);
                self.b.ins().fsub(rest, second)
            });
            self.note_truncation(n, sum, rests);
        }
        self.finish(n, sum)
    }

    fn fused(&mut self, n: usize, a: Value, b: Value, c: Value) -> Value {
        let sum = self.b.ins().fma(a, b, c);
        if self.mode.exact_sums {
            let rest = self.b.ins().fsub(c, sum);
            let one = self.b.ins().fma(a, b, rest);
            let negated = self.b.ins().fneg(sum);
            let rest = self.b.ins().fma(a, b, negated);
            let other = self.b.ins().fadd(rest, c);
            self.note_truncation(n, sum, [one, other]);
        }
        self.finish(n, sum)
    }

    /// Notes lanes in which a sum is the largest number only because it was truncated. Each of
    /// `rests` is the truncated part of the sum, provided that its first subtraction was exact.
    /// This holds for the one that began with the larger term. So the sum was truncated where one
    /// of `rests` isn't zero.
    fn note_truncation(&mut self, n: usize, sum: Value, rests: [Value; 2]) {
        let zero = self.longs(0);
        let float_zero = self.cast(F64X2, zero);
        let [one, other] = rests.map(|rest| self.b.ins().fcmp(FloatCC::NotEqual, rest, float_zero));
        let truncated = self.b.ins().bor(one, other);
        let limit = self.longs(LARGEST);
        let limit = self.cast(F64X2, limit);
        let magnitude = self.b.ins().fabs(sum);
        let equal = self.b.ins().fcmp(FloatCC::Equal, magnitude, limit);
        let above = self.b.ins().band(truncated, equal);
        let before = self.unverified.above.get_or_insert([zero; 2])[n];
        let above = self.b.ins().bor(before, above);
        if let Some(all) = &mut self.unverified.above {
            all[n] = above;
        }
    }

    fn longs(&mut self, bits: u64) -> Value {
        self.constant_bytes(I64X2, [bits.to_le_bytes(); 2].concat())
    }

    /// Half `n` of a result, truncated to a single's range and precision. Notes what the commit
    /// needs for the flags.
    fn finish(&mut self, n: usize, result: Value) -> Value {
        let result = self.cast(I64X2, result);
        let sign = self.longs(DOUBLE_SIGN);
        let magnitude = self.b.ins().band_not(result, sign);
        let sign = self.b.ins().band(result, sign);
        let magnitude = self.cast(F64X2, magnitude);
        let zero = self.longs(0);

        let smallest = self.longs(SMALLEST);
        let smallest = self.cast(F64X2, smallest);
        let small = self.b.ins().fcmp(FloatCC::LessThan, magnitude, smallest);
        let bits = self.cast(I64X2, magnitude);
        let lost = self.b.ins().band(bits, small);
        let tiny = self.unverified.tiny.get_or_insert([zero; 2])[n];
        let tiny = self.b.ins().bor(tiny, lost);
        if let Some(all) = &mut self.unverified.tiny {
            all[n] = tiny;
        }

        let zero = self.cast(F64X2, zero);
        let largest = self.unverified.largest.get_or_insert([zero; 2])[n];
        let less = self.b.ins().fcmp(FloatCC::LessThan, magnitude, largest);
        let less = self.cast(F64X2, less);
        let largest = self.b.ins().bitselect(less, largest, magnitude);
        if let Some(all) = &mut self.unverified.largest {
            all[n] = largest;
        }

        let limit = self.longs(LARGEST);
        let limit = self.cast(F64X2, limit);
        let less = self.b.ins().fcmp(FloatCC::LessThan, magnitude, limit);
        let less = self.cast(F64X2, less);
        let saturated = self.b.ins().bitselect(less, magnitude, limit);
        let saturated = self.cast(I64X2, saturated);
        let kept = self.longs(KEPT);
        let truncated = self.b.ins().band(saturated, kept);
        let signed = self.b.ins().bor(truncated, sign);
        let result = self.b.ins().band_not(signed, small);
        self.cast(F64X2, result)
    }

    /// A register's lanes as doubles. Notes the flags that its lanes raise as operands.
    fn doubles_with_flags(&mut self, register: u8) -> [Value; 2] {
        let id = self.get(register);
        let facts = self.facts(id);
        if !facts.plain && !facts.flags_noted {
            self.note_operand_flags(id);
        }
        self.doubles(id)
    }

    fn note_operand_flags(&mut self, id: Id) {
        let words = self.words(id);
        // The bits without the sign, plus one exponent step: exponent 255 wraps around to 0, and
        // exponent 0 becomes 1.
        let shifted = self.b.ins().iadd(words, words);
        let one = self.splat(0x0100_0000);
        let wrapped = self.b.ins().iadd(shifted, one);
        let limit = self.splat(0x0200_0000);
        let low = self.b.ins().icmp(IntCC::UnsignedLessThan, wrapped, limit);
        let other = self.b.ins().icmp(IntCC::NotEqual, wrapped, one);
        let special = self.b.ins().band(low, other);
        let flag = self.and(special, 1);
        self.raise(flag);
        self.node(id).facts.flags_noted = true;
    }

    /// Notes flags, at their positions in the FPSCR.
    pub(super) fn raise(&mut self, flags: Value) {
        let flags = self.or(self.unverified.flags, flags);
        self.unverified.flags = Some(flags);
    }

    pub(super) fn doubles(&mut self, id: Id) -> [Value; 2] {
        if let Some(doubles) = self.node(id).doubles {
            return doubles;
        }
        if let Some(words) = self.constant(id) {
            let wide = words.map(widened);
            return [0, 2].map(|n| {
                let bytes = [wide[n].to_le_bytes(), wide[n + 1].to_le_bytes()].concat();
                self.constant_bytes(F64X2, bytes)
            });
        }
        let words = self.words(id);
        let shifted = self.right_signed(words, SHIFT);
        let shifted = self.and(shifted, SIGN | MAGNITUDE >> SHIFT);
        let rebias = self.splat(REBIAS);
        let upper = self.b.ins().iadd(shifted, rebias);
        let lower = self.left(words, 32 - SHIFT);
        let zero = self.is_zero(words);
        let upper = self.b.ins().band_not(upper, zero);
        let lower = self.b.ins().band_not(lower, zero);
        let doubles = [INTERLEAVED_LOW, INTERLEAVED_HIGH].map(|from| {
            let pair = self.shuffle(lower, upper, from);
            self.cast(F64X2, pair)
        });
        if !self.in_side_exit {
            self.node(id).doubles = Some(doubles);
        }
        doubles
    }

    /// The words of singles that equal these doubles.
    pub(super) fn narrow(&mut self, doubles: [Value; 2]) -> Value {
        let upper = self.shuffle(doubles[0], doubles[1], ODD_WORDS);
        let upper = self.cast(I32X4, upper);
        let lower = self.narrow_mask(doubles);
        let sign = self.and(upper, SIGN);
        let rebias = self.splat(REBIAS);
        let magnitude = self.and(upper, MAGNITUDE);
        let magnitude = self.b.ins().isub(magnitude, rebias);
        let magnitude = self.left(magnitude, SHIFT);
        let lower = self.right(lower, 32 - SHIFT);
        let magnitude = self.b.ins().bor(magnitude, lower);
        let word = self.b.ins().bor(magnitude, sign);
        let zero = self.splat(0);
        let zero = self.b.ins().icmp(IntCC::Equal, upper, zero);
        self.b.ins().band_not(word, zero)
    }

    /// The lower words of two pairs. For masks, this gives one word a lane.
    pub(super) fn narrow_mask(&mut self, pairs: [Value; 2]) -> Value {
        let words = self.shuffle(pairs[0], pairs[1], EVEN_WORDS);
        self.cast(I32X4, words)
    }

    /// `selb` whose mask has whole words of ones or zeros.
    pub(super) fn select_doubles(
        &mut self,
        i: Instruction,
        [a, b]: [[Value; 2]; 2],
        mask: Id,
        facts: Facts,
    ) {
        let mask = self.words(mask);
        let masks = [
            [0, 1, 2, 3, 0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7],
            [8, 9, 10, 11, 8, 9, 10, 11, 12, 13, 14, 15, 12, 13, 14, 15],
        ];
        let doubles = [0, 1].map(|n| {
            let mask = self.shuffle(mask, mask, masks[n]);
            let mask = self.cast(F64X2, mask);
            self.b.ins().bitselect(mask, b[n], a[n])
        });
        self.put_node(
            i.rt,
            Node { doubles: Some(doubles), is_of_doubles: true, facts, ..Node::default() },
        );
    }
}
