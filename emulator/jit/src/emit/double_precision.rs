//! Double precision.
//!
//! The host rounds these instructions to nearest, and single precision toward zero. Its rounding
//! mode is changed where one follows the other, and is back at every exit. The host's flags report
//! the cases that an SPU treats differently: NaNs, denormal operands, overflow and underflow. They
//! don't show which slice was inexact. So each rounding error is computed too, which is a double
//! unless one of those flags is raised.

use cranelift_codegen::ir::condcodes::FloatCC;
use cranelift_codegen::ir::types::{F32X4, F64X2, I32X4};
use cranelift_codegen::ir::{InstBuilder, Value};
use spu_isa::{Class, Instruction, Op};

use super::registers::Node;
use super::{Emitter, field};
use crate::host;

/// A shuffle that swaps the words of each doubleword, whose upper word comes first in a register.
const SWAPPED: [u8; 16] = [4, 5, 6, 7, 0, 1, 2, 3, 12, 13, 14, 15, 8, 9, 10, 11];
/// A shuffle that moves the upper words of the doublewords to the front.
const UPPER: [u8; 16] = [0, 1, 2, 3, 8, 9, 10, 11, 0, 1, 2, 3, 8, 9, 10, 11];
/// The reverse: the first two words become the upper words, and the other words 0.
const TO_UPPER: [u8; 16] = [0, 1, 2, 3, 32, 32, 32, 32, 4, 5, 6, 7, 32, 32, 32, 32];
/// The smallest normal double, and the smallest normal single.
const SMALLEST: f64 = f64::MIN_POSITIVE;
const SMALLEST_SINGLE: f64 = f32::MIN_POSITIVE as f64;
/// The inexact flags of the two slices, in the second and third word of the FPSCR.
const INEXACT: [u32; 4] = [0, 0x800, 0x800, 0];

/// Masks of slices.
#[derive(Clone, Copy)]
struct Errors {
    inexact: Value,
    /// Whether it is unknown if the result is inexact.
    undecided: Value,
}

impl Emitter<'_> {
    /// Changes the host's rounding mode for an instruction of this class, if necessary.
    pub(super) fn round_for(&mut self, class: Class) {
        match class {
            Class::Fpd if !self.rounds_to_nearest => {
                self.call_with_context(host::round_to_nearest);
                self.rounds_to_nearest = true;
            }
            Class::Fp6 | Class::Fp7 => self.round_toward_zero(),
            _ => {}
        }
    }

    /// Has the host round toward zero again.
    pub(super) fn round_toward_zero(&mut self) {
        if self.rounds_to_nearest {
            self.call_with_context(host::round_toward_zero);
            self.rounds_to_nearest = self.in_side_exit;
        }
    }

    /// `dfa`, `dfs`, `dfm`, `dfma`, `dfms`, `dfnms`, `dfnma`.
    pub(super) fn double_arithmetic(&mut self, i: Instruction) {
        let (a, mut b) = (self.double_slices(i.ra), self.double_slices(i.rb));
        let (result, errors) = match i.op {
            Op::Dfa | Op::Dfs => {
                if i.op == Op::Dfs {
                    b = self.b.ins().fneg(b);
                }
                let sum = self.b.ins().fadd(a, b);
                (sum, self.unless_inexact(|e| e.errors_of_sum(a, b)))
            }
            Op::Dfm => {
                let product = self.b.ins().fmul(a, b);
                (product, self.unless_inexact(|e| e.errors_of_product(a, b)))
            }
            _ => {
                let mut t = self.double_slices(i.rt);
                if matches!(i.op, Op::Dfms | Op::Dfnms) {
                    t = self.b.ins().fneg(t);
                }
                let fused = self.b.ins().fma(a, b, t);
                let errors = self.unless_inexact(|e| e.errors_of_fused(a, b, t, fused));
                (fused, errors)
            }
        };
        self.note_double(result, errors, SMALLEST);
        let result = match i.op {
            Op::Dfnms | Op::Dfnma => self.b.ins().fneg(result),
            _ => result,
        };
        self.set_double_slices(i, result);
    }

    /// `fesd`. Every single is a double.
    pub(super) fn double_of_single(&mut self, i: Instruction) {
        let words = self.lanes(I32X4, i.ra);
        let singles = self.shuffle(words, words, UPPER);
        let singles = self.cast(F32X4, singles);
        let result = self.b.ins().fvpromote_low(singles);
        self.note_nan(result);
        self.set_double_slices(i, result);
    }

    /// `frds`
    pub(super) fn single_of_double(&mut self, i: Instruction) {
        let double = self.double_slices(i.ra);
        let singles = self.b.ins().fvdemote(double);
        let rounded = self.b.ins().fvpromote_low(singles);
        let errors = self.unless_inexact(|e| Errors {
            inexact: e.differ(rounded, double),
            undecided: e.splat(0),
        });
        self.note_double(rounded, errors, SMALLEST_SINGLE);
        let singles = self.shuffle(singles, singles, TO_UPPER);
        self.set(i.rt, singles);
    }

    fn double_slices(&mut self, register: u8) -> Value {
        let id = self.get(register);
        if let Some(slices) = self.node(id).slices {
            return slices;
        }
        let words = self.words(id);
        let slices = self.shuffle(words, words, SWAPPED);
        let slices = self.cast(F64X2, slices);
        self.node(id).slices = Some(slices);
        slices
    }

    fn set_double_slices(&mut self, i: Instruction, slices: Value) {
        let words = self.shuffle(slices, slices, SWAPPED);
        let words = self.cast(I32X4, words);
        self.put_node(i.rt, Node { words: Some(words), slices: Some(slices), ..Node::default() });
    }

    /// The rounded sum, and its error, exactly.
    fn two_sum(&mut self, a: Value, b: Value) -> (Value, Value) {
        let sum = self.b.ins().fadd(a, b);
        let of_b = self.b.ins().fsub(sum, a);
        let of_a = self.b.ins().fsub(sum, of_b);
        let rest_of_a = self.b.ins().fsub(a, of_a);
        let rest_of_b = self.b.ins().fsub(b, of_b);
        (sum, self.b.ins().fadd(rest_of_a, rest_of_b))
    }

    /// The rounded product, and its error, exactly.
    fn two_product(&mut self, a: Value, b: Value) -> (Value, Value) {
        let product = self.b.ins().fmul(a, b);
        let negated = self.b.ins().fneg(product);
        (product, self.b.ins().fma(a, b, negated))
    }

    /// Emits code that finds the rounding errors, and runs unless the FPSCR has the inexact flags
    /// of both slices already.
    fn unless_inexact(&mut self, errors: impl FnOnce(&mut Self) -> Errors) -> Errors {
        let flags = match self.unverified.inexact_flags {
            Some(flags) => flags,
            None => self.load_inexact_flags(),
        };
        let unknown = self.b.create_block();
        let continuation = self.b.create_block();
        let none = self.splat(0);
        self.b.ins().brif(flags, continuation, &[none.into(), none.into()], unknown, &[]);
        self.b.switch_to_block(unknown);
        let Errors { inexact, undecided } = errors(self);
        self.b.ins().jump(continuation, &[inexact.into(), undecided.into()]);
        self.b.switch_to_block(continuation);
        Errors {
            inexact: self.b.append_block_param(continuation, I32X4),
            undecided: self.b.append_block_param(continuation, I32X4),
        }
    }

    /// Whether the FPSCR had both inexact flags at the last commit.
    fn load_inexact_flags(&mut self) -> Value {
        let fpscr = self.load_field(I32X4, field::FPSCR);
        let words = [1, 2].map(|lane| self.b.ins().extractlane(fpscr, lane));
        let both = self.b.ins().band(words[0], words[1]);
        let flags = self.b.ins().band_imm_u(both, i64::from(INEXACT[1]));
        self.unverified.inexact_flags = Some(flags);
        flags
    }

    fn errors_of_sum(&mut self, a: Value, b: Value) -> Errors {
        let (_, error) = self.two_sum(a, b);
        self.errors_of(error)
    }

    fn errors_of_product(&mut self, a: Value, b: Value) -> Errors {
        let (_, error) = self.two_product(a, b);
        self.errors_of(error)
    }

    fn errors_of(&mut self, error: Value) -> Errors {
        Errors { inexact: self.is_not_zero(error), undecided: self.splat(0) }
    }

    /// The errors of `a * b + t`. The exact value less the result is the sum of `rest`, the sum's
    /// error and the product's error.
    fn errors_of_fused(&mut self, a: Value, b: Value, t: Value, fused: Value) -> Errors {
        let (product, product_error) = self.two_product(a, b);
        let (sum, sum_error) = self.two_sum(product, t);
        let negated = self.b.ins().fneg(fused);
        let (rest, lost) = self.two_sum(sum, negated);
        let undecided = self.is_not_zero(lost);
        let (rest, error) = self.two_sum(rest, sum_error);
        let (rest, last) = self.two_sum(rest, product_error);
        // If `last` isn't zero, rest + last is no double, so it isn't -error.
        let is_more = self.is_not_zero(last);
        let negated = self.b.ins().fneg(error);
        let differs = self.differ(rest, negated);
        Errors { inexact: self.b.ins().bor(is_more, differs), undecided }
    }

    fn is_not_zero(&mut self, value: Value) -> Value {
        let zero = self.splat(0);
        let zero = self.cast(F64X2, zero);
        self.differ(value, zero)
    }

    fn differ(&mut self, a: Value, b: Value) -> Value {
        let mask = self.b.ins().fcmp(FloatCC::NotEqual, a, b);
        self.cast(I32X4, mask)
    }

    /// Notes the flags of a result. A result that was rounded up to the smallest normal number
    /// was tiny for an SPU, and isn't for the host.
    fn note_double(&mut self, result: Value, errors: Errors, smallest: f64) {
        self.note_nan(result);
        self.note_special(errors.undecided);
        let smallest = self.constant_bytes(F64X2, [smallest.to_le_bytes(); 2].concat());
        let magnitude = self.b.ins().fabs(result);
        let is_smallest = self.b.ins().fcmp(FloatCC::Equal, magnitude, smallest);
        let is_smallest = self.cast(I32X4, is_smallest);
        self.note_special(is_smallest);
        let flags = self.vector(INEXACT);
        let flags = self.b.ins().band(errors.inexact, flags);
        self.raise(flags);
    }

    /// Notes slices with NaNs. The comparison also makes the host report denormal results of exact
    /// operations.
    fn note_nan(&mut self, result: Value) {
        let nan = self.b.ins().fcmp(FloatCC::Unordered, result, result);
        let nan = self.cast(I32X4, nan);
        self.note_special(nan);
    }

    fn note_special(&mut self, mask: Value) {
        self.fail_on(mask);
        self.unverified.arithmetic = true;
        self.unverified.double_precision = true;
    }
}
