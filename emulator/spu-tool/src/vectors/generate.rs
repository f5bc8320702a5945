//! Makes vectors: random instructions on random operands and on edge cases. The interpreter runs
//! them, and the model of the pipelines counts their cycles.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use spu_emulator::edges::{DOUBLES, LARGE, WORDS};
use spu_emulator::float::estimate;
use spu_emulator::float::fpscr::Fpscr;
use spu_emulator::interp::{Quad, Spu};
use spu_emulator::local_store::LocalStore;
use spu_isa::timing::{Pipeline, Rules};
use spu_isa::{
    Class, Field, Format, Instruction, LIMIT_MASK, Machine, Op, Pipe, Target, disassemble, feature,
};
use std::array::from_fn;

use super::{Cycles, SRR0, State, Value, Vector, stop_code, truth};

/// Constants of instructions at the ends of their fields.
const CONSTANTS: [i32; 6] = [0, 1, -1, i16::MIN as i32, i16::MAX as i32, 1 << 17];
/// Preferred words that conditional branches distinguish.
const CONDITIONS: [u32; 6] = [0, 0, 1, 0x8000, 0x1_0000, 0x8000_0000];
/// Addresses at the ends of local store.
const ENDS: [u32; 4] = [0, 4, LIMIT_MASK & !7, LIMIT_MASK & !3];

/// The vectors of one instruction, without end.
pub struct Generator {
    op: Op,
    random: ChaCha8Rng,
    count: u64,
    spu: Spu,
    local_store: LocalStore,
}

impl Generator {
    /// The vectors of `op` that belong to `seed`.
    #[must_use]
    pub fn new(op: Op, seed: u64) -> Self {
        // Each instruction has its own stream, whichever others are written.
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(u64::from(op.row().opcode));
        let spu = match op.row().machine {
            Machine::Every => Spu::new(),
            Machine::DoubleExtension => Spu::with_double_extension(),
        };
        Self { op, random, count: 0, spu, local_store: LocalStore::new() }
    }

    fn below(&mut self, limit: usize) -> usize {
        (self.random.next_u64() % limit as u64) as usize
    }

    /// True once in `times`.
    fn once_in(&mut self, times: usize) -> bool {
        self.below(times) == 0
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }

    /// A random instruction. Returns `None` if the architecture does not define it.
    fn instruction(&mut self) -> Option<Instruction> {
        let row = self.op.row();
        let operands = self.random.next_u32() >> row.format.opcode_bits();
        let mut i = Instruction::decode(u32::from(row.opcode) << 21 | operands)?;
        for field in [Field::Rt, Field::Ra, Field::Rb, Field::Rc] {
            if self.once_in(4) {
                // One of few registers, so that two operands are often the same.
                *i.register_mut(field) = 3 + self.below(2) as u8;
            }
        }
        match row.format {
            Format::Flagged | Format::Hint if matches!(self.op, Op::Sync | Op::Hbr) => {
                i.immediate &= feature::CHANNEL_OR_PREFETCH;
            }
            Format::Flagged => i.immediate &= feature::DISABLE | feature::ENABLE,
            Format::Ri8From155 | Format::Ri8From173 => {
                return (0..=127).contains(&i.immediate).then_some(i.without_reserved());
            }
            _ if self.once_in(4) => i.immediate = self.one_of(&CONSTANTS),
            _ => {}
        }
        match self.op {
            Op::Wrch => i.ra = SRR0[0],
            Op::Rdch => i.ra = SRR0[1],
            Op::Rchcnt => i.ra = self.one_of(&SRR0),
            _ => {}
        }
        Instruction::decode(i.without_reserved().encode())
    }

    fn word(&mut self, kind: usize) -> u32 {
        let bits = self.random.next_u32();
        match kind {
            0 => bits,
            1 => self.one_of(&WORDS),
            2 => self.one_of(&WORDS) ^ 1 << (bits & 31),
            3 => self.one_of(&LARGE),
            // Singles around one, so that results are ordinary.
            4 => (100 + self.below(54) as u32) << 23 | bits & 0x807f_ffff,
            // Counts of shifts and rotates, of both signs.
            _ => (self.below(129) as u32).wrapping_sub(64),
        }
    }

    fn double(&mut self, kind: usize) -> u64 {
        let bits = self.random.next_u64();
        match kind {
            0 => bits,
            1 => self.one_of(&DOUBLES) ^ self.one_of(&[0, 1, 1 << 52]) | bits & 1 << 63,
            // Doubles around one, with few bits or many, so that results are exact or not.
            _ => {
                let kept = self.one_of(&[0, !0 << 49, !0 << 26, !0]) & !0 >> 12;
                (1003 + self.below(40) as u64) << 52 | bits & (kept | 1 << 63)
            }
        }
    }

    /// A number for [`Self::quad`].
    fn kind(&mut self) -> usize {
        self.below(6)
    }

    fn quad(&mut self, kind: usize) -> Quad {
        let row = self.op.row();
        let doubles = row.class == Class::Fpd || row.machine == Machine::DoubleExtension;
        if doubles && self.op != Op::Fesd {
            Quad::from_doublewords(from_fn(|_| self.double(kind / 2)))
        } else {
            Quad(from_fn(|_| self.word(kind)))
        }
    }

    /// The constant of an instruction in each lane, as wide as it may be.
    fn constant(&mut self, immediate: i32) -> Quad {
        match self.below(3) {
            0 => Quad::splat(immediate as u32),
            1 => Quad::from_halfwords([immediate as u16; 8]),
            _ => Quad::from_bytes([immediate as u8; 16]),
        }
    }

    /// An operand that may be close to the one before.
    fn operand(&mut self, before: Option<Quad>, kind: usize) -> Quad {
        let Some(mut near) = before.filter(|_| self.once_in(3)) else { return self.quad(kind) };
        if self.once_in(2) {
            near.0[self.below(4)] ^= 1 << self.below(32);
        }
        near
    }

    fn state(&mut self, i: Instruction) -> State {
        let row = self.op.row();
        let ends = self.once_in(8);
        let pc = if ends { self.one_of(&ENDS) } else { self.random.next_u32() };
        let mut state = State { pc: pc & LIMIT_MASK & !3, ..State::default() };
        let touched = i.reads().union(i.writes()).union(i.false_target());
        let mut before = (row.format == Format::Ri10).then(|| self.constant(i.immediate));
        // Operands of one kind give ordinary results, others give edge cases.
        let (shared, is_shared) = (self.kind(), self.once_in(2));
        for number in touched.iter() {
            let kind = if is_shared { shared } else { self.kind() };
            let value = self.operand(before, kind);
            state.regs.push((number, Value(value)));
            before = Some(value);
        }
        let condition = row.class == Class::Br && row.reads.contains(&Field::Rt);
        for (number, Value(value)) in &mut state.regs {
            if *number == i.rt && condition && self.once_in(2) {
                value.0[0] = self.one_of(&CONDITIONS);
            }
        }
        if self.op == Op::Fi && self.once_in(2) {
            self.estimate(i, &mut state);
        }
        let fpscr = from_fn(|_| if self.once_in(2) { 0 } else { self.random.next_u32() });
        state.fpscr = Value(Quad(Fpscr::from_words(fpscr).words()));
        state.srr0 = self.random.next_u32() & LIMIT_MASK & !3;
        if row.format == Format::Flagged && self.op != Op::Sync {
            // An enabled interrupt would run other instructions.
            state.event = self.once_in(2) && i.immediate & feature::ENABLE == 0;
            state.interrupts = !state.event && self.once_in(4);
        }
        state.ram.push((state.pc & !15, Value(Quad::ZERO)));
        state.ram[0].1.0.0[state.pc as usize / 4 % 4] = i.encode();
        state
    }

    /// Makes rb the estimate for ra, as in a program.
    fn estimate(&mut self, i: Instruction, state: &mut State) {
        let of = self.one_of(&[estimate::frest, estimate::frsqest]);
        let operand = state.register(i.ra);
        for (number, Value(value)) in &mut state.regs {
            if let Some(operand) = operand.filter(|_| *number == i.rb) {
                *value = Quad(operand.0.map(of));
            }
        }
    }

    /// Runs the instruction. Returns `None` if the next one would be the same again, or would not
    /// be the word 0, which is a stop.
    fn run(&mut self, i: Instruction, mut initial: State) -> Option<Vector> {
        let mut unit = initial.load(&mut self.spu, &self.local_store);
        let code = initial.pc & !15;
        let access = self.spu.access(i);
        if let Some(access) = access.filter(|access| access.address != code) {
            let kind = self.kind();
            let value = self.quad(kind);
            self.local_store.store_quadword(access.address, value.0);
            initial.ram.push((access.address, Value(value)));
        }
        let stopped = self.spu.step(&self.local_store, &mut unit);
        let after = initial.of(&self.spu, &self.local_store, &unit);
        for &(address, _) in &initial.ram {
            self.local_store.store_quadword(address, [0; 4]);
        }
        let changes_code = access.is_some_and(|access| {
            let reads_code = access.address == code && !access.is_store;
            [code, after.pc & !15].contains(&access.address) && !reads_code
        });
        if changes_code || after.pc == initial.pc {
            return None;
        }
        // Without objdump's comment, which repeats a constant.
        let text = disassemble(i.encode(), initial.pc).to_string();
        let text = text.split('#').next().unwrap_or_default().trim_end().replace('\t', " ");
        let vector = Vector {
            name: format!("{} {text}", self.count),
            truth: truth::of_result(i, &initial),
            stop: stopped.and_then(|stopped| stop_code(&stopped.reason)),
            cycles: cycles(i, initial.pc, after.pc),
            initial,
            after,
        };
        self.count += 1;
        Some(vector)
    }
}

impl Iterator for Generator {
    type Item = Vector;

    fn next(&mut self) -> Option<Vector> {
        loop {
            let Some(i) = self.instruction() else { continue };
            let state = self.state(i);
            if let Some(vector) = self.run(i, state) {
                return Some(vector);
            }
        }
    }
}

/// The cycles of an instruction at `pc` that goes on at `next`, or in the other word of its pair,
/// from which it could issue together with another.
fn cycles(i: Instruction, pc: u32, next: u32) -> Cycles {
    let no_operation = |op| Instruction::new(op, [0; 4], 0);
    let row = i.op.row();
    let double_extension = row.machine == Machine::DoubleExtension;
    let nop = no_operation(Op::Nop);
    // Both successors are for the even pipe, so they pair with no instruction before them.
    let reader = match row.target {
        Target::Rt => Instruction { rt: i.rt, ra: i.rt, ..no_operation(Op::Ai) },
        Target::False | Target::None => nop,
    };
    let taken = next != pc.wrapping_add(4) & LIMIT_MASK;
    let place = pc & !7;
    let time = |pair: &[Instruction], successor| {
        let mut pipeline = Pipeline::new(Rules { double_extension, ..Rules::default() });
        // The even word of a pair comes first.
        let start =
            if pair.len() == 1 && row.class.pipe() == Pipe::Odd { place + 4 } else { place };
        let mut first = None;
        for (address, &instruction) in (start..).step_by(4).zip(pair) {
            let issue = pipeline.issue(address, instruction);
            first.get_or_insert(issue.cycle);
        }
        if row.class == Class::Br {
            pipeline.branched(place + 4, taken.then_some(next));
        }
        let successor = pipeline.issue(if taken { next } else { place + 8 }, successor);
        (successor.cycle - first.unwrap_or_default()) as u16
    };
    let pair = match row.class.pipe() {
        Pipe::Even => [i, no_operation(Op::Lnop)],
        Pipe::Odd => [nop, i],
    };
    Cycles { alone: time(&[i], reader), pair: time(&pair, nop), truth: truth::of_cycles(i, taken) }
}
