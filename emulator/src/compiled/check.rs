//! The check mode: compares compiled code with the interpreter.
//!
//! Each runs on its own copy of local store, so writes by others during the run reach neither.
//! Afterwards the interpreter's changes are written to local store itself.

use std::fmt;

use spu_compiler::{Cpu, Exit, MAX_STEPS, Storage};

use crate::channel::Channels;
use crate::float::fpscr::Fpscr;
use crate::interp::{Quad, Spu};
use crate::local_store::{LocalStore, SIZE};
use crate::stop::{Stop, Stopped};

const QUADWORD: usize = 16;
/// The most instructions that are compared at once. Comparing local stores takes as long as running
/// some thousands of instructions.
const AT_ONCE: u32 = 4096;

/// The state of an SPU between instructions.
#[derive(Clone, Debug, PartialEq, Eq)]
struct State {
    registers: [Quad; 128],
    fpscr: [u32; 4],
    pc: u32,
}

impl State {
    fn of(spu: &Spu) -> Self {
        Self {
            registers: spu.registers,
            fpscr: spu.fpscr.words(),
            pc: spu.pc(),
        }
    }
}

/// A run of instructions for which compiled code and the interpreter gave different results.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    before: State,
    instructions: u32,
    compiled: State,
    interpreted: State,
    stopped: Option<Stopped>,
    /// The first quadword of local store that differs: its address, and its contents in the
    /// compiled and in the interpreted run.
    local_store: Option<(u32, [u32; 4], [u32; 4])>,
}

impl Difference {
    pub(crate) fn described(&self) -> (u32, String) {
        (self.before.pc, self.to_string())
    }
}

fn words(words: [u32; 4]) -> String {
    words.map(|word| format!("{word:08x}")).join(" ")
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (compiled, interpreted) = (&self.compiled, &self.interpreted);
        write!(
            f,
            "{} instructions from {:#07x} gave different results:\n\
             the program counter is {:#07x} compiled, {:#07x} interpreted",
            self.instructions, self.before.pc, compiled.pc, interpreted.pc
        )?;
        if let Some(stopped) = &self.stopped {
            write!(
                f,
                "\nthe interpreter stopped, compiled code did not: {stopped}"
            )?;
        }
        if let Some((address, compiled, interpreted)) = self.local_store {
            let (compiled, interpreted) = (words(compiled), words(interpreted));
            write!(
                f,
                "\nlocal store at {address:#07x}: {compiled} compiled, {interpreted} interpreted"
            )?;
        }
        writeln!(
            f,
            "\nregister: before; compiled; interpreted, if it differs"
        )?;
        writeln!(
            f,
            "FPSCR: {}; {}; {}",
            words(self.before.fpscr),
            words(compiled.fpscr),
            words(interpreted.fpscr)
        )?;
        for number in 0..128 {
            let [before, compiled, interpreted] =
                [&self.before, compiled, interpreted].map(|state| state.registers[number].0);
            if compiled != interpreted {
                let (compiled, interpreted) = (words(compiled), words(interpreted));
                writeln!(f, "${number}: {}; {compiled}; {interpreted}", words(before))?;
            } else if before != compiled {
                writeln!(f, "${number}: {}; {}", words(before), words(compiled))?;
            }
        }
        Ok(())
    }
}

/// The copies of local store that the two runs work on.
pub(super) struct Copies {
    compiled: LocalStore,
    interpreted: LocalStore,
    /// Their contents, and those of local store before the runs.
    original: Vec<u8>,
    by_compiled: Vec<u8>,
    by_interpreter: Vec<u8>,
}

impl Copies {
    pub fn new() -> Self {
        let bytes = || vec![0; SIZE as usize];
        Self {
            compiled: LocalStore::new(),
            interpreted: LocalStore::new(),
            original: bytes(),
            by_compiled: bytes(),
            by_interpreter: bytes(),
        }
    }

    /// Reads what the runs have made of the copies, and returns the first quadword that differs.
    fn difference(&mut self) -> Option<(u32, [u32; 4], [u32; 4])> {
        self.compiled.read(0, &mut self.by_compiled);
        self.interpreted.read(0, &mut self.by_interpreter);
        if self.by_compiled == self.by_interpreter {
            return None;
        }
        let differs = |&address: &u32| {
            self.compiled.load_quadword(address) != self.interpreted.load_quadword(address)
        };
        let address = (0..SIZE).step_by(QUADWORD).find(differs)?;
        Some((
            address,
            self.compiled.load_quadword(address),
            self.interpreted.load_quadword(address),
        ))
    }

    /// Writes the interpreter's changes to local store.
    fn write_changes(&self, local_store: &LocalStore) {
        const CHUNK: usize = 1024;
        let chunks = self.original.chunks_exact(CHUNK);
        for (start, (before, after)) in (0..)
            .step_by(CHUNK)
            .zip(chunks.zip(self.by_interpreter.chunks_exact(CHUNK)))
        {
            if before == after {
                continue;
            }
            let quadwords = before.chunks_exact(QUADWORD);
            for (address, (before, after)) in (start..)
                .step_by(QUADWORD)
                .zip(quadwords.zip(after.chunks_exact(QUADWORD)))
            {
                if before != after {
                    local_store.write(address, after);
                }
            }
        }
    }
}

/// Runs units from the SPU's program counter on, then as many instructions with the interpreter,
/// and compares the results. The SPU keeps the interpreter's results. Where many instructions give
/// a difference, fewer are run, so that it names the unit.
pub(super) fn check<C: Channels>(
    cpu: &mut Cpu,
    spu: &mut Spu,
    local_store: &LocalStore,
    copies: &mut Copies,
    channels: &mut C,
    left: u64,
) -> Result<Exit, Box<Difference>> {
    let left = left.min(u64::from(AT_ONCE)) as u32;
    let (before, executed) = (State::of(spu), spu.executed());
    local_store.read(0, &mut copies.original);
    let few = MAX_STEPS as u32;
    let mut result = compare(cpu, spu, copies, channels, left);
    if result.is_err() && left > few {
        spu.registers = before.registers;
        spu.fpscr = Fpscr::from_words(before.fpscr);
        spu.set_pc(before.pc);
        spu.executed = executed;
        result = compare(cpu, spu, copies, channels, few);
    }
    copies.write_changes(local_store);
    result
}

/// Runs at most `budget` instructions by both, each on its copy.
fn compare<C: Channels>(
    cpu: &mut Cpu,
    spu: &mut Spu,
    copies: &mut Copies,
    channels: &mut C,
    budget: u32,
) -> Result<Exit, Box<Difference>> {
    for copy in [&copies.compiled, &copies.interpreted] {
        copy.write(0, &copies.original);
    }
    let before = State::of(spu);
    let mut compiled = before.clone();
    let storage = Storage {
        registers: compiled.registers.as_mut_ptr().cast(),
        local_store: copies.compiled.as_ptr(),
    };
    // SAFETY: the registers belong to this function and the local store to `copies`, and both have
    // the required size and alignment.
    let (exit, pc, instructions) =
        unsafe { cpu.enter(storage, &mut compiled.fpscr, before.pc, budget) };
    compiled.fpscr = Fpscr::from_words(compiled.fpscr).words();
    compiled.pc = pc;

    let stopped = spu.run_limited(&copies.interpreted, channels, u64::from(instructions));
    let requested = |stopped: &Stopped| stopped.reason == Stop::Requested;
    let interrupted = stopped.as_ref().is_some_and(requested);
    let interpreted = State::of(spu);
    let local_store = copies.difference();
    let equal = stopped.is_none() && compiled == interpreted && local_store.is_none();
    if equal || interrupted {
        return Ok(exit);
    }
    Err(Box::new(Difference {
        before,
        instructions,
        compiled,
        interpreted,
        stopped,
        local_store,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::channel::NoChannels;
    use crate::float::estimate::reciprocal_root_words;
    use spu_compiler::{Compiler, Estimates, FloatMode, Step, Trace};
    use spu_isa::{Instruction, Op};

    /// With wrong tables compiled code differs, and the message names the place.
    #[test]
    fn a_difference_is_found_and_told() {
        let estimates = Estimates {
            reciprocal: &[0; 32],
            reciprocal_root: reciprocal_root_words(),
        };
        let mut compiler =
            Compiler::new(estimates, false).expect("the hosts of the tests have AVX2 and FMA");
        let instruction = Instruction {
            op: Op::Frest,
            rt: 5,
            ra: 4,
            rb: 0,
            rc: 0,
            branch_distance: 0,
            immediate: 0,
        };
        let word = instruction.encode();
        let step = Step {
            pc: 0,
            word,
            instruction,
            next: 4,
        };
        let trace = Trace::new(vec![step]).expect("the instruction can be compiled");
        let unit = compiler
            .compile(trace, FloatMode::SINGLES)
            .expect("there is room");
        let mut cpu = compiler.new_cpu();
        cpu.install(&unit);
        let local_store = LocalStore::new();
        local_store.write(0, &word.to_be_bytes());
        let mut spu = Spu::new();
        spu.set_register(4, Quad::splat(0x3f80_0000));
        let mut copies = Copies::new();
        let difference = check(
            &mut cpu,
            &mut spu,
            &local_store,
            &mut copies,
            &mut NoChannels,
            100,
        );
        let difference = difference.expect_err("the tables are wrong").to_string();
        assert!(
            difference.starts_with("1 instructions from 0x00000"),
            "{difference}"
        );
        let register = "$5: 00000000 00000000 00000000 00000000; 3f000000 3f000000 3f000000 3f000000; \
                        3f7ffbe0 3f7ffbe0 3f7ffbe0 3f7ffbe0";
        assert!(difference.contains(register), "{difference}");
        assert_eq!(
            spu.register(5),
            Quad::splat(0x3f7f_fbe0),
            "the SPU keeps the interpreter's result"
        );
    }
}
