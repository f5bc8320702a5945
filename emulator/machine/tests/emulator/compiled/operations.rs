//! Tests every instruction that a trace can contain, alone and after another, on random operands
//! and on edge cases, in all float modes.

use super::units::{Compiled, START, State, code_cache, compare, trace};
use super::wasm::Emitted;
use crate::prelude::*;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use spu_emulator::edges::{LARGE, WORDS};
use spu_isa::{Class, Machine};
use spu_jit::{Exit, FloatMode, Steps, Tier, can_compile};

/// The fixed modes. The tests add a fourth, random mode: some instructions in doubles, the others
/// in singles.
const MODES: [FloatMode; 3] = [FloatMode::SINGLES, FloatMode::DOUBLES, FloatMode::EXACT_DOUBLES];

fn mixed(rng: &mut ChaCha8Rng, length: usize) -> FloatMode {
    let mut in_doubles = Steps::NONE;
    for step in 0..length {
        if rng.random() {
            in_doubles.add(step);
        }
    }
    FloatMode { in_doubles, exact_sums: rng.random() }
}

pub(super) fn word(rng: &mut ChaCha8Rng, kind: u32) -> u32 {
    match kind {
        4 => LARGE[rng.random_range(0..LARGE.len())],
        0 => rng.random(),
        1 => WORDS[rng.random_range(0..WORDS.len())],
        // Numbers around one, so that results stay within IEEE's range.
        2 => rng.random_range(100..154) << 23 | rng.random::<u32>() & 0x807f_ffff,
        _ => WORDS[rng.random_range(0..WORDS.len())] ^ 1 << rng.random_range(0..32),
    }
}

fn quad(rng: &mut ChaCha8Rng) -> Quad {
    let kind = rng.random_range(0..5);
    Quad(std::array::from_fn(|_| word(rng, kind)))
}

fn state(rng: &mut ChaCha8Rng, ordinary: bool) -> State {
    let registers = std::array::from_fn(|_| {
        if ordinary { Quad(std::array::from_fn(|_| word(rng, 2))) } else { quad(rng) }
    });
    let fpscr = std::array::from_fn(|_| if rng.random() { 0 } else { rng.random::<u32>() & 0xf07 });
    let local_store = LocalStore::new();
    for address in (0..SIZE).step_by(16) {
        local_store.store_quadword(address, [address, rng.random(), rng.random(), !address]);
    }
    State { registers, fpscr, local_store }
}

/// A random instruction with this operation, one of few registers and any immediate.
pub(super) fn instruction(rng: &mut ChaCha8Rng, op: Op) -> Option<Instruction> {
    let row = op.row();
    let word = u32::from(row.opcode) << 21 | rng.random::<u32>() & 0x1fff_ffff >> 3;
    let mut i = Instruction::decode(word).filter(|i| i.op == op)?;
    for register in [&mut i.rt, &mut i.ra, &mut i.rb, &mut i.rc] {
        *register = 3 + *register % 6;
    }
    if row.class == Class::Br || row.operands.is_empty() {
        // An indirect branch takes its target from a register, the others take it from here.
        i.immediate &= 0xfff8;
    }
    let i = Instruction::decode(i.encode())?;
    can_compile(i).then_some(i)
}

fn operations() -> impl Iterator<Item = Op> {
    Op::rows().iter().filter(|row| row.machine == Machine::Every).map(|row| row.op)
}

/// Compares code that is compiled for this host and for WebAssembly with the interpreter, on every
/// sequence of instructions that `make` returns. Returns the number of failures in each mode, of
/// this host's code and of WebAssembly.
pub(super) fn compare_all(
    rng: &mut ChaCha8Rng,
    rounds: usize,
    states: &[State],
    mut make: impl FnMut(&mut ChaCha8Rng) -> Option<Vec<Instruction>>,
) -> [[u32; 2]; 4] {
    let (code_cache, mut emitted) = (code_cache(), Emitted::new());
    let mut failures = [[0; 2]; 4];
    for _ in 0..rounds {
        let Some(code) = make(rng) else { continue };
        let made = rng.random_range(0..states.len());
        let trace = trace(&code, &states[made]);
        let mixed = mixed(rng, code.len());
        let tier = if rng.random() { Tier::Baseline } else { Tier::Optimized };
        for (mode, failures) in MODES.into_iter().chain([mixed]).zip(&mut failures) {
            let mut compiled = Compiled::new(&code_cache, tier, &trace, mode);
            emitted.install(&trace, mode);
            for state in states {
                let exits = [
                    compare(&mut compiled, mode, &code, state),
                    compare(&mut emitted, mode, &code, state),
                ];
                for (exit, failures) in exits.into_iter().zip(&mut *failures) {
                    *failures += u32::from(matches!(exit, Exit::Failed(_)));
                    assert!(!matches!(exit, Exit::Stale(_)), "{code:?}");
                }
            }
        }
    }
    failures
}

#[test]
fn each_alone() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let states: Vec<_> = (0..12).map(|_| state(&mut rng, false)).collect();
    let mut compiled = 0;
    for op in operations() {
        let some = (0..64).any(|_| instruction(&mut rng, op).is_some());
        compiled += u32::from(some);
        compare_all(&mut rng, 10, &states, |rng| Some(vec![instruction(rng, op)?]));
    }
    assert!(compiled > 160, "only {compiled} instructions are compiled");
}

#[test]
fn each_after_another() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let states: Vec<_> = (0..8).map(|_| state(&mut rng, false)).collect();
    let operations: Vec<_> = operations().filter(|op| op.row().class != Class::Br).collect();
    for &op in &operations {
        compare_all(&mut rng, 8, &states, |rng| {
            let before = operations[rng.random_range(0..operations.len())];
            let after = operations[rng.random_range(0..operations.len())];
            [before, op, op, after].map(|op| instruction(rng, op)).into_iter().collect()
        });
    }
}

#[test]
fn long_straight_code() {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let states: Vec<_> = (0..6).map(|_| state(&mut rng, false)).collect();
    let operations: Vec<_> = operations().filter(|op| op.row().class != Class::Br).collect();
    compare_all(&mut rng, 150, &states, |rng| {
        let length = rng.random_range(10..60);
        let mut code = Vec::new();
        while code.len() < length {
            let op = operations[rng.random_range(0..operations.len())];
            code.extend(instruction(rng, op));
        }
        Some(code)
    });
}

/// On ordinary numbers no mode fails; otherwise the compiler would be of no use.
#[test]
fn ordinary_arithmetic_does_not_fail() {
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    let states: Vec<_> = (0..20).map(|_| state(&mut rng, true)).collect();
    let arithmetic = [Op::Fa, Op::Fs, Op::Fm, Op::Fma, Op::Fms, Op::Fnms, Op::Fcgt, Op::Csflt];
    let failures = compare_all(&mut rng, 60, &states, |rng| {
        let op = arithmetic[rng.random_range(0..arithmetic.len())];
        Some(vec![instruction(rng, op)?])
    });
    assert_eq!(failures, [[0; 2]; 4]);
}

/// In doubles, only sums that may be the largest number are left to the interpreter. With exact
/// sums nothing is, and in WebAssembly nothing at all.
#[test]
fn specials_do_not_fail_in_doubles() {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let states: Vec<_> = (0..20).map(|_| state(&mut rng, false)).collect();
    let arithmetic = [Op::Fa, Op::Fs, Op::Fm, Op::Fma, Op::Fms, Op::Fnms, Op::Frest, Op::Fi];
    let [singles, doubles, exact, _] = compare_all(&mut rng, 60, &states, |rng| {
        let op = arithmetic[rng.random_range(0..arithmetic.len())];
        Some(vec![instruction(rng, op)?])
    });
    assert!(singles.iter().all(|&count| count > 100), "not special: {singles:?} failures");
    assert!(doubles[0] < singles[0] / 10, "{doubles:?} of {singles:?}");
    assert_eq!((doubles[1], exact), (0, [0; 2]));
}

/// A selection keeps the bits of denormals and of -0, also where arithmetic has read them.
#[test]
fn selections_between_operands_and_results() {
    let mut rng = ChaCha8Rng::seed_from_u64(6);
    let states: Vec<_> = (0..20).map(|_| state(&mut rng, false)).collect();
    let instruction = |op, operands| Instruction::new(op, operands, 0);
    let arithmetic = [Op::Fa, Op::Fs, Op::Fm, Op::Fma];
    compare_all(&mut rng, 40, &states, |rng| {
        let op = arithmetic[rng.random_range(0..arithmetic.len())];
        let compared = instruction(Op::Fcgt, [10, 5, 6, 0]);
        let computed = instruction(op, [11, 3, 4, 5]);
        let selected = [[12, 3, 11, 10], [13, 11, 4, 10], [14, 3, 4, 10]];
        let selected = selected.map(|operands| instruction(Op::Selb, operands));
        Some([&[compared, computed], &selected[..]].concat())
    });
}

/// A load fails if it is of a quadword for which a store is held back, unless the mode has it
/// commit first.
#[test]
fn loads_of_quadwords_that_were_just_stored() {
    let mut rng = ChaCha8Rng::seed_from_u64(9);
    let mut state = state(&mut rng, true);
    let operands = [[3, 4], [5, 6], [5, 4]].map(|[rt, ra]| [rt, ra, 0, 0]);
    let [stored, loaded, after] = operands;
    let code = [
        Instruction::new(Op::Stqd, stored, 0),
        Instruction::new(Op::Lqd, loaded, 0),
        Instruction::new(Op::Stqd, after, 16),
    ];
    let code_cache = code_cache();
    let mut committing = FloatMode::SINGLES;
    committing.in_doubles.add(1);
    state.registers[4] = Quad::splat(0x8000);
    for (address, overlaps) in [(0x7fff, false), (0x8000, true), (0x800f, true), (0x8010, false)] {
        state.registers[6] = Quad::splat(address);
        for (mode, fails) in [(FloatMode::SINGLES, overlaps), (committing, false)] {
            let trace = trace(&code, &state);
            let mut unit = Compiled::new(&code_cache, Tier::Optimized, &trace, mode);
            let exit = compare(&mut unit, mode, &code, &state);
            assert_eq!(matches!(exit, Exit::Failed(_)), fails, "{address:#x} {mode:?}");
        }
    }
}

/// In a loop, registers may keep their values from one iteration to the next.
#[test]
fn loops() {
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let mut states: Vec<_> = (0..6).map(|_| state(&mut rng, false)).collect();
    // One of them leaves the loop after three iterations.
    states[0].registers[2] = Quad::splat(3);
    states[1..].iter_mut().for_each(|state| state.registers[2] = Quad::splat(100));
    let operations: Vec<_> = operations().filter(|op| op.row().class != Class::Br).collect();
    compare_all(&mut rng, 100, &states, |rng| {
        let ops =
            (0..rng.random_range(1..12)).map(|_| operations[rng.random_range(0..operations.len())]);
        let ops: Vec<_> = ops.collect();
        let mut code: Vec<_> =
            ops.into_iter().map(|op| instruction(rng, op)).collect::<Option<_>>()?;
        let back = -4 * (code.len() as i32 + 1);
        code.push(Instruction::new(Op::Ai, [2, 2, 0, 0], -1));
        code.push(Instruction::new(Op::Brnz, [2, 0, 0, 0], back));
        Some(code)
    });
}

/// A store into the trace's own code never runs in a unit, because the code after it may change.
#[test]
fn stores_into_code_are_interpreted() {
    let mut rng = ChaCha8Rng::seed_from_u64(8);
    let states = [state(&mut rng, false)];
    for address in [START, START + 16, START + 32] {
        let store = Instruction::new(Op::Stqa, [3, 0, 0, 0], address as i32);
        let code = [&[Instruction::new(Op::Ai, [3, 3, 0, 0], 1); 6][..], &[store]].concat();
        let trace = trace(&code, &states[0]);
        let mut emitted = Emitted::new();
        emitted.install(&trace, FloatMode::SINGLES);
        let exit = compare(&mut emitted, FloatMode::SINGLES, &code, &states[0]);
        // The code ends within the second quadword.
        let within = address < START + 32;
        assert_eq!(exit, if within { Exit::Interpret } else { Exit::Left }, "{address:#x}");
    }
}
