//! What a family of cases is, and what is counted of it.
//!
//! Invariant: a tally depends on the cases alone, in their order: not on who has tried them.

use crate::generator::Generator;
use kernels::Bench;
use thiserror::Error;

use super::statement::{Bound, StatementError};

/// Cases of one kind, tried on one kernel or one chain of them.
pub struct Family {
    /// The family.
    pub name: &'static str,
    /// What is tried on it.
    pub subject: String,
    /// What its errors are counted in.
    pub unit: &'static str,
    /// What they are held to.
    pub bound: Bound,
    /// Rounds of a run that is neither quick nor full.
    pub rounds: u32,
    /// How cases are made and tried.
    pub cases: Box<dyn Cases>,
}

/// How cases are made and tried.
pub trait Cases: Sync {
    /// Tries some new ones.
    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally);
    /// Tries the one that these words say.
    fn replay(&self, bench: &mut Bench, words: &[u32], tally: &mut Tally) -> Replayed;
}

/// Whether words were a case.
pub type Replayed = Result<(), NoCaseError>;

/// Families, if all of their bounds are where they should be.
pub type Families = Result<Vec<Family>, StatementError>;

/// The words of a kept input say no case of its family.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{found} words, where a case has {needed}")]
pub struct NoCaseError {
    /// Words that there are.
    pub found: usize,
    /// Words that a case has.
    pub needed: usize,
}

/// Refuses what are not as many words as a case has.
pub fn need(needed: usize, words: &[u32]) -> Replayed {
    let found = words.len();
    if found == needed {
        Ok(())
    } else {
        Err(NoCaseError { found, needed })
    }
}

/// The vectors of a case, or of a part of one, that has as many words as they do.
pub fn points_of<const N: usize>(words: &[u32]) -> Result<[[u32; 3]; N], NoCaseError> {
    need(3 * N, words)?;
    Ok(std::array::from_fn(|n| [0, 1, 2].map(|k| words[3 * n + k])))
}

/// What is said of a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Judgement {
    /// Nothing is asked of it.
    Uncounted,
    /// It is wrong, by more than an error.
    Wrong,
    /// How large its error is.
    Error(f64),
}

impl Judgement {
    /// No error where it is right, else this one.
    pub fn unless(right: bool, error: impl FnOnce() -> f64) -> Self {
        Self::Error(if right { 0.0 } else { error() })
    }
}

/// What has been found of a family.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    /// Cases tried.
    pub cases: u64,
    /// Cases that the bound is asked of; the others are beyond what is stated, and are only tried.
    pub counted: u64,
    /// Answers that no error is small enough for: a hit lost or made up, other bits than the
    /// twin's.
    pub wrong: u64,
    /// Largest error of the others.
    pub worst: f64,
    /// The input of the first wrong answer, else of the largest error.
    pub input: Vec<u32>,
}

impl Tally {
    /// A case that nothing is asked of.
    pub fn uncounted(&mut self) {
        self.cases += 1;
    }

    /// A case and its error.
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

    /// A case whose answer is wrong.
    pub fn wrong(&mut self, input: impl FnOnce() -> Vec<u32>) {
        self.cases += 1;
        self.counted += 1;
        if self.wrong == 0 {
            self.input = input();
        }
        self.wrong += 1;
    }

    /// A case and what is said of it.
    pub fn judged(&mut self, judgement: Judgement, input: impl FnOnce() -> Vec<u32>) {
        match judgement {
            Judgement::Uncounted => self.uncounted(),
            Judgement::Wrong => self.wrong(input),
            Judgement::Error(error) => self.error(error, input),
        }
    }

    /// A case that is right or wrong.
    pub fn verdict(&mut self, right: bool, input: impl FnOnce() -> Vec<u32>) {
        if right {
            self.error(0.0, input);
        } else {
            self.wrong(input);
        }
    }

    /// Adds what has been found after this.
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

    /// Whether all that is asked of it holds, and anything was asked.
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
    fn the_worst_input_is_kept_and_a_wrong_answer_before_it() {
        let tally = of(&[(1.0, false), (3.0, false), (3.0, false), (2.0, false)]);
        assert_eq!((tally.worst, &tally.input[..]), (3.0, &[2][..]));
        let tally = of(&[(1.0, false), (0.0, true), (9.0, false), (0.0, true)]);
        assert_eq!((tally.wrong, tally.worst), (2, 9.0));
        assert_eq!(tally.input, [2]);
    }

    #[test]
    fn parts_add_up_to_the_whole() {
        let cases = [
            (1.0, false),
            (0.0, true),
            (9.0, false),
            (0.0, true),
            (9.0, false),
        ];
        for split in 0..=cases.len() {
            let (first, second) = cases.split_at(split);
            let mut sum = of(first);
            let mut rest = of(second);
            // Numbers go on where the first part ends.
            for word in &mut rest.input {
                *word += split as u32;
            }
            sum.append(rest);
            assert_eq!(sum, of(&cases), "{split}");
        }
    }

    #[test]
    fn nothing_counted_holds_nothing() {
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
