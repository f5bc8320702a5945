//! Products of vectors for every type of number.

use std::ops::{Add, Mul, Sub};

/// x, y, z.
pub type Vector = [f64; 3];

/// The component type of vectors.
pub(super) trait Number:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
}

impl<T: Clone + Add<Output = T> + Sub<Output = T> + Mul<Output = T>> Number for T {}

pub(super) fn dot<T: Number>(a: &[T; 3], b: &[T; 3]) -> T {
    let product = |axis: usize| a[axis].clone() * b[axis].clone();
    product(0) + product(1) + product(2)
}

pub(super) fn cross<T: Number>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    std::array::from_fn(|k| {
        let (next, last) = ((k + 1) % 3, (k + 2) % 3);
        a[next].clone() * b[last].clone() - a[last].clone() * b[next].clone()
    })
}

/// a - b.
pub(super) fn sub<T: Number>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    std::array::from_fn(|axis| a[axis].clone() - b[axis].clone())
}
