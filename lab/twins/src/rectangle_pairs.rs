//! Twin of `spu/isect/isect_rectangle_pairs_r16.s`: a ray from anywhere and a parallelogram
//! that is seen from one side or both.

use super::pairs::nearer;
use super::rectangle::{Rectangle, meet_within};
use super::sphere_ray::Ray;
use super::{SIGN, below_zero, dot};

/// A parallelogram as an object of a scene.
#[derive(Clone, Copy, Debug)]
pub struct RectangleObject {
    /// Its plane and edges.
    pub rectangle: Rectangle,
    /// Whether its back is visible, too.
    pub both: bool,
}

/// The ray after its test with a parallelogram, whose record is at `object`.
#[must_use]
pub fn isect_rectangle(ray: Ray, shape: &RectangleObject, object: u32) -> Ray {
    let RectangleObject { rectangle, both } = shape;
    let meeting = meet_within(ray.origin, ray.direction, rectangle);
    let seen = *both || below_zero(dot(rectangle.normal, ray.direction));
    let misses = below_zero(meeting.outside) || !seen;
    nearer(ray, meeting.n ^ SIGN, object, misses)
}
