//! Reciprocals and square roots where tables' entries meet: the first and the last fraction of
//! every entry, and the fractions next to them, with every exponent and both signs.

use crate::stability::prelude::*;
use kernels::cases::math::error::ulps;
use kernels::cases::math::{self, FUNCTIONS, Function};

/// The number of low bits of a fraction that do not select a table entry.
const POSITION: u32 = 18;
/// The number of entries for one exponent.
const ENTRIES: u32 = 1 << (23 - POSITION);
/// The number of quadwords in a call.
const QUADWORDS: usize = 64;

struct Estimates(&'static Function);

/// A family for each function.
pub fn families() -> Families {
    let family = |function: &'static Function| {
        Ok(Family {
            name: "estimate-borders",
            subject: function.kernel.to_owned(),
            unit: "ulp",
            bound: Bound::of(function.kernel)?,
            rounds: 400,
            cases: Box::new(Estimates(function)),
        })
    };
    FUNCTIONS.iter().map(family).collect()
}

/// A fraction at the border of an entry, or up to two ulps inside, with a random exponent and
/// sign.
fn operand(random: &mut Generator) -> Single {
    let first = random.random_range(0..ENTRIES) << POSITION;
    let within = random.random_range(0..3);
    let last = (1 << POSITION) - 1;
    let fraction = first | if random.random() { within } else { last - within };
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
        let Self(function) = self;
        let results = math::call(bench, function.kernel, operands);
        for (x, found) in operands.as_flattened().iter().zip(results.as_flattened()) {
            let input = || vec![*x];
            let magnitude = x & 0x7fff_ffff;
            let [low, high] = function.domain;
            let negative = x >> 31 != 0 && !function.quantity.takes_negative();
            if *found != (function.twin)(*x) {
                tally.wrong(input);
            } else if !(low..=high).contains(&magnitude) || negative {
                tally.uncounted();
            } else {
                tally.error(ulps(function, *x, *found), input);
            }
        }
    }
}

impl Cases for Estimates {
    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally) {
        let operands = [(); QUADWORDS].map(|()| [(); 4].map(|()| operand(random)));
        self.try_operands(bench, &operands, tally);
    }

    fn replay(&self, bench: &mut Bench, words: &[u32], tally: &mut Tally) -> Replayed {
        need(1, words)?;
        self.try_operands(bench, &[[words[0]; 4]], tally);
        Ok(())
    }
}
