//! Twin of `spu/isect/isect_triangle_pairs_r16.s`: a ray from anywhere and a triangle that
//! is seen from one side or both.

use super::pairs::nearer;
use super::sphere_ray::Ray;
use super::triangle::{Triangle, meet, shear};
use super::{SIGN, below_zero};

/// A triangle as an object of a scene.
#[derive(Clone, Copy, Debug)]
pub struct TriangleObject {
    /// Its vertices.
    pub vertices: Triangle,
    /// Whether it is seen from where they go clockwise, too.
    pub both: bool,
}

/// The ray after its test with a triangle, whose record is at `object`.
#[must_use]
pub fn isect_triangle(ray: Ray, shape: &TriangleObject, object: u32) -> Ray {
    let shear = shear(ray.origin, ray.direction);
    let (meeting, sum) = meet(&shear, &shape.vertices);
    let seen = shape.both || below_zero(sum ^ shear.minus_per_z);
    let misses = below_zero(meeting.outside) || !seen;
    nearer(ray, meeting.n ^ SIGN, object, misses)
}
