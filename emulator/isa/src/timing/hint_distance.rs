//! Whether hints in straight-line code are far enough ahead of their branches.

use super::hint::hinted_branch;
use super::rules::HINT_MINIMUM_INSTRUCTIONS;
use super::schedule::Line;

/// The effect of a hint if there is no branch between it and its branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The branch is free.
    Free,
    /// The branch waits this many cycles.
    Waits(u64),
    /// The branch is too close to see the hint.
    NotSeen,
    /// The hint at this address replaces it before the branch.
    Replaced(u32),
}

/// A hint and the distance to its branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HintDistance {
    /// Address of the hint.
    pub address: u32,
    /// Address of the branch.
    pub branch: u32,
    /// Number of instructions between them.
    pub instructions: u64,
    /// Cycles from the hint's issue to the branch's, before any wait for the hint.
    pub cycles: u64,
    /// What follows from the distance.
    pub verdict: Verdict,
}

/// The hints in a function's schedule whose branches come later in it.
#[must_use]
pub fn hint_distances(lines: &[Line]) -> Vec<HintDistance> {
    let distance = |(at, line): (usize, &Line)| {
        let (instruction, issue) = line.issued?;
        let branch = hinted_branch(line.address, instruction)?;
        let later_lines = &lines[at + 1..];
        let instructions = later_lines.iter().position(|line| line.address == branch)?;
        let (_, branch_issue) = later_lines[instructions].issued?;
        let cycles = branch_issue.cycle - issue.cycle;
        let hints = |line: &&Line| {
            let hint = line.issued.and_then(|(i, _)| hinted_branch(line.address, i));
            hint.is_some()
        };
        let later = later_lines[..instructions].iter().find(hints);
        let instructions = instructions as u64;
        let verdict = if let Some(later) = later {
            Verdict::Replaced(later.address)
        } else if instructions < HINT_MINIMUM_INSTRUCTIONS {
            Verdict::NotSeen
        } else if branch_issue.cycle < issue.ready_cycle {
            Verdict::Waits(issue.ready_cycle - branch_issue.cycle)
        } else {
            Verdict::Free
        };
        Some(HintDistance { address: line.address, branch, instructions, cycles, verdict })
    };
    lines.iter().enumerate().filter_map(distance).collect()
}
