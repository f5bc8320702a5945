//! Places instructions in pairs of words and computes their cycles in the model.
//!
//! Two instructions of one cycle are at 0 and 4 mod 8. Other instructions follow each other
//! directly, because the pipelines wait by themselves. If an odd number of them comes before a
//! pair, a no-operation fills the gap.

use super::function::{BlockId, Node};
use spu_isa::timing::rules::{HINT_MINIMUM_INSTRUCTIONS, MISS_CYCLES};
use spu_isa::timing::{Pipeline, Rules};
use spu_isa::{Class, Instruction, Op, Pipe};

/// The register that GCC names in its padding, so that no register in use is encoded as a target.
const UNUSED_TARGET: u8 = 127;

/// The cycles from the first instruction of a block, which is at 0 mod 8, to its end.
pub(super) fn cost(nodes: &[Node], cycles: &[u64]) -> u64 {
    let mut pipeline = Pipeline::new(Rules::default());
    let words = fill(nodes, cycles);
    for (address, node) in (0..).step_by(4).zip(&words) {
        pipeline.issue(address, node.i);
    }
    pipeline.clock()
}

/// The cycles of a block at the address `start`, without padding, and the first cycle in which all
/// of its results are ready. A hint that is too near to its branch costs as much as a miss. `ahead`
/// is the number of instructions from the block's end to a branch, if it comes after it.
pub(super) fn cost_in_place(
    nodes: &[&Node],
    start: u32,
    ahead: &dyn Fn(BlockId) -> Option<usize>,
) -> (u64, u64) {
    let mut pipeline = Pipeline::new(Rules::default());
    let (mut ready, mut late) = (0, 0);
    for ((at, pc), node) in (1..).zip((start..).step_by(4)).zip(nodes) {
        ready = ready.max(pipeline.issue(pc, node.i).ready_cycle);
        if let Some(ahead) = node.hinted.and_then(ahead) {
            let between = (nodes.len() - at + ahead) as u64;
            late += if between < HINT_MINIMUM_INSTRUCTIONS { MISS_CYCLES } else { 0 };
        }
    }
    (pipeline.clock() + late, ready)
}

/// The block padded with no-operations to an even number of words.
pub(super) fn fill(nodes: &[Node], cycles: &[u64]) -> Vec<Node> {
    let mut words: Vec<Node> = Vec::with_capacity(nodes.len() * 2);
    let mut at = 0;
    while at < nodes.len() {
        let paired = at + 1 < nodes.len()
            && cycles[at] == cycles[at + 1]
            && nodes[at].pipe() != nodes[at + 1].pipe();
        if paired {
            complete(&mut words);
            words.push(nodes[at].clone());
            at += 1;
        }
        words.push(nodes[at].clone());
        at += 1;
    }
    complete(&mut words);
    words
}

/// Pads the words to a multiple of 8 bytes without costing a cycle.
fn complete(words: &mut Vec<Node>) {
    if words.len().is_multiple_of(2) {
        return;
    }
    let last = words.len() - 1;
    let node = &words[last];
    if node.pipe() == Pipe::Even {
        words.push(no_operation(Op::Lnop, node.stage));
    } else {
        let filler = no_operation(Op::Nop, node.stage);
        words.insert(last, filler);
    }
}

fn no_operation(op: Op, stage: u32) -> Node {
    let rt = if op.row().class == Class::Nop { UNUSED_TARGET } else { 0 };
    let mut node = Node::added(plain(op, rt, 0, 0), None, "pairing");
    node.stage = stage;
    node
}

/// An instruction with registers and a constant as operands.
pub(super) fn plain(op: Op, rt: u8, ra: u8, immediate: i32) -> Instruction {
    Instruction::new(op, [rt, ra, 0, 0], immediate)
}
