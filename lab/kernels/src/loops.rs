//! The loops of a kernel, and how close their schedules come to the limits of the pipes.

use serde::Serialize;
use spu_isa::timing::{self, Rules, find_loops};
use spu_scheduler::code::Code;
use spu_scheduler::{Figures, Outcome, Scheduled};

use crate::set::Kernels;

/// A loop of a scheduled kernel.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Loop {
    /// The loop's label.
    pub name: String,
    /// The result of scheduling it.
    pub form: Form,
}

/// The result of scheduling a loop.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Form {
    /// It was pipelined, so that passes overlap.
    Pipelined(Cycles),
    /// It was not pipelined, so passes do not overlap.
    Straight {
        /// The reason.
        why: String,
        /// The cycles of the loop in the images. `None` if the kernel also has loops that are
        /// pipelined.
        /// pipelined.
        cycles: Option<Cycles>,
    },
}

impl Form {
    /// The cycles of a pass, if they are known.
    #[must_use]
    pub fn cycles(&self) -> Option<&Cycles> {
        match self {
            Self::Pipelined(cycles) => Some(cycles),
            Self::Straight { cycles, .. } => cycles.as_ref(),
        }
    }
}

/// The cycles of a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Cycles {
    /// Cycles in which the plain pass uses the even pipe.
    pub even: u64,
    /// Cycles in which it uses the odd pipe.
    pub odd: u64,
    /// The lower bound for any schedule, from the pipes and from chains between passes.
    pub bound: u64,
    /// Cycles from one pass to the next.
    pub interval: u64,
    /// The number of passes that overlap.
    pub stages: u64,
    /// The number of passes that the scheduled loop's code contains.
    pub passes: u64,
}

impl Cycles {
    /// The bound divided by the interval. 1 is the best possible.
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
            passes: figures.passes,
        }
    }
}

/// The loops in a kernel's schedule.
#[must_use]
pub fn loops(kernels: &Kernels, kernel: &str, schedule: &Scheduled) -> Vec<Loop> {
    let mut straight = straight_cycles(kernels, kernel, schedule.loops.len()).into_iter();
    let found = schedule.loops.iter().map(|report| Loop {
        name: report.name.clone(),
        form: match &report.outcome {
            Outcome::Pipelined(figures) => Form::Pipelined(figures.into()),
            Outcome::Plain(why) => Form::Straight { why: why.clone(), cycles: straight.next() },
        },
    });
    found.collect()
}

/// The cycles of a kernel's loops, if both images contain this number of loops. That is the case
/// if none is pipelined, because pipelining would add a second one.
fn straight_cycles(kernels: &Kernels, kernel: &str, count: usize) -> Vec<Cycles> {
    let [plain, scheduled] = [kernels.plain, kernels.scheduled].map(|image| found(kernel, image));
    if plain.len() != count || scheduled.len() != count {
        return Vec::new();
    }
    let cycles = plain.iter().zip(&scheduled).filter_map(|(plain, scheduled)| {
        Some(Cycles {
            even: plain.even,
            odd: plain.odd,
            bound: plain.bound(),
            interval: scheduled.steady.as_ref()?.cycles_a_pass().ceil() as u64,
            stages: 1,
            passes: 1,
        })
    });
    cycles.collect()
}

/// The loops of a kernel in an image.
fn found(kernel: &str, image: &[u8]) -> Vec<timing::Loop> {
    let Ok(code) = Code::parse(image) else {
        return Vec::new();
    };
    let functions = code.functions();
    let function = functions.iter().find(|function| function.name == kernel);
    function.map_or_else(Vec::new, |function| {
        find_loops(&code.words(function.start, function.end), Rules::default())
    })
}
