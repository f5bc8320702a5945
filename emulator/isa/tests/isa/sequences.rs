//! Sequences of instructions, and the cycles in which they issue.

use spu_isa::timing::{Issue, Pipeline, Rules};
use spu_isa::{Instruction, Op};

/// An instruction with target `rt` and its sources in the order ra, rb, rc.
pub fn i(mnemonic: &str, rt: u8, sources: &[u8]) -> Instruction {
    let source = |n: usize| sources.get(n).copied().unwrap_or(0);
    let op = Op::of_mnemonic(mnemonic).unwrap();
    Instruction::new(op, [rt, source(0), source(1), source(2)], 0)
}

pub fn hint(mnemonic: &str, branch_distance: i16, immediate: i32) -> Instruction {
    Instruction { branch_distance, immediate, ..i(mnemonic, 0, &[90]) }
}

/// Feeds straight-line code that starts at `pc`.
pub fn feed(pipeline: &mut Pipeline, pc: u32, code: &[Instruction]) -> Vec<Issue> {
    let addresses = (pc..).step_by(4);
    let issue = |(pc, &instruction)| pipeline.issue(pc, instruction);
    addresses.zip(code).map(issue).collect()
}

pub fn cycles_from(pc: u32, code: &[Instruction]) -> Vec<u64> {
    let issues = feed(&mut Pipeline::default(), pc, code);
    issues.iter().map(|issue| issue.cycle).collect()
}

pub fn cycles(code: &[Instruction]) -> Vec<u64> {
    cycles_from(0, code)
}

pub fn cycles_by(rules: Rules, code: &[Instruction]) -> Vec<u64> {
    let issues = feed(&mut Pipeline::new(rules), 0, code);
    issues.iter().map(|issue| issue.cycle).collect()
}

pub fn nops(count: usize) -> Vec<Instruction> {
    vec![i("nop", 127, &[]); count]
}
