//! The figures of functions and lines.

use spu_emulator::profile::Tally;
use spu_scheduler::code::{Function, Source};

/// The figures of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FunctionFigures {
    /// The function.
    pub function: Function,
    /// How often its first instruction issued.
    pub calls: u64,
    /// The total cost of its instructions.
    pub tally: Tally,
}

impl FunctionFigures {
    /// The function's own cycles for each call, without those of functions that it calls. `None`
    /// if execution never entered it at its start.
    #[must_use]
    pub fn cycles_a_call(&self) -> Option<f64> {
        (self.calls != 0).then(|| self.tally.cycles() as f64 / self.calls as f64)
    }
}

/// The figures of a source line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LineFigures {
    /// The source line.
    pub source: Source,
    /// The function that contains its first word.
    pub function: Option<String>,
    /// The total cost of its words.
    pub tally: Tally,
}
