//! The loops of a kernel: how near their schedules come to what the pipes allow.

use serde::{Deserialize, Serialize};
use spu_isa::timing::{self, Rules, find_loops};
use spu_scheduler::Figures;
use spu_scheduler::code::Code;

use crate::set::Kernels;
use crate::workshop::Schedule;

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
    /// Passes do not overlap.
    Straight {
        /// Why not.
        why: String,
        /// What the images' loop takes; none if the kernel has others beside it that are
        /// pipelined.
        cycles: Option<Cycles>,
    },
}

impl Form {
    /// Cycles of a pass, if they are known.
    #[must_use]
    pub fn cycles(&self) -> Option<&Cycles> {
        match self {
            Self::Pipelined(cycles) => Some(cycles),
            Self::Straight { cycles, .. } => cycles.as_ref(),
        }
    }
}

/// Cycles of a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
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

/// The loops of a kernel in its schedule.
#[must_use]
pub fn loops(kernels: &Kernels, kernel: &str, schedule: &Schedule) -> Vec<Loop> {
    let mut straight = straight_cycles(kernels, kernel, schedule.loops.len()).into_iter();
    let found = schedule.loops.iter().map(|(name, outcome)| Loop {
        name: name.clone(),
        form: match outcome {
            Ok(cycles) => Form::Pipelined(*cycles),
            Err(why) => Form::Straight {
                why: why.clone(),
                cycles: straight.next(),
            },
        },
    });
    found.collect()
}

/// What the loops of a kernel take, if it has this many in both images: so if none is pipelined,
/// which would leave a second one behind.
fn straight_cycles(kernels: &Kernels, kernel: &str, count: usize) -> Vec<Cycles> {
    let [plain, scheduled] = [kernels.plain, kernels.scheduled].map(|image| found(kernel, image));
    if plain.len() != count || scheduled.len() != count {
        return Vec::new();
    }
    let cycles = plain
        .iter()
        .zip(&scheduled)
        .filter_map(|(plain, scheduled)| {
            Some(Cycles {
                even: plain.even,
                odd: plain.odd,
                bound: plain.bound(),
                interval: scheduled.steady.as_ref()?.cycles_a_pass().ceil() as u64,
                stages: 1,
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
