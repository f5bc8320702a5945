//! Which instructions must issue before which, and by how many cycles.
//!
//! An edge means `cycle(to) >= cycle(from) + latency - distance * interval`, where the interval is
//! the number of cycles from one pass of a loop to the next. Any order that respects the edges
//! gives correct results, because the pipelines wait by themselves. The latencies only make a
//! schedule fast.

use super::Kind;
use super::displacement::Movable;
use super::function::{Node, Reference, Registers};
use super::memory::Memory;
use super::values::{Source, Values};
use spu_isa::{Class, Field, Op, Pipe};

/// What a kernel may do so that passes overlap more freely.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Freedom {
    /// Whether accesses may move across the increments of their address.
    pub moves: bool,
    /// How many passes the kernel's code contains, in each of which values have other registers.
    pub passes: i64,
}

impl Freedom {
    pub const NONE: Self = Self { moves: false, passes: 1 };
}

/// A pair of instructions of which one must issue before the other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub from: usize,
    pub to: usize,
    pub latency: i64,
    /// The number of passes between the two instructions.
    pub distance: i64,
    /// For an edge that only keeps a register from being overwritten: the value that `from` reads
    /// there.
    pub keeps: Option<Source>,
}

/// The minimum number of cycles between two instructions if the first must come before the second
/// in the code.
pub(super) fn in_order(before: &Node, later: &Node) -> i64 {
    i64::from(!(before.pipe() == Pipe::Even && later.pipe() == Pipe::Odd))
}

struct Graph<'a> {
    nodes: &'a [Node],
    edges: Vec<Edge>,
}

impl Graph<'_> {
    fn order(&mut self, from: usize, to: usize, distance: i64) {
        self.keep(from, to, distance, None);
    }

    fn keep(&mut self, from: usize, to: usize, distance: i64, keeps: Option<Source>) {
        if from == to {
            return;
        }
        self.edges.push(Edge {
            from,
            to,
            latency: in_order(&self.nodes[from], &self.nodes[to]),
            distance,
            keeps,
        });
    }

    fn flow(&mut self, from: usize, to: usize, distance: i64) {
        self.edges.push(Edge {
            from,
            to,
            latency: i64::from(self.nodes[from].class().latency()),
            distance,
            keeps: None,
        });
    }

    fn memory(&mut self, memory: &Memory, in_loop: bool) {
        for to in 0..self.nodes.len() {
            for from in 0..to {
                if memory.conflict(from, to, in_loop) {
                    self.order(from, to, 0);
                }
            }
        }
    }
}

/// The edges of a block that runs once. With `renaming`, the block may use as many registers of
/// the pool as it needs, except for the values in `live`, which stay in their registers.
pub(super) fn straight(nodes: &[Node], live: Registers, renaming: bool, kind: Kind) -> Vec<Edge> {
    let values = Values::of(nodes);
    let memory = Memory::of(nodes, &values, kind);
    let kept = values.kept(nodes, live);
    let mut graph = Graph { nodes, edges: Vec::new() };
    let mut readers: Vec<Vec<(usize, Source)>> = vec![Vec::new(); 256];
    let mut writer: [Option<usize>; 256] = [None; 256];
    let mut barrier = None;
    let mut hint = None;
    for (at, node) in nodes.iter().enumerate() {
        for &(_, source) in &values.reads[at] {
            if let Source::Node(from) = source {
                graph.flow(from, at, 0);
            }
        }
        if let Some(register) = node.writes() {
            let slot = usize::from(register);
            let stays = |&source: &Source| match source {
                Source::Node(from) => !renaming || kept[from],
                Source::Entry(_) => true,
            };
            let replaced = values.replaced(nodes, at);
            for &(reader, source) in &readers[slot] {
                let overwritten = (!renaming || kept[at]) && stays(&source);
                if overwritten || replaced == Some(source) {
                    graph.order(reader, at, 0);
                }
            }
            if !renaming || kept[at] {
                if let Some(before) = writer[slot] {
                    graph.order(before, at, 0);
                }
                writer[slot] = Some(at);
            }
        }
        for &(_, source) in &values.reads[at] {
            let register = match source {
                Source::Node(from) => nodes[from].i.rt,
                Source::Entry(register) => register,
            };
            readers[usize::from(register)].push((at, source));
        }
        if let Some(before) = barrier {
            graph.order(before, at, 0);
        }
        if node.class() == Class::Hb {
            // A hint replaces the one before it.
            if let Some(before) = hint {
                graph.order(before, at, 0);
            }
            hint = Some(at);
        }
        if let Some(Reference::Hint { late: true, .. }) = node.reference {
            for before in 0..at {
                graph.order(before, at, 0);
            }
        }
        if node.is_barrier() || node.ends_block() {
            for (before, earlier) in nodes[..at].iter().enumerate() {
                graph.order(before, at, 0);
                if earlier.class() == Class::Hb {
                    graph.flow(before, at, 0);
                }
            }
            barrier = Some(at);
        }
    }
    graph.memory(&memory, false);
    graph.edges
}

/// The edges of a loop's body, without the branch back, for passes that overlap. `live` are the
/// registers that are live at the start of the loop or after it.
///
/// Each register holds a value until the next pass that uses the register makes its own. The edges
/// with [`keeps`](Edge::keeps) ensure this.
pub(super) fn cyclic(nodes: &[Node], live: Registers, freedom: Freedom) -> Vec<Edge> {
    let values = Values::of(nodes);
    let memory = Memory::of(nodes, &values, Kind::Kernel);
    let mut graph = Graph { nodes, edges: Vec::new() };
    for (at, movable) in Movable::of_loop(nodes, freedom).into_iter().enumerate() {
        if let Some(Movable { increment, ahead, .. }) = movable {
            graph.flow(increment, at, 1 - ahead.0);
            graph.order(at, increment, ahead.1);
        }
        for &(field, source) in &values.reads[at] {
            if movable.is_some() && field == Field::Ra {
                continue;
            }
            let (from, distance) = match source {
                Source::Node(from) => (from, 0),
                Source::Entry(register) => match values.last[usize::from(register)] {
                    Some(from) => (from, 1),
                    None => continue,
                },
            };
            graph.flow(from, at, distance);
            let passes = if values.hands_on(nodes, from, live) { 1 } else { freedom.passes };
            graph.keep(at, from, passes - distance, Some(source));
        }
    }
    graph.memory(&memory, true);
    for from in 0..nodes.len() {
        for to in 0..nodes.len() {
            if let Some(distance) = memory.passes_to_conflict(from, to) {
                graph.order(from, to, distance);
            }
        }
    }
    graph.edges
}

/// The reason why the body of a loop can't be pipelined, if there is one.
pub(super) fn obstacle(body: &[Node]) -> Option<String> {
    let values = Values::of(body);
    let bad = |at: &usize| body[*at].is_barrier() || values.replaced(body, *at).is_some();
    let node = &body[(0..body.len()).find(bad)?];
    let mnemonic = node.i.op.row().mnemonic;
    let why = if node.is_barrier() {
        "no instruction may move past it"
    } else {
        "it changes its own target"
    };
    Some(format!("`{mnemonic}` at line {}: {why}", node.line))
}

/// The node that counts down a loop which ends when its counter is 0.
pub(super) fn counter(body: &[Node], register: u8) -> Option<usize> {
    let mut writers = (0..body.len()).filter(|&at| body[at].writes() == Some(register));
    let at = writers.next()?;
    let i = body[at].i;
    let counts = i.op == Op::Ai && i.register(Field::Ra) == register && i.immediate == -1;
    (counts && writers.next().is_none()).then_some(at)
}
