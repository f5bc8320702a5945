//! Commits, and the ways out.

use cranelift_codegen::ir::condcodes::{FloatCC, IntCC};
use cranelift_codegen::ir::{InstBuilder, MemFlagsData, Value, types};

use super::memory::{Address, Key};
use super::registers::Id;
use super::{Emitter, field};
use crate::cpu::{Exit, Passage};
use crate::host;

/// From where the interpreter goes on if the next commit fails.
pub(super) struct Committed {
    changed: Vec<(u8, Id)>,
    pc: u32,
    count: u32,
}

impl Committed {
    pub fn at(pc: u32) -> Self {
        Self {
            changed: Vec::new(),
            pc,
            count: 0,
        }
    }
}

/// A store that is held back.
pub(super) struct Pending {
    pub address: Address,
    /// As a quadword of local store, in the SPU's order.
    pub bytes: Value,
    /// As a register's words.
    pub words: Value,
}

/// What has to be looked at before the next commit.
#[derive(Default)]
pub(super) struct Unverified {
    /// In singles: there was arithmetic, of whose exceptions the host tells.
    pub arithmetic: bool,
    /// In singles: operands without their signs, shifted left by one; the largest of each lane.
    pub magnitudes: Option<Value>,
    /// In singles: lanes that something found special.
    pub special: Option<Value>,
    /// In doubles: the largest magnitudes of results before saturation.
    pub largest: Option<[Value; 2]>,
    /// In doubles: bits of magnitudes that were too small.
    pub tiny: Option<[Value; 2]>,
    /// In exact doubles: where a sum was above the largest number by less than a double shows.
    pub above: Option<[Value; 2]>,
    /// In doubles: further flags, in the lanes of the FPSCR.
    pub flags: Option<Value>,
    /// In doubles: lanes in which a zero was divided by.
    pub zeros: Option<Value>,
}

impl Unverified {
    fn any_doubles(&self) -> bool {
        self.largest.is_some() || self.flags.is_some() || self.zeros.is_some()
    }
}

impl Emitter<'_> {
    /// All that happened so far is to stay.
    pub(super) fn commit(&mut self) {
        let raised = self.raised();
        let mut failures = Vec::new();
        self.find_specials(&mut failures);
        if let Some(Raised { undecided, .. }) = raised {
            failures.extend(undecided);
        }
        self.find_stores_into_code(&mut failures);
        self.fail_if(&failures);
        for n in 0..self.pending.len() {
            let Pending { address, bytes, .. } = self.pending[n];
            self.b.ins().store(
                MemFlagsData::trusted(),
                bytes,
                address.pointer,
                address.offset,
            );
        }
        if let Some(Raised { fpscr, .. }) = raised {
            self.store_field(fpscr, field::FPSCR);
        }
        if !self.aside {
            self.pending.clear();
            self.unverified = Unverified::default();
            self.committed = Committed {
                changed: self.file.changed(),
                pc: self.pc,
                count: self.count,
            };
        }
    }

    fn fail_if(&mut self, failures: &[Value]) {
        if failures.is_empty() {
            return;
        }
        let fail = self.b.create_block();
        self.b.set_cold_block(fail);
        for &failure in failures {
            let on = self.b.create_block();
            self.b.ins().brif(failure, fail, &[], on, &[]);
            self.b.switch_to_block(on);
        }
        let Some(on) = self.b.current_block() else {
            unreachable!("a block was switched to");
        };
        self.b.switch_to_block(fail);
        let aside = std::mem::replace(&mut self.aside, true);
        let changed = std::mem::take(&mut self.committed.changed);
        self.write(&changed);
        self.committed.changed = changed;
        self.exit(Exit::FAILED);
        self.aside = aside;
        self.b.switch_to_block(on);
    }

    /// Leaves as the last commit was.
    pub(super) fn exit(&mut self, status: u32) {
        let number = self.word(self.number);
        self.store_field(number, field::UNIT);
        let pc = self.word(self.committed.pc);
        self.leave(status, pc, self.committed.count);
    }

    fn leave(&mut self, status: u32, pc: Value, count: u32) {
        self.log(count);
        self.store_field(pc, field::PC);
        let left = self.budget_left(count);
        self.store_field(left, field::BUDGET);
        let status = self.b.ins().iconst(types::I64, i64::from(status));
        self.b.ins().return_(&[status]);
    }

    /// Writes down that this many instructions of the unit have run, if any, and the targets of the
    /// hints among them.
    pub(super) fn log(&mut self, count: u32) {
        if !self.logs || count == 0 {
            return;
        }
        let flags = MemFlagsData::trusted();
        let at = self.load_field(types::I64, field::LOG);
        let passage = self.word(Passage::new(self.number, count).to_word());
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

    /// The budget that is left after this many instructions.
    pub(super) fn budget_left(&mut self, count: u32) -> Value {
        self.b.ins().iadd_imm_s(self.budget, -i64::from(count))
    }

    /// Commits, and leaves for the unit at `pc`, if there is one.
    pub(super) fn leave_for(&mut self, pc: Value) {
        self.commit();
        self.write_back();
        self.log(self.count);
        let left = self.budget_left(self.count);
        let table = self.load_field(types::I64, field::TABLE);
        let wide = self.b.ins().uextend(types::I64, pc);
        let distance = self.b.ins().ishl_imm_u(wide, 1);
        let place = self.b.ins().iadd(table, distance);
        let target = self
            .b
            .ins()
            .load(types::I64, MemFlagsData::trusted(), place, 0);
        let arguments = [self.registers, self.local_store, self.context, left, pc];
        self.b
            .ins()
            .return_call_indirect(self.unit, target, &arguments);
    }

    /// Commits, and leaves the instruction at hand to the interpreter.
    pub(super) fn leave_to_interpreter(&mut self) {
        self.commit();
        self.write_back();
        let pc = self.word(self.pc);
        self.leave(Exit::INTERPRET, pc, self.count);
    }

    /// Whether the code of the trace differs from local store.
    pub(super) fn code_differs(&mut self) -> Value {
        let mut quadwords: Vec<(u32, [u8; 16], [u8; 16])> = Vec::new();
        for range in &self.code {
            for (pc, word) in (range.start..).step_by(4).zip(&range.words) {
                let (quadword, at) = (pc & !15, (pc & 15) as usize);
                if quadwords.last().is_none_or(|last| last.0 != quadword) {
                    quadwords.push((quadword, [0; 16], [0; 16]));
                }
                if let Some((_, bytes, care)) = quadwords.last_mut() {
                    bytes[at..at + 4].copy_from_slice(&word.to_be_bytes());
                    care[at..at + 4].fill(0xff);
                }
            }
        }
        let mut all = None;
        for (quadword, bytes, care) in quadwords {
            let flags = MemFlagsData::trusted();
            let found = self
                .b
                .ins()
                .load(types::I8X16, flags, self.local_store, quadword as i32);
            let expected = self.constant_bytes(types::I8X16, bytes.to_vec());
            let mut different = self.b.ins().bxor(found, expected);
            if care != [0xff; 16] {
                let care = self.constant_bytes(types::I8X16, care.to_vec());
                different = self.b.ins().band(different, care);
            }
            all = Some(self.or(all, different));
        }
        let Some(all) = all else {
            unreachable!("a trace has instructions");
        };
        self.b.ins().vany_true(all)
    }

    /// `value`, or what has gathered already and `value`.
    pub(super) fn or(&mut self, gathered: Option<Value>, value: Value) -> Value {
        match gathered {
            Some(gathered) => self.b.ins().bor(gathered, value),
            None => value,
        }
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

    /// In singles: what the host did that an SPU does not.
    fn find_specials(&mut self, failures: &mut Vec<Value>) {
        let mut special = self.unverified.special;
        if let Some(magnitudes) = self.unverified.magnitudes {
            // Exponents of 255.
            let from = self.splat(0xff00_0000);
            let beyond = self
                .b
                .ins()
                .icmp(IntCC::UnsignedGreaterThanOrEqual, magnitudes, from);
            special = Some(self.or(special, beyond));
        }
        if let Some(special) = special {
            failures.push(self.b.ins().vany_true(special));
        }
        if self.unverified.arithmetic {
            let reader = host::read_mxcsr as *const () as i64;
            let reader = self.b.ins().iconst(types::I64, reader);
            self.b
                .ins()
                .call_indirect(self.mxcsr_reader, reader, &[self.context]);
            let mxcsr = self.load_field(types::I32, field::MXCSR);
            failures.push(self.b.ins().band_imm_u(mxcsr, i64::from(host::EXCEPTIONS)));
        }
    }

    /// In doubles: the FPSCR with the flags that were raised since the last commit.
    fn raised(&mut self) -> Option<Raised> {
        if !self.unverified.any_doubles() {
            return None;
        }
        let mut flags = self.unverified.flags;
        let old = self.load_field(types::I32X4, field::FPSCR);
        let mut undecided = None;
        if let (Some(largest), Some(tiny)) = (self.unverified.largest, self.unverified.tiny) {
            let limit = self.double(LARGEST);
            let beyond = largest.map(|l| self.b.ins().fcmp(FloatCC::GreaterThan, l, limit));
            let mut overflow = self.narrow_mask(beyond);
            if let Some(above) = self.unverified.above {
                let above = self.narrow_mask(above);
                overflow = self.b.ins().bor(overflow, above);
            }
            let limit = self.double(IEEE_LACKS);
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
            if !self.way.exact_sums {
                undecided = Some(self.doubtful(largest, old));
            }
        }
        let mut fpscr = old;
        if let Some(flags) = flags {
            fpscr = self.b.ins().bor(fpscr, flags);
        }
        if let Some(zeros) = self.unverified.zeros {
            // Bits 0x800 to 0x100 of the last word.
            let reversed = self.shuffle(zeros, zeros, REVERSED_WORDS);
            let reversed = self.cast(types::I32X4, reversed);
            let bits = self.b.ins().vhigh_bits(types::I32, reversed);
            let bits = self.b.ins().ishl_imm_u(bits, 8);
            let none = self.vector([0; 4]);
            let raised = self.b.ins().insertlane(none, bits, 3);
            fpscr = self.b.ins().bor(fpscr, raised);
        }
        Some(Raised { fpscr, undecided })
    }

    /// Whether a result may be above the largest number by less than a double shows, or be that
    /// number exactly. Where the flag of overflow is up in `fpscr` that makes no difference.
    fn doubtful(&mut self, largest: [Value; 2], fpscr: Value) -> Value {
        let limit = self.double(LARGEST);
        let equal = largest.map(|l| self.b.ins().fcmp(FloatCC::Equal, l, limit));
        let equal = self.narrow_mask(equal);
        let four = self.splat(4);
        let up = self.b.ins().band(fpscr, four);
        let down = self.b.ins().icmp(IntCC::NotEqual, up, four);
        let doubtful = self.b.ins().band(equal, down);
        self.b.ins().vany_true(doubtful)
    }

    fn double(&mut self, value: f64) -> Value {
        let bytes = [value.to_le_bytes(); 2].concat();
        self.constant_bytes(types::F64X2, bytes)
    }
}

/// The SPU's largest number, (2 - 2^-23) * 2^128.
const LARGEST: f64 = f64::from_bits((1023 + 128) << 52 | 0xf_ffff_e000_0000);
/// 2^128, the first number that IEEE lacks.
const IEEE_LACKS: f64 = f64::from_bits((1023 + 128) << 52);

/// The words from the last to the first.
pub(super) const REVERSED_WORDS: [u8; 16] = [12, 13, 14, 15, 8, 9, 10, 11, 4, 5, 6, 7, 0, 1, 2, 3];

#[derive(Clone, Copy)]
struct Raised {
    fpscr: Value,
    /// Whether something has to be left to the interpreter.
    undecided: Option<Value>,
}
