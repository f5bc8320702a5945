//! Exact numbers. Roots and quotients have many more digits than are needed.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

/// The number of binary digits of roots and quotients.
const DIGITS: usize = 320;

/// A number with as many digits as it needs.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub(super) struct Exact(FBig<HalfEven, 2>);

impl From<f64> for Exact {
    /// # Panics
    ///
    /// Panics if the value is not finite.
    fn from(value: f64) -> Self {
        let number = FBig::try_from(value).expect("a finite number");
        Self(number.with_precision(0).value())
    }
}

impl Exact {
    pub fn sign(&self) -> Ordering {
        self.0.partial_cmp(&FBig::<HalfEven>::ZERO).unwrap_or(Ordering::Equal)
    }

    /// The square root, to [`DIGITS`], of a number that is not below 0.
    pub fn sqrt(&self) -> Self {
        if self.sign() == Ordering::Equal {
            return self.clone();
        }
        let rounded = self.0.clone().with_precision(DIGITS).value();
        Self(rounded.sqrt().with_precision(0).value())
    }

    pub fn to_f64(&self) -> f64 {
        self.0.to_f64().value()
    }
}

macro_rules! exactly {
    ($($trait:ident $method:ident $operator:tt)*) => {$(
        impl $trait for Exact {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self(self.0 $operator other.0)
            }
        }
    )*};
}

exactly! { Add add + Sub sub - Mul mul * }

impl Neg for Exact {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Div for Exact {
    type Output = Self;

    /// The quotient to [`DIGITS`].
    fn div(self, other: Self) -> Self {
        let rounded = |number: FBig<HalfEven, 2>| number.with_precision(DIGITS).value();
        let quotient = rounded(self.0) / rounded(other.0);
        Self(quotient.with_precision(0).value())
    }
}

#[cfg(test)]
impl Exact {
    pub fn abs(&self) -> Self {
        match self.sign() {
            Ordering::Less => -self.clone(),
            _ => self.clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_arithmetic_keeps_all_digits() {
        let (large, small) = (2_f64.powi(128), 2_f64.powi(-126));
        let sum = Exact::from(large) + Exact::from(small);
        assert_eq!((sum - Exact::from(large)).to_f64(), small);
        let square = Exact::from(large) * Exact::from(large) * Exact::from(small);
        assert_eq!(square.to_f64(), 2_f64.powi(130));
    }

    #[test]
    fn roots_and_quotients_have_their_digits() {
        let two = Exact::from(2.0);
        let off = two.sqrt() * two.sqrt() - two;
        assert!(off.abs() < Exact::from(2_f64.powi(-310)));
        let third = Exact::from(1.0) / Exact::from(3.0);
        assert_eq!(third.to_f64(), 1.0 / 3.0);
        assert_eq!(Exact::from(0.0).sqrt().sign(), Ordering::Equal);
    }
}
