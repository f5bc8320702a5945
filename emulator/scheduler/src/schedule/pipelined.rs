//! Software pipelining, which turns a loop of one block into a fill, a kernel, a drain and a short
//! form.
//!
//! The kernel starts a pass every `interval` cycles, so that `stages` passes overlap. If values
//! live longer than an interval, it may contain several passes that differ in registers (Lam
//! 1988), each with an exit and a drain of its own. The fill and the drain are the kernel's
//! instructions of the first and last passes. If the trip count is below the number of stages, the
//! short form runs, which is the plain loop. A loop whose source states a minimum that suffices has
//! none. Invariant: for every trip count, memory and the registers that are live after the loop
//! have the same contents as after the plain loop.

use std::ops::RangeInclusive;

use super::colour::colour;
use super::copies;
use super::dependence::{Edge, Freedom, counter, cyclic, obstacle};
use super::displacement::{Movable, Moved};
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
/// more copies but allows more cycles for each instruction.
const LIVES: i64 = 5;
const LIFE_PARTS: i64 = 12;
/// The number of instructions between a hint and its branch that keeps the branch in reach even
/// after padding.
const HINT_REACH: usize = 200;
/// A kernel with more cycles or instructions than this contains its own hint.
const OWN_HINT: usize = 150;
/// The largest number of passes that a kernel contains, and the largest number of its cycles if it
/// contains several. A value lives at least as long as its instruction takes, which are 7 cycles at
/// most but for double precision. Where the interval is longer, copies cost little.
const MAX_PASSES: i64 = 4;
const EXPANDED: i64 = 24;
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
    /// The number of passes that the kernel contains, each with registers of its own.
    pub passes: u64,
}

struct Kernel {
    /// For each pass that it contains: the nodes in the order of the code, the branch last, each
    /// with its stage.
    passes: Vec<Vec<Node>>,
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
                match replace(function, at, &kernel) {
                    Ok(()) => Outcome::Pipelined(figures),
                    Err(why) => Outcome::Plain(why.into()),
                }
            }
            Err(why) => Outcome::Plain(why),
        };
        reports.push(LoopReport { name, line, outcome });
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
    let Flow { falls_through: true, leaves: Leaves::No, .. } = block.flow() else {
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
        edges.into_iter().filter(|edge| edge.keeps.is_none()).collect()
    };
    let true_edges = flow(cyclic(body, live, Freedom::NONE));
    let resources = even.max(odd) as i64;
    let recurrence = |&interval: &i64| impossible(body.len(), &true_edges, interval).is_none();
    let unbounded = (resources.max(3)..).find(recurrence);
    let minimum = unbounded.ok_or("no interval is long enough")?;
    // A loop without overlap takes this long.
    let plain_cycles =
        super::list::schedule(body, liveness.end[at]).1.last().map_or(0, |last| last + 1) as i64;
    let hint_edges = |nodes: &[Node]| {
        let branch = nodes.len() - 1;
        let mut edges = Vec::new();
        if let Some(hint) = nodes.iter().position(|node| node.class() == Class::Hb) {
            let edge = |from, to, latency| Edge { from, to, latency, distance: 0, keeps: None };
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
        let first = |freedom: Freedom| {
            let mut tried = Vec::new();
            lives(interval).find_map(|life| {
                let nodes = copies::insert(&hinted, interval, life, live, freedom)?;
                if tried.contains(&nodes.len()) {
                    return None;
                }
                tried.push(nodes.len());
                let mut edges = cyclic(&nodes, live, freedom);
                edges.extend(hint_edges(&nodes));
                search(&nodes, &edges, interval, live, freedom)
            })
        };
        let found = freedoms(body, interval).find_map(first);
        if let Some(found) = found {
            let figures = Figures {
                even,
                odd,
                minimum: minimum as u64,
                interval: interval as u64,
                stages: found.stages,
                registers: found.registers,
                copies: found.times.len() - hinted.len(),
                passes: found.nodes.len() as u64,
            };
            return Ok(in_rows(&found.nodes, &found.times, interval, figures));
        }
    }
    Err("no schedule with overlapping passes is shorter, or registers are too few".into())
}

/// What a kernel of this interval may do, the simplest form of code first.
fn freedoms(body: &[Node], interval: i64) -> impl Iterator<Item = Freedom> {
    let moves = Freedom { moves: true, ..Freedom::NONE };
    let any_moves = Movable::of_loop(body, moves).iter().any(Option::is_some);
    let most = if body[body.len() - 1].one_pass { 1 } else { MAX_PASSES };
    let passes = (1..=most).filter(move |&passes| passes == 1 || passes * interval <= EXPANDED);
    let each = [false, true].into_iter().filter(move |&moves| any_moves || !moves);
    passes.flat_map(move |passes| each.clone().map(move |moves| Freedom { moves, passes }))
}

/// A schedule of a loop's body.
struct Found {
    stages: u64,
    registers: u32,
    /// For each pass that the kernel contains: the nodes with their registers.
    nodes: Vec<Vec<Node>>,
    times: Vec<i64>,
}

/// Of some schedules of this interval, returns the one with the fewest stages, and among these the
/// one with the fewest registers.
fn search(
    nodes: &[Node],
    edges: &[Edge],
    interval: i64,
    live: Registers,
    freedom: Freedom,
) -> Option<Found> {
    let movable = Movable::of_loop(nodes, freedom);
    let problem = Problem::new(nodes, edges, &movable, interval);
    let attempts = (PLACED / nodes.len()).clamp(ATTEMPTS.0, ATTEMPTS.1) as u64;
    let passes = freedom.passes as usize;
    let schedules = (0..attempts).filter_map(|attempt| {
        let mut times = problem.attempt(attempt)?;
        problem.sink(&mut times);
        let (mut nodes, registers) = colour(nodes, &movable, &times, interval, live, passes)?;
        for nodes in &mut nodes {
            move_accesses(nodes, &movable, &times, interval);
        }
        let last = times.iter().max().copied().unwrap_or(0);
        let stages = (last / interval + 1) as u64;
        // Passes that do not overlap need no registers of their own.
        (stages > 1 || passes == 1).then_some(Found { stages, registers, nodes, times })
    });
    schedules.take(KEPT).min_by_key(|found| (found.stages, found.registers))
}

/// Gives the accesses that may move the displacements for their places in the kernel.
fn move_accesses(nodes: &mut [Node], movable: &[Option<Movable>], times: &[i64], interval: i64) {
    let place = |nodes: &[Node], at: usize| row_order(&nodes[at], times[at], interval);
    for (at, movable) in movable.iter().enumerate() {
        let Some(access) = *movable else {
            continue;
        };
        let before = place(nodes, access.increment) < place(nodes, at);
        let stages = times[at] / interval - times[access.increment] / interval;
        let moved = Moved::new(access, stages + i64::from(before));
        nodes[at].i.immediate = moved.in_kernel();
        nodes[at].moved = Some(moved);
    }
}

/// What the code of a kernel is sorted by.
fn row_order(node: &Node, time: i64, interval: i64) -> (i64, bool) {
    (time % interval, node.pipe() == Pipe::Odd)
}

/// The cycles of the longest chain within a pass.
fn longest_chain(edges: &[Edge], count: usize) -> i64 {
    let within: Vec<Edge> = edges.iter().filter(|edge| edge.distance == 0).copied().collect();
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
    let reference = Reference::Hint { branch: id, target: Some(id), late };
    Node::added(plain(Op::Hbrr, 0, 0, 0), Some(reference), "hint")
}

fn in_rows(nodes: &[Vec<Node>], times: &[i64], interval: i64, figures: Figures) -> Kernel {
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.sort_by_key(|&at| row_order(&nodes[0][at], times[at], interval));
    let placed = |nodes: &Vec<Node>| {
        let placed = order.iter().map(|&at| {
            let mut node = nodes[at].clone();
            node.stage = (times[at] / interval) as u32;
            node
        });
        placed.collect()
    };
    Kernel {
        passes: nodes.iter().map(placed).collect(),
        rows: order.iter().map(|&at| (times[at] % interval) as u64).collect(),
        figures,
    }
}

impl Kernel {
    fn nodes(&self) -> &[Node] {
        &self.passes[0]
    }

    fn stages(&self) -> u32 {
        self.figures.stages as u32
    }

    /// The nodes of these stages in the order of the code, where the pass that is in stage 0 has
    /// this number.
    fn part(&self, number: u32, stages: RangeInclusive<u32>) -> impl Iterator<Item = &Node> {
        let count = self.passes.len() as i64;
        (0..self.rows.len()).filter_map(move |at| {
            let stage = self.nodes()[at].stage;
            let pass = (i64::from(number) - i64::from(stage)).rem_euclid(count);
            let node = &self.passes[pass as usize][at];
            stages.contains(&stage).then_some(node)
        })
    }

    /// Such nodes outside the kernel, where neither its branch nor its hint belongs.
    /// `displacement` is that of an access which has moved, in the pass of a stage.
    fn outside(
        &self,
        number: u32,
        stages: RangeInclusive<u32>,
        displacement: impl Fn(Moved, i64) -> i32,
    ) -> Vec<Node> {
        let runs = |node: &&Node| !node.ends_block() && node.class() != Class::Hb;
        let nodes = self.part(number, stages).filter(runs).cloned();
        nodes
            .map(|mut node| {
                if let Some(moved) = node.moved {
                    node.i.immediate = displacement(moved, node.stage.into());
                }
                node.stage = 0;
                node.in_order = true;
                node
            })
            .collect()
    }

    /// The first passes, up to where all stages run.
    fn fill(&self) -> Vec<Node> {
        let first_passes = |last: u32| {
            self.outside(last, 0..=last, |moved, stage| moved.in_fill(i64::from(last) - stage))
        };
        (0..self.stages() - 1).flat_map(first_passes).collect()
    }

    /// The last passes, where the last one to start in the kernel is that of part `part` of its
    /// code.
    fn drain(&self, part: u32) -> Vec<Node> {
        let end = self.stages() - 1;
        let last_passes = |first: u32| {
            self.outside(end + part + first, first..=end, |moved, stage| {
                moved.in_drain(stage - i64::from(first))
            })
        };
        (1..=end).flat_map(last_passes).collect()
    }
}

/// Replaces the loop by its fill, kernel, drain and short form.
fn replace(function: &mut Function, at: usize, kernel: &Kernel) -> Result<(), &'static str> {
    let live = function.liveness().start[at];
    let plain_loop = function.blocks[at].clone();
    let name = plain_loop.name.clone().unwrap_or_else(|| format!("{}_loop", function.name));
    let mut next_id = function.new_id();
    let mut new_id = || {
        next_id += 1;
        next_id - 1
    };
    let stages = kernel.stages();
    let parts = kernel.passes.len() as u32;
    let kernel_ids: Vec<BlockId> = (0..parts).map(|_| new_id()).collect();
    let drain_ids: Vec<BlockId> = (0..parts).map(|_| new_id()).collect();
    let (first_id, last_id) = (kernel_ids[0], kernel_ids[kernel_ids.len() - 1]);
    let short_id = new_id();
    let named = |id, suffix: &str, nodes| Block {
        id,
        name: (!suffix.is_empty()).then(|| format!("{name}{suffix}")),
        nodes,
        cycles: None,
    };

    let own_hint = kernel.nodes().iter().any(|node| node.class() == Class::Hb);
    let branch = &plain_loop.nodes[plain_loop.nodes.len() - 1];
    // A branch out that is taken if `test` is 0, for which the source has the loop's count.
    let leave = |test: u8, id: BlockId, reason| {
        let brz = plain(Op::Brz, test, 0, 0);
        let mut node = Node::added(brz, Some(Reference::Block(id)), reason);
        node.plain.rt = branch.i.rt;
        node
    };
    let mut entry = Vec::new();
    let has_short_form = stages > branch.min_passes;
    if has_short_form {
        let free = POOL.rev().find(|&register| live & bit(register) == 0);
        let test = free.ok_or("no register is free for the test of its trip count")?;
        let enough = plain(Op::Clgti, test, branch.i.rt, stages as i32 - 1);
        let mut enough = Node::added(enough, None, "at least as many passes as overlap");
        enough.plain.rt = branch.i.rt;
        entry.extend([enough, leave(test, short_id, "too few passes")]);
    }
    let short_forms = usize::from(has_short_form);
    if stages > 1 {
        for node in kernel.nodes() {
            // Besides the short form: each part of the kernel contains every stage, and a drain of
            // its own contains a stage as often as there are stages before it. The fill contains it
            // as often as there are stages after it. The branch back closes only the last part.
            let times = if node.ends_block() {
                1
            } else {
                parts * (1 + node.stage) + (stages - 1 - node.stage)
            };
            function.copied(node, times as usize + short_forms - 1);
        }
    }
    let mut fill = kernel.fill();
    if !own_hint {
        let length = kernel.rows.len() * kernel.passes.len();
        let late = fill.len().saturating_sub(HINT_REACH.saturating_sub(length) / 2);
        let mut hint = hint(last_id, late > 0);
        if let Some(Reference::Hint { target, .. }) = &mut hint.reference {
            *target = Some(first_id);
        }
        fill.insert(late, hint);
    }

    let part = |part: u32| {
        let mut nodes: Vec<Node> =
            kernel.part(stages - 1 + part, 0..=stages - 1).cloned().collect();
        for node in &mut nodes {
            match &mut node.reference {
                Some(Reference::Block(id)) if *id == plain_loop.id => {
                    if part + 1 == parts {
                        *id = first_id;
                    } else {
                        *node = leave(node.i.rt, drain_ids[part as usize], "the last pass");
                    }
                }
                Some(Reference::Hint { branch, target, .. }) => {
                    (*branch, *target) = (last_id, Some(first_id));
                }
                _ => {}
            }
        }
        let mut block = named(kernel_ids[part as usize], "", nodes);
        block.name = (part == 0).then(|| name.clone());
        block.cycles = Some(kernel.rows.clone());
        block
    };
    let mut short_nodes = plain_loop.nodes.clone();
    for node in &mut short_nodes {
        if let Some(Reference::Block(id)) = &mut node.reference
            && *id == plain_loop.id
        {
            *id = short_id;
        }
    }

    // If the next block ends the function's path, it becomes part of the drain, and copies follow
    // the short form and the other drains.
    let mut after = Vec::new();
    let mut drain = kernel.drain(parts - 1);
    if let Some(next) = function.blocks.get(at + 1) {
        let alone = function.branches_to(next.id) == 0
            && !next.flow().falls_through
            && next.flow().branch != Some(plain_loop.id)
            && next.nodes.len() <= MAX_COPY;
        if alone && stages > 1 {
            let next = function.blocks.remove(at + 1);
            for node in &next.nodes {
                function.copied(node, parts as usize + short_forms - 1);
            }
            drain.extend(next.nodes.iter().cloned());
            after = next.nodes;
        } else if stages > 1 {
            let reference = Some(Reference::Block(next.id));
            after.push(Node::added(plain(Op::Br, 0, 0, 0), reference, ""));
        }
    }
    let outer = function.branches_to(plain_loop.id) > 1;
    let mut blocks = vec![named(plain_loop.id, if outer { "_entry" } else { "" }, entry)];
    blocks.push(named(new_id(), "", fill));
    blocks.extend((0..parts).map(part));
    if !drain.is_empty() {
        blocks.push(named(drain_ids[drain_ids.len() - 1], "_drain", drain));
    }
    function.blocks.splice(at..=at, blocks);
    for part in 0..parts - 1 {
        let mut drain = kernel.drain(part);
        drain.extend(after.iter().cloned());
        let block = named(drain_ids[part as usize], "_drain", drain);
        function.blocks.push(block);
    }
    if has_short_form {
        function.blocks.push(named(short_id, "_short", short_nodes));
        function.blocks.push(named(new_id(), "", after));
    }
    Ok(())
}
