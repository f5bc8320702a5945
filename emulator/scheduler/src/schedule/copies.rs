//! Copies of values that would otherwise live longer than a pass of the loop takes.
//!
//! A register holds a value until the next pass makes its own. A later reader therefore gets a
//! copy, made by an instruction that is scheduled like any other.

use super::dependence::{Edge, Freedom, cyclic};
use super::function::{Node, Registers};
use super::layout::plain;
use super::modulo::{impossible, longest};
use super::values::{Source, Values};
use spu_isa::{Op, Pipe};

/// The first number that is not a register of the machine.
const FIRST_VIRTUAL: u8 = 128;

/// The body with copies, so that no value lives longer than `life` for each pass that the kernel
/// contains. `None` if copies don't help, or if no pipe has free slots for them in `interval`
/// cycles.
pub(super) fn insert(
    body: &[Node],
    interval: i64,
    life: i64,
    live: Registers,
    freedom: Freedom,
) -> Option<Vec<Node>> {
    let mut nodes = body.to_vec();
    for register in FIRST_VIRTUAL..=u8::MAX {
        let mut edges = cyclic(&nodes, live, freedom);
        let Some(cycle) = impossible(nodes.len(), &edges, life) else {
            return Some(nodes);
        };
        edges.retain(|edge| edge.keeps.is_none());
        if impossible(nodes.len(), &edges, life).is_some() {
            return None;
        }
        let early = longest(&edges, life, vec![0; nodes.len()], true);
        // The value that lives longest.
        let lives = |edge: &Edge| early[edge.from] + life * (1 - edge.distance) - early[edge.to];
        let kept = cycle.iter().filter(|edge| edge.keeps.is_some());
        let longest_lived = kept.max_by_key(|edge| lives(edge))?;
        let (reader, source) = (longest_lived.from, longest_lived.keeps?);
        let has_free_slot = |pipe| {
            let taken = nodes.iter().filter(|node| node.pipe() == pipe).count();
            (taken as i64) < interval
        };
        let op = if has_free_slot(Pipe::Odd) {
            Op::Shlqbyi
        } else if has_free_slot(Pipe::Even) {
            Op::Ori
        } else {
            return None;
        };
        nodes = with_copy(nodes, reader, source, &early, op, register);
    }
    None
}

/// Gives a copy in `register` to `reader` and to all who read the value no earlier than it.
fn with_copy(
    nodes: Vec<Node>,
    reader: usize,
    source: Source,
    early: &[i64],
    op: Op,
    register: u8,
) -> Vec<Node> {
    let values = Values::of(&nodes);
    let (position, copied, named) = match source {
        Source::Node(at) => (at + 1, nodes[at].i.rt, nodes[at].plain.rt),
        Source::Entry(register) => (0, register, register),
    };
    let mut copy = Node::added(plain(op, register, copied, 0), None, "copy");
    copy.plain = plain(op, named, named, 0);
    // The instruction that makes the register's next value continues to read the original.
    let next = match source {
        Source::Node(_) => None,
        Source::Entry(register) => values.last[usize::from(register)],
    };
    let mut changed = nodes;
    for (at, reads) in values.reads.iter().enumerate() {
        if at != reader && (early[at] < early[reader] || next == Some(at)) {
            continue;
        }
        for &(field, _) in reads.iter().filter(|read| read.1 == source) {
            changed[at].set_register(field, register);
        }
    }
    changed.insert(position, copy);
    changed
}
