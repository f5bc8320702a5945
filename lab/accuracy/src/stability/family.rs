//! Families of cases and the tallies of their results.
//!
//! Invariant: a tally depends only on the cases in their order, not on the thread that tried them.

use super::statement::{Bound, StatementError};
use crate::stability::prelude::*;

/// Cases of one kind, tried on one kernel or on one sequence of kernels.
pub struct Family {
    /// The family's name.
    pub name: &'static str,
    /// What the cases test.
    pub subject: String,
    /// The unit of its errors.
    pub unit: &'static str,
    /// The bound of its errors.
    pub bound: Bound,
    /// The number of rounds in a run of the default size.
    pub rounds: u32,
    /// How cases are made and tried.
    pub cases: Box<dyn Cases>,
}

/// Makes and tries cases.
pub trait Cases: Sync {
    /// Tries some new cases.
    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally);
    /// Tries the case that these words describe.
    fn replay(&self, bench: &mut Bench, words: &[u32], tally: &mut Tally) -> Replayed;
}

/// Whether the words were a case.
pub type Replayed = Result<(), NoCaseError>;

/// Families, or the error that one of their bounds is missing from its kernel's header.
pub type Families = Result<Vec<Family>, StatementError>;

/// The words of a saved input are not a case of its family.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{found} words, but a case has {needed}")]
pub struct NoCaseError {
    /// The number of words in the input.
    pub found: usize,
    /// The number of words in a case.
    pub needed: usize,
}

/// Checks the number of words in a case.
pub fn need(needed: usize, words: &[u32]) -> Replayed {
    let found = words.len();
    if found == needed { Ok(()) } else { Err(NoCaseError { found, needed }) }
}

/// The vectors of a case, or of a part of one with as many words.
pub fn points_of<const N: usize>(words: &[u32]) -> Result<[[u32; 3]; N], NoCaseError> {
    need(3 * N, words)?;
    Ok(std::array::from_fn(|n| [0, 1, 2].map(|k| words[3 * n + k])))
}

/// The judgement of a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Judgement {
    /// Nothing is required of it.
    Uncounted,
    /// It is wrong, which is worse than any error.
    Wrong,
    /// The size of its error.
    Error(f64),
}

impl Judgement {
    /// No error if it is right, and this one otherwise.
    pub fn unless(right: bool, error: impl FnOnce() -> f64) -> Self {
        Self::Error(if right { 0.0 } else { error() })
    }
}

/// The results of a family.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    /// The number of cases tried.
    pub cases: u64,
    /// The number of cases to which the bound applies. The others are outside the stated domain
    /// and are only tried.
    pub counted: u64,
    /// The number of results that are wrong whatever the bound is: a lost or false hit, or other
    /// bits than the twin's.
    pub wrong: u64,
    /// The largest error of the others.
    pub worst: f64,
    /// The input of the first wrong result, or else of the largest error.
    pub input: Vec<u32>,
}

impl Tally {
    /// Adds a case of which nothing is required.
    pub fn uncounted(&mut self) {
        self.cases += 1;
    }

    /// Adds a case with its error.
    pub fn error(&mut self, error: f64, input: impl FnOnce() -> Vec<u32>) {
        self.cases += 1;
        self.counted += 1;
        if error > self.worst || self.input.is_empty() {
            self.worst = self.worst.max(error);
            if self.wrong == 0 {
                self.input = input();
            }
        }
    }

    /// Adds a case with a wrong result.
    pub fn wrong(&mut self, input: impl FnOnce() -> Vec<u32>) {
        self.cases += 1;
        self.counted += 1;
        if self.wrong == 0 {
            self.input = input();
        }
        self.wrong += 1;
    }

    /// Adds a case with its judgement.
    pub fn judged(&mut self, judgement: Judgement, input: impl FnOnce() -> Vec<u32>) {
        match judgement {
            Judgement::Uncounted => self.uncounted(),
            Judgement::Wrong => self.wrong(input),
            Judgement::Error(error) => self.error(error, input),
        }
    }

    /// Adds a case that is either right or wrong.
    pub fn verdict(&mut self, right: bool, input: impl FnOnce() -> Vec<u32>) {
        if right {
            self.error(0.0, input);
        } else {
            self.wrong(input);
        }
    }

    /// Adds the results of later cases.
    pub fn append(&mut self, later: Self) {
        let takes = if later.wrong > 0 {
            self.wrong == 0
        } else {
            self.wrong == 0 && (later.worst > self.worst || self.input.is_empty())
        };
        if takes {
            self.input = later.input;
        }
        self.cases += later.cases;
        self.counted += later.counted;
        self.wrong += later.wrong;
        self.worst = self.worst.max(later.worst);
    }

    /// Whether the bound holds for every case to which it applies, and there is such a case.
    pub fn holds(&self, bound: &Bound) -> bool {
        self.counted > 0 && self.wrong == 0 && self.worst <= bound.value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(cases: &[(f64, bool)]) -> Tally {
        let mut tally = Tally::default();
        for (number, (error, wrong)) in (1..).zip(cases) {
            if *wrong {
                tally.wrong(|| vec![number]);
            } else {
                tally.error(*error, || vec![number]);
            }
        }
        tally
    }

    #[test]
    fn tally_keeps_wrong_result_before_worst_error() {
        let tally = of(&[(1.0, false), (3.0, false), (3.0, false), (2.0, false)]);
        assert_eq!((tally.worst, &tally.input[..]), (3.0, &[2][..]));
        let tally = of(&[(1.0, false), (0.0, true), (9.0, false), (0.0, true)]);
        assert_eq!((tally.wrong, tally.worst), (2, 9.0));
        assert_eq!(tally.input, [2]);
    }

    #[test]
    fn tallies_of_parts_add_up() {
        let cases = [(1.0, false), (0.0, true), (9.0, false), (0.0, true), (9.0, false)];
        for split in 0..=cases.len() {
            let (first, second) = cases.split_at(split);
            let mut sum = of(first);
            let mut rest = of(second);
            // Numbers continue where the first part ends.
            for word in &mut rest.input {
                *word += split as u32;
            }
            sum.append(rest);
            assert_eq!(sum, of(&cases), "{split}");
        }
    }

    #[test]
    fn bound_needs_counted_cases_to_hold() {
        let bound = Bound::none("a test");
        let mut tally = Tally::default();
        tally.uncounted();
        assert!(!tally.holds(&bound));
        tally.error(0.0, Vec::new);
        assert!(tally.holds(&bound));
        tally.error(0.5, Vec::new);
        assert!(!tally.holds(&bound));
    }
}
