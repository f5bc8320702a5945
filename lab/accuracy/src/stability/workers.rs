//! Tries families' cases on all of the host's cores.
//!
//! Invariant: the tallies do not depend on the number of cores, because each round has its own
//! random numbers and parts are added in the order of their rounds.

use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::SuiteError;
use super::family::{Family, Tally};
use super::random::of_round;
use crate::parallel;
use crate::stability::prelude::*;

/// The number of rounds that are tried at a time.
const PART: u32 = 4;

/// Some rounds of a family.
struct Part {
    family: usize,
    rounds: Range<u32>,
}

/// Tries this many rounds of each family. Fails if a kernel breaks a rule of the ABI, its versions
/// disagree, or it does not end.
pub fn tally(families: &[(&Family, u32)], seed: u64) -> Result<Vec<Tally>, SuiteError> {
    let parts: Vec<Part> = families
        .iter()
        .enumerate()
        .flat_map(|(family, (_, rounds))| {
            let starts = (0..*rounds).step_by(PART as usize);
            starts.map(move |start| Part { family, rounds: start..(start + PART).min(*rounds) })
        })
        .collect();
    let found = parallel::map(&parts, Bench::new, |bench, part| {
        let (family, _) = families[part.family];
        // The harness stops a kernel by a panic. The bench may then be in an invalid state, so no
        // other part uses it.
        let tried = catch_unwind(AssertUnwindSafe(|| rounds(bench, family, seed, part)));
        tried.map_err(|panic| {
            *bench = Bench::new();
            SuiteError::kernel(&*panic)
        })
    });
    let mut tallies = vec![Tally::default(); families.len()];
    for (part, tally) in parts.iter().zip(found) {
        tallies[part.family].append(tally?);
    }
    Ok(tallies)
}

fn rounds(bench: &mut Bench, family: &Family, seed: u64, part: &Part) -> Tally {
    let mut tally = Tally::default();
    for round in part.rounds.clone() {
        let mut random = of_round(seed, family.name, &family.subject, round);
        family.cases.round(bench, &mut random, &mut tally);
    }
    tally
}
