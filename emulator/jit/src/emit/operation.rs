//! Selects the emitting function for each instruction that is no branch.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I8X16, I16X8, I32X4};
use spu_isa::{Instruction, Op};

use super::Emitter;
use super::convert::Sign;
use super::float::Compare;
use super::integer::{Half, Logic};
use super::shift_rotate::{Bits, Bytes, Count, Move};
use crate::trace::{bytes, halfwords};

impl Emitter<'_> {
    /// Emits the instruction.
    ///
    /// # Panics
    ///
    /// If the instruction is a branch, or [`can_compile`](crate::can_compile) rejects it.
    #[expect(clippy::too_many_lines, reason = "one line per instruction")]
    pub(super) fn operation(&mut self, i: Instruction) {
        use IntCC::{Equal, SignedGreaterThan, UnsignedGreaterThan};
        match i.op {
            Op::Lqd => {
                let address = self.displaced(i);
                self.load(i, address);
            }
            Op::Lqx => {
                let address = self.indexed(i);
                self.load(i, address);
            }
            Op::Lqa => {
                let address = self.fixed(i.immediate as u32);
                self.load(i, address);
            }
            Op::Lqr => {
                let address = self.fixed(self.pc.wrapping_add_signed(i.immediate));
                self.load(i, address);
            }
            Op::Stqd => {
                let address = self.displaced(i);
                self.store(i, address);
            }
            Op::Stqx => {
                let address = self.indexed(i);
                self.store(i, address);
            }
            Op::Stqa => {
                let address = self.fixed(i.immediate as u32);
                self.store(i, address);
            }
            Op::Stqr => {
                let address = self.fixed(self.pc.wrapping_add_signed(i.immediate));
                self.store(i, address);
            }
            Op::Cbd => self.insert_displaced(i, 0),
            Op::Chd => self.insert_displaced(i, 1),
            Op::Cwd => self.insert_displaced(i, 2),
            Op::Cdd => self.insert_displaced(i, 3),
            Op::Cbx => self.insert_indexed(i, 0),
            Op::Chx => self.insert_indexed(i, 1),
            Op::Cwx => self.insert_indexed(i, 2),
            Op::Cdx => self.insert_indexed(i, 3),

            Op::Il | Op::Ila => self.set_constant(i.rt, [i.immediate as u32; 4]),
            Op::Ilh => self.set_constant(i.rt, [(i.immediate as u32 & 0xffff) * 0x0001_0001; 4]),
            Op::Ilhu => self.set_constant(i.rt, [(i.immediate as u32) << 16; 4]),
            Op::Iohl => self.logic_constant(i, i.rt, Logic::Or, i.immediate as u32 & 0xffff),
            Op::Fsmbi => self.form_mask_of_constant(i),

            Op::A => self.add(i, I32X4),
            Op::Ah => self.add(i, I16X8),
            Op::Ai => self.add_constant(i),
            Op::Ahi => self.add_halfword_constant(i),
            Op::Sf => self.subtract(i, I32X4),
            Op::Sfh => self.subtract(i, I16X8),
            Op::Sfi => self.subtract_from_constant(i, I32X4),
            Op::Sfhi => self.subtract_from_constant(i, I16X8),
            Op::Addx => self.add_extended(i, false),
            Op::Sfx => self.add_extended(i, true),
            Op::Cg => self.carry(i, false, false),
            Op::Cgx => self.carry(i, false, true),
            Op::Bg => self.carry(i, true, false),
            Op::Bgx => self.carry(i, true, true),

            Op::Mpy => self.multiply(i, Half::SignedLow),
            Op::Mpyu => self.multiply(i, Half::Low),
            Op::Mpyhh => self.multiply(i, Half::SignedHigh),
            Op::Mpyhhu => self.multiply(i, Half::High),
            Op::Mpyi => self.multiply_constant(i, Half::SignedLow),
            Op::Mpyui => self.multiply_constant(i, Half::Low),
            Op::Mpya => self.multiply_add(i, Half::SignedLow, i.rc),
            Op::Mpyhha => self.multiply_add(i, Half::SignedHigh, i.rt),
            Op::Mpyhhau => self.multiply_add(i, Half::High, i.rt),
            Op::Mpyh => self.multiply_high(i),
            Op::Mpys => self.multiply_shifted(i),

            Op::Clz => self.leading_zeros(i),
            Op::Cntb => self.count_ones_in_bytes(i),
            Op::Avgb => self.average_bytes(i),
            Op::Absdb => self.difference_of_bytes(i),
            Op::Sumb => self.sum_bytes(i),
            Op::Xsbh => self.extend_sign(i, I16X8, 8),
            Op::Xshw => self.extend_sign(i, I32X4, 16),
            Op::Xswd => self.extend_sign_of_word(i),

            Op::And => self.logic(i, Logic::And),
            Op::Or => self.logic(i, Logic::Or),
            Op::Xor => self.logic(i, Logic::Xor),
            Op::Nand => self.logic(i, Logic::Nand),
            Op::Nor => self.logic(i, Logic::Nor),
            Op::Eqv => self.logic(i, Logic::Eqv),
            Op::Andc => self.logic(i, Logic::Andc),
            Op::Orc => self.logic(i, Logic::Orc),
            Op::Andi => self.logic_constant(i, i.ra, Logic::And, i.immediate as u32),
            Op::Ori => self.logic_constant(i, i.ra, Logic::Or, i.immediate as u32),
            Op::Xori => self.logic_constant(i, i.ra, Logic::Xor, i.immediate as u32),
            Op::Andhi => self.logic_constant(i, i.ra, Logic::And, halfwords(i)),
            Op::Orhi => self.logic_constant(i, i.ra, Logic::Or, halfwords(i)),
            Op::Xorhi => self.logic_constant(i, i.ra, Logic::Xor, halfwords(i)),
            Op::Andbi => self.logic_constant(i, i.ra, Logic::And, bytes(i)),
            Op::Orbi => self.logic_constant(i, i.ra, Logic::Or, bytes(i)),
            Op::Xorbi => self.logic_constant(i, i.ra, Logic::Xor, bytes(i)),
            Op::Orx => self.or_across(i),

            Op::Selb => self.select(i),
            Op::Shufb => self.shuffle_bytes(i),
            Op::Fsm => self.form_mask_of_words(i),
            Op::Fsmh => self.form_mask_of_halfwords(i),
            Op::Fsmb => self.form_mask_of_bytes(i),
            Op::Gb => self.gather_words(i),
            Op::Gbh => self.gather_halfwords(i),
            Op::Gbb => self.gather_bytes(i),

            Op::Shl => self.shift(i, I32X4, Move::Left),
            Op::Shlh => self.shift(i, I16X8, Move::Left),
            Op::Rot => self.shift(i, I32X4, Move::Rotate),
            Op::Roth => self.shift(i, I16X8, Move::Rotate),
            Op::Rotm => self.shift(i, I32X4, Move::Right),
            Op::Rothm => self.shift(i, I16X8, Move::Right),
            Op::Rotma => self.shift(i, I32X4, Move::RightSigned),
            Op::Rotmah => self.shift(i, I16X8, Move::RightSigned),
            Op::Shli => self.shift_constant(i, I32X4, Move::Left),
            Op::Shlhi => self.shift_constant(i, I16X8, Move::Left),
            Op::Roti => self.shift_constant(i, I32X4, Move::Rotate),
            Op::Rothi => self.shift_constant(i, I16X8, Move::Rotate),
            Op::Rotmi => self.shift_constant(i, I32X4, Move::Right),
            Op::Rothmi => self.shift_constant(i, I16X8, Move::Right),
            Op::Rotmai => self.shift_constant(i, I32X4, Move::RightSigned),
            Op::Rotmahi => self.shift_constant(i, I16X8, Move::RightSigned),
            Op::Shlqbi => self.shift_bits(i, Bits::Left, Count::Register),
            Op::Shlqbii => self.shift_bits(i, Bits::Left, Count::Constant),
            Op::Rotqbi => self.shift_bits(i, Bits::Rotate, Count::Register),
            Op::Rotqbii => self.shift_bits(i, Bits::Rotate, Count::Constant),
            Op::Rotqmbi => self.shift_bits(i, Bits::Right, Count::Register),
            Op::Rotqmbii => self.shift_bits(i, Bits::Right, Count::Constant),
            Op::Shlqby => self.shift_bytes(i, Bytes::Left, Count::Register),
            Op::Shlqbyi => self.shift_bytes(i, Bytes::Left, Count::Constant),
            Op::Shlqbybi => self.shift_bytes(i, Bytes::Left, Count::RegisterInBits),
            Op::Rotqby => self.shift_bytes(i, Bytes::Rotate, Count::Register),
            Op::Rotqbyi => self.shift_bytes(i, Bytes::Rotate, Count::Constant),
            Op::Rotqbybi => self.shift_bytes(i, Bytes::Rotate, Count::RegisterInBits),
            Op::Rotqmby => self.shift_bytes(i, Bytes::Right, Count::Register),
            Op::Rotqmbyi => self.shift_bytes(i, Bytes::Right, Count::Constant),
            Op::Rotqmbybi => self.shift_bytes(i, Bytes::Right, Count::RegisterInBits),

            Op::Ceq => self.compare(i, I32X4, Equal),
            Op::Ceqh => self.compare(i, I16X8, Equal),
            Op::Ceqb => self.compare(i, I8X16, Equal),
            Op::Cgt => self.compare(i, I32X4, SignedGreaterThan),
            Op::Cgth => self.compare(i, I16X8, SignedGreaterThan),
            Op::Cgtb => self.compare(i, I8X16, SignedGreaterThan),
            Op::Clgt => self.compare(i, I32X4, UnsignedGreaterThan),
            Op::Clgth => self.compare(i, I16X8, UnsignedGreaterThan),
            Op::Clgtb => self.compare(i, I8X16, UnsignedGreaterThan),
            Op::Ceqi => self.compare_constant(i, I32X4, Equal),
            Op::Ceqhi => self.compare_constant(i, I16X8, Equal),
            Op::Ceqbi => self.compare_constant(i, I8X16, Equal),
            Op::Cgti => self.compare_constant(i, I32X4, SignedGreaterThan),
            Op::Cgthi => self.compare_constant(i, I16X8, SignedGreaterThan),
            Op::Cgtbi => self.compare_constant(i, I8X16, SignedGreaterThan),
            Op::Clgti => self.compare_constant(i, I32X4, UnsignedGreaterThan),
            Op::Clgthi => self.compare_constant(i, I16X8, UnsignedGreaterThan),
            Op::Clgtbi => self.compare_constant(i, I8X16, UnsignedGreaterThan),

            Op::Hbr | Op::Hbra | Op::Hbrr | Op::Lnop | Op::Nop | Op::Mtspr => {}

            Op::Fa | Op::Fs | Op::Fm | Op::Fma | Op::Fms | Op::Fnms => self.arithmetic(i),
            Op::Frest => self.estimate_reciprocal(i),
            Op::Frsqest => self.estimate_reciprocal_root(i),
            Op::Fi => self.interpolate(i),
            Op::Csflt => self.single_of_integer(i, Sign::Signed),
            Op::Cuflt => self.single_of_integer(i, Sign::Unsigned),
            Op::Cflts => self.integer_of_single(i, Sign::Signed),
            Op::Cfltu => self.integer_of_single(i, Sign::Unsigned),
            Op::Fceq => self.compare_singles(i, Compare::Equal, false),
            Op::Fcmeq => self.compare_singles(i, Compare::Equal, true),
            Op::Fcgt => self.compare_singles(i, Compare::Greater, false),
            Op::Fcmgt => self.compare_singles(i, Compare::Greater, true),

            Op::Dfa | Op::Dfs | Op::Dfm | Op::Dfma | Op::Dfms | Op::Dfnms | Op::Dfnma => {
                self.double_arithmetic(i);
            }
            Op::Fesd => self.double_of_single(i),
            Op::Frds => self.single_of_double(i),

            // Branches and halts, which `branch` emits.
            Op::Br | Op::Bra | Op::Brsl | Op::Brasl | Op::Brz | Op::Brnz | Op::Brhz
            | Op::Brhnz | Op::Bi | Op::Bisl | Op::Biz | Op::Binz | Op::Bihz | Op::Bihnz
            | Op::Heq | Op::Heqi | Op::Hgt | Op::Hgti | Op::Hlgt | Op::Hlgti
            // Instructions that `can_compile` rejects.
            | Op::Iret | Op::Bisled | Op::Stop | Op::Stopd | Op::Sync | Op::Dsync | Op::Mfspr
            | Op::Rdch | Op::Rchcnt | Op::Wrch | Op::Fscrrd | Op::Fscrwr | Op::Dfceq
            | Op::Dfcmeq | Op::Dfcgt | Op::Dfcmgt | Op::Dftsv => {
                unreachable!("a trace can't contain this operation: {i:?}")
            }
        }
    }
}
