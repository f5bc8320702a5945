//! Tries families' cases on all of the host's cores.
//!
//! Invariant: the tallies are the same for any number of workers: each round has random numbers of its own,
//! and parts are added in the order of their rounds.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use kernels::Bench;

use super::SuiteError;
use super::family::{Family, Tally};
use super::random::of_round;

/// Rounds that a worker takes at a time.
const PART: u32 = 4;

/// Rounds of a family.
struct Part {
    family: usize,
    rounds: std::ops::Range<u32>,
}

/// Tries so many rounds of each family.
///
/// # Errors
/// A kernel broke a rule of the ABI, its versions disagree, or it did not come to an end.
pub fn tally(
    families: &[(&dyn Family, u32)],
    seed: u64,
    workers: usize,
) -> Result<Vec<Tally>, SuiteError> {
    let parts: Vec<Part> = families
        .iter()
        .enumerate()
        .flat_map(|(family, (_, rounds))| {
            let starts = (0..*rounds).step_by(PART as usize);
            starts.map(move |start| Part {
                family,
                rounds: start..(start + PART).min(*rounds),
            })
        })
        .collect();
    let next = AtomicUsize::new(0);
    let found = Mutex::new(vec![Tally::default(); parts.len()]);
    let work = || {
        let mut bench = Bench::new();
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            let Some(part) = parts.get(number) else {
                return;
            };
            let (family, _) = families[part.family];
            let mut tally = Tally::default();
            for round in part.rounds.clone() {
                let mut random = of_round(seed, family.name(), family.subject(), round);
                family.round(&mut bench, &mut random, &mut tally);
            }
            found.lock().expect("no worker dies with the tallies in hand")[number] = tally;
        }
    };
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..workers.max(1)).map(|_| scope.spawn(work)).collect();
        let mut outcomes = threads.into_iter().map(|thread| thread.join());
        outcomes.try_for_each(|outcome| outcome.map_err(|panic| SuiteError::kernel(&*panic)))
    })?;
    let found = found.into_inner().expect("no worker is left");
    let mut tallies = vec![Tally::default(); families.len()];
    for (part, tally) in parts.iter().zip(found) {
        tallies[part.family].append(tally);
    }
    Ok(tallies)
}
