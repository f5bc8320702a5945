//! Reads the test vectors of all instructions back with code that is emitted for WebAssembly.
//! `spu-tool` has the tests of the other engines.

use super::units::{Outcome, Run};
use super::wasm::Emitted;
use crate::prelude::*;
use spu_isa::Machine;
use spu_jit::{Exit, FloatMode, Step, Trace};
use spu_tool::vectors::{Generator, Vector};

/// Why a vector is not run by emitted code.
#[derive(Debug, PartialEq, Eq)]
enum Skipped {
    /// Units do not contain the instruction.
    NotCompiled,
    /// The unit leaves it to the interpreter: a halt, or operands outside the mode.
    Left,
}

/// Runs the vector's instruction as a unit, and compares the state with the vector's.
fn check(emitted: &mut Emitted, vector: &Vector, mode: FloatMode) -> Result<(), Skipped> {
    let instruction = vector.initial.instruction().expect("a vector has an instruction");
    let step = Step {
        pc: vector.initial.pc,
        word: instruction.encode(),
        instruction,
        next: vector.after.pc,
    };
    let trace = Trace::new(vec![step]).ok_or(Skipped::NotCompiled)?;
    emitted.install(&trace, mode);
    let (mut spu, local_store) = (Spu::new(), LocalStore::new());
    spu.registers = std::array::from_fn(|number| Quad::splat(0xdead_be00 | number as u32));
    let unit = vector.initial.load(&mut spu, &local_store);
    let before = spu.registers;
    let Outcome { registers, fpscr, local_store, exit, pc, executed } =
        emitted.run(&spu, &local_store);
    if executed == 0 {
        assert!(matches!(exit, Exit::Interpret | Exit::Failed(_)), "{vector:x?}: {exit:?}");
        return Err(Skipped::Left);
    }
    spu.registers = registers;
    spu.fpscr = Fpscr::from_words(fpscr);
    spu.set_pc(pc);
    let found = vector.after.of(&spu, &local_store, &unit);
    assert_eq!((&found, executed, vector.stop), (&vector.after, 1, None), "{vector:x?}");
    for (number, (now, before)) in (0..).zip(registers.iter().zip(&before)) {
        let mentioned = vector.after.register(number).is_some();
        assert!(mentioned || now == before, "{vector:x?}: ${number}");
    }
    Ok(())
}

#[test]
fn emitted_code_passes_all_vectors() {
    let mut emitted = Emitted::new();
    let (mut passed, mut all) = (0, 0);
    for row in Op::rows().iter().filter(|row| row.machine == Machine::Every) {
        for vector in Generator::new(row.op, 0).take(randomness::rounds(8) as usize) {
            for mode in [FloatMode::SINGLES, FloatMode::DOUBLES, FloatMode::EXACT_DOUBLES] {
                all += 1;
                match check(&mut emitted, &vector, mode) {
                    Ok(()) => passed += 1,
                    Err(Skipped::NotCompiled) => break,
                    Err(Skipped::Left) => {}
                }
            }
        }
    }
    println!("{passed} of {all} runs were by emitted code");
    assert!(passed > all * 9 / 10, "only {passed} of {all}");
}
