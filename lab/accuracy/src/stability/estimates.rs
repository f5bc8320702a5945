//! Reciprocals and square roots where tables meet: the first and the last fraction of every entry, those next
//! to them, with every exponent and either sign.

use crate::generator::Generator;
use kernels::Bench;
use kernels::cases::math::error::ulps;
use kernels::cases::math::{self, FUNCTIONS, Function};
use rand::Rng as _;
use twins::Single;

use super::family::{Family, NoCaseError, Tally, words_of};
use super::statement::{Bound, StatementError};

/// Bits of a fraction behind those that choose an entry of a table.
const POSITION: u32 = 18;
/// Entries for one exponent.
const ENTRIES: u32 = 1 << (23 - POSITION);
/// Quadwords of a call.
const QUADWORDS: usize = 64;

struct Estimates {
    function: &'static Function,
    bound: Bound,
}

/// A family for each function.
///
/// # Errors
/// A header does not state its error.
pub fn families() -> Result<Vec<Box<dyn Family>>, StatementError> {
    let mut families: Vec<Box<dyn Family>> = Vec::new();
    for function in &FUNCTIONS {
        let bound = Bound::of(function.kernel)?;
        families.push(Box::new(Estimates { function, bound }));
    }
    Ok(families)
}

/// A fraction at a border of an entry, and up to two ulps within; any exponent and sign.
fn operand(random: &mut Generator) -> Single {
    let first = random.random_range(0..ENTRIES) << POSITION;
    let within = random.random_range(0..3);
    let last = (1 << POSITION) - 1;
    let fraction = first
        | if random.random() {
            within
        } else {
            last - within
        };
    let exponent: u32 = match random.random_range(0..4) {
        0 => random.random_range(0..4),
        1 => random.random_range(252..256),
        _ => random.random_range(0..256),
    };
    let sign = u32::from(random.random_ratio(1, 4));
    sign << 31 | exponent << 23 | fraction
}

impl Estimates {
    fn try_operands(&self, bench: &mut Bench, operands: &[[Single; 4]], tally: &mut Tally) {
        let results = math::call(bench, self.function.kernel, operands, 0, false);
        for (x, found) in operands.as_flattened().iter().zip(results.as_flattened()) {
            let input = || vec![*x];
            let magnitude = x & 0x7fff_ffff;
            let [low, high] = self.function.domain;
            let negative = x >> 31 != 0 && !self.function.quantity.takes_negative();
            if *found != (self.function.twin)(*x) {
                tally.wrong(input);
            } else if !(low..=high).contains(&magnitude) || negative {
                tally.uncounted();
            } else {
                tally.error(ulps(self.function, *x, *found), input);
            }
        }
    }
}

impl Family for Estimates {
    fn name(&self) -> &'static str {
        "estimate-borders"
    }

    fn subject(&self) -> &str {
        self.function.kernel
    }

    fn unit(&self) -> &'static str {
        "ulp"
    }

    fn bound(&self) -> Bound {
        self.bound.clone()
    }

    fn rounds(&self) -> u32 {
        400
    }

    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally) {
        let operands = [(); QUADWORDS].map(|()| [(); 4].map(|()| operand(random)));
        self.try_operands(bench, &operands, tally);
    }

    fn replay(
        &self,
        bench: &mut Bench,
        words: &[u32],
        tally: &mut Tally,
    ) -> Result<(), NoCaseError> {
        let [x] = words_of(words)?;
        self.try_operands(bench, &[[x; 4]], tally);
        Ok(())
    }
}
