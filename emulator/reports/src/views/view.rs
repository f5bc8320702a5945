//! A program's part of a profile, combined with its code.

use std::collections::BTreeMap;
use std::path::Path;

use spu_emulator::profile::{ProgramId, Tally};
use spu_scheduler::code::{Code, Function};
use thiserror::Error;

use super::figures::{FunctionFigures, LineFigures};
use super::{json, listing};
use crate::ProfileFile;

/// The name for instructions that are in no function of the file.
const OUTSIDE: &str = "(outside the program's code)";

/// Why a program can't be shown from a profile.
#[derive(Debug, Error)]
pub enum ViewError {
    /// The profile is of other programs.
    #[error("program {asked} is not in the profile; it has {ran}")]
    OtherProgram {
        /// The program in the file.
        asked: ProgramId,
        /// The programs in the profile.
        ran: String,
    },
    /// The file has no such function.
    #[error("no function {name}; the functions that ran are {ran}")]
    NoFunction {
        /// The function's name.
        name: String,
        /// The functions that ran.
        ran: String,
    },
}

/// Everything that all SPEs ran of one program.
#[derive(Clone, Debug)]
pub struct View<'a> {
    pub(super) code: &'a Code,
    pub(super) cycles_per_second: u64,
    pub(super) tallies: BTreeMap<(u32, u32), Tally>,
}

impl<'a> View<'a> {
    /// The view of the program whose file is `image`, from which `code` was read.
    pub fn new(code: &'a Code, image: &[u8], profile: &ProfileFile) -> Result<Self, ViewError> {
        let asked = ProgramId::of(image);
        let mut tallies: BTreeMap<_, Tally> = BTreeMap::new();
        let of_it = |program: Option<ProgramId>| program == Some(asked);
        for program in profile.programs().filter(|it| of_it(it.program)) {
            for entry in &program.instructions {
                let tally = tallies.entry((entry.address, entry.word)).or_default();
                tally.add(&entry.tally());
            }
        }
        if tallies.is_empty() {
            let mut ran: Vec<_> = profile.programs().map(|it| it.program).collect();
            ran.sort();
            ran.dedup();
            let name = |id: &Option<ProgramId>| id.map_or("unnamed".into(), |id| id.to_string());
            return Err(ViewError::OtherProgram { asked, ran: list(ran.iter().map(name), "none") });
        }
        Ok(Self { code, cycles_per_second: profile.cycles_per_second(), tallies })
    }

    /// The total of the whole program.
    #[must_use]
    pub fn total(&self) -> Tally {
        sum(self.tallies.values())
    }

    /// The functions that ran, the most expensive first.
    #[must_use]
    pub fn functions(&self) -> Vec<FunctionFigures> {
        let mut figures = Vec::new();
        for function in self.code.functions() {
            let tally = self.between(function.start, function.end);
            if tally == Tally::default() {
                continue;
            }
            figures.push(FunctionFigures {
                function: function.clone(),
                calls: self.between(function.start, function.start + 4).issued,
                tally,
            });
        }
        let nowhere = |address: u32| self.function_at(address).is_none();
        let outside = self.tallies.iter().filter(|(place, _)| nowhere(place.0));
        let outside = sum(outside.map(|(_, tally)| tally));
        if outside != Tally::default() {
            figures.push(FunctionFigures {
                function: Function { name: OUTSIDE.into(), start: 0, end: 0 },
                calls: 0,
                tally: outside,
            });
        }
        figures.sort_by_key(|figures| std::cmp::Reverse(figures.tally.cycles()));
        figures
    }

    /// Finds a function by name.
    pub fn function(&self, name: &str) -> Result<FunctionFigures, ViewError> {
        let functions = self.functions();
        let found = functions.iter().find(|it| it.function.name == name);
        found.cloned().ok_or_else(|| ViewError::NoFunction {
            name: name.to_owned(),
            ran: list(functions.into_iter().map(|it| it.function.name), "none"),
        })
    }

    /// The source lines that ran, of one function or of all, the most expensive first.
    /// Instructions without a line are left out.
    #[must_use]
    pub fn lines(&self, function: Option<&Function>) -> Vec<LineFigures> {
        let mut lines: BTreeMap<_, LineFigures> = BTreeMap::new();
        let sources: BTreeMap<_, _> = self.code.sources().into_iter().collect();
        let range = function.map_or(0..u32::MAX, |function| function.start..function.end);
        for (&(address, _), tally) in self.tallies.range((range.start, 0)..(range.end, 0)) {
            let Some(source) = sources.get(&address) else {
                continue;
            };
            let line = lines.entry((&source.file, source.line));
            let line = line.or_insert_with(|| LineFigures {
                source: (*source).clone(),
                function: self.function_at(address),
                tally: Tally::default(),
            });
            line.tally.add(tally);
        }
        let mut lines: Vec<_> = lines.into_values().collect();
        lines.sort_by_key(|line| std::cmp::Reverse(line.tally.cycles()));
        lines
    }

    /// The table of functions.
    #[must_use]
    pub fn functions_text(&self) -> String {
        listing::functions(self)
    }

    /// The annotated listing of a function; `read` returns the text of a source file, if it can.
    #[must_use]
    pub fn function_text(
        &self,
        function: &FunctionFigures,
        read: &mut dyn FnMut(&Path) -> Option<String>,
    ) -> String {
        listing::function(self, function, read)
    }

    /// The table of lines.
    #[must_use]
    pub fn lines_text(
        &self,
        function: Option<&Function>,
        read: &mut dyn FnMut(&Path) -> Option<String>,
    ) -> String {
        listing::lines(self, function, read)
    }

    /// One JSON document: all functions and their lines, or one function with its instructions.
    #[must_use]
    pub fn json(&self, function: Option<&FunctionFigures>) -> String {
        json::document(self, function)
    }

    /// The instructions of a function that ran, and the words of it that did not.
    pub(super) fn instructions(&self, function: &Function) -> Vec<(u32, u32, Tally)> {
        let mut rows: BTreeMap<_, _> = self
            .tallies
            .range((function.start, 0)..(function.end, 0))
            .map(|(&place, tally)| (place, tally.clone()))
            .collect();
        for place in self.code.words(function.start, function.end) {
            rows.entry(place).or_default();
        }
        let row = |((address, word), tally)| (address, word, tally);
        rows.into_iter().map(row).collect()
    }

    fn between(&self, start: u32, end: u32) -> Tally {
        sum(self.tallies.range((start, 0)..(end, 0)).map(|(_, tally)| tally))
    }

    fn function_at(&self, address: u32) -> Option<String> {
        let functions = self.code.functions();
        let after = functions.partition_point(|function| function.start <= address);
        let function = functions[..after].last()?;
        (address < function.end).then(|| function.name.clone())
    }
}

fn sum<'t>(tallies: impl Iterator<Item = &'t Tally>) -> Tally {
    let mut sum = Tally::default();
    for tally in tallies {
        sum.add(tally);
    }
    sum
}

fn list(names: impl Iterator<Item = String>, none: &str) -> String {
    let names: Vec<_> = names.collect();
    if names.is_empty() { none.into() } else { names.join(", ") }
}
