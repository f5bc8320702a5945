//! The loops of a kernel: how near their schedules come to what the pipes allow.

use serde::Serialize;
use spu_emulator::schedule::{Figures, LoopReport, Outcome};

/// A loop of a scheduled kernel.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Loop {
    /// Its label.
    pub name: String,
    /// What the scheduler made of it.
    pub form: Form,
}

/// What the scheduler made of a loop.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Form {
    /// Passes overlap.
    Pipelined(Cycles),
    /// Passes do not overlap, for this reason.
    Straight(String),
}

/// Cycles of a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Cycles {
    /// In which the plain pass takes the even pipe.
    pub even: u64,
    /// In which it takes the odd pipe.
    pub odd: u64,
    /// That no schedule goes below: pipes, and chains from pass to pass.
    pub bound: u64,
    /// From pass to pass.
    pub interval: u64,
    /// Passes that overlap.
    pub stages: u64,
}

impl Cycles {
    /// The share of the bound that is reached: 1 is all.
    #[must_use]
    pub fn reached(&self) -> f64 {
        self.bound as f64 / self.interval as f64
    }
}

impl From<&Figures> for Cycles {
    fn from(figures: &Figures) -> Self {
        Self {
            even: figures.even,
            odd: figures.odd,
            bound: figures.minimum,
            interval: figures.interval,
            stages: figures.stages,
        }
    }
}

impl From<&LoopReport> for Loop {
    fn from(report: &LoopReport) -> Self {
        Self {
            name: report.name.clone(),
            form: match &report.outcome {
                Outcome::Pipelined(figures) => Form::Pipelined(figures.into()),
                Outcome::Plain(why) => Form::Straight(why.clone()),
            },
        }
    }
}
