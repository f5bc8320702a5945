//! Twin of `lab/spu/isect/isect_rectangle_r16.s`, `any_rectangle_r16.s` and `isect_plane_r16.s`:
//! rays, parallelograms and planes.

use spu_emulator::float::single::{fm, fnms, fs};
use zerocopy::FromBytes;

use super::flat::{FlatHit, Meeting};
use super::math::reciprocal;
use super::{ONE, Single, dot};

/// A parallelogram, or the plane through it.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct Rectangle {
    /// Where u and v are 0.
    pub point: [Single; 3],
    /// Unit normal.
    pub normal: [Single; 3],
    /// Its products with the edges are 1 and 0, with the normal 0.
    pub dual_u: [Single; 3],
    /// Its products with the edges are 0 and 1, with the normal 0.
    pub dual_v: [Single; 3],
}

/// Where the ray meets the plane, the parallelogram's bounds left out.
fn meet(origin: [Single; 3], direction: [Single; 3], rectangle: &Rectangle) -> Meeting {
    let beside: [Single; 3] = std::array::from_fn(|axis| fs(origin[axis], rectangle.point[axis]));
    let inverse = reciprocal(dot(rectangle.normal, direction));
    let n = fm(dot(rectangle.normal, beside), inverse);
    let hit = std::array::from_fn(|axis| fnms(n, direction[axis], beside[axis]));
    Meeting { n, u: dot(rectangle.dual_u, hit), v: dot(rectangle.dual_v, hit), outside: 0 }
}

/// As [`meet`], with the bounds: compared as unsigned integers, where all below 0 are above 1.
pub(super) fn meet_within(
    origin: [Single; 3],
    direction: [Single; 3],
    rectangle: &Rectangle,
) -> Meeting {
    let meeting = meet(origin, direction, rectangle);
    let beyond = meeting.u > ONE || meeting.v > ONE;
    Meeting { outside: u32::from(beyond).wrapping_neg(), ..meeting }
}

/// The nearer of `hit` and the hit with the parallelogram.
#[must_use]
pub fn isect_rectangle(
    origin: [Single; 3],
    direction: [Single; 3],
    rectangle: &Rectangle,
    object: u32,
    hit: FlatHit,
) -> FlatHit {
    meet_within(origin, direction, rectangle).nearer(hit, object)
}

/// Whether the parallelogram is hit nearer than `farthest`.
#[must_use]
pub fn any_rectangle(
    origin: [Single; 3],
    direction: [Single; 3],
    rectangle: &Rectangle,
    farthest: Single,
) -> bool {
    meet_within(origin, direction, rectangle).hits(farthest)
}

/// The nearer of `hit` and the hit with the parallelogram's plane.
#[must_use]
pub fn isect_plane(
    origin: [Single; 3],
    direction: [Single; 3],
    rectangle: &Rectangle,
    object: u32,
    hit: FlatHit,
) -> FlatHit {
    meet(origin, direction, rectangle).nearer(hit, object)
}
