//! Which loads and stores may access the same quadword.
//!
//! `docs/spu-programming.md` has the rules. In kernels, accesses through different base values do
//! not overlap. In drivers, only objects of different names and the stack do not. Accesses through
//! the same base value overlap if their offsets do. A store marked `may alias` overlaps every
//! access.

use super::Kind;
use super::function::{Node, Reference};
use super::values::{Source, Values};
use spu_isa::{Field, Op};

/// Size of an access in bytes.
const QUADWORD: i64 = 16;
const STACK_POINTER: u8 = 1;

/// The value that an address is computed from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Root {
    /// A register at the start of the block.
    Entry(u8),
    /// The result of a node.
    Node(usize),
    /// A section or a symbol.
    Place(String),
    /// Address 0.
    Zero,
}

/// A load or store.
#[derive(Clone, Debug)]
struct Access {
    root: Root,
    /// The second register of an indexed access, unless its value is a known constant.
    index: Option<Root>,
    offset: i64,
    store: bool,
    /// Whether it may overlap any other access.
    anything: bool,
}

impl Access {
    /// Whether it stays within one named object or the stack.
    fn is_object(&self) -> bool {
        self.index.is_none() && matches!(self.root, Root::Place(_) | Root::Entry(STACK_POINTER))
    }
}

/// The loads and stores of a block.
pub(super) struct Memory {
    kind: Kind,
    accesses: Vec<Option<Access>>,
    /// For each register that a pass hands to the next: where its value comes from.
    carried: Vec<(u8, Root, i64)>,
}

impl Memory {
    pub fn of(nodes: &[Node], values: &Values, kind: Kind) -> Self {
        let access = |(at, node)| access(nodes, values, at, node);
        let accesses = nodes.iter().enumerate().map(access).collect();
        let mut carried = Vec::new();
        for (register, last) in (0u8..=255).zip(values.last) {
            if let Some(last) = last {
                let (root, offset) = trace(nodes, values, Source::Node(last));
                carried.push((register, root, offset));
            }
        }
        Self { kind, accesses, carried }
    }

    /// Whether the order of two accesses of one pass matters.
    pub fn conflict(&self, one: usize, other: usize, in_loop: bool) -> bool {
        let (Some(one), Some(other)) = (&self.accesses[one], &self.accesses[other]) else {
            return false;
        };
        if !one.store && !other.store {
            return false;
        }
        if one.anything || other.anything {
            return true;
        }
        if self.kind == Kind::Driver && one.root != other.root {
            return !(one.is_object() && other.is_object());
        }
        let same_record = |one: &Root, other: &Root| {
            one == other || in_loop && self.carried_root(one).0 == self.carried_root(other).0
        };
        if !same_record(&one.root, &other.root) {
            return false;
        }
        let distance = if one.root == other.root {
            one.offset - other.offset
        } else {
            // One accesses a record, the other the record of the pass before. The two records are
            // the same or disjoint.
            one.offset + self.carried_root(&one.root).1
                - other.offset
                - self.carried_root(&other.root).1
        };
        one.index != other.index || distance.abs() < QUADWORD
    }

    /// After how many passes, at least one, `later` may access the quadword that `earlier`
    /// accessed.
    pub fn passes_to_conflict(&self, earlier: usize, later: usize) -> Option<i64> {
        let (Some(earlier), Some(later)) = (&self.accesses[earlier], &self.accesses[later]) else {
            return None;
        };
        if !earlier.store && !later.store {
            return None;
        }
        if earlier.anything || later.anything {
            return Some(1);
        }
        let (root, offset) = self.carried_root(&earlier.root);
        let (later_root, later_offset) = self.carried_root(&later.root);
        if root != later_root {
            return None;
        }
        if earlier.index != later.index {
            return Some(1);
        }
        let step = match &earlier.index {
            None => self.step(root),
            Some(index) => match (self.step(root), self.step(index)) {
                (Some(base), Some(index)) => Some(base + index),
                _ => return Some(1),
            },
        };
        let ahead = earlier.offset + offset - later.offset - later_offset;
        match step {
            // The address moves to a new record in each pass, or stays, or moves to another that
            // does not overlap.
            None | Some(0) => (ahead.abs() < QUADWORD).then_some(1),
            Some(step) => {
                let near = ahead.div_euclid(step);
                let passes = (near - QUADWORD..=near + QUADWORD).filter(|&passes| passes >= 1);
                passes.into_iter().find(|passes| (ahead - passes * step).abs() < QUADWORD)
            }
        }
    }

    /// If a register gets a value of its own in each pass, it is treated as that value.
    fn carried_root<'a>(&'a self, root: &'a Root) -> (&'a Root, i64) {
        if let Root::Entry(register) = root
            && let Some((_, from, offset)) = self.carried.iter().find(|(r, ..)| r == register)
            && matches!(from, Root::Node(_))
        {
            return (from, *offset);
        }
        (root, 0)
    }

    /// The bytes by which a root moves in a pass, or `None` if it is an unrelated value in each
    /// pass.
    fn step(&self, root: &Root) -> Option<i64> {
        match root {
            Root::Node(_) => None,
            Root::Place(_) | Root::Zero => Some(0),
            Root::Entry(register) => {
                let Some((_, from, step)) = self.carried.iter().find(|(r, ..)| r == register)
                else {
                    return Some(0);
                };
                (from == root).then_some(*step)
            }
        }
    }
}

fn access(nodes: &[Node], values: &Values, at: usize, node: &Node) -> Option<Access> {
    let store = node.is_store();
    if !store && !node.is_load() {
        return None;
    }
    let immediate = i64::from(node.i.immediate);
    let traced = |field| {
        let source = values.operand(at, field);
        source.map_or((Root::Zero, 0), |source| trace(nodes, values, source))
    };
    let (root, index, offset) = match node.i.op {
        Op::Lqd | Op::Stqd => {
            let (root, offset) = traced(Field::Ra);
            (root, None, offset + immediate)
        }
        Op::Lqx | Op::Stqx => {
            let (base, near) = traced(Field::Ra);
            let (index, far) = traced(Field::Rb);
            match (base, index) {
                (root, Root::Zero) | (Root::Zero, root) => (root, None, near + far),
                (root, index) => (root, Some(index), near + far),
            }
        }
        _ => match &node.reference {
            Some(Reference::Symbol(symbol)) => {
                (Root::Place(symbol.place.clone()), None, symbol.offset)
            }
            _ => (Root::Zero, None, immediate),
        },
    };
    Some(Access { root, index, offset, store, anything: node.may_alias || node.in_order })
}

/// Expresses a value as another value plus a constant.
pub(super) fn trace(nodes: &[Node], values: &Values, source: Source) -> (Root, i64) {
    let mut source = source;
    let mut offset = 0;
    loop {
        let at = match source {
            Source::Entry(register) => return (Root::Entry(register), offset),
            Source::Node(at) => at,
        };
        let node = &nodes[at];
        let immediate = i64::from(node.i.immediate);
        let moves = matches!(node.i.op, Op::Ori | Op::Shlqbyi) && immediate == 0;
        match (node.i.op, &node.reference) {
            (Op::Il | Op::Ila, None) => return (Root::Zero, offset + immediate),
            (Op::Ila, Some(Reference::Symbol(symbol))) => {
                return (Root::Place(symbol.place.clone()), offset + symbol.offset);
            }
            (Op::Ai, None) => offset += immediate,
            _ if moves => {}
            _ => return (Root::Node(at), offset),
        }
        match values.operand(at, Field::Ra) {
            Some(before) => source = before,
            None => return (Root::Node(at), offset),
        }
    }
}
