//! A second implementation of the SPU's arithmetic, in integers of unlimited size: results are
//! exact, and are rounded once at the end.
//!
//! It was written from the rules, not from the crate's code, and it is slow. Provenance of
//! expectations: model.

use num_bigint::{BigInt, Sign};

/// integer * 2^exponent
#[derive(Clone, Debug)]
pub struct Exact {
    pub integer: BigInt,
    pub exponent: i64,
}

impl Exact {
    pub fn new(negative: bool, magnitude: u64, exponent: i64) -> Self {
        let sign = if negative { Sign::Minus } else { Sign::Plus };
        let integer = BigInt::from_biguint(sign, magnitude.into());
        Self { integer, exponent }
    }

    pub fn is_zero(&self) -> bool {
        self.integer.sign() == Sign::NoSign
    }

    pub fn is_negative(&self) -> bool {
        self.integer.sign() == Sign::Minus
    }

    pub fn times(&self, other: &Self) -> Self {
        Self { integer: &self.integer * &other.integer, exponent: self.exponent + other.exponent }
    }

    pub fn plus(&self, other: &Self) -> Self {
        let exponent = self.exponent.min(other.exponent);
        let at = |x: &Self| &x.integer << (x.exponent - exponent);
        Self { integer: at(self) + at(other), exponent }
    }

    /// The exponent of the highest bit.
    pub fn top(&self) -> i64 {
        self.integer.bits() as i64 - 1 + self.exponent
    }

    /// The magnitude in units of 2^unit: the number of whole units, and the remainder compared
    /// with half a unit (0: zero, 1: less than half, 2: half, 3: more).
    pub fn in_units(&self, unit: i64) -> (u64, u32) {
        let magnitude = self.integer.magnitude();
        let shift = unit - self.exponent;
        if shift <= 0 {
            return (u64::try_from(magnitude << -shift).unwrap(), 0);
        }
        let whole = magnitude >> shift;
        let rest = magnitude - (&whole << shift);
        let half = num_bigint::BigUint::from(1u32) << (shift - 1);
        let kind = if rest == 0u32.into() {
            0
        } else {
            match rest.cmp(&half) {
                std::cmp::Ordering::Less => 1,
                std::cmp::Ordering::Equal => 2,
                std::cmp::Ordering::Greater => 3,
            }
        };
        (u64::try_from(whole).unwrap(), kind)
    }
}
