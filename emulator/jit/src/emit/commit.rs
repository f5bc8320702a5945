//! Commits and exits.

use cranelift_codegen::ir::condcodes::{FloatCC, IntCC};
use cranelift_codegen::ir::{InstBuilder, MemFlagsData, Value, types};

use super::memory::{Address, Key};
use super::registers::Id;
use super::{Emitter, field};
use crate::cpu::Passage;
use crate::exit::Exit;
use crate::host;

/// The state from which the interpreter continues if the next commit fails.
pub(super) struct Committed {
    changed: Vec<(u8, Id)>,
    pc: u32,
    count: u32,
}

impl Committed {
    pub fn at(pc: u32) -> Self {
        Self { changed: Vec::new(), pc, count: 0 }
    }
}

/// A store that is held back until the next commit.
pub(super) struct Pending {
    pub address: Address,
    /// The quadword in the SPU's byte order, as in local store.
    pub bytes: Value,
    /// The quadword as the words of a register.
    pub words: Value,
}

/// Everything that the next commit must check.
#[derive(Default)]
pub(super) struct Unverified {
    /// In singles, and in double precision: whether there was arithmetic. The host's exception
    /// flags show how it went.
    pub arithmetic: bool,
    /// In singles: the largest operand of each lane, as bits without the sign, shifted left by
    /// one.
    pub magnitudes: Option<Value>,
    /// A mask of lanes with special operands or results.
    pub special: Option<Value>,
    /// Whether there was double precision, which units compute in one rounding mode only.
    pub double_precision: bool,
    /// In double precision: whether the FPSCR had the inexact flags of both slices.
    pub inexact_flags: Option<Value>,
    /// In doubles: the largest magnitude of each lane's results, before saturation.
    pub largest: Option<[Value; 2]>,
    /// In doubles: the bits of all magnitudes that were too small, combined with OR.
    pub tiny: Option<[Value; 2]>,
    /// With exact sums: a mask of sums that exceeded the largest number by less than a double's
    /// precision.
    pub above: Option<[Value; 2]>,
    /// Further flags, at their positions in the FPSCR.
    pub flags: Option<Value>,
    /// Not 0 if a watched quadword was accessed.
    pub watched: Option<Value>,
    /// Whether a load was of a quadword for which a store is held back.
    pub overlapping: Option<Value>,
    /// In doubles: a mask of lanes in which an estimate's operand was zero.
    pub zeros: Option<Value>,
}

impl Unverified {
    fn any_doubles(&self) -> bool {
        self.largest.is_some() || self.flags.is_some() || self.zeros.is_some()
    }
}

impl Emitter<'_> {
    /// Emits a commit: checks everything since the last commit, then stores what was held back.
    pub(super) fn commit(&mut self) {
        let raised = self.raised();
        let mut failures = Vec::new();
        self.find_specials(&mut failures);
        if let Some(RaisedFlags { uncertain, .. }) = raised {
            failures.extend(uncertain);
        }
        self.find_stores_into_code(&mut failures);
        failures.extend(self.unverified.overlapping);
        self.exit_if(&failures, Exit::FAILED);
        let watched: Vec<Value> = self.unverified.watched.into_iter().collect();
        self.exit_if(&watched, Exit::WATCHED);
        for n in 0..self.pending.len() {
            let Pending { address, bytes, .. } = self.pending[n];
            self.b.ins().store(MemFlagsData::trusted(), bytes, address.pointer, address.offset);
        }
        if let Some(RaisedFlags { fpscr, .. }) = raised {
            self.store_field(fpscr, field::FPSCR);
        }
        if !self.in_side_exit {
            self.pending.clear();
            self.unverified = Unverified::default();
            self.committed =
                Committed { changed: self.file.changed(), pc: self.pc, count: self.count };
        }
    }

    /// Exits with the state of the last commit if one of these values isn't 0.
    fn exit_if(&mut self, failures: &[Value], status: u32) {
        // One branch for all, because each takes the compiler long.
        let mut any = None;
        for &failure in failures {
            let word = match self.b.func.dfg.value_type(failure) {
                types::I32 => failure,
                _ => self.b.ins().uextend(types::I32, failure),
            };
            any = Some(self.or(any, word));
        }
        let Some(any) = any else { return };
        self.side_exit_if(any, |e| {
            let changed = std::mem::take(&mut e.committed.changed);
            e.write(&changed);
            e.committed.changed = changed;
            e.exit(status);
        });
    }

    /// Exits with the state of the last commit.
    pub(super) fn exit(&mut self, status: u32) {
        let number = self.word(self.number);
        self.store_field(number, field::UNIT);
        let pc = self.word(self.committed.pc);
        self.leave(status, pc, self.committed.count);
    }

    fn leave(&mut self, status: u32, pc: Value, count: u32) {
        self.round_toward_zero();
        self.log(count);
        self.store_field(pc, field::PC);
        let left = self.budget_left(count);
        self.store_field(left, field::BUDGET);
        let status = self.b.ins().iconst(types::I64, i64::from(status));
        self.b.ins().return_(&[status]);
    }

    /// Logs a passage of this many instructions, if any, and the targets of the hints among them.
    pub(super) fn log(&mut self, count: u32) {
        if !self.logs || count == 0 {
            return;
        }
        let flags = MemFlagsData::trusted();
        let at = self.load_field(types::I64, field::LOG);
        let passage = self.word(Passage { unit: self.number, count }.to_word());
        self.b.ins().store(flags, passage, at, 0);
        let mut end = 4;
        for n in 0..self.hints.len() {
            let (after, target) = self.hints[n];
            if after <= count {
                self.b.ins().store(flags, target, at, end);
                end += 4;
            }
        }
        let next = self.b.ins().iadd_imm_s(at, i64::from(end));
        self.store_field(next, field::LOG);
    }

    /// The budget that remains after this many instructions.
    pub(super) fn budget_left(&mut self, count: u32) -> Value {
        self.b.ins().iadd_imm_s(self.budget, -i64::from(count))
    }

    /// Commits, and jumps to the unit at `pc`, or to the exit stub if there is none.
    pub(super) fn chain_to(&mut self, pc: Value) {
        self.commit();
        self.round_toward_zero();
        self.write_back();
        self.log(self.count);
        let left = self.budget_left(self.count);
        let table = self.load_field(types::I64, field::TABLE);
        let wide = self.b.ins().uextend(types::I64, pc);
        let distance = self.b.ins().ishl_imm_u(wide, 1);
        let place = self.b.ins().iadd(table, distance);
        let target = self.b.ins().load(types::I64, MemFlagsData::trusted(), place, 0);
        let arguments = [self.registers, self.local_store, self.context, left, pc];
        self.b.ins().return_call_indirect(self.unit, target, &arguments);
    }

    /// Commits, and leaves the current instruction to the interpreter.
    pub(super) fn leave_to_interpreter(&mut self) {
        self.commit();
        self.write_back();
        let pc = self.word(self.pc);
        self.leave(Exit::INTERPRET, pc, self.count);
    }

    /// Whether local store differs from the code of the trace.
    pub(super) fn code_differs(&mut self) -> Value {
        let mut quadwords: Vec<(u32, [u8; 16], [u8; 16])> = Vec::new();
        for range in &self.code {
            for (pc, word) in (range.start..).step_by(4).zip(&range.words) {
                let (quadword, at) = (pc & !15, (pc & 15) as usize);
                if quadwords.last().is_none_or(|last| last.0 != quadword) {
                    quadwords.push((quadword, [0; 16], [0; 16]));
                }
                if let Some((_, bytes, mask)) = quadwords.last_mut() {
                    bytes[at..at + 4].copy_from_slice(&word.to_be_bytes());
                    mask[at..at + 4].fill(0xff);
                }
            }
        }
        let mut all = None;
        for (quadword, bytes, mask) in quadwords {
            let flags = MemFlagsData::trusted();
            let found = self.b.ins().load(types::I8X16, flags, self.local_store, quadword as i32);
            let expected = self.constant_bytes(types::I8X16, bytes.to_vec());
            let mut different = self.b.ins().bxor(found, expected);
            if mask != [0xff; 16] {
                let mask = self.constant_bytes(types::I8X16, mask.to_vec());
                different = self.b.ins().band(different, mask);
            }
            all = Some(self.or(all, different));
        }
        let Some(all) = all else {
            unreachable!("a trace has instructions");
        };
        self.b.ins().vany_true(all)
    }

    /// Combines `value` with the values gathered so far, if there are any.
    pub(super) fn or(&mut self, gathered: Option<Value>, value: Value) -> Value {
        match gathered {
            Some(gathered) => self.b.ins().bor(gathered, value),
            None => value,
        }
    }

    /// Has the next commit fail if `mask` has a lane that is not 0.
    pub(super) fn fail_on(&mut self, mask: Value) {
        self.unverified.special = Some(self.or(self.unverified.special, mask));
    }

    fn find_stores_into_code(&mut self, failures: &mut Vec<Value>) {
        let mut all = None;
        for n in 0..self.pending.len() {
            let address = self.pending[n].address;
            for range in 0..self.code.len() {
                let start = self.code[range].start & !15;
                let length = ((self.code[range].end() + 15) & !15) - start;
                let hit = match address.key {
                    Key::Constant(at) if at.wrapping_sub(start) >= length => continue,
                    _ => {
                        let from = self.b.ins().iadd_imm_s(address.masked, -i64::from(start));
                        let length = self.word(length);
                        self.b.ins().icmp(IntCC::UnsignedLessThan, from, length)
                    }
                };
                all = Some(self.or(all, hit));
            }
        }
        failures.extend(all);
    }

    /// Adds conditions under which the host's results may differ from an SPU's.
    fn find_specials(&mut self, failures: &mut Vec<Value>) {
        let mut special = self.unverified.special;
        if let Some(magnitudes) = self.unverified.magnitudes {
            // An exponent of 255.
            let from = self.splat(0xff00_0000);
            let beyond = self.b.ins().icmp(IntCC::UnsignedGreaterThanOrEqual, magnitudes, from);
            special = Some(self.or(special, beyond));
        }
        if let Some(special) = special {
            failures.push(self.b.ins().vany_true(special));
        }
        if self.unverified.arithmetic {
            self.call_with_context(host::read_mxcsr);
            let mxcsr = self.load_field(types::I32, field::MXCSR);
            failures.push(self.b.ins().band_imm_u(mxcsr, i64::from(host::EXCEPTIONS)));
        }
        if self.unverified.double_precision {
            let modes = self.load_field(types::I32, field::FPSCR);
            failures.push(self.b.ins().band_imm_u(modes, ROUNDING_MODES));
        }
    }

    /// In doubles: the FPSCR including the flags raised since the last commit.
    fn raised(&mut self) -> Option<RaisedFlags> {
        if !self.unverified.any_doubles() {
            return None;
        }
        let mut flags = self.unverified.flags;
        let old = self.load_field(types::I32X4, field::FPSCR);
        let mut uncertain = None;
        if let (Some(largest), Some(tiny)) = (self.unverified.largest, self.unverified.tiny) {
            let limit = self.double(LARGEST);
            let beyond = largest.map(|l| self.b.ins().fcmp(FloatCC::GreaterThan, l, limit));
            let mut overflow = self.narrow_mask(beyond);
            if let Some(above) = self.unverified.above {
                let above = self.narrow_mask(above);
                overflow = self.b.ins().bor(overflow, above);
            }
            let limit = self.double(BEYOND_IEEE);
            let beyond = largest.map(|l| self.b.ins().fcmp(FloatCC::GreaterThanOrEqual, l, limit));
            let different = self.narrow_mask(beyond);
            let zero = self.constant_bytes(types::I64X2, vec![0; 16]);
            let not_zero = tiny.map(|t| self.b.ins().icmp(IntCC::NotEqual, t, zero));
            let underflow = self.narrow_mask(not_zero);
            for (mask, bits) in [(overflow, 4), (underflow, 3), (different, 1)] {
                let bits = self.splat(bits);
                let raised = self.b.ins().band(mask, bits);
                flags = Some(self.or(flags, raised));
            }
            if !self.mode.exact_sums {
                uncertain = Some(self.uncertain(largest, old));
            }
        }
        let mut fpscr = old;
        if let Some(flags) = flags {
            fpscr = self.b.ins().bor(fpscr, flags);
        }
        if let Some(zeros) = self.unverified.zeros {
            // Division by zero has one flag a lane: bits 0x800 to 0x100 of the last word.
            let reversed = self.shuffle(zeros, zeros, REVERSED_WORDS);
            let reversed = self.cast(types::I32X4, reversed);
            let bits = self.b.ins().vhigh_bits(types::I32, reversed);
            let bits = self.b.ins().ishl_imm_u(bits, 8);
            let none = self.vector([0; 4]);
            let raised = self.b.ins().insertlane(none, bits, 3);
            fpscr = self.b.ins().bor(fpscr, raised);
        }
        Some(RaisedFlags { fpscr, uncertain })
    }

    /// Whether it is uncertain that a result overflowed: it may be the largest number exactly, or
    /// exceed it by less than a double's precision. Where the overflow flag in `fpscr` is already
    /// set, this makes no difference.
    fn uncertain(&mut self, largest: [Value; 2], fpscr: Value) -> Value {
        let limit = self.double(LARGEST);
        let equal = largest.map(|l| self.b.ins().fcmp(FloatCC::Equal, l, limit));
        let equal = self.narrow_mask(equal);
        let four = self.splat(4);
        let up = self.b.ins().band(fpscr, four);
        let down = self.b.ins().icmp(IntCC::NotEqual, up, four);
        let uncertain = self.b.ins().band(equal, down);
        self.b.ins().vany_true(uncertain)
    }

    fn double(&mut self, value: f64) -> Value {
        let bytes = [value.to_le_bytes(); 2].concat();
        self.constant_bytes(types::F64X2, bytes)
    }
}

/// The SPU's largest number, (2 - 2^-23) * 2^128.
const LARGEST: f64 = f64::from_bits((1023 + 128) << 52 | 0xf_ffff_e000_0000);
/// 2^128, the smallest number beyond the range of IEEE singles.
const BEYOND_IEEE: f64 = f64::from_bits((1023 + 128) << 52);

/// The rounding modes of both slices in the first word of the FPSCR: 0 for to nearest.
const ROUNDING_MODES: i64 = 0xf00;

/// A shuffle that reverses the order of the words.
pub(super) const REVERSED_WORDS: [u8; 16] = [12, 13, 14, 15, 8, 9, 10, 11, 4, 5, 6, 7, 0, 1, 2, 3];

#[derive(Clone, Copy)]
struct RaisedFlags {
    fpscr: Value,
    /// Whether the flags are uncertain, so that the interpreter must continue.
    uncertain: Option<Value>,
}
