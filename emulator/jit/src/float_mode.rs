//! How a unit computes floating-point arithmetic.

use crate::trace::MAX_STEPS;

/// How a unit computes floating-point arithmetic. Every mode is exact.
///
/// Each instruction is computed in the host's singles or in its doubles. Singles are fast, but the
/// unit fails if an operand or result differs from IEEE's: if an exponent is 255, an operand is
/// denormal, or a result is flushed or saturated. Doubles are slower, but represent all of an
/// SPU's numbers as ordinary numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FloatMode {
    /// The instructions that are computed in doubles. A load among them commits stores that it may
    /// overlap beforehand. Other loads fail if they do overlap one.
    pub in_doubles: Steps,
    /// Whether they distinguish a sum that is exactly the largest number from one that exceeds it
    /// by less than a double's precision. This is slower still. Without it, a unit fails where the
    /// distinction matters.
    pub exact_sums: bool,
}

impl FloatMode {
    /// Every instruction in singles.
    pub const SINGLES: Self = Self { in_doubles: Steps::NONE, exact_sums: false };
    /// Every instruction in doubles.
    pub const DOUBLES: Self = Self { in_doubles: Steps::ALL, exact_sums: false };
    /// Every instruction in doubles, with exact sums. Arithmetic never fails in this mode.
    pub const EXACT_DOUBLES: Self = Self { in_doubles: Steps::ALL, exact_sums: true };

    /// The next slower mode, for a unit that fails often in this one. `special` are the
    /// instructions that had operands or results that singles can't represent. Returns `None` if
    /// arithmetic never fails in this mode.
    #[must_use]
    pub fn fallback(self, special: Steps) -> Option<Self> {
        let in_doubles = self.in_doubles.with(special);
        if in_doubles != self.in_doubles {
            Some(Self { in_doubles, ..self })
        } else if !self.exact_sums && in_doubles != Steps::NONE {
            Some(Self { exact_sums: true, ..self })
        } else if self != Self::EXACT_DOUBLES {
            Some(Self::EXACT_DOUBLES)
        } else {
            None
        }
    }
}

const BITS: usize = u64::BITS as usize;

/// A set of a trace's instructions, by their positions in it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Steps([u64; MAX_STEPS.div_ceil(BITS)]);

impl Steps {
    /// No instruction.
    pub const NONE: Self = Self([0; _]);
    /// All instructions.
    pub const ALL: Self = Self([u64::MAX; _]);

    /// Whether the set contains the instruction at this position.
    #[must_use]
    pub fn contains(&self, step: usize) -> bool {
        self.0[step / BITS] >> (step % BITS) & 1 != 0
    }

    /// Adds the instruction at this position.
    pub fn add(&mut self, step: usize) {
        self.0[step / BITS] |= 1 << (step % BITS);
    }

    /// The union of both sets.
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
        assert!(special.contains(130) && !special.contains(129) && !special.contains(2));
        let mut modes = vec![FloatMode::SINGLES];
        while let Some(next) = modes.last().and_then(|mode| mode.fallback(special)) {
            modes.push(next);
        }
        let mixed = |exact_sums| FloatMode { in_doubles: special, exact_sums };
        let expected = [FloatMode::SINGLES, mixed(false), mixed(true), FloatMode::EXACT_DOUBLES];
        assert_eq!(modes, expected);
        assert_eq!(FloatMode::SINGLES.fallback(Steps::NONE), Some(FloatMode::EXACT_DOUBLES));
    }
}
