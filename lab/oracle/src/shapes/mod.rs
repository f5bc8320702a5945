//! Intersects rays from anywhere with the shapes of a scene, in `f64`.
//!
//! A ray that starts within [`rounding`] of a surface counts as starting on it. Then it doesn't
//! hit a plane at all, and it hits a quadric only at the other crossing. So a ray leaves a surface
//! without an origin offset, at any scale, and without knowing which object it leaves. A hit's
//! point is moved onto its surface first, so that it is near enough.
//!
//! Invariant: a distance is finite, above 0 and below the limit; a normal has length 1.

mod cone;
mod polygon;
mod sphere;
#[cfg(test)]
pub(crate) mod tests;

use glam::DVec3;
use scenes::Shape;

use crate::bvh::Bounds;
use crate::ray::Ray;
use cone::Cone;
pub(crate) use polygon::MAX_PATCH_VERTICES;
use polygon::Polygon;
use sphere::Sphere;

/// A surface that rays can hit.
#[derive(Debug, Clone)]
pub(crate) enum Surface {
    Sphere(Sphere),
    Cone(Cone),
    Polygon(Polygon),
}

/// The sides from which a surface is visible. Its front is the side of its normal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Sides {
    pub front: bool,
    pub back: bool,
}

impl Sides {
    const BOTH: Self = Self { front: true, back: true };
    const FRONT: Self = Self { front: true, back: false };

    /// Whether the surface is visible to a ray against the normal (`true`) or along it.
    fn seen(self, against: bool) -> bool {
        if against { self.front } else { self.back }
    }
}

/// A point on a surface, with its normals.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    /// The point, which is on the surface except for [`rounding`].
    pub point: DVec3,
    /// The surface's normal, on its front.
    pub normal: DVec3,
    /// The normal that a patch interpolates; for other surfaces `normal`.
    pub smooth: DVec3,
}

impl Surface {
    /// The surface of a shape. With `transmits` it is visible from both sides. `None` if the shape
    /// has no surface: a polygon without area, a cone without height or radius.
    pub(crate) fn new(shape: &Shape, transmits: bool) -> Option<Self> {
        let sides = if transmits { Sides::BOTH } else { Sides::FRONT };
        match shape {
            &Shape::Sphere { centre, radius } => {
                (radius != 0.0).then(|| Self::Sphere(Sphere::new(centre, radius, sides)))
            }
            &Shape::Cone { base, base_radius, apex, apex_radius } => {
                // A cone is a sheet, not a body: if its outside is visible, its inside is too.
                let sides = if base_radius.max(apex_radius) > 0.0 { Sides::BOTH } else { sides };
                Cone::new((base, base_radius), (apex, apex_radius), sides).map(Self::Cone)
            }
            Shape::Polygon { vertices } => Polygon::new(vertices, None, sides).map(Self::Polygon),
            Shape::Patch { vertices, normals } => {
                Polygon::new(vertices, Some(normals), sides).map(Self::Polygon)
            }
        }
    }

    /// The distance to the nearest crossing below `limit` that is visible from its side.
    pub(crate) fn hit(&self, ray: &Ray, limit: f64) -> Option<f64> {
        match self {
            Self::Sphere(sphere) => sphere.hit(ray, limit),
            Self::Cone(cone) => cone.hit(ray, limit),
            Self::Polygon(polygon) => polygon.hit(ray, limit),
        }
    }

    /// The place of a hit, at a distance that [`Self::hit`] returned.
    pub(crate) fn place(&self, ray: &Ray, distance: f64) -> Place {
        let point = ray.at(distance);
        match self {
            Self::Sphere(sphere) => sphere.place(point),
            Self::Cone(cone) => cone.place(point, ray.direction),
            Self::Polygon(polygon) => polygon.place(point),
        }
    }

    /// A box around the surface.
    pub(crate) fn bounds(&self) -> Bounds {
        match self {
            Self::Sphere(sphere) => sphere.bounds(),
            Self::Cone(cone) => cone.bounds(),
            Self::Polygon(polygon) => polygon.bounds(),
        }
    }
}

/// How far a point that was moved onto a surface may be off it: tens of rounding errors of its
/// coordinates, and of its coordinates relative to the surface's origin. Only a few such errors
/// occur.
fn rounding(point: DVec3, from_own_origin: DVec3) -> f64 {
    let largest = |vector: DVec3| vector.abs().max_element();
    64.0 * f64::EPSILON * (largest(point) + largest(from_own_origin))
}

/// The nearest visible one of two crossings, at a distance above `min` and below `limit`. Each
/// crossing has its distance, and whether the ray goes against the normal.
fn nearest_seen(crossings: [(f64, bool); 2], sides: Sides, min: f64, limit: f64) -> Option<f64> {
    let seen = |&(t, against): &(f64, bool)| t > min && t < limit && sides.seen(against);
    let distances = crossings.iter().filter(|it| seen(it)).map(|&(t, _)| t);
    distances.reduce(f64::min)
}
