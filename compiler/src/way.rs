//! How a unit does floating-point arithmetic.

use crate::trace::MOST_STEPS;

/// How a unit does floating-point arithmetic. Every way is exact.
///
/// An instruction is carried out in singles of the host, or in doubles. In singles it is fast, and
/// the unit fails where its operands or results are not those that IEEE has: where an exponent is
/// 255, an operand denormal, a result flushed or saturated. In doubles all of an SPU's numbers are
/// ordinary, and it is slower.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Way {
    /// The instructions that are carried out in doubles.
    pub in_doubles: Steps,
    /// Whether these tell a sum that is the largest number exactly from one that is above it by
    /// less than a double shows. This is slower still. Without it a unit fails where it makes a
    /// difference.
    pub exact_sums: bool,
}

impl Way {
    /// All in singles.
    pub const SINGLES: Self = Self {
        in_doubles: Steps::NONE,
        exact_sums: false,
    };
    /// All in doubles.
    pub const DOUBLES: Self = Self {
        in_doubles: Steps::ALL,
        exact_sums: false,
    };
    /// All in doubles, which never fails.
    pub const EXACT_DOUBLES: Self = Self {
        in_doubles: Steps::ALL,
        exact_sums: true,
    };

    /// What to try instead, if this way fails often and `special` are the instructions that were
    /// seen to do what singles can't; `None` if this way never fails by its arithmetic.
    #[must_use]
    pub fn or_with(self, special: Steps) -> Option<Self> {
        let in_doubles = self.in_doubles.with(special);
        if in_doubles != self.in_doubles {
            Some(Self { in_doubles, ..self })
        } else if !self.exact_sums && in_doubles != Steps::NONE {
            Some(Self {
                exact_sums: true,
                ..self
            })
        } else if self != Self::EXACT_DOUBLES {
            Some(Self::EXACT_DOUBLES)
        } else {
            None
        }
    }
}

const BITS: usize = u64::BITS as usize;

/// Some instructions of a trace, by their numbers in it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Steps([u64; MOST_STEPS.div_ceil(BITS)]);

impl Steps {
    /// No instruction.
    pub const NONE: Self = Self([0; _]);
    /// All of them.
    pub const ALL: Self = Self([u64::MAX; _]);

    /// Whether the instruction of this number is one of them.
    #[must_use]
    pub fn has(&self, step: usize) -> bool {
        self.0[step / BITS] >> (step % BITS) & 1 != 0
    }

    /// Adds the instruction of this number.
    pub fn add(&mut self, step: usize) {
        self.0[step / BITS] |= 1 << (step % BITS);
    }

    /// These and those.
    #[must_use]
    pub fn with(mut self, other: Self) -> Self {
        for (own, other) in self.0.iter_mut().zip(other.0) {
            *own |= other;
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_way_that_fails_is_followed_by_a_slower_one() {
        let mut special = Steps::NONE;
        special.add(130);
        assert!(special.has(130) && !special.has(129) && !special.has(2));
        let mut ways = vec![Way::SINGLES];
        while let Some(next) = ways.last().and_then(|way| way.or_with(special)) {
            ways.push(next);
        }
        let mixed = |exact_sums| Way {
            in_doubles: special,
            exact_sums,
        };
        let expected = [Way::SINGLES, mixed(false), mixed(true), Way::EXACT_DOUBLES];
        assert_eq!(ways, expected);
        assert_eq!(Way::SINGLES.or_with(Steps::NONE), Some(Way::EXACT_DOUBLES));
    }
}
