//! Twin of the general form of `spu/include/sphere_tmpl.inc`: a ray from anywhere and a sphere
//! that is seen from one side or both.

use super::pairs::{Sides, nearer};
use super::sphere::General;
use super::sphere_ray::Ray;
use super::{Single, below_zero};

/// A sphere as an object of a scene.
#[derive(Clone, Copy, Debug)]
pub struct SphereObject {
    /// Centre.
    pub centre: [Single; 3],
    /// Radius, of either sign.
    pub offset: Single,
    /// From where it is seen.
    pub sides: Sides,
}

/// The ray after its test with a sphere, whose record is at `object`, by a formulation.
#[must_use]
pub fn isect_sphere_pair<F: General>(ray: Ray, sphere: &SphereObject, object: u32) -> Ray {
    let found = F::crossing(&ray, sphere);
    nearer(ray, found.t, object, below_zero(found.outside))
}
