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

/// Runs units from the SPU's program counter on, then as many instructions with the interpreter,
/// and compares the results. The SPU keeps the interpreter's results.
pub(super) fn check<C: Channels>(
    cpu: &mut Cpu,
    spu: &mut Spu,
    local_store: &LocalStore,
    channels: &mut C,
    left: u64,
) -> Result<Exit, Box<Difference>> {
    let before = State::of(spu);
    let mut original = vec![0; SIZE as usize];
    local_store.read(0, &mut original);
    let [for_compiled, for_interpreted] = [(); 2].map(|()| {
        let copy = LocalStore::new();
        copy.write(0, &original);
        copy
    });

    let mut compiled = before.clone();
    let storage = Storage {
        registers: compiled.registers.as_mut_ptr().cast(),
        local_store: for_compiled.as_ptr(),
    };
    let budget = left.min(MAX_STEPS as u64) as u32;
    // SAFETY: registers and local store belong to this function, and have the required size and
    // alignment.
    let (exit, pc, instructions) =
        unsafe { cpu.enter(storage, &mut compiled.fpscr, before.pc, budget) };
    compiled.fpscr = Fpscr::from_words(compiled.fpscr).words();
    compiled.pc = pc;

    let stopped = spu.run_limited(&for_interpreted, channels, u64::from(instructions));
    let requested = |stopped: &Stopped| stopped.reason == Stop::Requested;
    let interrupted = stopped.as_ref().is_some_and(requested);
    let interpreted = State::of(spu);
    let mut differs = None;
    let quadwords = original.chunks_exact(QUADWORD);
    for (address, original) in (0..).step_by(QUADWORD).zip(quadwords) {
        let by_interpreter = for_interpreted.load_quadword(address);
        let by_compiled = for_compiled.load_quadword(address);
        if by_compiled != by_interpreter {
            differs.get_or_insert((address, by_compiled, by_interpreter));
        }
        let bytes = by_interpreter.map(u32::to_be_bytes).concat();
        if bytes != original {
            local_store.store_quadword(address, by_interpreter);
        }
    }
    let equal = stopped.is_none() && compiled == interpreted && differs.is_none();
    if equal || interrupted {
        return Ok(exit);
    }
    Err(Box::new(Difference {
        before,
        instructions,
        compiled,
        interpreted,
        stopped,
        local_store: differs,
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
        let difference = check(&mut cpu, &mut spu, &local_store, &mut NoChannels, 100);
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
