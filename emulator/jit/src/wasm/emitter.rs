//! The function of a trace: its registers, exits and loop.

use std::collections::HashSet;

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
/// Why the unit exits.
const STATUS: u32 = 5;
/// The number of the first vector.
const FIRST_VECTOR: u32 = 6;

/// The status with which a unit continues with another one.
const CHAIN: u32 = u32::MAX;

/// Facts about a register's value.
#[derive(Clone, Copy, Default)]
pub(super) struct Facts {
    /// No lane is a denormal single.
    pub no_denormals: bool,
    /// Each lane is all ones or all zeros.
    pub mask: bool,
}

/// A register that has a local.
#[derive(Clone, Copy, Default)]
struct Register {
    local: u32,
    /// The value, if it is known.
    constant: Option<[u32; 4]>,
    facts: Facts,
}

pub(super) struct Emitter<'a> {
    trace: &'a Trace,
    pub mode: &'a FloatMode,
    number: u32,
    pub places: Places,
    body: Vec<u8>,
    registers: [Option<Register>; 128],
    /// The registers that differ from those in memory, in the order in which they were changed.
    changed: Vec<u8>,
    /// The number of registers that the trace writes.
    targets: usize,
    /// The number of blocks around the current place, within those of registers.
    depth: u32,
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
            registers: [None; 128],
            changed: Vec::new(),
            targets: 0,
            depth: 0,
            vectors: 0,
            temporaries: Vec::new(),
            pc: trace.start(),
            count: 0,
        }
    }

    /// Emits the function. Returns its locals and its body.
    ///
    /// Around the instructions there is a block for each register that the trace writes. After each
    /// block its register is written back, and after all of them the unit exits. So an exit leaves
    /// the block of the register that was changed last, and all exits share this code.
    pub fn emit(mut self) -> (Vec<(u32, ValType)>, Vec<u8>) {
        let is_loop = self.trace.is_loop();
        self.targets = self.targets();
        for _ in 0..=self.targets {
            self.f().block(BlockType::Empty);
        }
        self.exit_if_stale();
        if is_loop {
            self.hold_all();
            self.f().loop_(BlockType::Empty);
            self.depth += 1;
        }
        self.enter();
        for step in self.trace.steps() {
            self.step(step);
        }
        if is_loop {
            let count = self.count as i32;
            self.f().local_get(BUDGET).i32_const(count).i32_sub().local_set(BUDGET);
            self.f().br(0).end().unreachable();
        } else {
            let next = self.trace.steps().last().map_or(self.pc, |last| code_address(last.next));
            self.f().i32_const(next as i32).local_set(ADDRESS);
            self.leave(CHAIN);
        }
        for register in std::mem::take(&mut self.changed).into_iter().rev() {
            self.f().end();
            self.write(register);
        }
        self.f().end();
        self.finish();
        (vec![(1, ValType::I32), (self.vectors, ValType::V128)], self.body)
    }

    fn step(&mut self, step: &Step) {
        self.pc = step.pc;
        if !self.branch(step.instruction, step.next) {
            self.operation(step.instruction);
        }
        self.count += 1;
    }

    /// The number of registers that the trace writes.
    fn targets(&self) -> usize {
        let steps = self.trace.steps().iter().map(|step| step.instruction);
        let targets = steps.filter(|i| i.op.row().target == Target::Rt).map(|i| i.rt);
        targets.collect::<HashSet<_>>().len()
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
                self.change(i.rt);
            }
        }
    }

    /// Notes that a register differs from the one in memory.
    fn change(&mut self, register: u8) {
        if !self.changed.contains(&register) {
            self.changed.push(register);
        }
    }

    fn enter(&mut self) {
        let steps = self.trace.steps().len() as i32;
        self.f().local_get(BUDGET).i32_const(steps).i32_lt_s();
        self.aside(|e| e.exit(Exit::LEFT));
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
        self.f().v128_any_true();
        self.aside(|e| e.exit(Exit::STALE));
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
        FIRST_VECTOR + self.vectors - 1
    }

    /// One of the locals that keep values within an instruction.
    pub fn temporary(&mut self, number: usize) -> u32 {
        while self.temporaries.len() <= number {
            let local = self.new_local();
            self.temporaries.push(local);
        }
        self.temporaries[number]
    }

    /// Has a local hold the register, so that [`push`](Self::push) may be called on ways that are
    /// not always taken.
    pub fn hold(&mut self, register: u8) {
        if self.registers[usize::from(register)].is_some() {
            return;
        }
        let local = self.new_local();
        let place = quadword(16 * u32::from(register));
        self.f().local_get(REGISTERS).v128_load(place).local_set(local);
        self.registers[usize::from(register)] = Some(Register { local, ..Register::default() });
    }

    /// Pushes a register's value.
    pub fn push(&mut self, register: u8) {
        self.hold(register);
        match self.registers[usize::from(register)] {
            Some(Register { constant: Some(words), .. }) => {
                self.f().v128_const(vector(words));
            }
            Some(Register { local, .. }) => _ = self.f().local_get(local),
            None => unreachable!("a local holds it"),
        }
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
        self.registers[usize::from(register)].and_then(|register| register.constant)
    }

    pub fn facts(&self, register: u8) -> Facts {
        self.registers[usize::from(register)].map_or_else(Facts::default, |register| register.facts)
    }

    pub fn set_facts(&mut self, register: u8, facts: Facts) {
        if let Some(register) = &mut self.registers[usize::from(register)] {
            register.facts = facts;
        }
    }

    /// Sets a register to the value on the stack.
    pub fn set(&mut self, register: u8) {
        self.set_with(register, Facts::default());
    }

    pub fn set_with(&mut self, register: u8, facts: Facts) {
        let held = self.registers[usize::from(register)];
        let local = held.map_or_else(|| self.new_local(), |register| register.local);
        self.f().local_set(local);
        self.registers[usize::from(register)] = Some(Register { local, constant: None, facts });
        self.change(register);
    }

    pub fn set_constant(&mut self, register: u8, words: [u32; 4]) {
        let facts = Facts {
            no_denormals: words.iter().all(|word| word << 1 == 0 || word << 1 >> 24 != 0),
            mask: words.iter().all(|&word| word == 0 || word == u32::MAX),
        };
        self.f().v128_const(vector(words));
        self.set_with(register, facts);
        if let Some(register) = &mut self.registers[usize::from(register)] {
            register.constant = Some(words);
        }
    }

    /// Writes a register to memory.
    fn write(&mut self, register: u8) {
        if let Some(Register { local, .. }) = self.registers[usize::from(register)] {
            let place = quadword(16 * u32::from(register));
            self.f().local_get(REGISTERS).local_get(local).v128_store(place);
        }
    }

    /// Has the interpreter run an instruction that uses registers only, and pushes its result.
    pub fn interpret(&mut self, i: Instruction) {
        for register in i.op.row().reads.iter().map(|&field| i.register(field)) {
            if self.changed.contains(&register) {
                self.write(register);
            }
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

    /// Begins what is done if the value on the stack is not 0, and exits in the end.
    pub fn aside(&mut self, exit: impl FnOnce(&mut Self)) {
        self.f().if_(BlockType::Empty);
        self.depth += 1;
        exit(self);
        self.depth -= 1;
        self.f().end();
    }

    /// Exits before the instruction at `pc`.
    pub fn exit(&mut self, status: u32) {
        let pc = self.pc as i32;
        self.f().i32_const(pc).local_set(ADDRESS);
        self.leave(status);
    }

    /// Continues with the unit at the address, which is a multiple of 4.
    pub fn chain(&mut self) {
        self.leave(CHAIN);
    }

    fn leave(&mut self, status: u32) {
        let count = self.count as i32;
        let block = self.depth + (self.targets - self.changed.len()) as u32;
        let mut f = self.f();
        f.local_get(BUDGET).i32_const(count).i32_sub().local_set(BUDGET);
        f.i32_const(status as i32).local_set(STATUS).br(block);
    }

    /// Exits, after all registers are written back.
    fn finish(&mut self) {
        let number = self.number as i32;
        let mut f = self.f();
        f.local_get(STATUS).i32_const(CHAIN as i32).i32_eq().if_(BlockType::Empty);
        f.local_get(REGISTERS).local_get(LOCAL_STORE).local_get(CONTEXT).local_get(BUDGET);
        f.local_get(ADDRESS).local_get(CONTEXT).i32_load(word(field::TABLE));
        f.local_get(ADDRESS).i32_add().i32_load(word(0)).return_call_indirect(0, UNIT_TYPE).end();
        f.local_get(CONTEXT).local_get(ADDRESS).i32_store(word(field::PC));
        f.local_get(CONTEXT).i32_const(number).i32_store(word(field::UNIT));
        f.local_get(CONTEXT).local_get(BUDGET).i64_extend_i32_u();
        f.i64_store(MemArg { align: 3, ..word(field::BUDGET) });
        f.local_get(STATUS).end();
    }
}
