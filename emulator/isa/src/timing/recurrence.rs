//! Chains of dependent instructions, within a loop's body and from pass to pass.

use super::hint::reserves_prefetch;
use super::rules::Rules;
use crate::instructions::{Instruction, RegisterSet};

/// The chain of values from pass to pass that bounds a loop.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Recurrence {
    /// The cycles of the chain.
    pub cycles: u64,
    /// The number of passes that the chain spans.
    pub passes: u64,
    /// The registers that carry values from pass to pass, in the order of the chain.
    pub registers: Vec<u8>,
}

impl Recurrence {
    /// The minimum number of whole cycles in a pass.
    #[must_use]
    pub fn ceiling(&self) -> u64 {
        self.cycles.div_ceil(self.passes)
    }
}

/// When each register's value is ready, in cycles after some moment. `None` if no value that
/// matters contributes to it.
type Arrivals = [Option<u64>; 128];

/// Runs a pass as fast as its dependences allow.
fn pass(body: &[Instruction], mut arrivals: Arrivals, rules: Rules) -> Arrivals {
    for &i in body {
        let sources = sources(i);
        let start = sources.iter().filter_map(|r| arrivals[usize::from(r)]).max();
        let done = start.map(|start| start + rules.latency(i.op.row().class));
        for target in i.writes().iter() {
            arrivals[usize::from(target)] = done;
        }
    }
    arrivals
}

fn sources(i: Instruction) -> RegisterSet {
    if reserves_prefetch(i) { RegisterSet::EMPTY } else { i.reads() }
}

/// The cycles of the longest chain in one pass, if all registers are ready at its start.
pub(super) fn critical_path(body: &[Instruction], rules: Rules) -> u64 {
    let mut arrivals = [Some(0); 128];
    let mut longest = 0;
    for &i in body {
        let ready = sources(i).iter().filter_map(|r| arrivals[usize::from(r)]);
        let start = ready.max().unwrap_or(0);
        // An instruction without a result, such as a store, ends the chain with its own cycle.
        longest = longest.max(start + 1);
        for target in i.writes().iter() {
            let done = start + rules.latency(i.op.row().class);
            arrivals[usize::from(target)] = Some(done);
            longest = longest.max(done);
        }
    }
    longest
}

/// The registers that the body both writes and reads before it writes them.
fn carried(body: &[Instruction]) -> Vec<u8> {
    let (mut read_first, mut written) = (RegisterSet::EMPTY, RegisterSet::EMPTY);
    for &i in body {
        for register in sources(i).iter().filter(|&r| !written.contains(r)) {
            read_first = read_first.union(RegisterSet::of(register));
        }
        written = written.union(i.writes());
    }
    read_first.iter().filter(|&register| written.contains(register)).collect()
}

/// The chain with the most cycles a pass. The graph has the carried registers as vertices, and the
/// longest chains of one pass between them as edges. The chain is the cycle with the largest mean
/// in it (Karp's algorithm).
pub(super) fn recurrence(body: &[Instruction], rules: Rules) -> Option<Recurrence> {
    let registers = carried(body);
    let n = registers.len();
    let edges: Vec<Vec<Option<u64>>> = registers
        .iter()
        .map(|&from| {
            let mut arrivals = [None; 128];
            arrivals[usize::from(from)] = Some(0);
            let arrivals = pass(body, arrivals, rules);
            let arrival = |&to: &u8| arrivals[usize::from(to)];
            registers.iter().map(arrival).collect()
        })
        .collect();

    // For each number of edges k and each vertex: the longest walk with k edges that ends in the
    // vertex, and the vertex before.
    let mut walks = vec![vec![Some((0, 0)); n]];
    for k in 0..n {
        let longest = |to: usize| {
            let walk = |from: usize| Some((walks[k][from]?.0 + edges[from][to]?, from));
            (0..n).filter_map(walk).max_by_key(|&(length, _)| length)
        };
        let next = (0..n).map(longest).collect();
        walks.push(next);
    }
    let mut best: Option<(u64, u64, usize)> = None;
    for (vertex, &whole) in walks[n].iter().enumerate() {
        let Some((whole, _)) = whole else {
            continue;
        };
        let means = (0..n).filter_map(|k| {
            let (part, _) = walks[k][vertex]?;
            Some((whole.saturating_sub(part), (n - k) as u64))
        });
        let min = means.min_by(|a, b| (a.0 * b.1).cmp(&(b.0 * a.1)));
        if let Some((cycles, passes)) = min
            && best.is_none_or(|(c, p, _)| cycles * p > c * passes)
        {
            best = Some((cycles, passes, vertex));
        }
    }
    let (_, _, vertex) = best?;

    // A walk of n edges over n vertices visits some vertex twice. The cycle between the visits is
    // the chain.
    let mut trail = vec![vertex];
    for k in (1..=n).rev() {
        let &last = trail.last()?;
        let (_, from) = walks[k][last]?;
        trail.push(from);
    }
    let closes = |end: usize| (0..end).rev().find(|&begin| trail[begin] == trail[end]);
    let (begin, end) = (1..trail.len()).find_map(|end| Some((closes(end)?, end)))?;
    // The trail runs backwards.
    let chain: Vec<usize> = trail[begin..end].iter().rev().copied().collect();
    let next = |at: usize| chain[(at + 1) % chain.len()];
    let cycles = (0..chain.len()).filter_map(|at| edges[chain[at]][next(at)]);
    Some(Recurrence {
        cycles: cycles.sum(),
        passes: chain.len() as u64,
        registers: chain.iter().map(|&vertex| registers[vertex]).collect(),
    })
}
