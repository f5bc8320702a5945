//! Iterative modulo scheduling (Rau 1994): every pass starts `interval` cycles after the one
//! before.
//!
//! Instructions are placed in the order of the length of the chain that they head. An instruction
//! that finds no free place takes one by force and removes the instructions that conflict. These
//! are placed again, until all are placed or the budget is used up. Invariant of a result: all
//! edges hold, no pipe is used twice in a cycle, no FP6 is in the cycle after an FP7, no access
//! waits for an increment of its address, and the branch is in the last cycle of its pass.

use super::dependence::Edge;
use super::displacement::Movable;
use super::function::Node;
use super::random::Random;
use spu_isa::timing::rules::{DOUBLE_INTERVAL, FLOAT_CONFLICT_DISTANCE};
use spu_isa::{Class, Pipe};

/// Average number of placements of each instruction before an attempt is given up.
const BUDGET: usize = 24;

/// A loop to be scheduled. The last node is the branch back.
pub(super) struct Problem<'a> {
    nodes: &'a [Node],
    interval: i64,
    apart: Vec<Vec<Apart>>,
    predecessors: Vec<Vec<Edge>>,
    successors: Vec<Vec<Edge>>,
    heights: Vec<i64>,
    /// The earliest and latest cycles that leave the branch in its place.
    bounds: Vec<(i64, i64)>,
}

/// Two instructions of which one must not issue within a latency after the other, whatever passes
/// they belong to: an increment of an address and an access that may move across it.
#[derive(Clone, Copy, Debug)]
struct Apart {
    other: usize,
    /// The cycles after the other's issue that are forbidden: from the first to before the second.
    forbidden: (i64, i64),
}

/// What each node must be apart from.
fn apart(nodes: &[Node], movable: &[Option<Movable>]) -> Vec<Vec<Apart>> {
    let mut apart = vec![Vec::new(); nodes.len()];
    for (access, movable) in movable.iter().enumerate() {
        let Some(Movable { increment, .. }) = *movable else {
            continue;
        };
        let latency = i64::from(nodes[increment].class().latency());
        apart[access].push(Apart { other: increment, forbidden: (0, latency) });
        apart[increment].push(Apart { other: access, forbidden: (1 - latency, 1) });
    }
    apart
}

/// A cycle of edges that no schedule with this interval can satisfy, or `None` if there is none.
pub(super) fn impossible(count: usize, edges: &[Edge], interval: i64) -> Option<Vec<Edge>> {
    let mut time = vec![0i64; count];
    let mut cause: Vec<Option<Edge>> = vec![None; count];
    let mut moved = None;
    for _ in 0..=count {
        moved = None;
        for edge in edges {
            let earliest = time[edge.from] + edge.latency - interval * edge.distance;
            if earliest > time[edge.to] {
                time[edge.to] = earliest;
                cause[edge.to] = Some(*edge);
                moved = Some(edge.to);
            }
        }
        moved?;
    }
    // After as many steps back as there are nodes, the node is in the cycle.
    let mut at = moved?;
    for _ in 0..count {
        at = cause[at]?.from;
    }
    let mut cycle = Vec::new();
    let start = at;
    loop {
        let edge = cause[at]?;
        cycle.push(edge);
        at = edge.from;
        if at == start {
            return Some(cycle);
        }
    }
}

/// The longest chains of edges: from `seeds` on if `forward`, or else up to them. The edges must
/// have no [`impossible`] cycle.
pub(super) fn longest(edges: &[Edge], interval: i64, seeds: Vec<i64>, forward: bool) -> Vec<i64> {
    let mut length = seeds;
    loop {
        let mut changed = false;
        for edge in edges {
            let (from, to) = if forward { (edge.from, edge.to) } else { (edge.to, edge.from) };
            let reached = length[from].saturating_add(edge.latency - interval * edge.distance);
            if length[from] > UNREACHED && reached > length[to] {
                length[to] = reached;
                changed = true;
            }
        }
        if !changed {
            return length;
        }
    }
}

/// The length of a chain that does not exist.
const UNREACHED: i64 = i64::MIN / 2;

impl<'a> Problem<'a> {
    /// The edges must have no [`impossible`] cycle at this interval. `movable` are the accesses
    /// that may move across the increments of their address.
    pub fn new(
        nodes: &'a [Node],
        edges: &[Edge],
        movable: &[Option<Movable>],
        interval: i64,
    ) -> Self {
        let count = nodes.len();
        let mut predecessors = vec![Vec::new(); count];
        let mut successors = vec![Vec::new(); count];
        for edge in edges {
            predecessors[edge.to].push(*edge);
            successors[edge.from].push(*edge);
        }
        let mut seeds = vec![UNREACHED; count];
        seeds[count - 1] = 0;
        let from_branch = longest(edges, interval, seeds.clone(), true);
        let to_branch = longest(edges, interval, seeds, false);
        let bound = |at: usize| {
            let earliest = (interval - 1 + from_branch[at]).max(0);
            let latest = match to_branch[at] {
                UNREACHED => i64::MAX,
                length => interval - 1 - length,
            };
            (earliest, latest)
        };
        Self {
            nodes,
            interval,
            apart: apart(nodes, movable),
            heights: longest(edges, interval, vec![0; count], false),
            bounds: (0..count).map(bound).collect(),
            predecessors,
            successors,
        }
    }

    /// The cycle of each node, or `None` if this attempt does not find a place for all of them.
    pub fn attempt(&self, number: u64) -> Option<Vec<i64>> {
        let count = self.nodes.len();
        if self.bounds.iter().any(|&(earliest, latest)| earliest > latest) {
            return None;
        }
        let mut random = Random::new(number + 1);
        let noise = 1 + number % 16;
        let priorities: Vec<i64> =
            self.heights.iter().map(|height| height + random.below(noise) as i64).collect();
        let mut table = Table::new(self);
        table.put(count - 1, self.interval - 1);
        let mut last: Vec<Option<i64>> = vec![None; count];
        let mut left: Vec<usize> = (0..count - 1).collect();
        for _ in 0..count * BUDGET {
            let urgent = |&(_, &at): &(usize, &usize)| (priorities[at], std::cmp::Reverse(at));
            let Some((place, &at)) = left.iter().enumerate().max_by_key(urgent) else {
                return Some(table.times.iter().flatten().copied().collect());
            };
            left.swap_remove(place);
            let cycle = self.choose(&table, at, last[at])?;
            last[at] = Some(cycle);
            let mut out = table.conflicting(at, cycle);
            out.extend(self.disturbed(&table, at, cycle));
            out.sort_unstable();
            out.dedup();
            if out.contains(&(count - 1)) {
                return None;
            }
            for other in out {
                table.take(other);
                left.push(other);
            }
            table.put(at, cycle);
        }
        None
    }

    /// A free cycle between the nodes that are placed, or else one by force.
    fn choose(&self, table: &Table<'_>, at: usize, last: Option<i64>) -> Option<i64> {
        let interval = self.interval;
        let (floor, ceiling) = self.bounds[at];
        let predecessors = self.predecessors[at].iter().filter_map(|edge| {
            Some(table.times[edge.from]? + edge.latency - interval * edge.distance)
        });
        let successors = self.successors[at].iter().filter_map(|edge| {
            Some(table.times[edge.to]? - edge.latency + interval * edge.distance)
        });
        let earliest = predecessors.fold(floor, i64::max).min(ceiling);
        let latest = successors.fold(ceiling, i64::min).min(earliest + interval - 1);
        let free = (earliest..=latest).find(|&cycle| table.conflicting(at, cycle).is_empty());
        if free.is_some() {
            return free;
        }
        let pinned = self.nodes.len() - 1;
        let again = last.map_or(earliest, |last| last + 1).max(earliest);
        let mut tries = (again..again + interval).chain(earliest..earliest + interval);
        tries.find(|&cycle| cycle <= ceiling && !table.conflicting(at, cycle).contains(&pinned))
    }

    /// The placed nodes whose edges to or from `at` would not hold.
    fn disturbed(&self, table: &Table<'_>, at: usize, cycle: i64) -> Vec<usize> {
        let interval = self.interval;
        let predecessors = self.predecessors[at].iter().filter_map(|edge| {
            let earliest = table.times[edge.from]? + edge.latency - interval * edge.distance;
            (edge.from != at && earliest > cycle).then_some(edge.from)
        });
        let successors = self.successors[at].iter().filter_map(|edge| {
            let earliest = cycle + edge.latency - interval * edge.distance;
            (edge.to != at && earliest > table.times[edge.to]?).then_some(edge.to)
        });
        predecessors.chain(successors).collect()
    }

    /// Moves loads and constants later, to where their values are first needed, so that they
    /// occupy their registers for a shorter time.
    pub fn sink(&self, times: &mut [i64]) {
        let mut table = Table::new(self);
        for (at, &cycle) in times.iter().enumerate() {
            table.put(at, cycle);
        }
        let end = times.iter().max().map_or(0, |last| last / self.interval + 1) * self.interval;
        let mut order: Vec<usize> = (0..times.len() - 1).collect();
        order.sort_by_key(|&at| std::cmp::Reverse((times[at], at)));
        for at in order {
            let node = &self.nodes[at];
            if !node.is_load() && node.reads().next().is_some() {
                continue;
            }
            let (_, ceiling) = self.bounds[at];
            let successors = self.successors[at].iter().filter(|edge| edge.to != at);
            let limit = successors
                .map(|edge| times[edge.to] - edge.latency + self.interval * edge.distance)
                .fold(ceiling.min(end - 1), i64::min);
            table.take(at);
            let latest =
                (times[at]..=limit).rev().find(|&cycle| table.conflicting(at, cycle).is_empty());
            times[at] = latest.unwrap_or(times[at]);
            table.put(at, times[at]);
        }
    }
}

/// Which instruction uses which pipe in which cycle of the interval.
struct Table<'a> {
    nodes: &'a [Node],
    apart: &'a [Vec<Apart>],
    times: Vec<Option<i64>>,
    rows: Vec<[Option<usize>; 2]>,
}

impl<'a> Table<'a> {
    fn new(problem: &'a Problem<'_>) -> Self {
        let nodes = problem.nodes;
        Self {
            nodes,
            apart: &problem.apart,
            times: vec![None; nodes.len()],
            rows: vec![[None; 2]; problem.interval as usize],
        }
    }

    fn row(&self, cycle: i64) -> usize {
        cycle.rem_euclid(self.rows.len() as i64) as usize
    }

    /// The rows and pipes that a node uses.
    fn cells(&self, at: usize, cycle: i64) -> Vec<(usize, usize)> {
        let node = &self.nodes[at];
        if node.class() == Class::Fpd {
            let rows = (0..DOUBLE_INTERVAL as i64).map(|later| self.row(cycle + later));
            return rows.flat_map(|row| [(row, 0), (row, 1)]).collect();
        }
        vec![(self.row(cycle), usize::from(node.pipe() == Pipe::Odd))]
    }

    /// The nodes that use the same row and pipe, or that conflict with the node there.
    fn conflicting(&self, at: usize, cycle: i64) -> Vec<usize> {
        let cells = self.cells(at, cycle).into_iter();
        let mut others: Vec<usize> = cells.filter_map(|(row, pipe)| self.rows[row][pipe]).collect();
        for &Apart { other, forbidden } in &self.apart[at] {
            let clash = |time: i64| {
                let (first, end) = forbidden;
                (self.row(cycle - time - first) as i64) < end - first
            };
            if self.times[other].is_some_and(clash) {
                others.push(other);
            }
        }
        let distance = FLOAT_CONFLICT_DISTANCE as i64;
        let (neighbour, class) = match self.nodes[at].class() {
            Class::Fp6 => (cycle - distance, Class::Fp7),
            Class::Fp7 => (cycle + distance, Class::Fp6),
            _ => return others,
        };
        let neighbour = self.rows[self.row(neighbour)][0];
        others.extend(neighbour.filter(|&other| self.nodes[other].class() == class));
        others
    }

    fn put(&mut self, at: usize, cycle: i64) {
        for (row, pipe) in self.cells(at, cycle) {
            self.rows[row][pipe] = Some(at);
        }
        self.times[at] = Some(cycle);
    }

    fn take(&mut self, at: usize) {
        if let Some(cycle) = self.times[at].take() {
            for (row, pipe) in self.cells(at, cycle) {
                self.rows[row][pipe] = None;
            }
        }
    }
}
