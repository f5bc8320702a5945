//! Which instruction makes the value that each operand reads.

use super::function::{Node, POOL, Registers, bit};
use spu_isa::Field;

/// Where a value comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Source {
    /// From a node of the block.
    Node(usize),
    /// From this register at the start of the block.
    Entry(u8),
}

/// The values of a block.
pub(super) struct Values {
    /// For each node the fields that it reads.
    pub reads: Vec<Vec<(Field, Source)>>,
    /// The last node that writes each register, virtual ones included.
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
        reads
            .copied()
            .find(|read| read.0 == field)
            .map(|read| read.1)
    }

    /// The value that a node replaces in its register: it reads its own target.
    pub fn replaced(&self, nodes: &[Node], at: usize) -> Option<Source> {
        nodes[at].writes()?;
        self.operand(at, Field::Rt)
    }

    /// For each node the first of those that replace each other's value up to it: all these are in
    /// one register.
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

    /// Which values keep the register of the source: the last that are in `live`, all of registers
    /// outside the pool, and what shares a register with one of these or with one from before.
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
