//! Selects the emitting function for each instruction that is no branch.

use spu_isa::{Instruction, Op};

use super::emitter::{Emitter, splat, vector};
use super::integer::{Half, Operation};
use super::memory::Address;
use super::shift_rotate::{Count, Lanes, Move};
use crate::trace::{bytes, halfwords};

const WORDS: Lanes = Lanes {
    width: 32,
    left: |f| f.i32x4_shl(),
    right: |f| f.i32x4_shr_u(),
    right_signed: |f| f.i32x4_shr_s(),
};
const HALFWORDS: Lanes = Lanes {
    width: 16,
    left: |f| f.i16x8_shl(),
    right: |f| f.i16x8_shr_u(),
    right_signed: |f| f.i16x8_shr_s(),
};

/// For `fsmb`: the byte and the bit of the preferred word that each byte tests.
const BYTES_FROM: i128 = vector([0x0101_0101, 0x0101_0101, 0x0000_0000, 0x0000_0000]);
const BYTES_BITS: i128 = vector([0x8040_2010, 0x0804_0201, 0x8040_2010, 0x0804_0201]);
/// For `fsmh`, the same of halfwords, of which each word has the left one last.
const HALFWORDS_FROM: i128 = splat(0x0100_0100);
const HALFWORDS_BITS: i128 = vector([0x0080_0040, 0x0020_0010, 0x0008_0004, 0x0002_0001]);
const WORDS_FROM: i128 = splat(0x0302_0100);
const WORDS_BITS: i128 = vector([8, 4, 2, 1]);
/// For `gb`, `gbh` and `gbb`: the lanes from right to left.
const REVERSED: i128 = vector([0x0f0e_0d0c, 0x0b0a_0908, 0x0706_0504, 0x0302_0100]);

impl Emitter<'_> {
    /// Emits the instruction. The interpreter runs rare ones.
    #[expect(clippy::too_many_lines, reason = "one line per instruction")]
    pub(super) fn operation(&mut self, i: Instruction) {
        let word = i.immediate as u32;
        match i.op {
            Op::Hbr | Op::Hbra | Op::Hbrr | Op::Lnop | Op::Nop | Op::Mtspr => {}

            Op::Lqd => {
                let address = self.displaced(i);
                self.load(i, address);
            }
            Op::Lqx => {
                let address = self.indexed(i);
                self.load(i, address);
            }
            Op::Lqa => self.load(i, Address::Constant(word)),
            Op::Lqr => self.load(i, Address::Constant(self.pc.wrapping_add_signed(i.immediate))),
            Op::Stqd => {
                let address = self.displaced(i);
                self.store(i, address);
            }
            Op::Stqx => {
                let address = self.indexed(i);
                self.store(i, address);
            }
            Op::Stqa => self.store(i, Address::Constant(word)),
            Op::Stqr => self.store(i, Address::Constant(self.pc.wrapping_add_signed(i.immediate))),
            Op::Cbd | Op::Chd | Op::Cwd | Op::Cdd => {
                self.displaced(i);
                self.insert(i, insertion_size(i.op));
            }
            Op::Cbx | Op::Chx | Op::Cwx | Op::Cdx => {
                self.indexed(i);
                self.insert(i, insertion_size(i.op));
            }

            Op::Il | Op::Ila => self.set_constant(i.rt, [word; 4]),
            Op::Ilh => self.set_constant(i.rt, [halfwords(i); 4]),
            Op::Ilhu => self.set_constant(i.rt, [word << 16; 4]),
            Op::Iohl => self.or_constant(i, i.rt, word & 0xffff),
            Op::Fsmbi => {
                let byte = |n: u32| (word >> (15 - n) & 1) * 0xff;
                let words = |n: u32| (0..4).fold(0, |all, at| all << 8 | byte(4 * n + at));
                self.set_constant(i.rt, [0, 1, 2, 3].map(words));
            }

            Op::A => self.binary(i, |f| f.i32x4_add()),
            Op::Ah => self.binary(i, |f| f.i16x8_add()),
            Op::Ai => self.with_constant(i, word, |f| f.i32x4_add()),
            Op::Ahi => self.with_constant(i, halfwords(i), |f| f.i16x8_add()),
            Op::Sf => self.reversed(i, |f| f.i32x4_sub()),
            Op::Sfh => self.reversed(i, |f| f.i16x8_sub()),
            Op::Sfi => self.subtract_from(i, word, |f| f.i32x4_sub()),
            Op::Sfhi => self.subtract_from(i, halfwords(i), |f| f.i16x8_sub()),
            Op::Addx => self.extended(i, false),
            Op::Sfx => self.extended(i, true),
            Op::Cg => self.carry(i, false),
            Op::Bg => self.carry(i, true),
            Op::Cgx => self.extended_carry(i, false),
            Op::Bgx => self.extended_carry(i, true),

            Op::Mpy => self.multiply(i, Half::SignedLow),
            Op::Mpyu => self.multiply(i, Half::Low),
            Op::Mpyhh => self.multiply(i, Half::SignedHigh),
            Op::Mpyhhu => self.multiply(i, Half::High),
            Op::Mpyi => self.multiply_constant(i, Half::SignedLow, word),
            Op::Mpyui => self.multiply_constant(i, Half::Low, word & 0xffff),
            Op::Mpya => self.multiply_add(i, Half::SignedLow, i.rc),
            Op::Mpyhha => self.multiply_add(i, Half::SignedHigh, i.rt),
            Op::Mpyhhau => self.multiply_add(i, Half::High, i.rt),
            Op::Mpyh => {
                self.push_half(i.ra, Half::High);
                self.push(i.rb);
                self.f().i32x4_mul().i32_const(16).i32x4_shl();
                self.set(i.rt);
            }
            Op::Mpys => {
                self.push_product(i, Half::SignedLow);
                self.f().i32_const(16).i32x4_shr_s();
                self.set(i.rt);
            }
            Op::Cntb => self.unary(i, |f| f.i8x16_popcnt()),
            Op::Avgb => self.binary(i, |f| f.i8x16_avgr_u()),
            Op::Absdb => {
                let operations: [Operation; 2] = [|f| f.i8x16_max_u(), |f| f.i8x16_min_u()];
                for operation in operations {
                    self.push(i.ra);
                    self.push(i.rb);
                    operation(&mut self.f());
                }
                self.f().i8x16_sub();
                self.set(i.rt);
            }
            Op::Xsbh => self.unary(i, |f| f.i32_const(8).i16x8_shl().i32_const(8).i16x8_shr_s()),
            Op::Xshw => self.unary(i, |f| f.i32_const(16).i32x4_shl().i32_const(16).i32x4_shr_s()),
            Op::Xswd => self.extend_words(i),

            Op::And => self.logic(i, |f| f.v128_and()),
            Op::Or => self.logic(i, |f| f.v128_or()),
            Op::Xor => self.logic(i, |f| f.v128_xor()),
            Op::Nand => self.logic(i, |f| f.v128_and().v128_not()),
            Op::Nor => self.logic(i, |f| f.v128_or().v128_not()),
            Op::Eqv => self.logic(i, |f| f.v128_xor().v128_not()),
            Op::Andc => self.logic(i, |f| f.v128_andnot()),
            Op::Orc => self.logic(i, |f| f.v128_not().v128_or()),
            Op::Andi => self.with_constant(i, word, |f| f.v128_and()),
            Op::Andhi => self.with_constant(i, halfwords(i), |f| f.v128_and()),
            Op::Andbi => self.with_constant(i, bytes(i), |f| f.v128_and()),
            Op::Ori => self.or_constant(i, i.ra, word),
            Op::Orhi => self.or_constant(i, i.ra, halfwords(i)),
            Op::Orbi => self.or_constant(i, i.ra, bytes(i)),
            Op::Xori => self.with_constant(i, word, |f| f.v128_xor()),
            Op::Xorhi => self.with_constant(i, halfwords(i), |f| f.v128_xor()),
            Op::Xorbi => self.with_constant(i, bytes(i), |f| f.v128_xor()),
            Op::Orx => self.or_across(i),
            Op::Selb => self.select(i),
            Op::Shufb => self.shuffle(i),
            Op::Fsm => self.spread(i, WORDS_FROM, WORDS_BITS, |f| f.i32x4_eq()),
            Op::Fsmh => self.spread(i, HALFWORDS_FROM, HALFWORDS_BITS, |f| f.i16x8_eq()),
            Op::Fsmb => self.spread(i, BYTES_FROM, BYTES_BITS, |f| f.i8x16_eq()),
            Op::Gb => {
                self.gather(i, REVERSED, splat(1), |f| f.v128_const(0).i32x4_ne().i32x4_bitmask())
            }
            Op::Gbh => self.gather(i, REVERSED, splat(0x0001_0001), |f| {
                f.v128_const(0).i16x8_ne().i16x8_bitmask()
            }),
            Op::Gbb => self.gather(i, REVERSED, splat(0x0101_0101), |f| {
                f.v128_const(0).i8x16_ne().i8x16_bitmask()
            }),

            Op::Shl => self.shift_words(i, Move::Left),
            Op::Rot => self.shift_words(i, Move::Rotate),
            Op::Rotm => self.shift_words(i, Move::Right),
            Op::Rotma => self.shift_words(i, Move::RightSigned),
            Op::Shli => self.shift_constant(i, &WORDS, Move::Left),
            Op::Shlhi => self.shift_constant(i, &HALFWORDS, Move::Left),
            Op::Roti => self.shift_constant(i, &WORDS, Move::Rotate),
            Op::Rothi => self.shift_constant(i, &HALFWORDS, Move::Rotate),
            Op::Rotmi => self.shift_constant(i, &WORDS, Move::Right),
            Op::Rothmi => self.shift_constant(i, &HALFWORDS, Move::Right),
            Op::Rotmai => self.shift_constant(i, &WORDS, Move::RightSigned),
            Op::Rotmahi => self.shift_constant(i, &HALFWORDS, Move::RightSigned),
            Op::Shlqbi => self.shift_bits(i, Move::Left, Count::Register),
            Op::Shlqbii => self.shift_bits(i, Move::Left, Count::Constant),
            Op::Rotqbi => self.shift_bits(i, Move::Rotate, Count::Register),
            Op::Rotqbii => self.shift_bits(i, Move::Rotate, Count::Constant),
            Op::Rotqmbi => self.shift_bits(i, Move::Right, Count::Register),
            Op::Rotqmbii => self.shift_bits(i, Move::Right, Count::Constant),
            Op::Shlqby => self.shift_bytes(i, Move::Left, Count::Register),
            Op::Shlqbyi => self.shift_bytes(i, Move::Left, Count::Constant),
            Op::Shlqbybi => self.shift_bytes(i, Move::Left, Count::RegisterInBits),
            Op::Rotqby => self.shift_bytes(i, Move::Rotate, Count::Register),
            Op::Rotqbyi => self.shift_bytes(i, Move::Rotate, Count::Constant),
            Op::Rotqbybi => self.shift_bytes(i, Move::Rotate, Count::RegisterInBits),
            Op::Rotqmby => self.shift_bytes(i, Move::Right, Count::Register),
            Op::Rotqmbyi => self.shift_bytes(i, Move::Right, Count::Constant),
            Op::Rotqmbybi => self.shift_bytes(i, Move::Right, Count::RegisterInBits),

            Op::Ceq => self.compare(i, |f| f.i32x4_eq()),
            Op::Ceqh => self.compare(i, |f| f.i16x8_eq()),
            Op::Ceqb => self.compare(i, |f| f.i8x16_eq()),
            Op::Cgt => self.compare(i, |f| f.i32x4_gt_s()),
            Op::Cgth => self.compare(i, |f| f.i16x8_gt_s()),
            Op::Cgtb => self.compare(i, |f| f.i8x16_gt_s()),
            Op::Clgt => self.compare(i, |f| f.i32x4_gt_u()),
            Op::Clgth => self.compare(i, |f| f.i16x8_gt_u()),
            Op::Clgtb => self.compare(i, |f| f.i8x16_gt_u()),
            Op::Ceqi => self.compare_constant(i, word, |f| f.i32x4_eq()),
            Op::Ceqhi => self.compare_constant(i, halfwords(i), |f| f.i16x8_eq()),
            Op::Ceqbi => self.compare_constant(i, bytes(i), |f| f.i8x16_eq()),
            Op::Cgti => self.compare_constant(i, word, |f| f.i32x4_gt_s()),
            Op::Cgthi => self.compare_constant(i, halfwords(i), |f| f.i16x8_gt_s()),
            Op::Cgtbi => self.compare_constant(i, bytes(i), |f| f.i8x16_gt_s()),
            Op::Clgti => self.compare_constant(i, word, |f| f.i32x4_gt_u()),
            Op::Clgthi => self.compare_constant(i, halfwords(i), |f| f.i16x8_gt_u()),
            Op::Clgtbi => self.compare_constant(i, bytes(i), |f| f.i8x16_gt_u()),

            Op::Fa | Op::Fs | Op::Fm | Op::Fma | Op::Fms | Op::Fnms => self.arithmetic(i),
            Op::Frest => self.estimate(i, (self.places.reciprocal, 32), |f| {
                // 253 - exponent, at least 0.
                _ = f.i32x4_neg().v128_const(splat(253)).i32x4_add().v128_const(0).i32x4_max_s();
            }),
            Op::Frsqest => self.estimate(i, (self.places.reciprocal_root, 64), |f| {
                _ = f.i32x4_neg().v128_const(splat(380)).i32x4_add().i32_const(1).i32x4_shr_u();
            }),
            Op::Fi => self.interpolate(i),
            Op::Csflt => self.single_of_integer(i, |f| f.f64x2_convert_low_i32x4_s()),
            Op::Cuflt => self.single_of_integer(i, |f| f.f64x2_convert_low_i32x4_u()),
            Op::Cflts => self.integer_of_single(i, |f| f.i32x4_trunc_sat_f64x2_s_zero()),
            Op::Cfltu => self.integer_of_single(i, |f| f.i32x4_trunc_sat_f64x2_u_zero()),
            Op::Fceq => self.compare_singles(i, false, |f| f.i32x4_eq()),
            Op::Fcmeq => self.compare_singles(i, true, |f| f.i32x4_eq()),
            Op::Fcgt => self.compare_singles(i, false, |f| f.i32x4_gt_s()),
            Op::Fcmgt => self.compare_singles(i, true, |f| f.i32x4_gt_s()),

            _ => self.leave_out(i),
        }
    }
}

/// The size of what a generated control inserts.
fn insertion_size(op: Op) -> u32 {
    match op {
        Op::Cbd | Op::Cbx => 1,
        Op::Chd | Op::Chx => 2,
        Op::Cwd | Op::Cwx => 4,
        _ => 8,
    }
}
