//! What `spu time` reports about a file: the analysis from which the listing, the JSON and the
//! HTML page are made.

mod function;
mod html;
mod json;
mod listing;

use spu_isa::timing::{Rules, find_loops, hint_distances, straight_line};
use spu_scheduler::code::{Code, Function};

pub use function::FunctionReport;

/// The analysis of a file or of one function in it.
#[derive(Clone, Debug)]
pub struct Report<'a> {
    code: &'a Code,
    functions: Vec<FunctionReport>,
}

impl<'a> Report<'a> {
    /// Analyses every function, or only the one with this name. `None` if there is no such
    /// function.
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
        let functions: Vec<_> = code.functions().iter().filter(wanted).map(analyse).collect();
        (name.is_none() || !functions.is_empty()).then_some(Self { code, functions })
    }

    /// The functions, by address.
    #[must_use]
    pub fn functions(&self) -> &[FunctionReport] {
        &self.functions
    }

    /// The report as text.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = String::new();
        for function in &self.functions {
            listing::function(&mut text, self.code, function);
        }
        text
    }

    /// The report as one JSON document.
    #[must_use]
    pub fn json(&self) -> String {
        json::document(self.code, &self.functions)
    }

    /// The report as one HTML page, with a diagram of the pipelines for each schedule. It loads
    /// nothing else. `title` is shown as the name of what was analysed.
    #[must_use]
    pub fn html(&self, title: &str) -> String {
        html::page(self.code, title, &self.functions)
    }
}
