//! Translates a trace to a function of the host.
//!
//! The function follows the trace. It holds SPU registers in host values, and writes the changed
//! ones back where it exits. Where the SPU leaves the path of the trace, the function takes a side
//! exit.
//!
//! **Commits.** The function holds back stores and writes no registers until a commit has checked
//! everything since the last one: no float operation met numbers that the host treats differently,
//! no store hits the code of the trace itself, and no load was of a quadword for which a store is
//! held back. If a check fails, the function fails: it leaves the state of the last commit, and
//! the interpreter continues from there. There is a commit at every exit, and before loads that
//! the [`FloatMode`] names.
//!
//! **Loops.** Before a loop begins, the function compares its code with local store, and prepares
//! what the loop needs of registers that it never writes.
//!
//! Invariant: emitting a side exit doesn't change the emitter's state, because the trace continues
//! from the state before the exit.

mod branch;
mod bytes;
mod commit;
mod convert;
mod double_precision;
mod doubles;
mod estimate;
mod float;
mod integer;
mod lanes;
mod memory;
mod operation;
mod registers;
mod shift_rotate;
mod singles;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::{
    AbiParam, Block, InstBuilder, MemFlagsData, SigRef, Signature, Value, types,
};
use cranelift_codegen::isa::{CallConv, TargetFrontendConfig};
use cranelift_frontend::FunctionBuilder;

use crate::exit::Exit;
use crate::float_mode::FloatMode;
use crate::trace::{Range, Step, Trace, code_address};
use crate::unit::{Estimates, Tier, UnitOptions};
use commit::{Committed, Pending, Unverified};
use registers::Registers;
use spu_isa::timing::hints_by_register;
use spu_isa::{Class, Op, RegisterSet};

/// Offsets of [`Context`](crate::host::Context)'s fields.
pub(crate) mod field {
    use crate::host::Context;
    use std::mem::offset_of;

    pub const FPSCR: i32 = offset_of!(Context, fpscr) as i32;
    pub const SINK: i32 = offset_of!(Context, sink) as i32;
    pub const TABLE: i32 = offset_of!(Context, table) as i32;
    pub const ENTRIES: i32 = offset_of!(Context, entries) as i32;
    pub const LOG: i32 = offset_of!(Context, log) as i32;
    pub const WATCHED: i32 = offset_of!(Context, watched) as i32;
    pub const BUDGET: i32 = offset_of!(Context, budget) as i32;
    pub const PC: i32 = offset_of!(Context, pc) as i32;
    pub const UNIT: i32 = offset_of!(Context, unit) as i32;
    pub const MXCSR: i32 = offset_of!(Context, mxcsr) as i32;
}

/// The signature of units. The arguments are registers, local store, context, budget, program
/// counter. The result is the reason for the exit. Units end with tail calls to other units.
pub(crate) fn unit_signature() -> Signature {
    let mut signature = Signature::new(CallConv::Tail);
    signature.params.extend([AbiParam::new(types::I64); 4]);
    signature.params.push(AbiParam::new(types::I32));
    signature.returns.push(AbiParam::new(types::I64));
    signature
}

/// The number of entries after which a baseline unit reports that it is hot, and does so again. It
/// is a power of two.
const HOT_ENTRIES: u32 = 1 << 14;

/// Emits the function of one trace.
pub(crate) struct Emitter<'a> {
    b: FunctionBuilder<'a>,
    mode: FloatMode,
    tier: Tier,
    /// Whether the current instruction is computed in doubles, or commits before it loads.
    in_doubles: bool,
    /// Whether the host rounds to nearest here, for double precision.
    rounds_to_nearest: bool,
    /// Whether the host rounds to nearest where the trace's loop begins.
    loop_rounds_to_nearest: bool,
    estimates: Estimates,
    number: u32,
    /// Whether each passage through the unit is logged.
    logs: bool,
    /// Whether accesses to watched quadwords are left to the interpreter.
    watches: bool,
    /// The targets of hints by register, each with the number of instructions up to the hint.
    hints: Vec<(u32, Value)>,
    /// The code of the trace, as ranges of consecutive words.
    code: Vec<Range>,
    registers: Value,
    local_store: Value,
    context: Value,
    /// The budget of instructions when the function, or the current iteration of its loop, began.
    budget: Value,
    /// The block to which the trace's loop jumps back, if the trace is a loop.
    entry: Block,
    unit: SigRef,
    context_function: SigRef,
    file: Registers,
    committed: Committed,
    pending: Vec<Pending>,
    unverified: Unverified,
    /// The number of instructions before the one at `pc`.
    count: u32,
    pc: u32,
    /// Whether a side exit is being emitted.
    in_side_exit: bool,
    has_fallback: bool,
}

impl<'a> Emitter<'a> {
    /// Creates an emitter for a trace, and begins its function.
    pub fn new(
        mut b: FunctionBuilder<'a>,
        trace: &Trace,
        (mode, tier): (FloatMode, Tier),
        estimates: Estimates,
        number: u32,
        options: UnitOptions,
    ) -> Self {
        let first = b.create_block();
        b.append_block_params_for_function_params(first);
        b.switch_to_block(first);
        let &[registers, local_store, context, budget, _] = b.block_params(first) else {
            unreachable!("the signature has five parameters");
        };
        let entry = b.create_block();
        let unit = b.import_signature(unit_signature());
        let mut signature = Signature::new(CallConv::PreserveAll);
        signature.params.push(AbiParam::new(types::I64));
        let context_function = b.import_signature(signature);
        let start = trace.start();
        Self {
            b,
            mode,
            tier,
            in_doubles: false,
            rounds_to_nearest: false,
            loop_rounds_to_nearest: false,
            estimates,
            number,
            logs: options.logs,
            watches: options.watches,
            hints: Vec::new(),
            code: trace.ranges().to_vec(),
            registers,
            local_store,
            context,
            budget,
            entry,
            unit,
            context_function,
            file: Registers::default(),
            committed: Committed::at(start),
            pending: Vec::new(),
            unverified: Unverified::default(),
            count: 0,
            pc: start,
            in_side_exit: false,
            has_fallback: false,
        }
    }

    /// Emits the function. Returns whether another [`FloatMode`] may fail less often.
    pub fn emit(mut self, trace: &Trace, target: TargetFrontendConfig) -> bool {
        self.begin(trace);
        self.enter(trace.steps().len());
        for step in trace.steps() {
            self.step(step);
        }
        self.end(trace);
        self.b.seal_all_blocks();
        self.b.finalize(target);
        self.has_fallback
    }

    /// Emits the way to the block to which a loop returns. The unit exits there if local store does
    /// not hold its code. A loop whose only arithmetic is double precision keeps the host's
    /// rounding mode from one iteration to the next.
    fn begin(&mut self, trace: &Trace) {
        let different = self.code_differs();
        self.side_exit_if(different, |e| e.exit(Exit::STALE));
        if trace.is_loop() {
            self.prepare(trace);
        }
        let classes = || trace.steps().iter().map(|step| step.instruction.op.row().class);
        let is_single = |class| matches!(class, Class::Fp6 | Class::Fp7);
        if trace.is_loop() && !classes().any(is_single) && classes().any(|c| c == Class::Fpd) {
            self.round_for(Class::Fpd);
        }
        self.loop_rounds_to_nearest = self.rounds_to_nearest;
        self.b.ins().jump(self.entry, &[self.budget.into()]);
        self.budget = self.b.append_block_param(self.entry, types::I64);
        self.b.switch_to_block(self.entry);
    }

    /// Emits what a loop needs of registers that it never writes: addresses and the controls of
    /// shuffles.
    fn prepare(&mut self, trace: &Trace) {
        use Op::{Lqd, Lqx, Shufb, Stqd, Stqx};
        let steps = || trace.steps().iter().map(|step| step.instruction);
        let written = steps().fold(RegisterSet::EMPTY, |set, i| set.union(i.writes()));
        for i in steps() {
            let addresses: &[u8] = match i.op {
                Lqd | Stqd => &[i.ra],
                Lqx | Stqx => &[i.ra, i.rb],
                _ => &[],
            };
            for &register in addresses.iter().filter(|&&register| !written.contains(register)) {
                self.scalar(register);
            }
            if i.op == Shufb && !written.contains(i.rc) {
                let control = self.get(i.rc);
                self.shuffle_control(control);
            }
        }
    }

    fn step(&mut self, step: &Step) {
        self.pc = step.pc;
        self.in_doubles = self.mode.in_doubles.contains(self.count as usize);
        self.round_for(step.instruction.op.row().class);
        if !self.branch(step.instruction, step.next) {
            self.operation(step.instruction);
        }
        self.count += 1;
        if self.logs && hints_by_register(step.instruction) {
            let target = self.scalar(step.instruction.ra);
            self.hints.push((self.count, target));
        }
    }

    fn end(&mut self, trace: &Trace) {
        let Some(last) = trace.steps().last() else {
            return;
        };
        self.pc = code_address(last.next);
        if trace.is_loop() {
            self.commit();
            self.write_back();
            if !self.loop_rounds_to_nearest {
                self.round_toward_zero();
            }
            self.log(self.count);
            let left = self.budget_left(self.count);
            self.b.ins().jump(self.entry, &[left.into()]);
        } else {
            let pc = self.word(self.pc);
            self.chain_to(pc);
        }
    }

    /// Emits the start of a unit or of an iteration. The unit exits unless the budget covers all
    /// its instructions. Then it counts the entry, and a baseline unit may exit as hot.
    fn enter(&mut self, steps: usize) {
        let longest = self.b.ins().iconst(types::I64, steps as i64);
        let short = self.b.ins().icmp(IntCC::SignedLessThan, self.budget, longest);
        self.side_exit_if(short, |e| e.exit(Exit::LEFT));
        let at = self.load_field(types::I64, field::ENTRIES);
        let flags = MemFlagsData::trusted();
        let offset = 4 * self.number as i32;
        let entries = self.b.ins().load(types::I32, flags, at, offset);
        let entries = self.b.ins().iadd_imm_s(entries, 1);
        self.b.ins().store(flags, entries, at, offset);
        if self.tier == Tier::Baseline {
            let passed = self.b.ins().band_imm_u(entries, i64::from(HOT_ENTRIES - 1));
            let zero = self.word(0);
            let hot = self.b.ins().icmp(IntCC::Equal, passed, zero);
            self.side_exit_if(hot, |e| e.exit(Exit::HOT));
        }
    }

    /// Emits a side exit, taken if `condition` holds. Code emitted afterwards runs if it doesn't.
    fn side_exit_if(&mut self, condition: Value, exit: impl FnOnce(&mut Self)) {
        let aside = self.b.create_block();
        let continuation = self.b.create_block();
        self.b.set_cold_block(aside);
        self.b.ins().brif(condition, aside, &[], continuation, &[]);
        self.b.switch_to_block(aside);
        let outer = std::mem::replace(&mut self.in_side_exit, true);
        exit(self);
        self.in_side_exit = outer;
        self.b.switch_to_block(continuation);
    }

    fn load_field(&mut self, ty: types::Type, offset: i32) -> Value {
        let flags = MemFlagsData::trusted();
        self.b.ins().load(ty, flags, self.context, offset)
    }

    fn store_field(&mut self, value: Value, offset: i32) {
        let flags = MemFlagsData::trusted();
        self.b.ins().store(flags, value, self.context, offset);
    }

    /// Calls a function of the host that takes the context and preserves all registers.
    fn call_with_context(&mut self, function: extern "C" fn()) {
        let function = function as *const () as i64;
        let function = self.b.ins().iconst(types::I64, function);
        self.b.ins().call_indirect(self.context_function, function, &[self.context]);
    }

    fn word(&mut self, value: u32) -> Value {
        self.b.ins().iconst(types::I32, i64::from(value))
    }
}
