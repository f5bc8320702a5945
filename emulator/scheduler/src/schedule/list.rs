//! List scheduling of code that runs once, cycle by cycle.
//!
//! In each cycle and for each pipe, the most urgent instruction that can issue does so. The most
//! urgent one heads the longest chain. Several variations of these priorities are tried, and the
//! best result is kept.

use super::Kind;
use super::allocate::allocate;
use super::dependence::{Edge, straight};
use super::function::{BlockId, Node, Registers};
use super::layout;
use super::random::Random;
use spu_isa::timing::rules::{DOUBLE_INTERVAL, FLOAT_CONFLICT_DISTANCE};
use spu_isa::{Class, Pipe};

/// How many orders are tried with renamed registers, and again without.
const TRIES: u64 = 48;
/// Added to the height of hints, which are best far from their branches, also from those in other
/// blocks.
const HINT_HEIGHT: i64 = 1 << 10;

/// Schedules a block after which `live` are live. Returns the nodes with their new registers, and
/// their cycles, in the order of the code.
pub(super) fn schedule(nodes: &[Node], live: Registers) -> (Vec<Node>, Vec<u64>) {
    let mut best: Option<(u64, Vec<Node>, Vec<u64>)> = None;
    for renaming in [true, false] {
        let edges = straight(nodes, live, renaming, Kind::Kernel);
        let heights = heights(nodes, &edges);
        for attempt in 0..TRIES {
            let priorities = priorities(&heights, attempt);
            let cycles = place(nodes, &edges, &priorities);
            let mut order: Vec<usize> = (0..nodes.len()).collect();
            order.sort_by_key(|&at| (cycles[at], nodes[at].pipe() == Pipe::Odd));
            let Some(placed) = allocate(nodes, &order, live, renaming) else {
                continue;
            };
            let cycles: Vec<u64> = order.iter().map(|&at| cycles[at]).collect();
            let cost = layout::cost(&placed, &cycles);
            if best.as_ref().is_none_or(|(min, ..)| cost < *min) {
                best = Some((cost, placed, cycles));
            }
        }
    }
    let (_, nodes, cycles) = best.expect("without renaming, every order has enough registers");
    (nodes, cycles)
}

/// The nodes of a driver's block, which begins at `start`, in the best order that was found.
/// `ahead` is the number of instructions from the block's end to a branch, if it comes after it.
pub(super) fn reorder(
    nodes: &[Node],
    start: u32,
    ahead: &dyn Fn(BlockId) -> Option<usize>,
) -> Vec<Node> {
    let edges = straight(nodes, !0, false, Kind::Driver);
    let mut heights = heights(nodes, &edges);
    for (height, _) in heights.iter_mut().zip(nodes).filter(|(_, node)| node.hinted.is_some()) {
        *height += HINT_HEIGHT;
    }
    let mut best: Vec<&Node> = nodes.iter().collect();
    let mut smallest = layout::cost_in_place(&best, start, ahead);
    for attempt in 0..TRIES {
        let cycles = place(nodes, &edges, &priorities(&heights, attempt));
        for hints_first in [false, true] {
            let mut order: Vec<usize> = (0..nodes.len()).collect();
            order.sort_by_key(|&at| {
                let later = !hints_first || nodes[at].hinted.is_none();
                (cycles[at], later, nodes[at].pipe() == Pipe::Odd)
            });
            let order: Vec<&Node> = order.into_iter().map(|at| &nodes[at]).collect();
            let cost = layout::cost_in_place(&order, start, ahead);
            if cost < smallest {
                (best, smallest) = (order, cost);
            }
        }
    }
    best.into_iter().cloned().collect()
}

/// The cycles from each node's issue to the end of the block.
fn heights(nodes: &[Node], edges: &[Edge]) -> Vec<i64> {
    let mut heights: Vec<i64> =
        nodes.iter().map(|node| i64::from(node.class().latency())).collect();
    let mut by_source = edges.to_vec();
    // Edges of straight-line code only go forward.
    by_source.sort_by_key(|edge| std::cmp::Reverse(edge.from));
    for edge in &by_source {
        heights[edge.from] = heights[edge.from].max(heights[edge.to] + edge.latency);
    }
    heights
}

fn priorities(heights: &[i64], attempt: u64) -> Vec<i64> {
    const SCALE: i64 = 1 << 16;
    let mut random = Random::new(attempt + 1);
    let count = heights.len() as i64;
    let priority = |(at, &height): (usize, &i64)| {
        let early = count - at as i64;
        let noise = match attempt {
            0 => 0,
            1 => return early,
            _ => random.below(1 + attempt) as i64,
        };
        (height + noise) * SCALE + early
    };
    heights.iter().enumerate().map(priority).collect()
}

fn place(nodes: &[Node], edges: &[Edge], priorities: &[i64]) -> Vec<u64> {
    let count = nodes.len();
    let mut successors: Vec<Vec<&Edge>> = vec![Vec::new(); count];
    let mut waits = vec![0usize; count];
    for edge in edges {
        successors[edge.from].push(edge);
        waits[edge.to] += 1;
    }
    let mut earliest = vec![0i64; count];
    let mut cycles = vec![None; count];
    let mut ready: Vec<usize> = (0..count).filter(|&at| waits[at] == 0).collect();
    let mut left = count;
    let mut cycle = 0i64;
    let mut last_fp7 = None;
    while left > 0 {
        let mut next = cycle + 1;
        for pipe in [Pipe::Even, Pipe::Odd] {
            let free = |at: &usize| {
                let class = nodes[*at].class();
                let clash =
                    class == Class::Fp6 && last_fp7 == Some(cycle - FLOAT_CONFLICT_DISTANCE as i64);
                nodes[*at].pipe() == pipe && earliest[*at] <= cycle && !clash
            };
            let candidates = ready.iter().copied().filter(free);
            let Some(at) = candidates.max_by_key(|&at| priorities[at]) else {
                continue;
            };
            cycles[at] = Some(cycle as u64);
            left -= 1;
            ready.retain(|&other| other != at);
            for edge in &successors[at] {
                let to = edge.to;
                earliest[to] = earliest[to].max(cycle + edge.latency);
                waits[to] -= 1;
                if waits[to] == 0 {
                    ready.push(to);
                }
            }
            match nodes[at].class() {
                Class::Fp7 => last_fp7 = Some(cycle),
                Class::Fpd => {
                    next = cycle + DOUBLE_INTERVAL as i64;
                    break;
                }
                _ => {}
            }
        }
        cycle = next;
    }
    cycles.into_iter().flatten().collect()
}
