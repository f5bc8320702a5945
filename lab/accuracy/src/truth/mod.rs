//! The exact result for a ray and an object, for the same singles that a kernel gets.
//!
//! A ray is treated as the line through its origin in its direction, normalised to length 1.
//! Distances along it may be below 0. Results come from double precision with a bound of its own
//! rounding error (`bounded`). If the bound is above [`DOUBT`] ulp, or leaves a sign open, they
//! come from exact numbers (`exact`). Invariant: the verdict of hit or miss is exact, and a
//! distance is right to [`DOUBT`] ulp of a single.

mod bounded;
mod exact;
mod space;
pub mod sphere;
pub mod triangle;

use kernels::single;
use spu_emulator::float::single::to_f64;
use twins::Single;

pub use space::Vector;

/// The largest error of double precision that is accepted, in ulps of a single.
pub const DOUBT: f64 = 1.0 / 64.0;

/// A ray as exact numbers, each of which is a single.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// The ray's origin.
    pub origin: Vector,
    /// The ray's direction, with any length.
    pub direction: Vector,
}

impl Line {
    /// The ray that a kernel receives.
    pub fn new(origin: [Single; 3], direction: [Single; 3]) -> Self {
        Self { origin: origin.map(to_f64), direction: direction.map(to_f64) }
    }

    /// The point at a distance, in double precision.
    pub fn point(&self, distance: f64) -> Vector {
        let length = space::dot(&self.direction, &self.direction).sqrt();
        std::array::from_fn(|axis| self.origin[axis] + distance * (self.direction[axis] / length))
    }
}

/// The distance from a single to the next at `value`, which is an ulp. Below the smallest single,
/// it is the value there.
pub fn spacing(value: f64) -> f64 {
    const SMALLEST: f64 = 1.0 / (1_u128 << 126) as f64;
    single::spacing(value.abs().max(SMALLEST))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spacing_is_that_of_singles() {
        let ulp = 2_f64.powi(-23);
        for (value, expected) in [
            (1.0, ulp),
            (-1.999, ulp),
            (2.0, 2.0 * ulp),
            (0.999, ulp / 2.0),
            (2_f64.powi(128), 2_f64.powi(105)),
            (0.0, 2_f64.powi(-149)),
            (2_f64.powi(-130), 2_f64.powi(-149)),
        ] {
            assert_eq!(spacing(value), expected, "{value}");
        }
    }

    #[test]
    fn a_distance_counts_along_a_direction_of_length_1() {
        let line = Line { origin: [1.0, 2.0, 3.0], direction: [0.0, 0.0, -16.0] };
        assert_eq!(line.point(5.0), [1.0, 2.0, -2.0]);
    }
}
