//! Software pipelining, which turns a loop of one block into a fill, a kernel, a drain and a short
//! form.
//!
//! The kernel starts a pass every `interval` cycles, so that `stages` passes overlap. The fill and
//! the drain are the kernel's instructions of the first and last passes. If the trip count is
//! below the number of stages, the short form runs, which is the plain loop. Invariant: for every
//! trip count, memory and the registers that are live after the loop have the same contents as
//! after the plain loop.

use super::colour::colour;
use super::copies;
use super::dependence::{Edge, counter, cyclic, obstacle};
use super::function::{
    Block, BlockId, Flow, Function, Leaves, Node, POOL, Reference, Registers, bit,
};
use super::layout::plain;
use super::modulo::{Problem, impossible, longest};
use spu_isa::timing::rules::{DOUBLE_INTERVAL, HINT_CYCLES};
use spu_isa::{Class, Op, Pipe};

/// The number of instructions that are placed in the orders tried at each interval, and the bounds
/// of the number of orders.
const PLACED: usize = 16_000;
const ATTEMPTS: (usize, usize) = (24, 160);
/// The number of schedules of one interval from which the best is chosen.
const KEPT: usize = 12;
/// The number of limits on the lives of values that are tried at each interval. The first limit is
/// the interval itself; each further one is shorter by a fraction of it. A shorter limit needs
/// more copies but leaves more room for each instruction.
const LIVES: i64 = 5;
const LIFE_PARTS: i64 = 12;
/// The number of instructions between a hint and its branch that keeps the branch in reach even
/// after padding.
const HINT_REACH: usize = 200;
/// A kernel with more cycles or instructions than this contains its own hint.
const OWN_HINT: usize = 150;
/// The longest body that is pipelined, in instructions.
const MAX_BODY: usize = 1000;
/// The longest code after the loop, in instructions, that is copied to the short form, so that the
/// drain can be scheduled together with it.
const MAX_COPY: usize = 64;

/// The result of pipelining a loop.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoopReport {
    /// The loop's label, or else the function's name.
    pub name: String,
    /// The line of its branch.
    pub line: u64,
    /// What happened to it.
    pub outcome: Outcome,
}

/// What happened to a loop.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It was pipelined.
    Pipelined(Figures),
    /// It was scheduled as straight-line code, for this reason.
    Plain(String),
}

/// Figures of a pipelined loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Figures {
    /// Cycles in which the plain body uses the even pipe.
    pub even: u64,
    /// Cycles in which the plain body uses the odd pipe.
    pub odd: u64,
    /// The lower bound of the interval, from the pipes and from the chains between passes.
    pub minimum: u64,
    /// Cycles from one pass to the next.
    pub interval: u64,
    /// The number of passes that overlap.
    pub stages: u64,
    /// The number of registers that the kernel uses.
    pub registers: u32,
    /// The number of instructions added to copy values.
    pub copies: usize,
}

/// A scheduled kernel.
struct Kernel {
    /// The nodes in the order of the code, the branch last, each with its stage.
    nodes: Vec<Node>,
    rows: Vec<u64>,
    figures: Figures,
}

/// Pipelines every loop of a function for which it is possible.
pub(super) fn pipeline(function: &mut Function) -> Vec<LoopReport> {
    let mut reports = Vec::new();
    let ids: Vec<BlockId> = function.blocks.iter().map(|block| block.id).collect();
    for id in ids {
        // The code after a loop may have become part of it.
        let at = function.blocks.iter().position(|block| block.id == id);
        let Some((at, first)) = at.and_then(|at| Some((at, loop_start(function, at)?))) else {
            continue;
        };
        let block = &function.blocks[at];
        let head = &function.blocks[first];
        let name = head.name.clone().unwrap_or_else(|| function.name.clone());
        let line = block.nodes.last().map_or(0, |node| node.line);
        let outcome = match kernel(function, at, first) {
            Ok(kernel) => {
                let figures = kernel.figures;
                match replace(function, at, kernel) {
                    Ok(()) => Outcome::Pipelined(figures),
                    Err(why) => Outcome::Plain(why.into()),
                }
            }
            Err(why) => Outcome::Plain(why),
        };
        reports.push(LoopReport {
            name,
            line,
            outcome,
        });
    }
    reports
}

/// The target of the block's branch if it goes back.
fn loop_start(function: &Function, at: usize) -> Option<usize> {
    let target = function.position(function.blocks[at].flow().branch?);
    (target <= at).then_some(target)
}

fn cycles(nodes: &[Node], pipe: Pipe) -> u64 {
    let cycles = nodes.iter().map(|node| match node.class() {
        Class::Fpd => DOUBLE_INTERVAL,
        _ => u64::from(node.pipe() == pipe),
    });
    cycles.sum()
}

/// Finds the schedule of a loop, or returns the reason why there is none.
fn kernel(function: &Function, at: usize, first: usize) -> Result<Kernel, String> {
    let block = &function.blocks[at];
    let body = &block.nodes[..];
    let branch = &body[body.len() - 1];
    if first != at {
        return Err("it has several blocks".into());
    }
    let Flow {
        falls_through: true,
        leaves: Leaves::No,
        ..
    } = block.flow()
    else {
        return Err("it does not end in brnz".into());
    };
    let count = branch.i.rt;
    if branch.i.op != Op::Brnz || counter(body, count).is_none() {
        return Err("it is not counted down by `ai $count,$count,-1` and `brnz $count`".into());
    }
    if let Some(why) = obstacle(body) {
        return Err(why);
    }
    let last = function.blocks.last().map(Block::flow);
    if at + 1 == function.blocks.len() || last.is_some_and(|flow| flow.falls_through) {
        return Err("the function does not end in a branch".into());
    }
    if body.len() > MAX_BODY {
        return Err(format!("its body has more than {MAX_BODY} instructions"));
    }
    let liveness = function.liveness();
    let live = liveness.start[at] | liveness.end[at];
    let (even, odd) = (cycles(body, Pipe::Even), cycles(body, Pipe::Odd));
    let flow = |edges: Vec<Edge>| -> Vec<Edge> {
        edges
            .into_iter()
            .filter(|edge| edge.keeps.is_none())
            .collect()
    };
    let true_edges = flow(cyclic(body));
    let resources = even.max(odd) as i64;
    let recurrence = |&interval: &i64| impossible(body.len(), &true_edges, interval).is_none();
    let unbounded = (resources.max(3)..).find(recurrence);
    let minimum = unbounded.ok_or("no interval is long enough")?;
    // A loop without overlap takes this long.
    let plain_cycles = super::list::schedule(body, liveness.end[at])
        .1
        .last()
        .map_or(0, |last| last + 1) as i64;
    let hint_edges = |nodes: &[Node]| {
        let branch = nodes.len() - 1;
        let mut edges = Vec::new();
        if let Some(hint) = nodes.iter().position(|node| node.class() == Class::Hb) {
            let edge = |from, to, latency| Edge {
                from,
                to,
                latency,
                distance: 0,
                keeps: None,
            };
            edges.push(edge(hint, branch, HINT_CYCLES as i64 + 1));
            edges.push(edge(branch, hint, -(HINT_REACH as i64 / 2)));
        }
        edges
    };
    // If busy pipes make the interval long although chains are short, values are copied as if
    // passes were shorter.
    let unlimited = (3..=minimum).find(recurrence).unwrap_or(minimum);
    let short = (longest_chain(&true_edges, body.len()) / 2).max(unlimited);
    let lives = |interval: i64| {
        let part = (interval / LIFE_PARTS).max(1);
        let shorter = (0..LIVES).map(move |parts| interval - parts * part);
        shorter.chain(Some(short).filter(|&short| short <= interval))
    };
    for interval in minimum..plain_cycles.max(minimum + 1) {
        let hinted = with_hint(body, interval, block.id);
        let mut tried = Vec::new();
        for life in lives(interval) {
            let copied = copies::insert(&hinted, interval, life);
            let Some(nodes) = copied.filter(|nodes| !tried.contains(&nodes.len())) else {
                continue;
            };
            tried.push(nodes.len());
            let mut edges = cyclic(&nodes);
            edges.extend(hint_edges(&nodes));
            let Some(found) = search(&nodes, &edges, interval, live) else {
                continue;
            };
            let figures = Figures {
                even,
                odd,
                minimum: minimum as u64,
                interval: interval as u64,
                stages: found.stages,
                registers: found.registers,
                copies: nodes.len() - hinted.len(),
            };
            return Ok(in_rows(&found.nodes, &found.times, interval, figures));
        }
    }
    Err("no schedule with overlapping passes is shorter, or registers are too few".into())
}

/// A schedule of a loop's body.
struct Found {
    stages: u64,
    registers: u32,
    /// The nodes with their registers.
    nodes: Vec<Node>,
    times: Vec<i64>,
}

/// Of some schedules of this interval, returns the one with the fewest stages, and among these the
/// one with the fewest registers.
fn search(nodes: &[Node], edges: &[Edge], interval: i64, live: Registers) -> Option<Found> {
    let problem = Problem::new(nodes, edges, interval);
    let attempts = (PLACED / nodes.len()).clamp(ATTEMPTS.0, ATTEMPTS.1) as u64;
    let schedules = (0..attempts).filter_map(|attempt| {
        let mut times = problem.attempt(attempt)?;
        problem.sink(&mut times);
        let (nodes, registers) = colour(nodes, &times, interval, live)?;
        let last = times.iter().max().copied().unwrap_or(0);
        Some(Found {
            stages: (last / interval + 1) as u64,
            registers,
            nodes,
            times,
        })
    });
    schedules
        .take(KEPT)
        .min_by_key(|found| (found.stages, found.registers))
}

/// The cycles of the longest chain within a pass.
fn longest_chain(edges: &[Edge], count: usize) -> i64 {
    let within: Vec<Edge> = edges
        .iter()
        .filter(|edge| edge.distance == 0)
        .copied()
        .collect();
    let chains = longest(&within, 0, vec![0; count], true);
    chains.into_iter().max().unwrap_or(0)
}

/// The body with a hint in it if the kernel will be so long that a hint before it can't reach the
/// branch.
fn with_hint(body: &[Node], interval: i64, id: BlockId) -> Vec<Node> {
    let mut nodes = body.to_vec();
    if body.len().max(interval as usize) > OWN_HINT {
        nodes.insert(0, hint(id, false));
    }
    nodes
}

/// A hint for the branch of a loop of one block.
pub(super) fn hint(id: BlockId, late: bool) -> Node {
    let reference = Reference::Hint {
        branch: id,
        target: Some(id),
        late,
    };
    Node::added(plain(Op::Hbrr, 0, 0, 0), Some(reference), "hint")
}

fn in_rows(nodes: &[Node], times: &[i64], interval: i64, figures: Figures) -> Kernel {
    let mut order: Vec<usize> = (0..nodes.len()).collect();
    order.sort_by_key(|&at| (times[at] % interval, nodes[at].pipe() == Pipe::Odd));
    let placed = |&at: &usize| {
        let mut node = nodes[at].clone();
        node.stage = (times[at] / interval) as u32;
        node
    };
    Kernel {
        nodes: order.iter().map(placed).collect(),
        rows: order
            .iter()
            .map(|&at| (times[at] % interval) as u64)
            .collect(),
        figures,
    }
}

/// Replaces the loop by its fill, kernel, drain and short form.
fn replace(function: &mut Function, at: usize, kernel: Kernel) -> Result<(), &'static str> {
    let Kernel {
        nodes,
        rows,
        figures,
    } = kernel;
    let live = function.liveness().start[at];
    let plain_loop = function.blocks[at].clone();
    let name = plain_loop
        .name
        .clone()
        .unwrap_or_else(|| format!("{}_loop", function.name));
    let kernel_id = function.new_id();
    let short_id = kernel_id + 1;
    let named = |id, suffix: &str, nodes| Block {
        id,
        name: (!suffix.is_empty()).then(|| format!("{name}{suffix}")),
        nodes,
        cycles: None,
    };

    let stages = figures.stages as u32;
    if stages > 1 {
        for node in &plain_loop.nodes {
            // The branch ends the kernel and the short form. The fill and the drain together
            // contain every stage once less than passes overlap.
            let times = if node.ends_block() {
                2
            } else {
                figures.stages as usize + 1
            };
            function.copied(node, times);
        }
    }
    let own_hint = nodes.iter().any(|node| node.class() == Class::Hb);
    let mut entry = Vec::new();
    if stages > 1 {
        let branch = &plain_loop.nodes[plain_loop.nodes.len() - 1];
        let free = POOL.rev().find(|&register| live & bit(register) == 0);
        let test = free.ok_or("no register is free for the test of its trip count")?;
        let enough = plain(Op::Clgti, test, branch.i.rt, stages as i32 - 1);
        let mut enough = Node::added(enough, None, "at least as many passes as overlap");
        enough.plain.rt = branch.i.rt;
        let mut skip = plain(Op::Brz, test, 0, 0);
        let reference = Some(Reference::Block(short_id));
        let mut skip_node = Node::added(skip, reference, "too few passes");
        skip.rt = branch.i.rt;
        skip_node.plain = skip;
        entry.extend([enough, skip_node]);
    }
    let pass = |stages: std::ops::RangeInclusive<u32>| {
        let runs = |node: &&Node| {
            stages.contains(&node.stage) && !node.ends_block() && node.class() != Class::Hb
        };
        let nodes = nodes.iter().filter(runs).cloned();
        nodes
            .map(|mut node| {
                node.stage = 0;
                node.in_order = true;
                node
            })
            .collect::<Vec<_>>()
    };
    let mut fill: Vec<Node> = (0..stages - 1).flat_map(|last| pass(0..=last)).collect();
    if !own_hint {
        let late = fill
            .len()
            .saturating_sub(HINT_REACH.saturating_sub(nodes.len()) / 2);
        fill.insert(late, hint(kernel_id, late > 0));
    }
    let mut drain: Vec<Node> = (1..stages)
        .flat_map(|first| pass(first..=stages - 1))
        .collect();

    let mut kernel_nodes = nodes.clone();
    let mut short_nodes = plain_loop.nodes.clone();
    for node in &mut kernel_nodes {
        match &mut node.reference {
            Some(Reference::Block(id)) if *id == plain_loop.id => *id = kernel_id,
            Some(Reference::Hint { branch, target, .. }) => {
                (*branch, *target) = (kernel_id, Some(kernel_id));
            }
            _ => {}
        }
    }
    for node in &mut short_nodes {
        if let Some(Reference::Block(id)) = &mut node.reference
            && *id == plain_loop.id
        {
            *id = short_id;
        }
    }
    let mut kernel_block = named(kernel_id, "", kernel_nodes);
    kernel_block.name = Some(name.clone());
    kernel_block.cycles = Some(rows);

    // If the next block ends the function's path, it becomes part of the drain, and a copy follows
    // the short form.
    let mut after_short = Vec::new();
    if let Some(next) = function.blocks.get(at + 1) {
        let alone = function.branches_to(next.id) == 0
            && !next.flow().falls_through
            && next.flow().branch != Some(plain_loop.id)
            && next.nodes.len() <= MAX_COPY;
        if alone && stages > 1 {
            let next = function.blocks.remove(at + 1);
            for node in &next.nodes {
                function.copied(node, 2);
            }
            drain.extend(next.nodes.iter().cloned());
            after_short = next.nodes;
        } else if stages > 1 {
            let reference = Some(Reference::Block(next.id));
            after_short.push(Node::added(plain(Op::Br, 0, 0, 0), reference, ""));
        }
    }
    let outer = function.branches_to(plain_loop.id) > 1;
    let mut blocks = vec![named(
        plain_loop.id,
        if outer { "_entry" } else { "" },
        entry,
    )];
    blocks.push(named(short_id + 1, "", fill));
    blocks.push(kernel_block);
    if !drain.is_empty() {
        blocks.push(named(short_id + 2, "_drain", drain));
    }
    function.blocks.splice(at..=at, blocks);
    if stages > 1 {
        function.blocks.push(named(short_id, "_short", short_nodes));
        function.blocks.push(named(short_id + 3, "", after_short));
    }
    Ok(())
}
