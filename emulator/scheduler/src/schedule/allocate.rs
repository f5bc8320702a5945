//! Register allocation for a block that runs once.
//!
//! Each value occupies its register from the instruction that makes it to the last that reads it.
//! Values that are live at the end stay in the register of the source. The others get that
//! register too if it is free, or else any free one.

use super::function::{Node, POOL, Registers, bit};
use super::values::{Source, Values};

/// A range of positions: from after the first up to the second.
type Span = (usize, usize);

/// The nodes in the given order, with registers, or `None` if there are too few registers.
pub(super) fn allocate(
    nodes: &[Node],
    order: &[usize],
    live: Registers,
    renaming: bool,
) -> Option<Vec<Node>> {
    let in_order = |nodes: &[Node]| order.iter().map(|&at| nodes[at].clone()).collect();
    if !renaming {
        return Some(in_order(nodes));
    }
    let values = Values::of(nodes);
    let mut place = vec![0; nodes.len()];
    for (position, &at) in order.iter().enumerate() {
        // Place 0 is before the first instruction.
        place[at] = position + 1;
    }
    let end = nodes.len() + 1;
    let mut last_read = place.clone();
    let mut entry_end: [Option<usize>; 128] = [None; 128];
    for (at, reads) in values.reads.iter().enumerate() {
        for &(_, source) in reads {
            match source {
                Source::Node(from) => last_read[from] = last_read[from].max(place[at]),
                Source::Entry(register) => {
                    let slot = &mut entry_end[usize::from(register)];
                    *slot = (*slot).max(Some(place[at]));
                }
            }
        }
    }
    let mut taken: Vec<Vec<Span>> = vec![Vec::new(); 128];
    for register in 0..128u8 {
        let slot = usize::from(register);
        let untouched = values.last[slot].is_none() && live & bit(register) != 0;
        if untouched {
            taken[slot].push((0, end));
        } else if let Some(until) = entry_end[slot] {
            taken[slot].push((0, until));
        }
    }
    let kept = values.kept(nodes, live);
    for at in (0..nodes.len()).filter(|&at| kept[at] && nodes[at].writes().is_some()) {
        let slot = usize::from(nodes[at].i.rt);
        let lives_on = values.last[slot] == Some(at)
            && (!POOL.contains(&nodes[at].i.rt) || live & bit(nodes[at].i.rt) != 0);
        let until = if lives_on { end } else { last_read[at].max(place[at] + 1) };
        taken[slot].push((place[at], until));
    }
    let heads = values.heads(nodes);
    let mut group_end = last_read.clone();
    for (at, &head) in heads.iter().enumerate() {
        group_end[head] = group_end[head].max(last_read[at]).max(place[at] + 1);
    }
    let mut registers: Vec<u8> = nodes.iter().map(|node| node.i.rt).collect();
    for &at in order {
        let Some(own) = nodes[at].writes().filter(|_| !kept[at]) else {
            continue;
        };
        if heads[at] != at {
            registers[at] = registers[heads[at]];
            continue;
        }
        let span = (place[at], group_end[at]);
        let free = |register: &u8| {
            let spans = &taken[usize::from(*register)];
            spans.iter().all(|&(start, end)| end <= span.0 || span.1 <= start)
        };
        let chosen = [own].into_iter().chain(POOL).find(free)?;
        taken[usize::from(chosen)].push(span);
        registers[at] = chosen;
    }
    let mut renamed = nodes.to_vec();
    for (at, node) in renamed.iter_mut().enumerate() {
        for &(field, source) in &values.reads[at] {
            if let Source::Node(from) = source {
                node.set_register(field, registers[from]);
            }
        }
        if node.writes().is_some() {
            node.i.rt = registers[at];
        }
    }
    Some(in_order(&renamed))
}
