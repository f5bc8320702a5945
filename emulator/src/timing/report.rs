//! What `spu time` says of a file: the analysis that the listing and the JSON are made from.

use super::account::Account;
use super::code::{Code, Function};
use super::hint_distance::{HintDistance, hint_distances};
use super::loops::{Loop, find_loops};
use super::rules::Rules;
use super::schedule::{Schedule, straight_line};
use super::{json, listing};

/// The analysis of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FunctionReport {
    /// Which.
    pub function: Function,
    /// Its code from start to end, no branch being taken.
    pub schedule: Schedule,
    /// Its hints whose branches stand behind them.
    pub hints: Vec<HintDistance>,
    /// Its loops.
    pub loops: Vec<Loop>,
}

/// The analysis of a file or of one function in it.
#[derive(Clone, Debug)]
pub struct Report<'a> {
    code: &'a Code,
    functions: Vec<FunctionReport>,
}

impl<'a> Report<'a> {
    /// Analyses every function, or the one of this name; `None` if there is none of it.
    #[must_use]
    pub fn new(code: &'a Code, name: Option<&str>, rules: Rules) -> Option<Self> {
        let wanted = |function: &&Function| name.is_none_or(|name| function.name == name);
        let analyse = |function: &Function| {
            let words = code.words(function.start, function.end);
            let schedule = straight_line(&words, rules);
            FunctionReport {
                function: function.clone(),
                hints: hint_distances(&schedule.lines),
                schedule,
                loops: find_loops(&words, rules),
            }
        };
        let functions: Vec<_> = code
            .functions()
            .iter()
            .filter(wanted)
            .map(analyse)
            .collect();
        (name.is_none() || !functions.is_empty()).then_some(Self { code, functions })
    }

    /// The functions, by address.
    #[must_use]
    pub fn functions(&self) -> &[FunctionReport] {
        &self.functions
    }

    /// The report for people.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = String::new();
        for function in &self.functions {
            listing::function(&mut text, self.code, function);
        }
        text
    }

    /// The report for programs: one JSON document.
    #[must_use]
    pub fn json(&self) -> String {
        json::document(self.code, &self.functions)
    }
}

/// Cycles that were lost, in a line: `12 operand of LS, 6 double-precision stall`.
pub(super) fn waits(account: &Account) -> String {
    let waits = account.waits();
    let text = waits
        .iter()
        .map(|(cause, cycles)| format!("{cycles} {cause}"));
    text.collect::<Vec<_>>().join(", ")
}
