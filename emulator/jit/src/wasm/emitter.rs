//! The function of a trace: its registers, exits and loop.

use spu_isa::{Instruction, Op, Target};
use wasm_encoder::{BlockType, InstructionSink, MemArg, MemArgTarget, ValType};

use super::{INTERPRET_TYPE, Places, UNIT_TYPE, field};
use crate::exit::Exit;
use crate::float_mode::FloatMode;
use crate::trace::{Step, Trace, code_address};

/// The function's parameters.
pub(super) const REGISTERS: u32 = 0;
pub(super) const LOCAL_STORE: u32 = 1;
const CONTEXT: u32 = 2;
const BUDGET: u32 = 3;
/// The program counter, and from then on any address.
pub(super) const ADDRESS: u32 = 4;
const PARAMETERS: u32 = 5;

/// Facts about a register's value.
#[derive(Clone, Copy, Default)]
pub(super) struct Facts {
    /// No lane is a denormal single.
    pub no_denormals: bool,
    /// Each lane is all ones or all zeros.
    pub mask: bool,
}

#[derive(Clone, Copy, Default)]
struct Register {
    local: Option<u32>,
    /// Whether the local has the value.
    held: bool,
    /// The value, if it is known. It may be in no local.
    constant: Option<[u32; 4]>,
    /// Whether the value differs from that in memory.
    changed: bool,
    facts: Facts,
}

pub(super) struct Emitter<'a> {
    trace: &'a Trace,
    pub mode: &'a FloatMode,
    number: u32,
    pub places: Places,
    body: Vec<u8>,
    registers: [Register; 128],
    /// The number of locals that are vectors.
    vectors: u32,
    temporaries: Vec<u32>,
    pub pc: u32,
    /// The number of instructions before the one at `pc`.
    pub count: u32,
}

pub(super) const fn quadword(offset: u32) -> MemArg {
    MemArg { align: 4, ..word(offset) }
}

pub(super) const fn word(offset: u32) -> MemArg {
    MemArg { offset: offset as u64, align: 2, target: MemArgTarget::Memory(0), ordering: None }
}

pub(super) const fn splat(word: u32) -> i128 {
    vector([word; 4])
}

pub(super) const fn vector(words: [u32; 4]) -> i128 {
    let [a, b, c, d] = words;
    (a as u128 | (b as u128) << 32 | (c as u128) << 64 | (d as u128) << 96) as i128
}

impl<'a> Emitter<'a> {
    pub fn new(trace: &'a Trace, mode: &'a FloatMode, number: u32, places: Places) -> Self {
        Self {
            trace,
            mode,
            number,
            places,
            body: Vec::new(),
            registers: [Register::default(); 128],
            vectors: 0,
            temporaries: Vec::new(),
            pc: trace.start(),
            count: 0,
        }
    }

    /// Emits the function. Returns its locals and its body.
    pub fn emit(mut self) -> (Vec<(u32, ValType)>, Vec<u8>) {
        self.exit_if_stale();
        let is_loop = self.trace.is_loop();
        if is_loop {
            self.hold_all();
            self.f().loop_(BlockType::Empty);
        }
        self.enter();
        for step in self.trace.steps() {
            self.step(step);
        }
        self.pc = self.trace.steps().last().map_or(self.pc, |last| code_address(last.next));
        if is_loop {
            self.go_round();
        } else {
            self.chain_to(Some(self.pc));
            self.f().end();
        }
        (vec![(self.vectors, ValType::V128)], self.body)
    }

    fn step(&mut self, step: &Step) {
        self.pc = step.pc;
        if !self.branch(step.instruction, step.next) {
            self.operation(step.instruction);
        }
        self.count += 1;
    }

    /// Loads all registers that the loop reads or writes, because its locals keep them from one
    /// iteration to the next.
    fn hold_all(&mut self) {
        for step in self.trace.steps() {
            let i = step.instruction;
            let row = i.op.row();
            for &field in row.reads {
                self.hold(i.register(field));
            }
            if row.target == Target::Rt {
                self.hold(i.rt);
                self.registers[usize::from(i.rt)].changed = true;
            }
        }
    }

    fn go_round(&mut self) {
        for register in 0..128 {
            if !self.registers[usize::from(register)].held && self.constant(register).is_some() {
                self.hold(register);
            }
        }
        let count = self.count as i32;
        self.f().local_get(BUDGET).i32_const(count).i32_sub().local_set(BUDGET);
        self.f().br(0).end().unreachable().end();
    }

    fn enter(&mut self) {
        let steps = self.trace.steps().len() as i32;
        self.f().local_get(BUDGET).i32_const(steps).i32_lt_s().if_(BlockType::Empty);
        self.exit(Exit::LEFT);
        self.f().end();
        let entries = word(4 * self.number);
        let mut f = self.f();
        f.local_get(CONTEXT).i32_load(word(field::ENTRIES)).local_tee(ADDRESS);
        f.local_get(ADDRESS).i32_load(entries).i32_const(1).i32_add().i32_store(entries);
    }

    /// Exits if local store has other code than the trace. Only the trace's own stores could change
    /// it later, and these are left to the interpreter.
    fn exit_if_stale(&mut self) {
        let expected = self.places.code as i32;
        let mut at = 0;
        self.f().v128_const(0);
        for range in self.trace.ranges() {
            let end = range.end();
            let mut pc = range.start;
            while pc < end {
                // Whole quadwords as such.
                let (bytes, load): (u32, fn(&mut InstructionSink<'_>, MemArg)) = if end - pc >= 16 {
                    (16, |f, at| _ = f.v128_load(MemArg { align: 0, ..at }))
                } else {
                    (4, |f, at| _ = f.v128_load32_zero(at))
                };
                let mut f = self.f();
                load(f.local_get(LOCAL_STORE), word(pc));
                load(f.i32_const(expected), word(at));
                f.v128_xor().v128_or();
                pc += bytes;
                at += bytes;
            }
        }
        self.f().v128_any_true().if_(BlockType::Empty);
        self.exit(Exit::STALE);
        self.f().end();
    }

    /// The quadwords of the trace's code, as addresses of beginnings and ends.
    pub fn code(&self) -> impl Iterator<Item = (u32, u32)> + use<'a> {
        self.trace
            .ranges()
            .iter()
            .map(|range| (range.start & !15, range.end().next_multiple_of(16)))
    }

    /// Where instructions are added.
    pub fn f(&mut self) -> InstructionSink<'_> {
        InstructionSink::new(&mut self.body)
    }

    fn new_local(&mut self) -> u32 {
        self.vectors += 1;
        PARAMETERS + self.vectors - 1
    }

    /// One of the locals that keep values within an instruction.
    pub fn temporary(&mut self, number: usize) -> u32 {
        while self.temporaries.len() <= number {
            let local = self.new_local();
            self.temporaries.push(local);
        }
        self.temporaries[number]
    }

    fn local(&mut self, register: u8) -> u32 {
        let at = usize::from(register);
        let local = self.registers[at].local.unwrap_or_else(|| self.new_local());
        self.registers[at].local = Some(local);
        local
    }

    /// Has a local hold the register, so that [`push`](Self::push) may be called on ways that are
    /// not always taken.
    pub fn hold(&mut self, register: u8) {
        let local = self.local(register);
        let Register { held, constant, .. } = self.registers[usize::from(register)];
        if held {
            return;
        }
        let mut f = self.f();
        match constant {
            Some(words) => f.v128_const(vector(words)),
            None => f.local_get(REGISTERS).v128_load(quadword(16 * u32::from(register))),
        };
        f.local_set(local);
        self.registers[usize::from(register)].held = true;
    }

    /// Pushes a register's value.
    pub fn push(&mut self, register: u8) {
        if let Some(words) = self.constant(register) {
            self.f().v128_const(vector(words));
            return;
        }
        self.hold(register);
        let local = self.local(register);
        self.f().local_get(local);
    }

    /// Pushes the preferred word of a register.
    pub fn push_scalar(&mut self, register: u8) {
        match self.constant(register) {
            Some(words) => _ = self.f().i32_const(words[0] as i32),
            None => {
                self.push(register);
                self.f().i32x4_extract_lane(0);
            }
        }
    }

    pub fn constant(&self, register: u8) -> Option<[u32; 4]> {
        self.registers[usize::from(register)].constant
    }

    pub fn facts(&mut self, register: u8) -> &mut Facts {
        &mut self.registers[usize::from(register)].facts
    }

    /// Sets a register to the value on the stack.
    pub fn set(&mut self, register: u8) {
        self.set_with(register, Facts::default());
    }

    pub fn set_with(&mut self, register: u8, facts: Facts) {
        let local = self.local(register);
        self.f().local_set(local);
        self.registers[usize::from(register)] =
            Register { local: Some(local), held: true, constant: None, changed: true, facts };
    }

    pub fn set_constant(&mut self, register: u8, words: [u32; 4]) {
        let local = self.registers[usize::from(register)].local;
        let facts = Facts {
            no_denormals: words.iter().all(|word| word << 1 == 0 || word << 1 >> 24 != 0),
            mask: words.iter().all(|&word| word == 0 || word == u32::MAX),
        };
        self.registers[usize::from(register)] =
            Register { local, held: false, constant: Some(words), changed: true, facts };
    }

    /// Writes a register that differs from the one in memory.
    fn write(&mut self, register: u8) {
        let Register { constant, changed, .. } = self.registers[usize::from(register)];
        if !changed {
            return;
        }
        self.f().local_get(REGISTERS);
        match constant {
            Some(words) => _ = self.f().v128_const(vector(words)),
            None => {
                let local = self.local(register);
                self.f().local_get(local);
            }
        }
        self.f().v128_store(quadword(16 * u32::from(register)));
    }

    /// Has the interpreter run an instruction that uses registers only, and pushes its result.
    pub fn interpret(&mut self, i: Instruction) {
        for &field in i.op.row().reads {
            self.write(i.register(field));
        }
        let function = self.places.interpret as i32;
        let mut f = self.f();
        f.local_get(REGISTERS).local_get(CONTEXT).i32_const(field::FPSCR as i32).i32_add();
        f.i32_const(i.encode() as i32).i32_const(function).call_indirect(0, INTERPRET_TYPE);
        f.local_get(REGISTERS).v128_load(quadword(16 * u32::from(i.rt)));
    }

    /// As [`interpret`](Self::interpret), and sets the target.
    pub fn leave_out(&mut self, i: Instruction) {
        self.interpret(i);
        let no_denormals = matches!(i.op, Op::Fi | Op::Csflt | Op::Cuflt);
        self.set_with(i.rt, Facts { no_denormals, mask: false });
    }

    fn write_back(&mut self) {
        for register in 0..128 {
            self.write(register);
        }
    }

    /// Exits before the instruction at `pc`.
    pub fn exit(&mut self, status: u32) {
        self.write_back();
        let (pc, number, count) = (self.pc as i32, self.number as i32, self.count as i32);
        let mut f = self.f();
        f.local_get(CONTEXT).i32_const(pc).i32_store(word(field::PC));
        f.local_get(CONTEXT).i32_const(number).i32_store(word(field::UNIT));
        f.local_get(CONTEXT).local_get(BUDGET).i32_const(count).i32_sub().i64_extend_i32_u();
        f.i64_store(MemArg { align: 3, ..word(field::BUDGET) });
        f.i32_const(status as i32).return_();
    }

    /// Continues with the unit at this address, or at [`ADDRESS`], which is a multiple of 4.
    pub fn chain_to(&mut self, pc: Option<u32>) {
        self.write_back();
        let count = self.count as i32;
        let mut f = self.f();
        f.local_get(REGISTERS).local_get(LOCAL_STORE).local_get(CONTEXT);
        f.local_get(BUDGET).i32_const(count).i32_sub();
        match pc {
            Some(pc) => {
                f.i32_const(pc as i32);
                f.local_get(CONTEXT).i32_load(word(field::TABLE)).i32_load(word(pc));
            }
            None => {
                f.local_get(ADDRESS);
                f.local_get(CONTEXT).i32_load(word(field::TABLE));
                f.local_get(ADDRESS).i32_add().i32_load(word(0));
            }
        }
        f.return_call_indirect(0, UNIT_TYPE);
    }
}
