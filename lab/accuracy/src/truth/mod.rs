//! What is exactly so of a ray and an object, for the very singles that a kernel is given.
//!
//! A ray is taken as the line through its origin along its direction at length 1; distances along
//! it may be below 0. Answers come from double precision, which carries a bound of its own
//! rounding errors (`bounded`); where the bound is above [`DOUBT`] of an ulp, or leaves a sign
//! open, from exact numbers (`exact`). Invariant: the verdict of hit or miss is exact, and a
//! distance is right to [`DOUBT`] of an ulp of a single.

mod bounded;
mod exact;
mod space;
pub mod sphere;
pub mod triangle;

use kernels::single;
use spu_emulator::float::single::to_f64;
use twins::Single;

pub use space::Vector;

/// The part of an ulp that double precision may be off by.
pub const DOUBT: f64 = 1.0 / 64.0;

/// A ray as exact numbers, each a single.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Where it starts.
    pub origin: Vector,
    /// Where it goes, of any length.
    pub direction: Vector,
}

impl Line {
    /// The ray that a kernel is given.
    pub fn new(origin: [Single; 3], direction: [Single; 3]) -> Self {
        Self {
            origin: origin.map(to_f64),
            direction: direction.map(to_f64),
        }
    }

    /// The point at a distance, in double precision.
    pub fn point(&self, distance: f64) -> Vector {
        let length = space::dot(&self.direction, &self.direction).sqrt();
        std::array::from_fn(|axis| self.origin[axis] + distance * (self.direction[axis] / length))
    }
}

/// From a single to the next: what an ulp is at `value`. Below the smallest single, what it is
/// there.
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
        let line = Line {
            origin: [1.0, 2.0, 3.0],
            direction: [0.0, 0.0, -16.0],
        };
        assert_eq!(line.point(5.0), [1.0, 2.0, -2.0]);
    }
}
