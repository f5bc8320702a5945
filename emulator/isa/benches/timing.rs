//! Measures how many instructions a second of wall-clock time the pipeline model processes. The
//! figures are recorded, not checked.
//!
//! Each stream is a loop, fed as the interpreter feeds it, with a branch every sixteen
//! instructions.

#![expect(clippy::print_stdout, reason = "a benchmark has nothing to lose but its output")]

use spu_isa::timing::{Pipeline, Rules};
use spu_isa::{Instruction, Op};
use std::time::Instant;

const ROUNDS: u32 = 2_000_000;

/// An instruction on a few registers, so that some instructions have to wait.
fn instruction(op: Op, number: u8) -> Instruction {
    let [rt, ra, rc] = [0, 3, 1].map(|offset| 10 + (number + offset) % 7);
    Instruction::new(op, [rt, ra, 20, rc], 0)
}

fn measure(name: &str, rules: Rules, ops: [Op; 5]) {
    let body: Vec<Instruction> =
        (0..15).map(|number| instruction(ops[usize::from(number) % ops.len()], number)).collect();
    let branch = instruction(Op::Brnz, 15);
    let mut pipeline = Pipeline::new(rules);
    let start = Instant::now();
    for _ in 0..ROUNDS {
        for (pc, &instruction) in (0..).step_by(4).zip(&body) {
            pipeline.issue(pc, instruction);
        }
        pipeline.issue(60, branch);
        pipeline.branched(60, Some(0));
    }
    let seconds = start.elapsed().as_secs_f64();
    let instructions = pipeline.account().instructions();
    println!(
        "{name:12} {:6.0} million instructions/s ({:.2} cycles each)",
        instructions as f64 / seconds / 1e6,
        pipeline.clock() as f64 / instructions as f64
    );
}

fn main() {
    let rules = Rules::default();
    let prefetch = Rules { inline_prefetch: true, ..rules };
    let mixed = [Op::A, Op::Lqd, Op::Fma, Op::Shufb, Op::Mpy];
    measure("integer", rules, [Op::A, Op::Shufb, Op::Xor, Op::Lnop, Op::Ceq]);
    measure("float", rules, [Op::Fa, Op::Fma, Op::Fi, Op::Frest, Op::Fcgt]);
    measure("mixed", rules, mixed);
    measure("prefetch", prefetch, mixed);
}
