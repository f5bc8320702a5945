//! The stress suite: inputs that single precision is worst at, and the bounds that hold there.
//!
//! Owns how families of cases are tried, on all cores, how their worst inputs are kept and tried
//! again, and what is said of them. Invariant: a bound is a kernel header's, or follows from one;
//! a figure depends on the seed and the size alone.

mod family;
mod guarantees;
mod product;
mod random;
pub mod regressions;
pub mod report;
mod statement;
mod steps;
mod stress;
mod workers;

use std::any::Any;

use kernels::Bench;
use serde::Serialize;
use thiserror::Error;

use family::{Families, Family, NoCaseError, Tally};
use regressions::{Regressions, RegressionsError};
use report::{Report, Row, Section};
use statement::StatementError;

/// How many cases are tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Size {
    /// A tenth: for slow hosts.
    Quick,
    /// As many as the families say.
    Default,
    /// Ten times as many.
    Full,
}

/// The suite could not be run.
#[derive(Debug, Error)]
pub enum SuiteError {
    /// The harness stopped a kernel.
    #[error("{0}")]
    Kernel(String),
    /// A bound is not where it should be.
    #[error(transparent)]
    Statement(#[from] StatementError),
    /// Kept inputs can't be read.
    #[error(transparent)]
    Regressions(#[from] RegressionsError),
    /// A kept input is none of its family.
    #[error("a kept input of {family} on {subject}: {error}")]
    Kept {
        /// The family.
        family: &'static str,
        /// What it is tried on.
        subject: String,
        /// What is the matter.
        error: NoCaseError,
    },
}

impl SuiteError {
    /// What the harness has said when it stopped a kernel.
    pub(crate) fn kernel(panic: &(dyn Any + Send)) -> Self {
        let text = panic.downcast_ref::<String>().cloned();
        let text = text.or_else(|| panic.downcast_ref::<&str>().map(|text| (*text).to_owned()));
        Self::Kernel(text.unwrap_or_else(|| "a kernel was stopped".to_owned()))
    }
}

impl Size {
    fn rounds(self, rounds: u32) -> u32 {
        match self {
            Self::Quick => rounds.div_ceil(10),
            Self::Default => rounds,
            Self::Full => rounds * 10,
        }
    }
}

fn families(section: Section) -> Families {
    match section {
        Section::Stress => stress::families(),
        Section::Guarantees => guarantees::families(),
    }
}

/// The names of all families, each once.
///
/// # Errors
/// A bound is not where it should be.
pub fn names() -> Result<Vec<&'static str>, StatementError> {
    let mut names = Vec::new();
    for section in Section::ALL {
        for family in families(section)? {
            if !names.contains(&family.name) {
                names.push(family.name);
            }
        }
    }
    Ok(names)
}

/// Tries the kept inputs, then new ones.
///
/// # Errors
/// A kernel broke a rule, or a bound or the kept inputs can't be read. That a bound does not hold
/// is no error: the report says it.
pub fn run(
    size: Size,
    seed: u64,
    only: Option<&str>,
    kept: &Regressions,
) -> Result<Report, SuiteError> {
    let mut families: Vec<(Section, Family)> = Vec::new();
    for section in Section::ALL {
        let of_section = self::families(section)?.into_iter();
        let chosen = of_section.filter(|family| only.is_none_or(|only| family.name == only));
        families.extend(chosen.map(|family| (section, family)));
    }
    let sized: Vec<(&Family, u32)> = families
        .iter()
        .map(|(_, family)| (family, size.rounds(family.rounds)))
        .collect();
    let tallies = workers::tally(&sized, seed)?;
    let mut bench = Bench::new();
    let mut rows = Vec::new();
    for ((section, family), tally) in families.into_iter().zip(tallies) {
        let replayed = replay(&mut bench, &family, kept)?;
        rows.push(Row::new(section, family, replayed, tally));
    }
    Ok(Report { seed, size, rows })
}

/// Tries what is kept of a family.
fn replay(bench: &mut Bench, family: &Family, kept: &Regressions) -> Result<Tally, SuiteError> {
    let mut tally = Tally::default();
    for words in kept.of(family.name, &family.subject) {
        let tried = family.cases.replay(bench, words, &mut tally);
        tried.map_err(|error| SuiteError::Kept {
            family: family.name,
            subject: family.subject.clone(),
            error,
        })?;
    }
    Ok(tally)
}
