//! Checks a kernel after an edit, in seconds: its schedule, the rules of the ABI, its error, its
//! time, and that it equals its twin.

use std::io::{self, Write};

use rand::SeedableRng as _;
use rand_chacha::ChaCha8Rng;
use spu_scheduler::Outcome;
use thiserror::Error;

use crate::bench::{Bench, SEED};
use crate::catalogue::Kernel;
use crate::description::Unequal;
use crate::measure::time;
use crate::set::Kernels;
use crate::source::Source;
use crate::workshop::{Workshop, WorkshopError};

/// The fault that was found in a kernel.
#[derive(Debug, Error)]
pub enum CheckError {
    /// The kernel can't be assembled or scheduled.
    #[error(transparent)]
    Workshop(#[from] WorkshopError),
    /// Notes in the schedule differ from the model.
    #[error("{kernel}: {differences}")]
    Notes {
        /// The kernel.
        kernel: &'static str,
        /// One line for each difference.
        differences: String,
    },
    /// The error is larger than the header states.
    #[error("{kernel}: the error is {measured:.2}, but its header states {stated}")]
    Error {
        /// The kernel.
        kernel: &'static str,
        /// The measured error.
        measured: f64,
        /// The stated error.
        stated: f64,
    },
    /// The header states no error, although one is measured.
    #[error("{0}: its header states no error")]
    Unstated(&'static str),
    /// It differs from its twin.
    #[error(transparent)]
    Unequal(#[from] Unequal),
    /// The report can't be written.
    #[error("{0}")]
    Report(#[from] io::Error),
}

/// Checks kernels and reports the result of each step.
///
/// # Panics
///
/// Panics if a kernel breaks a rule of the ABI; see [`Bench::call`].
pub fn check(kernels: &[&Kernel], out: &mut impl Write) -> Result<(), CheckError> {
    let workshop = Workshop::here()?;
    let set = Kernels::here()?;
    let mut bench = Bench::of(set.clone());
    for kernel in kernels {
        let source = Source::find(kernel.name).expect("every kernel has a source");
        writeln!(out, "{} ({})", kernel.name, source.file)?;
        schedule(&workshop, source, out)?;
        for case in &kernel.cases {
            bench.reset();
            let arguments = (case.place)(&mut bench, case.objects.first());
            bench.call(kernel.name, &arguments);
        }
        writeln!(
            out,
            "  ABI       {} cases keep it, written and scheduled alike",
            kernel.cases.len()
        )?;
        error(kernel, source, &mut bench, out)?;
        for timed in time(&mut bench, kernel) {
            writeln!(
                out,
                "  time      {:.2} cycles a ray, {:.2} as written: {}, {} objects",
                timed.cycles_a_test(&timed.scheduled),
                timed.cycles_a_test(&timed.plain),
                timed.case,
                timed.objects,
            )?;
        }
        let calls = (kernel.equal)(&mut bench, &mut ChaCha8Rng::seed_from_u64(SEED))?;
        writeln!(out, "  twin      {calls} calls give its bits")?;
    }
    Ok(())
}

fn schedule(workshop: &Workshop, source: &Source, out: &mut impl Write) -> Result<(), CheckError> {
    let schedule = workshop.schedule(source)?;
    for report in &schedule.loops {
        let label = &report.name;
        match &report.outcome {
            Outcome::Pipelined(figures) => writeln!(
                out,
                "  loop      {label}: {} cycles a pass, no less than {} possible",
                figures.interval, figures.minimum
            )?,
            Outcome::Plain(why) => {
                writeln!(out, "  loop      {label}: passes do not overlap: {why}")?
            }
        }
    }
    let outcome = workshop.notes(source)?;
    if !outcome.differences.is_empty() {
        let lines = outcome.differences.iter().map(ToString::to_string);
        return Err(CheckError::Notes {
            kernel: source.name,
            differences: lines.collect::<Vec<_>>().join("\n"),
        });
    }
    writeln!(out, "  schedule  its {} notes agree with the model", outcome.notes)?;
    Ok(())
}

fn error(
    kernel: &Kernel,
    source: &Source,
    bench: &mut Bench,
    out: &mut impl Write,
) -> Result<(), CheckError> {
    let Some(error) = &kernel.error else {
        return Ok(());
    };
    let stated = source.header().and_then(|header| header.stated_error());
    let stated = stated.ok_or(CheckError::Unstated(kernel.name))?;
    let measured = error(bench, &mut ChaCha8Rng::seed_from_u64(SEED));
    if measured > stated {
        return Err(CheckError::Error { kernel: kernel.name, measured, stated });
    }
    writeln!(out, "  error     {measured:.2}, at most {stated} stated")?;
    Ok(())
}
