//! The stress suite: the inputs for which single precision is worst, and the bounds that hold for
//! them.
//!
//! This module tries families of cases on all cores, saves their worst inputs and tries them
//! again, and makes the report. Invariant: a bound comes from a kernel's header or follows from
//! one, and a figure depends only on the seed and the size.

mod family;
mod guarantees;
mod prelude;
mod product;
pub(crate) mod random;
pub mod regressions;
pub mod report;
mod statement;
mod steps;
mod stress;
mod workers;

use std::any::Any;

use serde::Serialize;

use crate::stability::prelude::*;
use family::{Families, Family, NoCaseError, Tally};
use regressions::{Regressions, RegressionsError};
use report::{Report, Row, Section};
use statement::StatementError;

/// The number of cases to try.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Size {
    /// A tenth of the default, for slow hosts.
    Quick,
    /// This many times the default, which the families define.
    Times(u32),
}

/// Why the suite could not be run.
#[derive(Debug, Error)]
pub enum SuiteError {
    /// The harness stopped a kernel.
    #[error("{0}")]
    Kernel(String),
    /// A bound is not in its kernel's header.
    #[error(transparent)]
    Statement(#[from] StatementError),
    /// The saved inputs can't be read.
    #[error(transparent)]
    Regressions(#[from] RegressionsError),
    /// A saved input is not a case of its family.
    #[error("a saved input of {family} on {subject}: {error}")]
    Kept {
        /// The family.
        family: &'static str,
        /// What the cases test.
        subject: String,
        /// What is wrong.
        error: NoCaseError,
    },
}

impl SuiteError {
    /// The harness's message when it stopped a kernel.
    pub(crate) fn kernel(panic: &(dyn Any + Send)) -> Self {
        let text = panic.downcast_ref::<String>().cloned();
        let text = text.or_else(|| panic.downcast_ref::<&str>().map(|text| (*text).to_owned()));
        Self::Kernel(text.unwrap_or_else(|| "the harness stopped a kernel".to_owned()))
    }
}

impl Size {
    fn rounds(self, rounds: u32) -> u32 {
        match self {
            Self::Quick => rounds.div_ceil(10),
            Self::Times(times) => rounds.saturating_mul(times),
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
/// Fails if a bound is not in its kernel's header.
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

/// Tries the saved inputs, and then new ones.
///
/// # Errors
/// Fails if a kernel breaks a rule, or if a bound or the saved inputs can't be read. A bound that
/// does not hold is not an error; the report shows it.
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
    let sized: Vec<(&Family, u32)> =
        families.iter().map(|(_, family)| (family, size.rounds(family.rounds))).collect();
    let tallies = workers::tally(&sized, seed)?;
    let mut bench = Bench::new();
    let mut rows = Vec::new();
    for ((section, family), tally) in families.into_iter().zip(tallies) {
        let replayed = replay(&mut bench, &family, kept)?;
        rows.push(Row::new(section, family, replayed, tally));
    }
    Ok(Report { seed, size, rows })
}

/// Tries the saved inputs of a family.
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
