//! Checks the schedule notes in assembly sources against the model.
//!
//! A note is the first word of a line's comment: `# 12e value` means cycle 12, even pipe. Cycles
//! count from the label before the line. If the label heads a loop, the note refers to the steady
//! state of the loop, counted from the first cycle that the pass could use. Otherwise cycles count
//! from the issue of the label's own instruction, with every register ready. A label is a symbol
//! of the file or `name:` in the source. A label at a branch, which only a hint names, does not
//! count.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::path::{Component, Path, PathBuf};

use thiserror::Error;

use crate::code::Code;
use spu_isa::timing::{Issue, Line, Loop, Rules, find_loops, hinted_branch, straight_line};
use spu_isa::{Instruction, Pipe};

/// A cycle and a pipe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slot {
    /// Cycles since the label.
    pub cycle: u64,
    /// The pipe.
    pub pipe: Pipe,
}

impl fmt::Display for Slot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pipe = match self.pipe {
            Pipe::Even => 'e',
            Pipe::Odd => 'o',
        };
        write!(f, "{}{pipe}", self.cycle)
    }
}

/// The model's result for an instruction's note.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Model {
    /// The instruction issues here.
    Slot(Slot),
    /// The line produced no instruction.
    NoInstruction,
    /// The line produced this many instructions, so it is not clear which one the note means.
    Several(usize),
    /// A word after the label is not an instruction.
    Unknown,
}

impl fmt::Display for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Slot(slot) => slot.fmt(f),
            Self::NoInstruction => f.write_str("no instruction"),
            Self::Several(count) => write!(f, "{count} instructions"),
            Self::Unknown => {
                f.write_str("unknown: not all words from the label on are instructions")
            }
        }
    }
}

/// A note that differs from the model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// The source file, under the name that was passed to [`check`].
    pub file: PathBuf,
    /// The line number in it, from 1.
    pub line: u64,
    /// The cycle and pipe in the note.
    pub note: Slot,
    /// The model's result.
    pub model: Model,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, line, note, model } = self;
        write!(f, "{}:{line}: note {note}, model {model}", file.display())
    }
}

/// The result of checking notes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outcome {
    /// The number of notes that were checked.
    pub notes: usize,
    /// The notes that differ from the model.
    pub differences: Vec<Difference>,
}

/// Why notes can't be checked.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum CheckError {
    /// No line table.
    #[error("no line table: assemble with -g")]
    NoLines,
    /// The line table does not name the source.
    #[error("{0}: the line table does not name it")]
    NotInTable(PathBuf),
}

/// The source files that the line table names.
#[must_use]
pub fn source_files(code: &Code) -> Vec<PathBuf> {
    let files: BTreeSet<_> = code.sources().iter().map(|(_, at)| at.file.clone()).collect();
    files.into_iter().collect()
}

/// Compares the notes in `sources` (paths and texts) with the model.
pub fn check(
    code: &Code,
    sources: &[(PathBuf, String)],
    rules: Rules,
) -> Result<Outcome, CheckError> {
    let table = code.sources();
    if table.is_empty() {
        return Err(CheckError::NoLines);
    }
    let loops: Vec<Loop> = code
        .functions()
        .iter()
        .flat_map(|function| find_loops(&code.words(function.start, function.end), rules))
        .collect();
    let mut outcome = Outcome::default();
    for (path, text) in sources {
        let mut by_line: BTreeMap<u64, Vec<u32>> = BTreeMap::new();
        for (address, source) in &table {
            if same_file(&source.file, path) {
                let addresses = by_line.entry(source.line).or_default();
                if addresses.is_empty() || !code.is_filler(*address) {
                    addresses.push(*address);
                }
            }
        }
        if by_line.is_empty() {
            return Err(CheckError::NotInTable(path.clone()));
        }
        let labels = label_addresses(code, text, &by_line);
        let notes = (1..).zip(text.lines());
        for (line, note) in notes.filter_map(|(line, text)| Some((line, note(text)?))) {
            outcome.notes += 1;
            let model = match by_line.get(&line).map_or(&[][..], Vec::as_slice) {
                [] => Model::NoInstruction,
                &[address] => {
                    let words = |from, to| code.words(from, to);
                    slot(&words, &labels, &loops, address, rules)
                        .map_or(Model::Unknown, Model::Slot)
                }
                several => Model::Several(several.len()),
            };
            if model != Model::Slot(note) {
                outcome.differences.push(Difference { file: path.clone(), line, note, model });
            }
        }
    }
    Ok(outcome)
}

/// The cycle and pipe in which the model issues the instruction at `address`, counted from the
/// label before it. `words` returns the code from one address up to another.
pub(crate) fn slot(
    words: &dyn Fn(u32, u32) -> Vec<(u32, u32)>,
    labels: &BTreeSet<u32>,
    loops: &[Loop],
    address: u32,
    rules: Rules,
) -> Option<Slot> {
    let label = labels.range(..=address).next_back().copied()?;
    let around = loops
        .iter()
        .filter(|found| found.start == label && found.branch >= address)
        .min_by_key(|found| found.branch);
    let in_loop = around.and_then(|found| found.steady.as_ref());
    let issue_in = |lines: &[Line]| -> Option<Issue> {
        let line = lines.iter().find(|line| line.address == address)?;
        line.issued.map(|(_, issue)| issue)
    };
    let issue = match in_loop {
        Some(steady) => issue_in(&steady.lines)?,
        None => {
            let schedule = straight_line(&words(label, address + 4), rules);
            schedule.account.as_ref()?;
            issue_in(&schedule.lines)?
        }
    };
    Some(Slot { cycle: issue.cycle, pipe: issue.pipe })
}

/// The note in a source line.
fn note(line: &str) -> Option<Slot> {
    let (_, comment) = line.split_once('#')?;
    let word = comment.split_whitespace().next()?;
    let word = word.trim_end_matches([',', ';', ':']);
    let (cycle, pipe) = match word.strip_suffix('e') {
        Some(cycle) => (cycle, Pipe::Even),
        None => (word.strip_suffix('o')?, Pipe::Odd),
    };
    if !cycle.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let cycle = cycle.parse().ok()?;
    Some(Slot { cycle, pipe })
}

/// The addresses of symbols, and of the first instructions after labels that are not symbols.
/// Branches that a hint names are left out.
fn label_addresses(code: &Code, text: &str, by_line: &BTreeMap<u64, Vec<u32>>) -> BTreeSet<u32> {
    let mut labels: BTreeSet<u32> = code.labels().collect();
    for (line, text) in (1..).zip(text.lines()) {
        if !has_label(text) {
            continue;
        }
        let later = by_line.range(line..).next();
        if let Some(&address) = later.and_then(|(_, addresses)| addresses.first()) {
            labels.insert(address);
        }
    }
    for function in code.functions() {
        for (pc, word) in code.words(function.start, function.end) {
            if let Some(branch) = Instruction::decode(word).and_then(|i| hinted_branch(pc, i)) {
                labels.remove(&branch);
            }
        }
    }
    labels
}

fn has_label(line: &str) -> bool {
    let code = line.split('#').next().unwrap_or_default();
    code.split_once(':').is_some_and(|(name, _)| {
        let name = name.trim();
        let in_name = |c: char| c.is_ascii_alphanumeric() || "._$".contains(c);
        !name.is_empty() && name.chars().all(in_name)
    })
}

/// Whether the line table's path means this file: both are the same file, or one path ends with
/// the other.
fn same_file(in_table: &Path, given: &Path) -> bool {
    if let (Ok(one), Ok(other)) = (in_table.canonicalize(), given.canonicalize()) {
        return one == other;
    }
    let names = |path: &Path| -> Vec<_> {
        let names = path.components().filter_map(|part| match part {
            Component::Normal(name) => Some(name.to_owned()),
            _ => None,
        });
        names.collect()
    };
    let (in_table, given) = (names(in_table), names(given));
    !given.is_empty() && (in_table.ends_with(&given) || given.ends_with(&in_table))
}
