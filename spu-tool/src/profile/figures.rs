//! Figures of functions and lines.

use spu_emulator::profile::Tally;
use spu_scheduler::code::{Function, Source};

/// A function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FunctionFigures {
    /// Which.
    pub function: Function,
    /// How often its first instruction issued.
    pub calls: u64,
    /// What all of it cost.
    pub tally: Tally,
}

impl FunctionFigures {
    /// Cycles of it, without those of functions that it calls, for each call; `None` if it was
    /// never begun at its start.
    #[must_use]
    pub fn cycles_a_call(&self) -> Option<f64> {
        (self.calls != 0).then(|| self.tally.cycles() as f64 / self.calls as f64)
    }
}

/// A source line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LineFigures {
    /// Which.
    pub source: Source,
    /// The function of its first word.
    pub function: Option<String>,
    /// What all its words cost.
    pub tally: Tally,
}
