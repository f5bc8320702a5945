//! Measures kernels: a row for each case.

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

/// What is known of a kernel.
#[derive(Clone, Debug, Serialize)]
pub struct Measured {
    /// Its name.
    pub kernel: &'static str,
    /// The file of its plain version.
    pub file: &'static str,
    /// What it does.
    pub doc: String,
    /// Its C prototype.
    pub prototype: String,
    /// Worst error measured now, in what the header counts it in.
    pub error: Option<f64>,
    /// The error that its header states, with its domain.
    pub stated_error: String,
    /// Its cases.
    pub cases: Vec<Timed>,
    /// Its loops.
    pub loops: Vec<Loop>,
}

/// Why a kernel is not measured.
#[derive(Debug, Error)]
pub enum MeasureError {
    /// Nothing is known of it.
    #[error("{0}: no source, or its header has not the house's form")]
    Header(&'static str),
    /// There are no kernels, or they can't be scheduled.
    #[error(transparent)]
    Workshop(#[from] WorkshopError),
}

/// A case, timed.
#[derive(Clone, Debug, Serialize)]
pub struct Timed {
    /// Its name.
    pub case: &'static str,
    /// Objects that the rays were tested with.
    pub objects: u32,
    /// Rays that a call tests with each object.
    pub rays: u32,
    /// The plain version.
    pub plain: Cost,
    /// The schedule.
    pub scheduled: Cost,
}

/// What a version costs.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Cost {
    /// The whole call.
    pub call: Time,
    /// For a list: what further objects take.
    pub stream: Option<Stream>,
}

/// What a list's further objects take.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Stream {
    /// How many there were.
    pub objects: u32,
    /// For all of them.
    pub time: Time,
}

impl Timed {
    /// Cycles in which one ray is tested with one object, everything counted.
    #[must_use]
    pub fn cycles_a_test(&self, cost: &Cost) -> f64 {
        cost.call.cycles as f64 / f64::from(self.objects * self.rays)
    }

    /// Cycles in which one ray is tested with one further object.
    #[must_use]
    pub fn cycles_in_stream(&self, cost: &Cost) -> Option<f64> {
        let stream = cost.stream.as_ref()?;
        Some(stream.time.cycles as f64 / f64::from(stream.objects * self.rays))
    }
}

impl Cost {
    /// What shows how well the pipes are used: the stream if there is one, else the call.
    #[must_use]
    pub fn main(&self) -> &Time {
        self.stream
            .as_ref()
            .map_or(&self.call, |stream| &stream.time)
    }
}

/// Measures kernels.
pub fn measure_all(
    kernels: impl IntoIterator<Item = &'static Kernel>,
) -> Result<Vec<Measured>, MeasureError> {
    let set = Kernels::here()?;
    let mut bench = Bench::of(set.clone());
    let workshop = Workshop::here()?;
    kernels
        .into_iter()
        .map(|kernel| measure(set, &mut bench, &workshop, kernel))
        .collect()
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
    // A generator of its own, so that a kernel's error does not hang on which others are measured.
    let mut random = ChaCha8Rng::seed_from_u64(SEED);
    let error = kernel.error.map(|error| error(bench, &mut random));
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

/// Times a kernel's cases, and nothing else of it.
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

/// Runs of which the fastest counts as the host's time.
const RUNS: u32 = 50;

/// Nanoseconds in which the host's interpreter tests one ray with one object by a kernel's
/// scheduled version: in its last case, on the longest list; none if it has no case.
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
        Objects::List(short, long) => Some(Stream {
            objects: long - short,
            time: call.up_to(&time(long)),
        }),
    };
    Cost { call, stream }
}

impl Objects {
    /// Objects of the call whose whole time is shown.
    #[must_use]
    pub const fn first(self) -> u32 {
        match self {
            Self::Fixed(count) | Self::List(count, _) => count,
        }
    }
}
