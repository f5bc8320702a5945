//! Single precision, by the interpreter's fast functions (`ordinary`): four lanes as two pairs of
//! doubles.

use spu_isa::{Instruction, Op};
use wasm_encoder::{BlockType, InstructionSink, ValType};

use super::emitter::{Emitter, Facts, splat, word};
use super::integer::{MASK, Operation};
use crate::exit::Exit;

const SIGN: u32 = 0x8000_0000;
const MAGNITUDE: u32 = 0x7fff_ffff;
const EXPONENT: u32 = 0x7f80_0000;
/// How many bits further right fraction and exponent are in a double than in a single.
const SHIFT: u32 = 3;
/// The low bits of a double that the truncation to a single drops.
const DROPPED: u32 = (1 << (32 - SHIFT)) - 1;
/// The difference between the exponent biases, in a double's upper word.
const REBIAS: u32 = (1023 - 127) << 20;
/// Upper words of 2^-126 and 2^128 as doubles: the singles that IEEE has, too.
const FROM: u32 = REBIAS + (0x0080_0000 >> SHIFT);
const TO: u32 = REBIAS + (EXPONENT >> SHIFT);
/// Scales at which the conversion of an ordinary single needs no more range than a double has, and
/// that of a denormal one gives 0.
const SCALES: std::ops::RangeInclusive<i32> = 0..=126;

const EVEN_WORDS: [u8; 16] = [0, 1, 2, 3, 8, 9, 10, 11, 16, 17, 18, 19, 24, 25, 26, 27];
const ODD_WORDS: [u8; 16] = [4, 5, 6, 7, 12, 13, 14, 15, 20, 21, 22, 23, 28, 29, 30, 31];
/// The lower halves of two vectors, and the upper half of one.
const LOWER_HALVES: [u8; 16] = [0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23];
const UPPER_HALF: [u8; 16] = [8, 9, 10, 11, 12, 13, 14, 15, 8, 9, 10, 11, 12, 13, 14, 15];

fn doubles(bits: u64) -> i128 {
    (u128::from(bits) << 64 | u128::from(bits)) as i128
}

/// 2^scale in both lanes.
fn power_of_two(scale: i32) -> i128 {
    doubles(((1023 + scale) as u64) << 52)
}

impl Emitter<'_> {
    /// Pushes half of a register's lanes as doubles.
    fn push_doubles(&mut self, register: u8, half: usize) {
        self.push(register);
        if half == 1 {
            self.push(register);
            self.f().i8x16_shuffle(UPPER_HALF);
        }
        self.f().f64x2_promote_low_f32x4();
    }

    /// Sets rt to `result`, which it pushes, unless a lane of the mask on the stack is set. All
    /// sources must be held.
    fn unless(&mut self, i: Instruction, facts: Facts, result: impl FnOnce(&mut Self)) {
        self.f().v128_any_true();
        if self.mode.in_doubles.contains(self.count as usize) {
            self.f().if_(BlockType::Result(ValType::V128));
            self.interpret(i);
            self.f().else_();
            result(self);
            self.f().end();
        } else {
            self.aside(|e| e.exit(Exit::FAILED));
            result(self);
        }
        self.set_with(i.rt, facts);
    }

    /// `fa`, `fs`, `fm`, `fma`, `fms` and `fnms`.
    pub(super) fn arithmetic(&mut self, i: Instruction) {
        let is_sum = i.op != Op::Fm;
        let sources = i.op.row().reads;
        sources.iter().for_each(|&field| self.hold(i.register(field)));
        let [x, y, s] = [[0, 1], [2, 3], [4, 5]].map(|pair| pair.map(|n| self.temporary(n)));
        for half in 0..2 {
            self.push_doubles(i.ra, half);
            if !matches!(i.op, Op::Fa | Op::Fs) {
                self.push_doubles(i.rb, half);
                self.f().f64x2_mul();
            }
            if is_sum {
                if i.op == Op::Fnms {
                    self.f().f64x2_neg();
                }
                self.f().local_tee(x[half]);
                let addend = if matches!(i.op, Op::Fa | Op::Fs) { i.rb } else { i.rc };
                self.push_doubles(addend, half);
                if matches!(i.op, Op::Fs | Op::Fms) {
                    self.f().f64x2_neg();
                }
                self.f().local_tee(y[half]).f64x2_add();
            }
            self.f().local_set(s[half]);
        }
        if is_sum {
            self.correct_rounding(x, y, s);
        }
        self.push_specials(s);
        self.push_denormals(i);
        self.unless(i, Facts { no_denormals: true, mask: false }, |e| e.push_narrowed(s));
    }

    /// Truncation corrects the rounding of a sum, unless the rounded sum is itself a single. Then
    /// goes one step back where the host has rounded away from zero.
    fn correct_rounding(&mut self, x: [u32; 2], y: [u32; 2], s: [u32; 2]) {
        let part = self.temporary(6);
        let mut f = self.f();
        f.local_get(s[0]).local_get(s[1]).i8x16_shuffle(EVEN_WORDS);
        f.v128_const(splat(DROPPED)).v128_and().v128_const(0).i32x4_eq();
        f.v128_any_true().if_(BlockType::Empty);
        for half in 0..2 {
            let (x, y, s) = (x[half], y[half], s[half]);
            // The error: (x - (s - part)) + (y - part).
            f.local_get(s).local_get(x).f64x2_sub().local_set(part);
            f.local_get(x).local_get(s).local_get(part).f64x2_sub().f64x2_sub();
            f.local_get(y).local_get(part).f64x2_sub().f64x2_add().local_tee(part);
            f.local_get(s).v128_xor().i32_const(63).i64x2_shr_s();
            f.local_get(part).v128_const(0).f64x2_ne().v128_and();
            f.local_get(s).i64x2_add().local_set(s);
        }
        f.end();
    }

    /// Pushes a mask of the results that are neither 0 nor singles that IEEE has.
    fn push_specials(&mut self, s: [u32; 2]) {
        let magnitudes = self.temporary(6);
        let mut f = self.f();
        f.local_get(s[0]).local_get(s[1]).i8x16_shuffle(ODD_WORDS);
        f.v128_const(splat(MAGNITUDE)).v128_and().local_tee(magnitudes);
        f.v128_const(splat(FROM)).i32x4_sub().v128_const(splat(TO - FROM)).i32x4_ge_u();
        f.local_get(magnitudes).v128_const(0).i32x4_ne().v128_and();
    }

    /// Adds the denormal operands to the mask on the stack. Those with exponent 255 are found by
    /// the result, which is an infinity or no number.
    fn push_denormals(&mut self, i: Instruction) {
        let mut sources: Vec<u8> = i.op.row().reads.iter().map(|&f| i.register(f)).collect();
        sources.sort_unstable();
        sources.dedup();
        sources.retain(|&register| !self.facts(register).no_denormals);
        for (n, &register) in sources.iter().enumerate() {
            self.push(register);
            self.push(register);
            self.f().i32x4_add().v128_const(-1).i32x4_add();
            if n > 0 {
                self.f().i32x4_min_u();
            }
        }
        if !sources.is_empty() {
            self.f().v128_const(splat(0x00ff_fffe)).i32x4_le_u().v128_or();
        }
        if !self.mode.in_doubles.contains(self.count as usize) {
            // Otherwise the unit has failed.
            for register in sources {
                let facts = Facts { no_denormals: true, ..self.facts(register) };
                self.set_facts(register, facts);
            }
        }
    }

    /// Pushes doubles within the ordinary range as singles, truncated, with every zero as +0.
    fn push_narrowed(&mut self, s: [u32; 2]) {
        let mut f = self.f();
        for s in s {
            f.local_get(s).v128_const(doubles(!u64::from(DROPPED))).v128_and();
            f.f32x4_demote_f64x2_zero();
        }
        f.i8x16_shuffle(LOWER_HALVES).v128_const(0).f32x4_add();
    }

    /// `csflt`, `cuflt`. [`can_compile`](crate::can_compile) rejects scales with other results than
    /// ordinary numbers.
    pub(super) fn single_of_integer(&mut self, i: Instruction, convert: Operation) {
        let s = [0, 1].map(|number| self.temporary(number));
        for (half, s) in s.into_iter().enumerate() {
            self.push(i.ra);
            if half == 1 {
                self.push(i.ra);
                self.f().i8x16_shuffle(UPPER_HALF);
            }
            let scale = power_of_two(-i.immediate);
            convert(&mut self.f()).v128_const(scale).f64x2_mul().local_set(s);
        }
        self.push_narrowed(s);
        self.set_with(i.rt, Facts { no_denormals: true, mask: false });
    }

    /// `cflts`, `cfltu`.
    pub(super) fn integer_of_single(&mut self, i: Instruction, convert: Operation) {
        if !SCALES.contains(&i.immediate) {
            return self.leave_out(i);
        }
        self.hold(i.ra);
        self.push_exponent(i.ra);
        self.f().v128_const(splat(EXPONENT)).i32x4_eq();
        self.unless(i, Facts::default(), |e| {
            for half in 0..2 {
                e.push_doubles(i.ra, half);
                convert(e.f().v128_const(power_of_two(i.immediate)).f64x2_mul());
            }
            e.f().i8x16_shuffle(LOWER_HALVES);
        });
    }

    fn push_exponent(&mut self, register: u8) {
        self.push(register);
        self.f().v128_const(splat(EXPONENT)).v128_and();
    }

    /// Pushes integers that have the same order as the singles, or as their magnitudes.
    fn push_order(&mut self, register: u8, magnitudes: bool) {
        let sign = self.temporary(0);
        self.push(register);
        self.f().v128_const(splat(MAGNITUDE)).v128_and();
        if !magnitudes {
            self.push(register);
            let mut f = self.f();
            f.i32_const(31).i32x4_shr_s().local_tee(sign).v128_xor();
            f.local_get(sign).i32x4_sub();
        }
        self.push_exponent(register);
        self.f().v128_const(0).i32x4_ne().v128_and();
    }

    pub(super) fn compare_singles(&mut self, i: Instruction, magnitudes: bool, test: Operation) {
        self.push_order(i.ra, magnitudes);
        self.push_order(i.rb, magnitudes);
        test(&mut self.f());
        self.set_with(i.rt, MASK);
    }

    /// `frest`, `frsqest`: an entry of a table, with the exponent that `exponent` makes of the
    /// operand's.
    pub(super) fn estimate(
        &mut self,
        i: Instruction,
        (table, entries): (u32, u32),
        exponent: impl FnOnce(&mut InstructionSink<'_>),
    ) {
        let [index, found] = [0, 1].map(|number| self.temporary(number));
        self.hold(i.ra);
        self.push_exponent(i.ra);
        self.f().v128_const(0).i32x4_eq();
        self.unless(i, Facts::default(), |e| {
            e.push(i.ra);
            let mut f = e.f();
            f.i32_const(16).i32x4_shr_u().v128_const(splat((entries - 1) * 4)).v128_and();
            f.local_set(index).v128_const(0).local_set(found);
            for lane in 0..4 {
                f.local_get(index).i32x4_extract_lane(lane).local_get(found);
                f.v128_load32_lane(word(table), lane).local_set(found);
            }
            e.push_exponent(i.ra);
            let mut f = e.f();
            exponent(f.i32_const(23).i32x4_shr_u());
            f.i32_const(23).i32x4_shl().local_get(found).v128_or();
            if i.op == Op::Frest {
                e.push(i.ra);
                e.f().v128_const(splat(SIGN)).v128_and().v128_or();
            }
        });
    }

    /// `fi`: subtracts from the base of the estimate in rb the part of its step that ra selects.
    pub(super) fn interpolate(&mut self, i: Instruction) {
        let [base, part] = [0, 1].map(|number| self.temporary(number));
        self.hold(i.ra);
        self.push(i.rb);
        self.f().i32_const(9).i32x4_shl().v128_const(splat(0x1fff << 19)).v128_and();
        self.f().local_set(base);
        self.push(i.rb);
        self.f().v128_const(splat(0x3ff)).v128_and();
        self.push(i.ra);
        let mut f = self.f();
        f.v128_const(splat(0x7_ffff)).v128_and().i32x4_mul().local_tee(part);
        f.local_get(base).i32x4_gt_u();
        for exponent in [0, EXPONENT] {
            self.push_exponent(i.rb);
            self.f().v128_const(splat(exponent)).i32x4_eq().v128_or();
        }
        self.unless(i, Facts { no_denormals: true, mask: false }, |e| {
            e.push(i.rb);
            let mut f = e.f();
            f.v128_const(splat(SIGN | EXPONENT)).v128_and();
            f.local_get(base).local_get(part).i32x4_sub().i32_const(9).i32x4_shr_u().v128_or();
        });
    }
}
