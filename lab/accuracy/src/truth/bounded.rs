//! Double precision with a bound of its error.
//!
//! Invariant: the exact number is within `error` of `value`, as long as no number leaves the
//! normal range of doubles. Products of six singles stay within it.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Sub};

/// The largest relative rounding error of a result.
const UNIT: f64 = f64::EPSILON / 2.0;
/// More than the rounding of a bound can take from it.
const UP: f64 = 1.0 + 16.0 * f64::EPSILON;

/// A number and the bound of its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounded {
    pub value: f64,
    pub error: f64,
}

impl From<f64> for Bounded {
    fn from(value: f64) -> Self {
        Self { value, error: 0.0 }
    }
}

impl Bounded {
    fn new(value: f64, error: f64) -> Self {
        Self { value, error: error * UP }
    }

    /// Its sign, or `None` if the error leaves it open.
    pub fn sign(self) -> Option<Ordering> {
        if self.value.abs() > self.error {
            self.value.partial_cmp(&0.0)
        } else {
            (self.error == 0.0).then_some(Ordering::Equal)
        }
    }

    /// The square root of a number that is not below 0.
    pub fn sqrt(self) -> Self {
        let root = self.value.max(0.0).sqrt();
        let smallest = (self.value - self.error).max(0.0).sqrt();
        let error =
            if root + smallest > 0.0 { self.error / (root + smallest) } else { self.error.sqrt() };
        Self::new(root, error + root * UNIT)
    }

    /// The more precise of two results for the same number.
    pub fn better(self, other: Self) -> Self {
        if other.error < self.error { other } else { self }
    }
}

impl Add for Bounded {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let sum = self.value + other.value;
        let part = sum - self.value;
        // The exact rounding error of the sum (Knuth). Most differences of singles have none.
        let lost = (self.value - (sum - part)) + (other.value - part);
        Self::new(sum, self.error + other.error + lost.abs())
    }
}

impl Sub for Bounded {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + Self { value: -other.value, ..other }
    }
}

impl Mul for Bounded {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = self.value * other.value;
        let error = self.value.abs() * other.error
            + other.value.abs() * self.error
            + self.error * other.error;
        Self::new(product, error + product.abs() * UNIT)
    }
}

impl Div for Bounded {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let smallest = other.value.abs() - other.error;
        let error = if smallest > 0.0 {
            (self.error + quotient.abs() * other.error) / smallest + quotient.abs() * UNIT
        } else {
            f64::INFINITY
        };
        Self::new(quotient, error)
    }
}

#[cfg(test)]
mod tests {
    use crate::generator::Generator;
    use rand::{Rng as _, SeedableRng as _};

    use super::super::exact::Exact;
    use super::*;

    #[test]
    fn exact_number_is_within_bound() {
        let mut random = Generator::seed_from_u64(5);
        for _ in 0..20_000 {
            let mut number = || {
                let scale = 2_f64.powi(random.random_range(-3..4));
                f64::from(random.random_range(-1.0_f32..1.0)) * scale
            };
            let [a, b, c, d] = [number(), number(), number(), number()];
            let exact = Exact::from;
            // A computation that often cancels: differences of products, divided by a difference.
            let ac = a - c;
            let by = Bounded::from;
            let top = by(a) * by(b) - by(c) * by(d);
            let quotient = top / (by(ac) * by(ac) + by(1.0));
            let exact_top = exact(a) * exact(b) - exact(c) * exact(d);
            let exact_bottom = exact(ac) * exact(ac) + exact(1.0);
            let scaled = exact_top.clone() - exact(quotient.value) * exact_bottom.clone();
            let bound = exact(quotient.error) * exact_bottom;
            assert!(scaled.abs() <= bound, "{a} {b} {c} {d}: {quotient:?}");
            let square = top * top;
            let root = square.sqrt();
            let off = (exact(root.value) - exact_top.abs()).abs();
            assert!(off <= exact(root.error), "{a} {b} {c} {d}: {root:?}");
        }
    }

    #[test]
    fn exact_sum_of_singles_has_no_error() {
        let sum = Bounded::from(1_048_576.25) - Bounded::from(3.5);
        assert_eq!(sum, Bounded::from(1_048_572.75));
    }

    #[test]
    fn sign_is_undecided_within_bound() {
        let about = |value, error| Bounded { value, error };
        assert_eq!(about(1.0, 0.5).sign(), Some(Ordering::Greater));
        assert_eq!(about(-1.0, 0.5).sign(), Some(Ordering::Less));
        assert_eq!(about(0.25, 0.5).sign(), None);
        assert_eq!(about(0.0, 0.0).sign(), Some(Ordering::Equal));
    }
}
