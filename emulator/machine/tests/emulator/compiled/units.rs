//! Compares one unit with the interpreter.

use crate::prelude::*;
use spu_emulator::channel::NoChannels;
use spu_jit::{
    CodeCache, Compiler, Cpu, Estimates, Exit, FloatMode, Step, Storage, Tier, Trace, UnitOptions,
};

/// The start address of the code in these tests.
pub const START: u32 = 0x1000;

/// Registers, FPSCR and local store.
pub struct State {
    pub registers: [Quad; 128],
    pub fpscr: [u32; 4],
    pub local_store: LocalStore,
}

impl State {
    /// A copy of the state with `code` at [`START`].
    pub fn with_code(&self, code: &[Instruction]) -> (Spu, LocalStore) {
        let local_store = copy(&self.local_store);
        for (address, instruction) in (START..).step_by(4).zip(code) {
            local_store.write(address, &instruction.encode().to_be_bytes());
        }
        let mut spu = Spu::new();
        spu.registers = self.registers;
        spu.fpscr = Fpscr::from_words(self.fpscr);
        spu.set_pc(START);
        (spu, local_store)
    }
}

fn copy(local_store: &LocalStore) -> LocalStore {
    let copy = LocalStore::new();
    // SAFETY: both have `SIZE` bytes, and nobody else accesses them.
    unsafe {
        std::ptr::copy_nonoverlapping(local_store.as_ptr(), copy.as_ptr(), SIZE as usize);
    }
    copy
}

pub fn local_store_bytes(local_store: &LocalStore) -> &[u8] {
    // SAFETY: local store has `SIZE` bytes, outlives the slice, and nobody writes to it meanwhile.
    unsafe { std::slice::from_raw_parts(local_store.as_ptr(), SIZE as usize) }
}

pub fn code_cache() -> Arc<CodeCache> {
    let estimates = Estimates {
        reciprocal: estimate::reciprocal_words(),
        reciprocal_root: estimate::reciprocal_root_words(),
    };
    CodeCache::new(estimates, UnitOptions::default())
        .expect("the hosts of the tests have AVX2 and FMA")
}

/// A trace of the path that the interpreter takes through `code`, at [`START`], from `state`.
pub fn trace(code: &[Instruction], state: &State) -> Trace {
    let (mut spu, local_store) = state.with_code(code);
    let steps = code.iter().map(|&instruction| {
        let pc = spu.pc();
        let stopped = spu.step(&local_store, &mut NoChannels);
        // After a halt whose condition holds, a trace continues at the next instruction.
        let next = if stopped.is_some() { pc + 4 } else { spu.pc() };
        Step { pc, word: instruction.encode(), instruction, next }
    });
    Trace::new(steps.collect()).expect("the code is straight and can be compiled")
}

/// A state after a unit has run, and why and where it ended.
pub struct Outcome {
    pub registers: [Quad; 128],
    pub fpscr: [u32; 4],
    pub local_store: LocalStore,
    pub exit: Exit,
    pub pc: u32,
    pub executed: u32,
}

/// A unit that can run on a copy of a state.
pub trait Run {
    fn run(&mut self, spu: &Spu, local_store: &LocalStore) -> Outcome;
}

/// How often units may run their trace, if it is a loop.
pub const ITERATIONS: u32 = 5;

/// A trace that is compiled for this host.
pub struct Compiled {
    cpu: Cpu,
    budget: u32,
}

impl Compiled {
    pub fn new(code: &Arc<CodeCache>, tier: Tier, trace: &Trace, mode: FloatMode) -> Self {
        let mut cpu = code.new_cpu();
        let unit = Compiler::new(code, tier).compile(trace.clone(), mode).expect("there is space");
        cpu.install(&unit);
        Self { cpu, budget: ITERATIONS * trace.steps().len() as u32 }
    }
}

impl Run for Compiled {
    fn run(&mut self, spu: &Spu, local_store: &LocalStore) -> Outcome {
        let local_store = copy(local_store);
        let mut registers = spu.registers;
        let mut fpscr = spu.fpscr.words();
        let storage = Storage {
            registers: registers.as_mut_ptr().cast(),
            local_store: local_store.as_ptr(),
            watched: std::ptr::null(),
        };
        // SAFETY: registers and local store belong to this function. The units watch nothing.
        let (exit, pc, executed) =
            unsafe { self.cpu.enter(storage, &mut fpscr, spu.pc(), self.budget) };
        Outcome { registers, fpscr, local_store, exit, pc, executed }
    }
}

/// Runs the unit once, and compares the state after it with the interpreter's after as many
/// instructions. Returns why the unit ended.
pub fn compare(unit: &mut impl Run, mode: FloatMode, code: &[Instruction], state: &State) -> Exit {
    let (start, local_store) = state.with_code(code);
    let Outcome { registers, fpscr, local_store, exit, pc, executed } =
        unit.run(&start, &local_store);
    let (mut spu, expected) = state.with_code(code);
    let stopped = spu.run_limited(&expected, &mut NoChannels, u64::from(executed));
    let context = || format!("{code:x?} {:?} {exit:?} after {executed}", mode);
    assert_eq!(stopped, None, "{}", context());
    assert_eq!(pc, spu.pc(), "{}", context());
    let operands = || {
        let of =
            |i: &Instruction| [i.ra, i.rb, i.rc, i.rt].map(|r| state.registers[usize::from(r)]);
        format!("operands {:x?}", code.iter().map(of).collect::<Vec<_>>())
    };
    let results = registers.iter().zip(&spu.registers);
    for (number, (now, expected)) in results.enumerate() {
        assert!(
            now == expected,
            "{}: ${number} is {now:x?}, not {expected:x?}; {}",
            context(),
            operands()
        );
    }
    assert!(
        fpscr == spu.fpscr.words(),
        "{}: FPSCR was {:x?}, is {fpscr:x?}, not {:x?}; {}",
        context(),
        state.fpscr,
        spu.fpscr.words(),
        operands()
    );
    assert!(
        local_store_bytes(&local_store) == local_store_bytes(&expected),
        "{}: local store",
        context()
    );
    exit
}
