//! The schedule of straight-line code, as IBM's static analyser shows it: branches are not taken,
//! and hints have no effect.

use super::account::Account;
use super::pipeline::{Issue, Pipeline};
use super::rules::Rules;
use crate::instructions::Instruction;

/// One word of code, and how it issued.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// The word's address.
    pub address: u32,
    /// The word.
    pub word: u32,
    /// The instruction and its issue, or `None` if the word is not an instruction.
    pub issued: Option<(Instruction, Issue)>,
    /// Address of the instruction for whose result it waited.
    pub producer: Option<u32>,
}

/// The schedule of some code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Schedule {
    /// The lines, in program order.
    pub lines: Vec<Line>,
    /// The account, or `None` if a word is not an instruction, because no total would be correct.
    pub account: Option<Account>,
}

/// Schedules `code` (pairs of address and word) from its first word. All registers are ready at
/// the start.
#[must_use]
pub fn straight_line(code: &[(u32, u32)], rules: Rules) -> Schedule {
    let rules = Rules { hints: false, ..rules };
    let mut feed = Feed::new(Pipeline::new(rules));
    let lines: Vec<Line> = code.iter().map(|&(address, word)| feed.next(address, word)).collect();
    let known = lines.iter().all(|line| line.issued.is_some());
    Schedule { lines, account: known.then(|| feed.pipeline.account().clone()) }
}

/// A pipeline, and for each register the instruction that wrote it.
pub(super) struct Feed {
    pub pipeline: Pipeline,
    writers: [Option<u32>; 128],
}

impl Feed {
    pub fn new(pipeline: Pipeline) -> Self {
        Self { pipeline, writers: [None; 128] }
    }

    pub fn next(&mut self, address: u32, word: u32) -> Line {
        let Some(instruction) = Instruction::decode(word) else {
            return Line { address, word, issued: None, producer: None };
        };
        let issue = self.pipeline.issue(address, instruction);
        let waited = issue.waited_register;
        let producer = waited.and_then(|register| self.writers[usize::from(register)]);
        for register in instruction.writes().iter() {
            self.writers[usize::from(register)] = Some(address);
        }
        Line { address, word, issued: Some((instruction, issue)), producer }
    }
}
