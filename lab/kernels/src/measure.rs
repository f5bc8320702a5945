//! Measures kernels, with one row for each case.

use rand::SeedableRng as _;
use rand_chacha::ChaCha8Rng;
use serde::Serialize;
use thiserror::Error;

use crate::bench::{Bench, SEED, Version};
use crate::catalogue::{Case, Kernel, Objects};
use crate::loops::{Loop, loops};
use crate::set::Kernels;
use crate::source::Source;
use crate::time::Time;
use crate::workshop::{Workshop, WorkshopError};

/// The results for a kernel.
#[derive(Clone, Debug, Serialize)]
pub struct Measured {
    /// The kernel's name.
    pub kernel: &'static str,
    /// The file of its plain version.
    pub file: &'static str,
    /// A description of what it does.
    pub doc: String,
    /// Its C prototype.
    pub prototype: String,
    /// The worst measured error, in the header's unit.
    pub error: Option<f64>,
    /// The error that its header states, and its domain.
    pub stated_error: String,
    /// Its cases.
    pub cases: Vec<Timed>,
    /// Its loops.
    pub loops: Vec<Loop>,
}

/// Why a kernel could not be measured.
#[derive(Debug, Error)]
pub enum MeasureError {
    /// The kernel has no source with a valid header.
    #[error("{0}: it has no source, or its header does not have the project's format")]
    Header(&'static str),
    /// There are no kernels, or they can't be scheduled.
    #[error(transparent)]
    Workshop(#[from] WorkshopError),
}

/// The times of a case.
#[derive(Clone, Debug, Serialize)]
pub struct Timed {
    /// The name of the case.
    pub case: &'static str,
    /// The number of objects with which the rays were tested.
    pub objects: u32,
    /// The number of rays that a call tests with each object.
    pub rays: u32,
    /// The plain version.
    pub plain: Cost,
    /// The schedule.
    pub scheduled: Cost,
}

/// The cost of a version.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Cost {
    /// The whole call.
    pub call: Time,
    /// For a list, the cost of further objects.
    pub stream: Option<Stream>,
}

/// The cost of a list's further objects.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Stream {
    /// The number of further objects.
    pub objects: u32,
    /// The time for all of them.
    pub time: Time,
}

impl Timed {
    /// The cycles in which one ray is tested with one object, including the whole call.
    #[must_use]
    pub fn cycles_a_test(&self, cost: &Cost) -> f64 {
        cost.call.cycles as f64 / f64::from(self.objects * self.rays)
    }

    /// The cycles in which one ray is tested with one further object.
    #[must_use]
    pub fn cycles_in_stream(&self, cost: &Cost) -> Option<f64> {
        let stream = cost.stream.as_ref()?;
        Some(stream.time.cycles as f64 / f64::from(stream.objects * self.rays))
    }
}

impl Cost {
    /// The time that shows best how well the pipes are used: the stream's if there is one, or else
    /// the call's.
    #[must_use]
    pub fn main(&self) -> &Time {
        self.stream.as_ref().map_or(&self.call, |stream| &stream.time)
    }
}

/// Measures kernels.
pub fn measure_all(
    kernels: impl IntoIterator<Item = &'static Kernel>,
) -> Result<Vec<Measured>, MeasureError> {
    let set = Kernels::here()?;
    let mut bench = Bench::of(set.clone());
    let workshop = Workshop::here()?;
    kernels.into_iter().map(|kernel| measure(set, &mut bench, &workshop, kernel)).collect()
}

fn measure(
    set: &Kernels,
    bench: &mut Bench,
    workshop: &Workshop,
    kernel: &Kernel,
) -> Result<Measured, MeasureError> {
    let source = Source::find(kernel.name);
    let known = source.and_then(|source| Some((source, source.header()?)));
    let (source, header) = known.ok_or(MeasureError::Header(kernel.name))?;
    let schedule = workshop.schedule(source)?;
    // Each kernel has its own generator, so that its error does not depend on which other kernels
    // are measured.
    let mut random = ChaCha8Rng::seed_from_u64(SEED);
    let error = kernel.error.as_ref().map(|error| error(bench, &mut random));
    let cases = time(bench, kernel);
    Ok(Measured {
        kernel: kernel.name,
        file: source.file,
        doc: header.doc,
        prototype: header.prototype,
        cases,
        error,
        stated_error: header.error,
        loops: loops(set, kernel.name, &schedule),
    })
}

/// Only times a kernel's cases.
pub fn time(bench: &mut Bench, kernel: &Kernel) -> Vec<Timed> {
    let cases = kernel.cases.iter().map(|case| {
        let mut cost = |version| cost(bench, kernel.name, case, version);
        Timed {
            case: case.name,
            objects: case.objects.first(),
            rays: kernel.rays,
            plain: cost(Version::Plain),
            scheduled: cost(Version::Scheduled),
        }
    });
    cases.collect()
}

/// The number of runs, of which the fastest counts as the host's time.
const RUNS: u32 = 50;

/// The nanoseconds in which the host's interpreter tests one ray with one object in a kernel's
/// scheduled version, measured on its last case and the longest list. `None` if it has no case.
#[must_use]
pub fn host_nanoseconds(bench: &mut Bench, kernel: &Kernel) -> Option<f64> {
    let case = kernel.cases.last()?;
    let (Objects::Fixed(objects) | Objects::List(_, objects)) = case.objects;
    bench.reset();
    let arguments = (case.place)(bench, objects);
    let run = |_| bench.host_time(Version::Scheduled, kernel.name, &arguments);
    let fastest = (0..RUNS).map(run).min()?;
    Some(fastest.as_secs_f64() * 1e9 / f64::from(objects * kernel.rays))
}

/// Times a case of a kernel in one version.
pub(crate) fn cost(bench: &mut Bench, kernel: &str, case: &Case, version: Version) -> Cost {
    let mut time = |objects| {
        bench.reset();
        let arguments = (case.place)(bench, objects);
        bench.time(version, kernel, &arguments)
    };
    let call = time(case.objects.first());
    let stream = match case.objects {
        Objects::Fixed(_) => None,
        Objects::List(short, long) => {
            Some(Stream { objects: long - short, time: call.up_to(&time(long)) })
        }
    };
    Cost { call, stream }
}

impl Objects {
    /// The number of objects in the call whose whole time is shown.
    #[must_use]
    pub const fn first(self) -> u32 {
        match self {
            Self::Fixed(count) | Self::List(count, _) => count,
        }
    }
}
