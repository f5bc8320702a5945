//! Which loads and stores may meet in the same quadword.
//!
//! The rules are `docs/schedule.md`'s: accesses through different base values do not overlap,
//! those through the same one do if their offsets do, and a store marked `may alias` overlaps
//! everything.

use super::function::{Node, Reference};
use super::values::{Source, Values};
use spu_isa::{Field, Op};

/// Bytes of an access.
const QUADWORD: i64 = 16;

/// The value that an address starts from.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Root {
    /// A register at the start of the block.
    Entry(u8),
    /// What a node makes.
    Node(usize),
    /// A section or a symbol.
    Place(String),
    /// Address 0.
    Zero,
}

/// An access.
#[derive(Clone, Debug)]
struct Access {
    root: Root,
    /// The second register of an indexed access, unless it is a known constant.
    index: Option<Root>,
    offset: i64,
    store: bool,
    /// Whether it may meet any other access.
    anything: bool,
}

/// The accesses of a block.
pub(super) struct Memory {
    accesses: Vec<Option<Access>>,
    /// For each register that a pass hands to the next: where its value comes from.
    carried: Vec<(u8, Root, i64)>,
}

impl Memory {
    pub fn of(nodes: &[Node], values: &Values) -> Self {
        let access = |(at, node)| access(nodes, values, at, node);
        let accesses = nodes.iter().enumerate().map(access).collect();
        let mut carried = Vec::new();
        for (register, last) in (0u8..=255).zip(values.last) {
            if let Some(last) = last {
                let (root, offset) = trace(nodes, values, Source::Node(last));
                carried.push((register, root, offset));
            }
        }
        Self { accesses, carried }
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
        let same_record = |one: &Root, other: &Root| {
            one == other || in_loop && self.anew(one).0 == self.anew(other).0
        };
        if !same_record(&one.root, &other.root) {
            return false;
        }
        let distance = if one.root == other.root {
            one.offset - other.offset
        } else {
            // A record and the one of the pass before: they coincide or are disjoint.
            one.offset + self.anew(&one.root).1 - other.offset - self.anew(&other.root).1
        };
        one.index != other.index || distance.abs() < QUADWORD
    }

    /// After how many passes, at least one, `later` may meet what `earlier` accessed.
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
        let (root, offset) = self.anew(&earlier.root);
        let (later_root, later_offset) = self.anew(&later.root);
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
            // A new record each pass, the same one, or another that does not overlap.
            None | Some(0) => (ahead.abs() < QUADWORD).then_some(1),
            Some(step) => {
                let near = ahead.div_euclid(step);
                let passes = (near - QUADWORD..=near + QUADWORD).filter(|&passes| passes >= 1);
                passes
                    .into_iter()
                    .find(|passes| (ahead - passes * step).abs() < QUADWORD)
            }
        }
    }

    /// A register that gets a value of its own each pass stands for that value.
    fn anew<'a>(&'a self, root: &'a Root) -> (&'a Root, i64) {
        if let Root::Entry(register) = root
            && let Some((_, from, offset)) = self.carried.iter().find(|(r, ..)| r == register)
            && matches!(from, Root::Node(_))
        {
            return (from, *offset);
        }
        (root, 0)
    }

    /// Bytes by which a root moves in a pass; `None` if it is another value each pass.
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
    Some(Access {
        root,
        index,
        offset,
        store,
        anything: node.may_alias || node.in_order,
    })
}

/// A value as another one and a constant.
fn trace(nodes: &[Node], values: &Values, source: Source) -> (Root, i64) {
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
            (Op::Ai, _) => offset += immediate,
            _ if moves => {}
            _ => return (Root::Node(at), offset),
        }
        match values.operand(at, Field::Ra) {
            Some(before) => source = before,
            None => return (Root::Node(at), offset),
        }
    }
}
