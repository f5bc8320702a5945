//! Loops: the mean cost of a pass, and its bounds.
//!
//! A loop is a branch back to its own or an earlier address. The body reaches from that address to
//! the branch. Branches inside it fall through. There are two bounds. Each pipe issues one
//! instruction a cycle. And the values that a pass takes from the pass before have to be ready
//! (the recurrence). Dependences through local store are not seen.

use super::account::Account;
use super::pipeline::Pipeline;
use super::recurrence::{Recurrence, critical_path, recurrence};
use super::rules::{DOUBLE_INTERVAL, Rules};
use super::schedule::{Feed, Line};
use crate::address::LIMIT_MASK;
use crate::instructions::{Class, Format, Instruction, Pipe, Target};

/// The number of instructions of the longest body that is analysed.
const MAX_BODY: usize = 2048;
/// The number of loops in a function that are analysed.
const MAX_LOOPS: usize = 256;
/// The number of passes after which the search for a repeating schedule ends.
const MAX_PASSES: usize = 256;
/// The number of instructions before the loop that are run first: twice the distance that a hint
/// can have.
const RUN_UP: usize = 512;

/// A loop and its analysis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loop {
    /// Address of the first instruction.
    pub start: u32,
    /// Address of the branch back.
    pub branch: u32,
    /// Number of instructions in the body.
    pub instructions: usize,
    /// The cost of a pass. `None` if a word of the body is not an instruction, the body is too
    /// long, or the schedule does not repeat.
    pub steady: Option<Steady>,
    /// Cycles of a pass in which the even pipe is occupied.
    pub even: u64,
    /// Cycles of a pass in which the odd pipe is occupied.
    pub odd: u64,
    /// The length in cycles of the longest chain of dependent instructions in one pass.
    pub critical_path: u64,
    /// The longest chain from pass to pass, or `None` if no value is carried over.
    pub recurrence: Option<Recurrence>,
}

/// A schedule that repeats.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Steady {
    /// Number of passes after which it repeats.
    pub passes: u64,
    /// The cycles of these passes.
    pub account: Account,
    /// The schedule of the last of these passes. Cycles count from the first cycle that the pass
    /// could use.
    pub lines: Vec<Line>,
}

impl Steady {
    /// Mean number of cycles of a pass.
    #[must_use]
    pub fn cycles_a_pass(&self) -> f64 {
        self.account.cycles() as f64 / self.passes as f64
    }
}

impl Loop {
    /// A lower bound for the cycles of a pass, whatever the schedule of the body.
    #[must_use]
    pub fn bound(&self) -> u64 {
        let recurrence = self.recurrence.as_ref().map_or(0, Recurrence::ceiling);
        self.even.max(self.odd).max(recurrence)
    }
}

/// The loops of a function, in the order of their branches. `code` is pairs of address and word.
#[must_use]
pub fn find_loops(code: &[(u32, u32)], rules: Rules) -> Vec<Loop> {
    let Some(&(first, _)) = code.first() else {
        return Vec::new();
    };
    let mut loops = Vec::new();
    for (at, &(address, word)) in code.iter().enumerate() {
        let Some(target) = Instruction::decode(word).and_then(|i| branch_target(address, i)) else {
            continue;
        };
        if target < first || target > address {
            continue;
        }
        let start = code.partition_point(|&(word_at, _)| word_at < target);
        if start > at || code[start].0 != target {
            continue;
        }
        let analyse = loops.len() < MAX_LOOPS;
        loops.push(Loop::new(code, start, at, rules, analyse));
    }
    loops
}

/// The target of a direct branch that is not a call.
fn branch_target(pc: u32, i: Instruction) -> Option<u32> {
    let row = i.op.row();
    if row.class != Class::Br || row.target == Target::Rt {
        return None;
    }
    match row.format {
        Format::Ri16Relative => Some(pc.wrapping_add_signed(i.immediate) & LIMIT_MASK),
        Format::Ri16Absolute => Some(i.immediate as u32 & LIMIT_MASK),
        _ => None,
    }
}

impl Loop {
    fn new(code: &[(u32, u32)], start: usize, branch: usize, rules: Rules, analyse: bool) -> Self {
        let body = &code[start..=branch];
        let mut found = Self {
            start: code[start].0,
            branch: code[branch].0,
            instructions: body.len(),
            steady: None,
            even: 0,
            odd: 0,
            critical_path: 0,
            recurrence: None,
        };
        if !analyse || body.len() > MAX_BODY {
            return found;
        }
        let decode = |&(_, word): &(u32, u32)| Instruction::decode(word);
        let Some(instructions) = body.iter().map(decode).collect::<Option<Vec<_>>>() else {
            return found;
        };
        for instruction in &instructions {
            let class = instruction.op.row().class;
            if class == Class::Fpd && !rules.double_extension {
                // A double-precision instruction keeps the odd pipe empty too.
                found.even += DOUBLE_INTERVAL;
                found.odd += DOUBLE_INTERVAL;
            } else if class.pipe() == Pipe::Even {
                found.even += 1;
            } else {
                found.odd += 1;
            }
        }
        found.critical_path = critical_path(&instructions, rules);
        found.recurrence = recurrence(&instructions, rules);
        let before = &code[start.saturating_sub(RUN_UP)..start];
        found.steady = steady(before, body, rules);
        found
    }
}

fn steady(before: &[(u32, u32)], body: &[(u32, u32)], rules: Rules) -> Option<Steady> {
    let (start, branch) = (body.first()?.0, body.last()?.0);
    let mut feed = Feed::new(Pipeline::new(rules));
    for &(address, word) in before {
        feed.next(address, word);
    }
    let mut states = Vec::new();
    let mut lines: Vec<Line> = Vec::new();
    for _ in 0..MAX_PASSES {
        let phase = feed.pipeline.phase();
        let account = feed.pipeline.account().clone();
        if let Some(earlier) = states.iter().position(|(seen, _)| *seen == phase) {
            let (_, since) = &states[earlier];
            return Some(Steady {
                passes: (states.len() - earlier) as u64,
                account: account.since(since),
                lines,
            });
        }
        states.push((phase, account));
        let origin = feed.pipeline.clock();
        lines = body
            .iter()
            .map(|&(address, word)| {
                let mut line = feed.next(address, word);
                if let Some((_, issue)) = &mut line.issued {
                    // In the first pass, the first instruction can pair with one before the loop
                    // and so be early. That pass is not kept.
                    issue.cycle = issue.cycle.saturating_sub(origin);
                    issue.ready_cycle = issue.ready_cycle.saturating_sub(origin);
                }
                line
            })
            .collect();
        feed.pipeline.branched(branch, Some(start));
    }
    None
}
