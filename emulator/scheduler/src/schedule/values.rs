//! Which instruction makes the value that each operand reads.

use super::function::{Node, POOL, Registers, bit};
use spu_isa::Field;

/// The origin of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Source {
    /// The result of a node of the block.
    Node(usize),
    /// The content of this register at the start of the block.
    Entry(u8),
}

pub(super) struct Values {
    /// The fields that each node reads, with their origins.
    pub reads: Vec<Vec<(Field, Source)>>,
    /// The last node that writes each register, including virtual ones.
    pub last: [Option<usize>; 256],
}

impl Values {
    pub fn of(nodes: &[Node]) -> Self {
        let mut last = [None; 256];
        let mut reads = Vec::with_capacity(nodes.len());
        for (at, node) in nodes.iter().enumerate() {
            let sources = node.reads().map(|(field, register)| {
                let made = last[usize::from(register)];
                (field, made.map_or(Source::Entry(register), Source::Node))
            });
            reads.push(sources.collect());
            if let Some(register) = node.writes() {
                last[usize::from(register)] = Some(at);
            }
        }
        Self { reads, last }
    }

    /// The value that a node reads in a field.
    pub fn operand(&self, node: usize, field: Field) -> Option<Source> {
        let reads = self.reads[node].iter();
        reads.copied().find(|read| read.0 == field).map(|read| read.1)
    }

    /// Whether a node of a loop makes the last value of a register that is in `live`, which is live
    /// at the start of the loop or after it. Such values keep the source's register.
    pub fn hands_on(&self, nodes: &[Node], at: usize, live: Registers) -> bool {
        nodes[at].writes().is_some_and(|register| {
            let last = self.last[usize::from(register)] == Some(at);
            register < 128 && live & bit(register) != 0 && last
        })
    }

    /// The previous value of its register that a node replaces, if it reads its own target.
    pub fn replaced(&self, nodes: &[Node], at: usize) -> Option<Source> {
        nodes[at].writes()?;
        self.operand(at, Field::Rt)
    }

    /// For each node, the first of the chain of nodes that replace each other's value up to it.
    /// All of these share one register.
    pub fn heads(&self, nodes: &[Node]) -> Vec<usize> {
        let mut heads: Vec<usize> = Vec::with_capacity(nodes.len());
        for at in 0..nodes.len() {
            heads.push(match self.replaced(nodes, at) {
                Some(Source::Node(from)) => heads[from],
                _ => at,
            });
        }
        heads
    }

    /// Which values keep the source's register: the last ones that are in `live`, all in registers
    /// outside the pool, and those that share a register with one of these or with a value from
    /// before the block.
    pub fn kept(&self, nodes: &[Node], live: Registers) -> Vec<bool> {
        let heads = self.heads(nodes);
        let mut kept = vec![false; nodes.len()];
        for (at, node) in nodes.iter().enumerate() {
            let Some(register) = node.writes() else {
                continue;
            };
            let last = self.last[usize::from(register)] == Some(at);
            let from_before = matches!(self.replaced(nodes, at), Some(Source::Entry(_)));
            if !POOL.contains(&register) || last && live & bit(register) != 0 || from_before {
                kept[heads[at]] = true;
            }
        }
        heads.into_iter().map(|head| kept[head]).collect()
    }
}
