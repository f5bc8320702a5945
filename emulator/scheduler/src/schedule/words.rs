//! Turns blocks into words: adds hints, registers and cycles of straight-line code, addresses,
//! labels and notes.

use std::collections::{BTreeMap, BTreeSet};

use super::function::{Block, BlockId, Function, Node, Reference, Registers, bit};
use super::layout::{fill, plain};
use super::names::Names;
use super::source::Source;
use super::text::{self, Word};
use super::{Kind, list, pipelined};
use crate::check;
use spu_isa::timing::rules::HINT_MINIMUM_INSTRUCTIONS;
use spu_isa::timing::{Rules, find_loops};
use spu_isa::{Class, Op};

/// The number of words between a hint and its branch that the hint can encode.
const HINT_WORDS: usize = 255;
/// The number of instructions between a hint and its branch that stays within this even after
/// padding.
const HINT_REACH: usize = 150;

/// The schedule of a function: its words, and their text.
pub(super) fn lay_out(
    function: &mut Function,
    names: &mut Names<'_>,
    source: &Source<'_>,
    path: &str,
) -> (Vec<Word>, String) {
    if function.kind == Kind::Kernel {
        hint_returns(function);
        hint_loops(function);
    }
    let mut blocks = scheduled(function);
    while let Some((block, hint)) = useless_hint(function, &blocks) {
        function.blocks[block].nodes.remove(hint);
        blocks = scheduled(function);
    }

    let mut labels = BTreeMap::new();
    let mut branches = BTreeMap::new();
    let hinted: BTreeMap<BlockId, Option<BlockId>> = hinted(function).collect();
    for (at, block) in function.blocks.iter().enumerate() {
        let referenced = function.branches_to(block.id) > 0;
        let label = match &block.name {
            Some(name) => names.label(name),
            None if at > 0 && referenced => names.label(&format!("{}_block", function.name)),
            None if referenced => function.name.clone(),
            None => String::new(),
        };
        if let Some(target) = hinted.get(&block.id) {
            let returns = block.nodes.last().is_some_and(Node::is_return);
            // The loop may begin in an earlier block than its last one.
            let target = target.and_then(|target| labels.get(&target));
            let branch = match (returns, target.unwrap_or(&label).as_str()) {
                (true, _) => format!("{}_return", function.name),
                (false, "") => format!("{}_back", function.name),
                (false, label) => format!("{label}_back"),
            };
            branches.insert(block.id, names.label(&branch));
        }
        labels.insert(block.id, label);
    }
    let words = words(function, blocks, &labels, &branches);
    let plain_path = (function.kind == Kind::Driver).then_some(path);
    let text = text::write(&words, &labels, &branches, names, source, plain_path);
    (words, text)
}

/// The registers that the words write.
pub(super) fn written(words: &[Word]) -> Registers {
    let written = words.iter().filter_map(|word| word.node.writes());
    written.fold(0, |set, register| set | bit(register))
}

fn scheduled(function: &Function) -> Vec<Vec<Node>> {
    if function.kind == Kind::Driver {
        // Blocks keep their sizes.
        let sizes = function.blocks.iter().map(|block| (block.id, block.nodes.len()));
        let starts: BTreeMap<BlockId, usize> = sizes
            .scan(0, |next, (id, size)| Some((id, std::mem::replace(next, *next + size))))
            .collect();
        let words = |block: &Block| {
            let start = starts[&block.id];
            let end = start + block.nodes.len();
            let ahead = |branch: BlockId| starts[&branch].checked_sub(end);
            list::reorder(&block.nodes, 4 * start as u32, &ahead)
        };
        return function.blocks.iter().map(words).collect();
    }
    let liveness = function.liveness();
    let words = |(at, block): (usize, &Block)| match &block.cycles {
        Some(cycles) => fill(&block.nodes, cycles),
        None => {
            let (nodes, cycles) = list::schedule(&block.nodes, liveness.end[at]);
            fill(&nodes, &cycles)
        }
    };
    function.blocks.iter().enumerate().map(words).collect()
}

/// Inserts a hint before each return, as early as its block allows.
fn hint_returns(function: &mut Function) {
    for block in &mut function.blocks {
        if block.nodes.last().is_some_and(Node::is_return) {
            let at = block.nodes.len().saturating_sub(HINT_REACH);
            let reference = Reference::Hint { branch: block.id, target: None, late: at > 0 };
            let hint = plain(Op::Hbr, 0, block.nodes[block.nodes.len() - 1].i.ra, 0);
            let hint = Node::added(hint, Some(reference), "hint");
            block.nodes.insert(at, hint);
        }
    }
}

/// Inserts a hint before each loop of one block that was not pipelined, or into the loop if it is
/// long.
fn hint_loops(function: &mut Function) {
    for at in 1..function.blocks.len() {
        let block = &function.blocks[at];
        let own = block.cycles.is_none() && block.flow().branch == Some(block.id);
        let (id, length) = (block.id, block.nodes.len());
        if own && length >= HINT_REACH {
            let place = length - HINT_REACH / 2;
            let hint = pipelined::hint(id, true);
            function.blocks[at].nodes.insert(place, hint);
            continue;
        }
        let before = &mut function.blocks[at - 1];
        if own && before.cycles.is_none() && before.flow().falls_through && length < HINT_REACH {
            let ends = usize::from(before.nodes.last().is_some_and(Node::ends_block));
            let end = before.nodes.len() - ends;
            let place = end.saturating_sub(HINT_REACH - length);
            before.nodes.insert(place, pipelined::hint(id, place > 0));
        }
    }
}

/// The blocks whose branches have hints, and the targets of these.
fn hinted(function: &Function) -> impl Iterator<Item = (BlockId, Option<BlockId>)> {
    let nodes = function.blocks.iter().flat_map(|block| &block.nodes);
    nodes.filter_map(|node| match node.reference {
        Some(Reference::Hint { branch, target, .. }) => Some((branch, target)),
        _ => None,
    })
}

/// A hint that is too near to its branch or too far from it: its block and its position there.
fn useless_hint(function: &Function, blocks: &[Vec<Node>]) -> Option<(usize, usize)> {
    let starts: Vec<usize> = blocks
        .iter()
        .scan(0, |at, words| {
            let start = *at;
            *at += words.len();
            Some(start)
        })
        .collect();
    for (at, words) in blocks.iter().enumerate() {
        let is_hint = |node: &Node| node.class() == Class::Hb;
        let Some(hint) = words.iter().position(is_hint) else {
            continue;
        };
        let Some(Reference::Hint { branch, .. }) = words[hint].reference else {
            continue;
        };
        let to = function.position(branch);
        let last = blocks[to].iter().rposition(Node::ends_block)?;
        let between = (starts[to] + last).saturating_sub(starts[at] + hint + 1);
        let returns = blocks[to][last].is_return();
        if between >= HINT_WORDS || returns && (between as u64) < HINT_MINIMUM_INSTRUCTIONS {
            let plain = function.blocks[at].nodes.iter().position(is_hint)?;
            if function.blocks[at].cycles.is_none() {
                return Some((at, plain));
            }
        }
    }
    None
}

/// Gives each word its address, the address that it refers to, and its note.
fn words(
    function: &Function,
    blocks: Vec<Vec<Node>>,
    labels: &BTreeMap<BlockId, String>,
    branches: &BTreeMap<BlockId, String>,
) -> Vec<Word> {
    let mut starts = BTreeMap::new();
    let mut ends = BTreeMap::new();
    let mut address = 0;
    for (block, words) in function.blocks.iter().zip(&blocks) {
        starts.insert(block.id, address);
        if let Some(last) = words.iter().rposition(Node::ends_block) {
            ends.insert(block.id, address + 4 * last as u32);
        }
        address += 4 * words.len() as u32;
    }
    let mut nodes: Vec<Node> = blocks.into_iter().flatten().collect();
    for (address, node) in (0u32..).step_by(4).zip(&mut nodes) {
        let distance = |to: u32| to.wrapping_sub(address) as i32;
        if let Some(branch) = node.hinted {
            node.i.branch_distance = distance(starts[&branch]) as i16;
        }
        match &node.reference {
            Some(Reference::Block(id)) => {
                node.i.immediate = match node.i.op {
                    Op::Bra | Op::Ila => starts[id] as i32,
                    _ => distance(starts[id]),
                };
            }
            Some(Reference::Hint { branch, target, .. }) => {
                node.i.branch_distance = distance(ends[branch]) as i16;
                node.i.immediate = target.map_or(0, |target| distance(starts[&target]));
            }
            _ => {}
        }
    }
    let code: Vec<(u32, u32)> =
        (0..).step_by(4).zip(nodes.iter().map(|node| node.i.encode())).collect();
    let mut named: BTreeMap<u32, Vec<String>> = BTreeMap::new();
    let mut origins = BTreeSet::from([0]);
    for (id, label) in labels.iter().filter(|(id, label)| !label.is_empty() && starts[id] > 0) {
        origins.insert(starts[id]);
        named.entry(starts[id]).or_default().push(label.clone());
    }
    for (id, label) in branches {
        named.entry(ends[id]).or_default().push(label.clone());
        origins.remove(&ends[id]);
    }
    let rules = Rules::default();
    let loops = find_loops(&code, rules);
    let between = |from: u32, to: u32| code[from as usize / 4..to as usize / 4].to_vec();
    let slots: Vec<_> = code
        .iter()
        .map(|&(address, _)| check::slot(&between, &origins, &loops, address, rules))
        .collect();
    let words = (0..).step_by(4).zip(nodes).zip(slots);
    words
        .map(|((address, node), slot)| Word {
            node,
            address,
            slot: slot.expect("all words are instructions"),
            labels: named.remove(&address).unwrap_or_default(),
        })
        .collect()
}
