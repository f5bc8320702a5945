//! The check mode: compares compiled code with the interpreter.
//!
//! Each runs on its own copy of local store, so writes by others during the run reach neither.
//! Afterwards the interpreter's changes are written to local store itself.

use std::fmt;

use spu_jit::{Cpu, Exit, MAX_STEPS, Storage};

use crate::channel::Channels;
use crate::float::fpscr::Fpscr;
use crate::interp::{Quad, Spu};
use crate::local_store::{DIFFERENCE_LINE, LocalStore};
use crate::simulated::Marks;
use crate::stop::{Stop, Stopped};

const QUADWORD: usize = 16;
/// The number of bytes that are compared first as a whole.
const CHUNK: usize = 1024;
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
        Self { registers: spu.registers, fpscr: spu.fpscr.words(), pc: spu.pc() }
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
            write!(f, "\nthe interpreter stopped, compiled code did not: {stopped}")?;
        }
        if let Some((address, compiled, interpreted)) = self.local_store {
            let (compiled, interpreted) = (words(compiled), words(interpreted));
            write!(
                f,
                "\nlocal store at {address:#07x}: {compiled} compiled, {interpreted} interpreted"
            )?;
        }
        writeln!(f, "\nregister: before; compiled; interpreted, if it differs")?;
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
///
/// Each check looks at all of local store, so that no store escapes it. But it copies only what has
/// changed: between two checks, the copies stay equal.
pub(super) struct Copies {
    compiled: LocalStore,
    interpreted: LocalStore,
    /// The contents of local store, and so of each copy, before the runs.
    original: LocalStore,
}

impl Copies {
    pub fn new() -> Self {
        Self {
            compiled: LocalStore::new(),
            interpreted: LocalStore::new(),
            original: LocalStore::new(),
        }
    }

    /// Copies what has changed in local store since the last runs.
    fn update(&mut self, local_store: &LocalStore) {
        for line in local_store.changed_lines(&self.original) {
            let mut now = [0; DIFFERENCE_LINE];
            local_store.read(line, &mut now);
            for copy in [&self.original, &self.compiled, &self.interpreted] {
                copy.write(line, &now);
            }
        }
    }

    /// Undoes the runs' changes, which are in these chunks.
    fn restore(&mut self, chunks: &[u32]) {
        for address in quadwords(chunks) {
            let before = self.original.load_quadword(address);
            for copy in [&self.compiled, &self.interpreted] {
                copy.store_quadword(address, before);
            }
        }
    }

    /// The addresses of the chunks in which a run has changed its copy.
    fn changed(&mut self) -> Vec<u32> {
        let [compiled, interpreted, original] =
            [self.compiled.as_bytes(), self.interpreted.as_bytes(), self.original.as_bytes()]
                .map(|bytes| bytes.as_chunks::<CHUNK>().0);
        let differs = |&at: &usize| compiled[at] != original[at] || interpreted[at] != original[at];
        let chunks = (0..original.len()).filter(differs);
        chunks.map(|at| (at * CHUNK) as u32).collect()
    }

    /// The first quadword in these chunks that differs.
    fn difference(&self, chunks: &[u32]) -> Option<(u32, [u32; 4], [u32; 4])> {
        quadwords(chunks).find_map(|address| {
            let compiled = self.compiled.load_quadword(address);
            let interpreted = self.interpreted.load_quadword(address);
            (compiled != interpreted).then_some((address, compiled, interpreted))
        })
    }

    /// Writes the interpreter's changes, which are in these chunks, to local store and to the other
    /// copies.
    fn write_changes(&mut self, chunks: &[u32], local_store: &LocalStore) {
        for address in quadwords(chunks) {
            let after = self.interpreted.load_quadword(address);
            if after != self.original.load_quadword(address) {
                local_store.store_quadword(address, after);
                self.original.store_quadword(address, after);
            }
            self.compiled.store_quadword(address, after);
        }
    }
}

/// The addresses of the quadwords in these chunks.
fn quadwords(chunks: &[u32]) -> impl Iterator<Item = u32> {
    chunks.iter().flat_map(|&start| (start..start + CHUNK as u32).step_by(QUADWORD))
}

/// Runs units from the SPU's program counter on, then as many instructions with the interpreter,
/// and compares the results. The SPU keeps the interpreter's results. Where many instructions give
/// a difference, fewer are run, so that it names the unit.
pub(super) fn check<C: Channels>(
    (cpu, marks): (&mut Cpu, &Marks),
    spu: &mut Spu,
    local_store: &LocalStore,
    copies: &mut Copies,
    channels: &mut C,
    left: u64,
) -> Result<Exit, Box<Difference>> {
    let left = left.min(u64::from(AT_ONCE)) as u32;
    let (before, executed) = (State::of(spu), spu.executed());
    copies.update(local_store);
    let few = MAX_STEPS as u32;
    let (mut result, mut changed) = compare((cpu, marks), spu, copies, channels, left);
    if result.is_err() && left > few {
        spu.registers = before.registers;
        spu.fpscr = Fpscr::from_words(before.fpscr);
        spu.set_pc(before.pc);
        spu.executed = executed;
        copies.restore(&changed);
        (result, changed) = compare((cpu, marks), spu, copies, channels, few);
    }
    copies.write_changes(&changed, local_store);
    result
}

/// Runs at most `budget` instructions with both engines, each on its copy. The second value is
/// where they have changed their copies.
fn compare<C: Channels>(
    (cpu, marks): (&mut Cpu, &Marks),
    spu: &mut Spu,
    copies: &mut Copies,
    channels: &mut C,
    budget: u32,
) -> (Result<Exit, Box<Difference>>, Vec<u32>) {
    let before = State::of(spu);
    let mut compiled = before.clone();
    let storage = Storage {
        registers: compiled.registers.as_mut_ptr().cast(),
        local_store: copies.compiled.as_ptr(),
        watched: marks.as_ptr(),
    };
    // SAFETY: the registers belong to this function and the local store to `copies`, and both have
    // the required size and alignment. The marks have a byte for each quadword of local store.
    let (exit, pc, instructions) =
        unsafe { cpu.enter(storage, &mut compiled.fpscr, before.pc, budget) };
    compiled.fpscr = Fpscr::from_words(compiled.fpscr).words();
    compiled.pc = pc;

    let stopped = spu.run_limited(&copies.interpreted, channels, u64::from(instructions));
    let requested = |stopped: &Stopped| stopped.reason == Stop::Requested;
    let interrupted = stopped.as_ref().is_some_and(requested);
    let interpreted = State::of(spu);
    let changed = copies.changed();
    let local_store = copies.difference(&changed);
    let equal = stopped.is_none() && compiled == interpreted && local_store.is_none();
    if equal || interrupted {
        return (Ok(exit), changed);
    }
    let difference =
        Difference { before, instructions, compiled, interpreted, stopped, local_store };
    (Err(Box::new(difference)), changed)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::channel::NoChannels;
    use crate::float::estimate::reciprocal_root_words;
    use spu_isa::{Instruction, Op};
    use spu_jit::{CodeCache, Compiler, Estimates, FloatMode, Step, Tier, Trace, UnitOptions};

    /// A store by one run alone is found wherever it is. Only the interpreter's stores reach local
    /// store.
    #[test]
    fn differing_local_stores_are_found() {
        const PLACES: [u32; 4] = [0, 0x1230, 0x2_0000, 0x3_fff0];
        let ([one, two], other) = ([[1; 4], [2; 4]], [7; 4]);
        let (store, mut copies) = (LocalStore::new(), Copies::new());
        for place in PLACES {
            store.store_quadword(place ^ 0x40, other);
            copies.update(&store);
            copies.interpreted.store_quadword(0x400, two);
            copies.compiled.store_quadword(0x400, two);
            let same = copies.changed();
            assert_eq!((same.as_slice(), copies.difference(&same)), (&[0x400][..], None));
            copies.compiled.store_quadword(place, one);
            let changed = copies.changed();
            assert_eq!(copies.difference(&changed), Some((place, one, [0; 4])));
            copies.restore(&changed);
            assert!(copies.changed().is_empty());
            copies.interpreted.store_quadword(place, two);
            copies.compiled.store_quadword(place, one);
            let changed = copies.changed();
            copies.write_changes(&changed, &store);
            assert_eq!(store.load_quadword(place), two);
            assert_eq!(store.load_quadword(place ^ 0x40), other);
            assert!(copies.changed().is_empty());
            store.store_quadword(place, [0; 4]);
        }
    }

    /// With wrong tables compiled code differs, and the message names the place.
    #[test]
    fn a_difference_is_found_and_told() {
        let estimates =
            Estimates { reciprocal: &[0; 32], reciprocal_root: reciprocal_root_words() };
        let code = CodeCache::new(estimates, UnitOptions::default())
            .expect("the hosts of the tests have AVX2 and FMA");
        let mut compiler = Compiler::new(&code, Tier::Baseline);
        let instruction = Instruction::new(Op::Frest, [5, 4, 0, 0], 0);
        let word = instruction.encode();
        let step = Step { pc: 0, word, instruction, next: 4 };
        let trace = Trace::new(vec![step]).expect("the instruction can be compiled");
        let unit = compiler.compile(trace, FloatMode::SINGLES).expect("the code cache has space");
        let mut cpu = code.new_cpu();
        cpu.install(&unit);
        let local_store = LocalStore::new();
        local_store.write(0, &word.to_be_bytes());
        let mut spu = Spu::new();
        spu.set_register(4, Quad::splat(0x3f80_0000));
        let mut copies = Copies::new();
        let difference = check(
            (&mut cpu, &Marks::default()),
            &mut spu,
            &local_store,
            &mut copies,
            &mut NoChannels,
            100,
        );
        let difference = difference.expect_err("the tables are wrong").to_string();
        assert!(difference.starts_with("1 instructions from 0x00000"), "{difference}");
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
