//! Loops: what a pass costs in the long run, and what bounds it.
//!
//! A loop is a branch back to an address at or before it, and the body from there to the branch.
//! Branches inside fall through. Bounds: each pipe issues one instruction a cycle; and what a pass
//! takes over from the pass before has to be ready (the recurrence). Dependences through local
//! store are not seen.

use super::account::Account;
use super::pipeline::Pipeline;
use super::recurrence::{Recurrence, critical_path, recurrence};
use super::rules::{DOUBLE_INTERVAL, Rules};
use super::schedule::{Feed, Line};
use crate::address::LIMIT_MASK;
use crate::instructions::{Class, Format, Instruction, Pipe, Target};

/// Longest body that is analysed.
const MAX_BODY: usize = 2048;
/// Loops of a function that are analysed.
const MAX_LOOPS: usize = 256;
/// Passes after which a schedule that has not come round is given up.
const MAX_PASSES: usize = 256;
/// Instructions before the loop that are run first: as far as a hint reaches, and as much again.
const RUN_UP: usize = 512;

/// A loop and its analysis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loop {
    /// Address of the first instruction.
    pub start: u32,
    /// Address of the branch back.
    pub branch: u32,
    /// Instructions in the body.
    pub instructions: usize,
    /// What a pass costs; `None` if a word of the body is no instruction, the body is too long, or
    /// the schedule did not come round.
    pub steady: Option<Steady>,
    /// Cycles in which the even pipe is taken in a pass.
    pub even: u64,
    /// Cycles in which the odd pipe is taken in a pass.
    pub odd: u64,
    /// Cycles of the longest chain of dependent instructions in one pass.
    pub critical_path: u64,
    /// The longest chain from pass to pass; `None` if no value is carried round.
    pub recurrence: Option<Recurrence>,
}

/// A schedule that repeats.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Steady {
    /// Passes after which it repeats.
    pub passes: u64,
    /// The cycles of these passes.
    pub account: Account,
    /// The last of them; cycles count from the first cycle that the pass could use.
    pub lines: Vec<Line>,
}

impl Steady {
    /// Mean cycles of a pass.
    #[must_use]
    pub fn cycles_a_pass(&self) -> f64 {
        self.account.cycles() as f64 / self.passes as f64
    }
}

impl Loop {
    /// No schedule of this body takes fewer cycles a pass.
    #[must_use]
    pub fn bound(&self) -> u64 {
        let recurrence = self.recurrence.as_ref().map_or(0, Recurrence::ceiling);
        self.even.max(self.odd).max(recurrence)
    }
}

/// The loops of a function, given as addresses and words, in the order of their branches.
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

/// Where a direct branch that is no call goes if taken.
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
                // It keeps the odd pipe empty too.
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
                    // Only in the first pass, which is not kept, can the first instruction join
                    // one before the loop, and so be early.
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
